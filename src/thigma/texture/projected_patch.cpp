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
  const double area = cross(t.at[1] - t.at[0], t.at[2] - t.at[0]);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min(least, cross(t.at[(k + 1) % 3] - t.at[k], at - t.at[k]) / area);
  }
  return least;
}

// Slack of the test whether a point lies on a triangle, of its barycentric coordinates: less would open cracks between
// neighbours by rounding; more only extends a triangle's plane by that share.
constexpr double kEdgeSlack = 1e-9;

bool covers(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return insideness(t, at) >= -kEdgeSlack;
}

bool touch(const PlaneBox& a, const PlaneBox& b) noexcept {
  return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
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
         t.at_by_texel.allFinite() && std::isfinite(t.height_origin) && t.height_by_at.allFinite();
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
                   ProjectedPatch& patch) noexcept {
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
  const std::int32_t count = static_cast<std::int32_t>(patch.triangles.size());
  // Where nothing is hidden one sheet is expected, and the first triangle found is the one.
  if (patch.hidden.empty() && near >= 0 && near < count) {
    const ProjectedTriangle& t = patch.triangles[static_cast<std::size_t>(near)];
    if (covers(t, at)) return height_on(patch, t, at);
  }
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
  SurfaceJet jet;
  std::int32_t on = -1;
  int sheets = 0;
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    const double inside = insideness(patch.triangles[i], at);
    if (inside < -kEdgeSlack) continue;
    sheets += inside > kEdgeSlack;
    const double here = height_on(patch, patch.triangles[i], at);
    if (here > jet.height) {
      jet.height = here;
      on = static_cast<std::int32_t>(i);
    }
  }
  if (on < 0) return jet;
  const ProjectedTriangle& t = patch.triangles[static_cast<std::size_t>(on)];
  const TexelJet texel = texel_jet(*patch.texture, texel_of(t, at));
  const Vec3& m = patch.direction_body;
  const Mat2 by_at = t.texel_by_at;
  jet.is_covered = true;
  jet.slope = t.height_by_at + by_at.transpose() * Vec2(m.dot(texel.by_x), m.dot(texel.by_y));
  jet.facet_slope =
      t.height_by_at + by_at.transpose() * Vec2(m.dot(texel.facet_by_x), m.dot(texel.facet_by_y));
  Mat2 second;
  second << m.dot(texel.by_xx), m.dot(texel.by_xy), m.dot(texel.by_xy), m.dot(texel.by_yy);
  jet.curvature = by_at.transpose() * second * by_at;
  const double direction = sign_of(patch.facing);
  jet.coarse_point << at, direction * coarse_height(t, at);
  jet.fine_point = jet.coarse_point + patch.contact_from_body * texel.value;
  // The projected tangents of the fine surface have to turn the same way as those of the coarse one.
  Mat2 fine_by_texel = t.at_by_texel;
  fine_by_texel.col(0) += (patch.contact_from_body * texel.by_x).head<2>();
  fine_by_texel.col(1) += (patch.contact_from_body * texel.by_y).head<2>();
  const bool is_upright = fine_by_texel.determinant() * t.at_by_texel.determinant() > 0.0;
  jet.is_height_field = is_upright && sheets <= 1;
  return jet;
}

}  // namespace thigma
