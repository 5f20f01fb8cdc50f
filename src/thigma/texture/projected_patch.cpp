#include "thigma/texture/projected_patch.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/plane_cross.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma {
namespace {

double sign_of(Facing facing) noexcept { return facing == Facing::along ? 1.0 : -1.0; }

// How far inside a triangle a point is: the least of its three barycentric coordinates.
double insideness(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return std::min({cross(t.edges[0], at - t.at[0]), cross(t.edges[1], at - t.at[1]),
                   cross(t.edges[2], at - t.at[2])});
}

// Slack of the test whether a point lies on a triangle, of its barycentric coordinates: less would open cracks between
// neighbours by rounding; more only extends a triangle's plane by that share.
constexpr double kEdgeSlack = 1e-9;

bool is_in(const PlaneBox& box, const Vec2& at) noexcept {
  return at.x() >= box.low.x() && at.x() <= box.high.x() && at.y() >= box.low.y() &&
         at.y() <= box.high.y();
}

bool covers(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return is_in(t.box, at) && insideness(t, at) >= -kEdgeSlack;
}

// The triangle of the last point where this one lies on it, too. Where nothing is hidden one sheet is expected, and the
// first triangle found is the one.
const ProjectedTriangle* first_guess(const ProjectedPatch& patch, const Vec2& at,
                                     std::int32_t near) noexcept {
  if (!patch.hidden.empty() || near < 0 || near >= static_cast<std::int32_t>(patch.triangles.size()))
    return nullptr;
  const ProjectedTriangle& t = patch.triangles[static_cast<std::size_t>(near)];
  return covers(t, at) ? &t : nullptr;
}

Vec2 texel_of(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return t.texel_origin + t.texel_by_at * at;
}

double coarse_height(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return t.height_origin + t.height_by_at.dot(at);
}

// Affine maps of a triangle whose corners in the contact frame are p and in the map c.
ProjectedTriangle affine_maps(const std::array<Vec3, 3>& p, const std::array<Vec2, 3>& c,
                              double direction) noexcept {
  ProjectedTriangle t;
  for (std::size_t k = 0; k < 3; ++k) t.at[k] = p[k].head<2>();
  Mat2 edges, texel_edges;
  edges << t.at[1] - t.at[0], t.at[2] - t.at[0];
  texel_edges << c[1] - c[0], c[2] - c[0];
  const double area = cross(edges.col(0), edges.col(1));
  for (std::size_t k = 0; k < 3; ++k) t.edges[k] = (t.at[(k + 1) % 3] - t.at[k]) / area;
  const Mat2 back = edges.inverse();
  t.texel_by_at = texel_edges * back;
  t.texel_origin = c[0] - t.texel_by_at * t.at[0];
  t.at_by_texel = edges * texel_edges.inverse();
  t.at_origin = t.at[0] - t.at_by_texel * c[0];
  const Vec2 rises(direction * (p[1].z() - p[0].z()), direction * (p[2].z() - p[0].z()));
  t.height_by_at = back.transpose() * rises;
  t.height_origin = direction * p[0].z() - t.height_by_at.dot(t.at[0]);
  return t;
}

bool is_finite(const ProjectedTriangle& t) noexcept {
  return t.texel_origin.allFinite() && t.texel_by_at.allFinite() && t.at_origin.allFinite() &&
         t.at_by_texel.allFinite() && t.edges[0].allFinite() && t.edges[1].allFinite() &&
         t.edges[2].allFinite() && std::isfinite(t.height_origin) && t.height_by_at.allFinite();
}

// What a triangle of a patch shows at a point on it.
SurfaceJet jet_on(const ProjectedPatch& patch, const ProjectedTriangle& t,
                  const Vec2& at) noexcept {
  const TexelJet texel = texel_jet(*patch.texture, texel_of(t, at));
  const Vec3& m = patch.direction_body;
  const Mat2 by_at = t.texel_by_at;
  SurfaceJet jet;
  jet.is_covered = true;
  jet.height = coarse_height(t, at) + m.dot(texel.value);
  jet.slope = t.height_by_at + by_at.transpose() * Vec2(m.dot(texel.by_x), m.dot(texel.by_y));
  jet.facet_slope =
      t.height_by_at + by_at.transpose() * Vec2(m.dot(texel.facet_by_x), m.dot(texel.facet_by_y));
  Mat2 second;
  second << m.dot(texel.by_xx), m.dot(texel.by_xy), m.dot(texel.by_xy), m.dot(texel.by_yy);
  jet.curvature = by_at.transpose() * second * by_at;
  const double direction = sign_of(patch.facing);
  jet.coarse_point << at, direction * coarse_height(t, at);
  jet.fine_point = jet.coarse_point + patch.contact_from_body * texel.value;
  jet.coarse_by_at << 1.0, 0.0, 0.0, 1.0, direction * t.height_by_at.transpose();
  Eigen::Matrix<double, 3, 2> by_texel;
  by_texel << patch.contact_from_body * texel.by_x, patch.contact_from_body * texel.by_y;
  jet.fine_by_at = jet.coarse_by_at + by_texel * by_at;
  // The projected tangents of the fine surface have to turn the same way as those of the coarse one.
  jet.is_height_field = jet.fine_by_at.topRows<2>().determinant() > 0.0;
  return jet;
}

}  // namespace

ContactFrame contact_frame(const Vec3& origin, const Vec3& normal) noexcept {
  int smallest = 0;
  for (int k = 1; k < 3; ++k) {
    if (std::fabs(normal[k]) < std::fabs(normal[smallest])) smallest = k;
  }
  const Vec3 u = Vec3::Unit(smallest).cross(normal).normalized();
  ContactFrame frame;
  frame.origin = origin;
  frame.world_from_contact << u, normal.cross(u), normal;
  return frame;
}

void project_patch(const HapticTexture& texture, std::span<const std::int32_t> triangles,
                   const Pose& world_from_body, const ContactFrame& frame, Facing facing,
                   ProjectedPatch& patch, const PlaneBox& over) noexcept {
  patch.texture = &texture;
  patch.facing = facing;
  patch.triangles.clear();
  patch.hidden.clear();
  patch.box = {};
  const double direction = sign_of(facing);
  const Mat3 world_from_axes = world_from_body.orientation.toRotationMatrix();
  patch.contact_from_body = frame.world_from_contact.transpose() * world_from_axes;
  patch.direction_body = direction * patch.contact_from_body.row(2).transpose();
  const Vec3 shift =
      frame.world_from_contact.transpose() * (world_from_body.position - frame.origin);
  for (const std::int32_t index : triangles) {
    const std::size_t i = static_cast<std::size_t>(index);
    std::array<Vec3, 3> p;
    PlaneBox box;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = static_cast<std::size_t>(texture.coarse.triangles[i][k]);
      p[k] = patch.contact_from_body * texture.coarse.positions[corner] + shift;
      box.low = box.low.cwiseMin(p[k].head<2>());
      box.high = box.high.cwiseMax(p[k].head<2>());
    }
    if (!touch(box, over)) continue;
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const double size = normal.norm();
    if (!(size > 0.0)) continue;
    // Cosine between a triangle's normal and the direction below which it counts as seen edge-on. Its height
    // changes by 1 / cosine per length: with the side of a box under a tilt of a tenth of a degree that would be the
    // slope of a contact, and its force sideways.
    constexpr double kEdgeOn = 0.1;
    if (!(direction * normal.z() > kEdgeOn * size)) {
      patch.hidden.push_back(box);
      continue;
    }
    ProjectedTriangle projected = affine_maps(p, texture.corners[i], direction);
    if (!is_finite(projected))
      continue;  // so far from the contact that nothing is left of its shape
    projected.triangle = index;
    const Vec2 slack = 2.0 * kEdgeSlack * (box.high - box.low);
    projected.box = {box.low - slack, box.high + slack};
    patch.triangles.push_back(projected);
    patch.box.low = patch.box.low.cwiseMin(box.low);
    patch.box.high = patch.box.high.cwiseMax(box.high);
  }
}

bool is_height_field(const ProjectedPatch& patch, const PlaneBox& over) noexcept {
  return std::none_of(patch.hidden.begin(), patch.hidden.end(),
                      [&](const PlaneBox& box) { return touch(box, over); });
}

double height_on(const ProjectedPatch& patch, const ProjectedTriangle& t, const Vec2& at) noexcept {
  const Vec3 displacement = displacement_at(*patch.texture, texel_of(t, at));
  return coarse_height(t, at) + patch.direction_body.dot(displacement);
}

double height_at(const ProjectedPatch& patch, const Vec2& at, std::int32_t& near) noexcept {
  if (const ProjectedTriangle* t = first_guess(patch, at, near)) return height_on(patch, *t, at);
  const std::int32_t count = static_cast<std::int32_t>(patch.triangles.size());
  double height = kNoSurface;
  for (std::int32_t i = 0; i < count; ++i) {
    const ProjectedTriangle& t = patch.triangles[static_cast<std::size_t>(i)];
    if (!covers(t, at)) continue;
    const double here = height_on(patch, t, at);
    if (here > height) {
      height = here;
      near = i;
    }
  }
  return height;
}

SurfaceJet surface_jet(const ProjectedPatch& patch, const Vec2& at) noexcept {
  std::int32_t near = -1;
  return surface_jet(patch, at, near);
}

SurfaceJet surface_jet(const ProjectedPatch& patch, const Vec2& at, std::int32_t& near) noexcept {
  if (const ProjectedTriangle* t = first_guess(patch, at, near)) return jet_on(patch, *t, at);
  double height = kNoSurface;
  int sheets = 0;
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    if (!is_in(patch.triangles[i].box, at)) continue;
    const double inside = insideness(patch.triangles[i], at);
    if (inside < -kEdgeSlack) continue;
    sheets += inside > kEdgeSlack;
    const double here = height_on(patch, patch.triangles[i], at);
    if (here > height) {
      height = here;
      near = static_cast<std::int32_t>(i);
    }
  }
  if (height == kNoSurface) return {};
  SurfaceJet jet = jet_on(patch, patch.triangles[static_cast<std::size_t>(near)], at);
  jet.is_height_field = jet.is_height_field && sheets <= 1;
  return jet;
}

}  // namespace thigma
