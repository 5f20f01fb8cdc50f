#include "thigma/depth/projected_patch.h"

#include <algorithm>
#include <cmath>

#include "thigma/depth/detail/inside_triangle.h"
#include "thigma/math/plane_cross.h"
#include "thigma/texture/texel_lookup.h"
#include "thigma/texture/texel_vector.h"

namespace thigma {
namespace {

double sign_of(Facing facing) noexcept { return facing == Facing::along ? 1.0 : -1.0; }

using detail::insideness;
using detail::kEdgeSlack;

bool covers(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return contains(t.box, at) && detail::covers(t, at);
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

// The point of a triangle nearest to one beside it.
Vec2 nearest_on(const ProjectedTriangle& t, const Vec2& p) noexcept {
  Vec2 best = t.at[0];
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 way = t.at[(k + 1) % 3] - t.at[k];
    const double share = std::clamp(way.dot(p - t.at[k]) / way.squaredNorm(), 0.0, 1.0);
    const Vec2 here = t.at[k] + share * way;
    const double distance = (p - here).squaredNorm();
    if (!(distance < least)) continue;
    least = distance;
    best = here;
  }
  return best;
}

// How far within a triangle a place counts as on it when it was found to kClose: no crack between
// neighbours.
constexpr double kClose = 1e-9;  // of the size of the triangle's box
constexpr double kFoundSlack = 1e-7;

// The least barycentric coordinates that a place on a triangle, moved sideways within a box, can
// have.
std::array<double, 3> least_coordinates(const ProjectedTriangle& t,
                                        const PlaneBox& sideways) noexcept {
  std::array<double, 3> least;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2& e = t.edges[k];
    least[k] = std::min(e.x() * sideways.low.y(), e.x() * sideways.high.y()) +
               std::min(-e.y() * sideways.low.x(), -e.y() * sideways.high.x()) - 2.0 * kFoundSlack;
  }
  return least;
}

// Whether a fine point of a triangle may lie over a place.
bool may_cover(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return contains(t.fine, at) && cross(t.edges[0], at - t.at[0]) >= t.least[0] &&
         cross(t.edges[1], at - t.at[1]) >= t.least[1] &&
         cross(t.edges[2], at - t.at[2]) >= t.least[2];
}

// What a displacement moves along the plane.
Vec2 sideways_by(const ProjectedPatch& patch, const Vec3& d) noexcept {
  const Mat3& m = patch.contact_from_body;
  return Vec2(m(0, 0) * d.x() + m(0, 1) * d.y() + m(0, 2) * d.z(),
              m(1, 0) * d.x() + m(1, 1) * d.y() + m(1, 2) * d.z());
}

Mat2 by_texel(const Vec3& x, const Vec3& y, const ProjectedPatch& patch) noexcept {
  Mat2 along;
  along.col(0) = sideways_by(patch, x);
  along.col(1) = sideways_by(patch, y);
  return along;
}

enum class Found : std::uint8_t {
  on,      // a place on the triangle
  beside,  // one beside it: the nearest of its edge stands in
  none,    // the fine surface turns over on the way
};

/// A place of a triangle's plane whose fine point lies over a point; `none`: the point itself.
struct Below {
  std::int32_t triangle = -1;
  Vec2 place = Vec2::Zero();
  Found found = Found::none;
};

// place: where it starts and ends.
Found look_below(const ProjectedPatch& patch, const ProjectedTriangle& t, const Vec2& at,
                 Vec2& place) noexcept {
  constexpr int kMostSteps = 12;
  const double close = kClose * (t.box.high - t.box.low).lpNorm<1>();
  for (int k = 0; k < kMostSteps; ++k) {
    // Beside the triangle texels are of others: its nearest point stands in. The way there gets no
    // longer by that.
    const bool is_on = insideness(t, place) >= 0.0;
    const TexelFacet facet =
        texel_facet(*patch.texture, texel_of(t, is_on ? place : nearest_on(t, place)));
    const Vec2 lack = at - place - sideways_by(patch, facet.value);
    if (lack.lpNorm<1>() <= close)
      return insideness(t, place) >= -kFoundSlack ? Found::on : Found::beside;
    if (!is_on) {
      place += lack;
      continue;
    }
    const Mat2 moves = Mat2::Identity() + by_texel(facet.by_x, facet.by_y, patch) * t.texel_by_at;
    const double turn = moves.determinant();
    constexpr double kTurnsOver = 0.05;  // of the area: nearly edge-on
    if (!(turn > kTurnsOver)) return Found::none;
    place += Vec2(cross(lack, moves.col(1)), cross(moves.col(0), lack)) / turn;
  }
  return Found::none;
}

double height_below(const ProjectedPatch& patch, const Below& below, const Vec2& at) noexcept {
  const ProjectedTriangle& t = projected_triangle(patch, below.triangle);
  if (below.found == Found::none) return height_on(patch, t, at);
  const Vec2 on = below.found == Found::on ? below.place : nearest_on(t, below.place);
  return coarse_height(t, on) +
         patch.direction_body.dot(displacement_at(*patch.texture, texel_of(t, on)));
}

// Where no fine point of the patch lies over a point: that of a triangle around, the highest.
Below highest_around(const ProjectedPatch& patch, const Vec2& at, int& sheets) noexcept {
  Below best;
  double highest = kNoSurface;
  for (std::size_t i = 0; i < patch.around.size(); ++i) {
    const ProjectedTriangle& t = patch.around[i];
    Below here{static_cast<std::int32_t>(patch.triangles.size() + i), at, Found::on};
    if (!may_cover(t, at) || !find_below(patch, t, at, here.place)) continue;
    sheets += insideness(t, here.place) > kFoundSlack;
    const double height = height_below(patch, here, at);
    if (!(height > highest)) continue;
    highest = height;
    best = here;
  }
  return best;
}

// Where none of those around does either: the highest of the coarse triangles there, by the nearest
// fine point of their edge where the fine surface ends, else to first order.
Below highest_coarse(const ProjectedPatch& patch, const Vec2& at, int& sheets) noexcept {
  Below best;
  double highest = kNoSurface;
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    if (!covers(patch.triangles[i], at)) continue;
    sheets += insideness(patch.triangles[i], at) > kEdgeSlack;
    Below here{static_cast<std::int32_t>(i), at, Found::none};
    here.found = look_below(patch, patch.triangles[i], at, here.place);
    const double height = height_below(patch, here, at);
    if (!(height > highest)) continue;
    highest = height;
    best = here;
  }
  return best;
}

// The highest sheet over a point; sheets: how many there are, counted only where not the first is
// taken.
Below find_highest(const ProjectedPatch& patch, const Vec2& at, const SurfaceFoot& foot,
                   int& sheets) noexcept {
  Below best;
  sheets = 1;
  const std::int32_t near = foot.triangle;
  bool is_tried = false;  // from the place itself, as the others are
  const bool has_guess = near >= 0 && near < static_cast<std::int32_t>(patch.triangles.size());
  if (has_guess && may_cover(patch.triangles[static_cast<std::size_t>(near)], at)) {
    best.place = at + foot.aside;
    if (look_below(patch, patch.triangles[static_cast<std::size_t>(near)], at, best.place) ==
        Found::on)
      return {near, best.place, Found::on};
    best = {};
    is_tried = foot.aside.isZero();
  }
  sheets = 0;
  double highest = kNoSurface;
  for (std::size_t i = 0; i < patch.triangles.size(); ++i) {
    const ProjectedTriangle& t = patch.triangles[i];
    if (!may_cover(t, at) || (is_tried && static_cast<std::int32_t>(i) == near)) continue;
    Below here{static_cast<std::int32_t>(i), at, Found::on};
    if (!find_below(patch, t, at, here.place)) continue;
    sheets += insideness(t, here.place) > kFoundSlack;
    const double height = height_below(patch, here, at);
    if (!(height > highest)) continue;
    highest = height;
    best = here;
  }
  return best;
}

// Where no fine point of the patch lies over a point. Nothing where no coarse triangle does.
Below find_beside(const ProjectedPatch& patch, const Vec2& at, int& sheets) noexcept {
  if (!patch.around.empty() &&
      std::any_of(patch.triangles.begin(), patch.triangles.end(),
                  [&](const ProjectedTriangle& t) { return covers(t, at); })) {
    const Below around = highest_around(patch, at, sheets);
    if (around.triangle >= 0) return around;
  }
  return highest_coarse(patch, at, sheets);
}

SurfaceFoot foot_of(const Below& below, const Vec2& at) noexcept {
  return {below.triangle, below.found == Found::on ? Vec2(below.place - at) : Vec2(Vec2::Zero())};
}

// Slope over the plane of what rises by `rises` a texel while it moves by `moves`.
Vec2 slope_of(const Mat2& moves, const Vec2& rises) noexcept {
  return moves.transpose().inverse() * rises;
}

Mat2 second_of(const Vec3& m, const TexelJet& texel) noexcept {
  Mat2 second;
  second << m.dot(texel.by_xx), m.dot(texel.by_xy), m.dot(texel.by_xy), m.dot(texel.by_yy);
  return second;
}

// What a triangle of a patch shows at a point. The fine point moves by `moves` a texel and rises by
// `rises`.
SurfaceJet jet_below(const ProjectedPatch& patch, const Below& below, const Vec2& at) noexcept {
  const ProjectedTriangle& t = projected_triangle(patch, below.triangle);
  const bool is_on = below.found == Found::on;
  const Vec2 on = below.found == Found::beside ? nearest_on(t, below.place) : below.place;
  const TexelJet texel = texel_jet(*patch.texture, texel_of(t, on));
  const Vec3& m = patch.direction_body;
  const Vec2 coarse = t.at_by_texel.transpose() * t.height_by_at;
  SurfaceJet jet;
  jet.is_covered = true;
  const Mat2 moves = t.at_by_texel + by_texel(texel.by_x, texel.by_y, patch),
             facet_moves = t.at_by_texel + by_texel(texel.facet_by_x, texel.facet_by_y, patch);
  // The projected tangents of the fine surface have to turn the same way as those of the coarse
  // one.
  const double turn = t.at_by_texel.determinant();
  const bool is_upright = moves.determinant() * turn > 0.0;
  if (is_on && is_upright && facet_moves.determinant() * turn > 0.0) {
    jet.height = coarse_height(t, below.place) + m.dot(texel.value);
    jet.slope = slope_of(moves, coarse + Vec2(m.dot(texel.by_x), m.dot(texel.by_y)));
    jet.facet_slope =
        slope_of(facet_moves, coarse + Vec2(m.dot(texel.facet_by_x), m.dot(texel.facet_by_y)));
    const Vec3 off = m - patch.contact_from_body.topRows<2>().transpose() * jet.slope;
    const Mat2 back = moves.inverse();
    jet.curvature = back.transpose() * second_of(off, texel) * back;
  } else {
    const Vec3& e = t.carried;
    jet.is_height_field = is_upright && below.found == Found::beside;
    jet.height = height_below(patch, below, at);
    const Mat2& by_at = t.texel_by_at;
    jet.slope = t.height_by_at + by_at.transpose() * Vec2(e.dot(texel.by_x), e.dot(texel.by_y));
    jet.facet_slope =
        t.height_by_at + by_at.transpose() * Vec2(e.dot(texel.facet_by_x), e.dot(texel.facet_by_y));
    jet.curvature = by_at.transpose() * second_of(e, texel) * by_at;
  }
  jet.point << at, sign_of(patch.facing) * jet.height;
  return jet;
}

// The height that a displacement adds where it stays on the plane of its triangle, at most as on
// one of 45 degrees: beyond, triangles end before the displacement does.
Vec3 carried_by(const ProjectedTriangle& t, const ProjectedPatch& patch) noexcept {
  const double steep = t.height_by_at.norm();
  const Vec2 rise = steep > 1.0 ? Vec2(t.height_by_at / steep) : t.height_by_at;
  return patch.direction_body - patch.contact_from_body.topRows<2>().transpose() * rise;
}

const TexelBounds& bounds_under(const HapticTexture& texture, std::int32_t triangle) noexcept {
  return texture.under.empty() ? texture.pyramid.back().cells.front()
                               : texture.under[static_cast<std::size_t>(triangle)];
}

// Bounds of what displacements within bounds move along the plane.
PlaneBox sideways_of(const TexelBounds& bounds, const Mat3& contact_from_body) noexcept {
  const Vec3 low = detail::texel_vector(bounds.low).head<3>(),
             high = detail::texel_vector(bounds.high).head<3>();
  PlaneBox box{Vec2::Zero(), Vec2::Zero()};
  for (int k = 0; k < 2; ++k) {
    const Vec3 way = contact_from_body.row(k).transpose();
    box.low[k] = way.cwiseProduct(low).cwiseMin(way.cwiseProduct(high)).sum();
    box.high[k] = way.cwiseProduct(low).cwiseMax(way.cwiseProduct(high)).sum();
  }
  return box;
}

// A triangle's corners in the contact frame.
struct Corners {
  std::array<Vec3, 3> at;
  PlaneBox box;
};

Corners corners_of(const ProjectedPatch& patch, std::int32_t triangle) noexcept {
  const TriangleMesh& coarse = patch.texture->coarse;
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t v = coarse.triangles[static_cast<std::size_t>(triangle)][k];
    corners.at[k] =
        patch.contact_from_body * coarse.positions[static_cast<std::size_t>(v)] + patch.shift;
    corners.box.low = corners.box.low.cwiseMin(corners.at[k].head<2>());
    corners.box.high = corners.box.high.cwiseMax(corners.at[k].head<2>());
  }
  return corners;
}

// Whether a triangle lies over a box, or its fine surface may.
bool may_reach(const ProjectedPatch& patch, const PlaneBox& box, const PlaneBox& over) noexcept {
  return overlap(box, over) ||
         overlap(box, {over.low - patch.sideways.high, over.high - patch.sideways.low});
}

enum class Seen : std::uint8_t {
  facing,
  hidden,  // looks the other way, or is seen edge-on
  has_no_area,
};

Seen seen(const ProjectedPatch& patch, const Corners& corners) noexcept {
  // Cosine between a triangle's normal and the direction below which it counts as seen edge-on. Its
  // height changes by 1 / cosine per length: with the side of a box under a tilt of a tenth of a
  // degree that would be the slope of a contact, and its force sideways.
  constexpr double kEdgeOn = 0.1;
  const Vec3 normal = (corners.at[1] - corners.at[0]).cross(corners.at[2] - corners.at[0]);
  const double size = normal.norm();
  if (!(size > 0.0)) return Seen::has_no_area;
  return sign_of(patch.facing) * normal.z() > kEdgeOn * size ? Seen::facing : Seen::hidden;
}

// Where a patch lies and which way it looks; no triangles yet.
void place_patch(const TexturedPatch& side, const ContactFrame& frame, Facing facing,
                 ProjectedPatch& patch) noexcept {
  const Pose& world_from_body = side.world_from_body;
  patch.texture = side.texture;
  patch.facing = facing;
  const Mat3 world_from_axes = world_from_body.orientation.toRotationMatrix();
  patch.contact_from_body = frame.world_from_contact.transpose() * world_from_axes;
  patch.direction_body = sign_of(facing) * patch.contact_from_body.row(2).transpose();
  patch.shift = frame.world_from_contact.transpose() * (world_from_body.position - frame.origin);
}

void add_box(PlaneBox& box, const Corners& corners) noexcept {
  box.low = box.low.cwiseMin(corners.box.low);
  box.high = box.high.cwiseMax(corners.box.high);
}

double highest(const ProjectedPatch& patch, const Corners& c) noexcept {
  const double direction = sign_of(patch.facing);
  return std::max({direction * c.at[0].z(), direction * c.at[1].z(), direction * c.at[2].z()});
}

// A triangle that faces; false for one so far from the contact that nothing is left of its shape.
bool project_triangle(const ProjectedPatch& patch, const Corners& corners, std::int32_t index,
                      ProjectedTriangle& projected) noexcept {
  const auto& texels = patch.texture->corners[static_cast<std::size_t>(index)];
  projected = affine_maps(corners.at, texels, sign_of(patch.facing));
  if (!is_finite(projected)) return false;
  projected.triangle = index;
  projected.carried = carried_by(projected, patch);
  const Vec2 slack = 2.0 * kEdgeSlack * (corners.box.high - corners.box.low);
  projected.box = {corners.box.low - slack, corners.box.high + slack};
  const PlaneBox sideways =
      sideways_of(bounds_under(*patch.texture, index), patch.contact_from_body);
  projected.least = least_coordinates(projected, sideways);
  projected.fine = {projected.box.low + sideways.low, projected.box.high + sideways.high};
  return true;
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

void project_patch(const TexturedPatch& side, const ContactFrame& frame, Facing facing,
                   ProjectedPatch& patch, const PlaneBox& over) noexcept {
  patch.triangles.clear();
  patch.around.clear();
  patch.hidden.clear();
  // As much of a side may reach the box another time.
  patch.triangles.reserve(side.triangles.size());
  patch.around.reserve(side.around.size());
  patch.hidden.reserve(side.triangles.size());
  patch.box = {};
  place_patch(side, frame, facing, patch);
  patch.sideways = sideways_of(side.texture->pyramid.back().cells.front(), patch.contact_from_body);
  ProjectedTriangle projected;
  for (const std::int32_t index : side.triangles) {
    const Corners corners = corners_of(patch, index);
    if (!may_reach(patch, corners.box, over)) continue;
    const Seen as = seen(patch, corners);
    if (as == Seen::hidden) {
      patch.hidden.push_back({corners.box, highest(patch, corners), index});
    } else if (as == Seen::facing && project_triangle(patch, corners, index, projected)) {
      patch.triangles.push_back(projected);
      add_box(patch.box, corners);
    }
  }
  const PlaneBox own = intersection(patch.box, over);
  for (const std::int32_t index : side.around) {
    const Corners corners = corners_of(patch, index);
    if (!may_reach(patch, corners.box, own) || seen(patch, corners) != Seen::facing) continue;
    if (project_triangle(patch, corners, index, projected) && overlap(projected.fine, own))
      patch.around.push_back(projected);
  }
}

PlaneBox patch_box(const TexturedPatch& side, const ContactFrame& frame, Facing facing) noexcept {
  ProjectedPatch patch;
  place_patch(side, frame, facing, patch);
  PlaneBox box;
  for (const std::int32_t index : side.triangles) {
    const Corners corners = corners_of(patch, index);
    if (seen(patch, corners) == Seen::facing) add_box(box, corners);
  }
  return box;
}

bool is_height_field(const ProjectedPatch& patch, const PlaneBox& over) noexcept {
  return std::none_of(patch.hidden.begin(), patch.hidden.end(),
                      [&](const HiddenTriangle& hidden) { return overlap(hidden.box, over); });
}

bool is_overhung(const ProjectedPatch& patch, const Vec2& at, double height,
                 double within) noexcept {
  const Vec2 around = Vec2::Constant(within);
  const PlaneBox over{at - around, at + around};
  return std::any_of(patch.hidden.begin(), patch.hidden.end(), [&](const HiddenTriangle& hidden) {
    return hidden.highest > height + within && overlap(hidden.box, over);
  });
}

double height_on(const ProjectedPatch& patch, const ProjectedTriangle& t, const Vec2& at) noexcept {
  return coarse_height(t, at) + t.carried.dot(displacement_at(*patch.texture, texel_of(t, at)));
}

double most_relief(const ProjectedPatch& patch, const ProjectedTriangle& t) noexcept {
  return detail::largest_along(t.carried, bounds_under(*patch.texture, t.triangle));
}

bool find_below(const ProjectedPatch& patch, const ProjectedTriangle& t, const Vec2& at,
                Vec2& place) noexcept {
  place = at;
  return look_below(patch, t, at, place) == Found::on;
}

double height_at(const ProjectedPatch& patch, const Vec2& at, std::int32_t& near) noexcept {
  SurfaceFoot foot{near};
  const double height = height_at(patch, at, foot);
  near = foot.triangle;
  return height;
}

double height_at(const ProjectedPatch& patch, const Vec2& at, SurfaceFoot& near) noexcept {
  int sheets = 0;
  Below below = find_highest(patch, at, near, sheets);
  if (below.triangle < 0) below = find_beside(patch, at, sheets);
  // A height to first order may be above all that is there: no place to climb to.
  if (below.triangle < 0 || below.found == Found::none) return kNoSurface;
  near = foot_of(below, at);
  return height_below(patch, below, at);
}

SurfaceJet surface_jet(const ProjectedPatch& patch, const Vec2& at) noexcept {
  SurfaceFoot near;
  return surface_jet(patch, at, near);
}

SurfaceJet surface_jet(const ProjectedPatch& patch, const Vec2& at, SurfaceFoot& near) noexcept {
  int sheets = 0;
  Below below = find_highest(patch, at, near, sheets);
  if (below.triangle < 0) below = find_beside(patch, at, sheets);
  if (below.triangle < 0) return {};
  near = foot_of(below, at);
  SurfaceJet jet = jet_below(patch, below, at);
  jet.is_height_field = jet.is_height_field && sheets <= 1;
  return jet;
}

}  // namespace thigma
