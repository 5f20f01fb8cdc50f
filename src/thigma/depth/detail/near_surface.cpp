#include "thigma/depth/detail/near_surface.h"

#include <algorithm>

#include "thigma/core/index.h"
#include "thigma/depth/detail/inside_triangle.h"
#include "thigma/math/plane_cross.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma::detail {
namespace {

// Of a texel: a fine point this far beside the place is corrected along its facet.
constexpr double kClose = 1e-3;

constexpr double kTurnsOver = 0.05;  // of the area: nearly edge-on, left to find_below

bool may_cover(const ProjectedTriangle& t, const Vec2& at) noexcept {
  return contains(t.fine, at) && cross(t.edges[0], at - t.at[0]) >= t.least[0] &&
         cross(t.edges[1], at - t.at[1]) >= t.least[1] &&
         cross(t.edges[2], at - t.at[2]) >= t.least[2];
}

/// The displacements over a cell of texels in the contact frame, along u, v and the facing
/// direction: first + x right + y down + x y twist, x and y from its first texel [m].
struct TurnedCell {
  Eigen::Vector4f first, right, down, twist;
  Vec2 at = Vec2::Zero();  // the place asked for, from the first texel
};

/// Along the plane.
Vec2 sideways(const Eigen::Vector4f& v) noexcept { return v.head<2>().cast<double>(); }
double upwards(const Eigen::Vector4f& v) noexcept { return static_cast<double>(v[2]); }

TurnedCell cell_at(const NearSurface& s, const Vec2& texel) noexcept {
  const HapticTexture& texture = *s.patch->texture;
  const double x = texel.x() > 0.0 ? std::min(texel.x(), texture.width - 1.0) : 0.0;
  const double y = texel.y() > 0.0 ? std::min(texel.y(), texture.height - 1.0) : 0.0;
  const int column = static_cast<int>(x), row = static_cast<int>(y);
  const auto load = [](const Texel& t) {
    return Eigen::Vector4f(Eigen::Map<const Eigen::Vector4f, Eigen::Aligned16>(&t.x));
  };
  const Texel* const top = &texel_at(texture, column, row);
  const Texel* const bottom = top + texture.width + 1;
  const Eigen::Vector4f first = load(top[0]), right = load(top[1]) - first,
                        down = load(bottom[0]) - first,
                        twist = load(bottom[1]) - load(top[1]) - down;
  const auto turned = [&](const Eigen::Vector4f& v) {
    return Eigen::Vector4f(v[0] * s.turn[0] + v[1] * s.turn[1] + v[2] * s.turn[2]);
  };
  return {turned(first), turned(right), turned(down), turned(twist), {x - column, y - row}};
}

double height_of(const NearSurface& s, const ProjectedTriangle& t, const Vec2& place) noexcept {
  const Vec2 texel = t.texel_origin + t.texel_by_at * place;
  return t.height_origin + t.height_by_at.dot(place) +
         s.patch->direction_body.dot(displacement_at(*s.patch->texture, texel));
}

/// A point of a triangle near one beside it.
Vec2 clamped(const ProjectedTriangle& t, const Vec2& at) noexcept {
  double share[3], sum = 0.0;  // of the corner across each edge
  for (std::size_t k = 0; k < 3; ++k)
    sum += share[k] = std::max(cross(t.edges[k], at - t.at[k]), 0.0);
  return (share[0] * t.at[2] + share[1] * t.at[0] + share[2] * t.at[1]) / sum;
}

/// Barycentric coordinates that a way may change, at most.
double coordinates_of(const ProjectedTriangle& t, double way) noexcept {
  return way * std::max({t.edges[0].lpNorm<1>(), t.edges[1].lpNorm<1>(), t.edges[2].lpNorm<1>()});
}

double height_by_find(const NearSurface& s, const ProjectedTriangle& t, const Vec2& at,
                      SurfaceFoot& foot) noexcept {
  Vec2 place;
  if (!find_below(*s.patch, t, at, place)) return kNoSurface;
  foot.aside = place - at;
  return height_of(s, t, place);
}

enum class Look : std::uint8_t { found, elsewhere, turns_over };

/// Looks within a cell for the coarse point whose fine one lies over a place; elsewhere: in another
/// cell, further on from there.
///
/// place   where it starts and ends
/// relief  what the displacement adds to the height
Look look_in_cell(const TurnedCell& cell, const ProjectedTriangle& t, const Vec2& at, double close,
                  Vec2& place, double& relief) noexcept {
  constexpr int kSteps = 6;
  const Vec2 first = sideways(cell.first), right = sideways(cell.right), down = sideways(cell.down),
             twist = sideways(cell.twist);
  Vec2 a = cell.at;
  for (int k = 0; k < kSteps; ++k) {
    const Vec2 by_x = right + a.y() * twist;
    const Vec2 lack = at - place - (first + a.y() * down + a.x() * by_x);
    Mat2 by_texel;
    by_texel << by_x, down + a.x() * twist;
    const Mat2 moves = Mat2::Identity() + by_texel * t.texel_by_at;
    const double turn = moves.determinant();
    if (!(turn > kTurnsOver)) return Look::turns_over;
    const Vec2 step = Vec2(cross(lack, moves.col(1)), cross(moves.col(0), lack)) / turn;
    place += step;
    a += t.texel_by_at * step;
    if (step.lpNorm<1>() <= close) {
      relief = upwards(cell.first) + a.y() * upwards(cell.down) +
               a.x() * (upwards(cell.right) + a.y() * upwards(cell.twist));
      return Look::found;
    }
    if (!((a.array() >= 0.0).all() && (a.array() <= 1.0).all())) break;
  }
  return Look::elsewhere;
}

/// Height of a triangle's fine surface over a place; kNoSurface where it does not lie. Where that
/// is hard to tell find_below does.
double height_over(const NearSurface& s, const ProjectedTriangle& t, const Vec2& at,
                   SurfaceFoot& foot) noexcept {
  constexpr int kSteps = 6;
  Vec2 place = at + foot.aside;
  for (int k = 0; k < kSteps; ++k) {
    const double inside = insideness(t, place);
    const bool is_on = inside >= 0.0;
    const TurnedCell cell =
        cell_at(s, t.texel_origin + t.texel_by_at * (is_on ? place : clamped(t, place)));
    if (!is_on) {
      const Vec2& a = cell.at;
      const Vec2 lack = at - place -
                        sideways(cell.first + static_cast<float>(a.y()) * cell.down +
                                 static_cast<float>(a.x()) *
                                     (cell.right + static_cast<float>(a.y()) * cell.twist));
      if (lack.lpNorm<1>() <= s.close && inside < -coordinates_of(t, 2.0 * s.close))
        return kNoSurface;
      place += lack;
      continue;
    }
    double relief = 0.0;
    const Look look = look_in_cell(cell, t, at, s.close, place, relief);
    if (look == Look::elsewhere) continue;
    if (look == Look::turns_over || insideness(t, place) < 0.0) break;
    foot.aside = place - at;
    return t.height_origin + t.height_by_at.dot(place) + relief;
  }
  return height_by_find(s, t, at, foot);
}

}  // namespace

void bind_surface(const ProjectedPatch& patch, NearSurface& surface) noexcept {
  surface.patch = &patch;
  surface.triangles.clear();
  surface.triangles.reserve(patch.triangles.capacity());
  surface.close = kClose * patch.texture->texel_size;
  const float sign = patch.facing == Facing::along ? 1.0f : -1.0f;
  for (int k = 0; k < 3; ++k) {
    const Eigen::Vector3f column = patch.contact_from_body.col(k).cast<float>();
    surface.turn[idx(k)] = {column[0], column[1], sign * column[2], 0.0f};
  }
}

void look_over(const PlaneBox& box, NearSurface& surface) noexcept {
  surface.triangles.clear();
  const auto& all = surface.patch->triangles;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (overlap(all[i].fine, box) || overlap(all[i].box, box))
      surface.triangles.push_back(static_cast<std::int32_t>(i));
}

double height_near(const NearSurface& surface, const Vec2& at, SurfaceFoot& foot) noexcept {
  const ProjectedPatch& patch = *surface.patch;
  const std::int32_t known = foot.triangle;
  if (known >= 0 && idx(known) < patch.triangles.size() &&
      may_cover(patch.triangles[idx(known)], at)) {
    const double height = height_over(surface, patch.triangles[idx(known)], at, foot);
    if (height != kNoSurface) return height;
  }
  double highest = kNoSurface;
  SurfaceFoot best;
  for (const std::int32_t i : surface.triangles) {
    if (i == known || !may_cover(patch.triangles[idx(i)], at)) continue;
    SurfaceFoot here{i, foot.aside};
    const double height = height_over(surface, patch.triangles[idx(i)], at, here);
    if (height > highest) highest = height, best = here;
  }
  if (highest == kNoSurface) {
    const bool is_covered =
        std::any_of(surface.triangles.begin(), surface.triangles.end(),
                    [&](std::int32_t i) { return covers(patch.triangles[idx(i)], at); });
    if (!is_covered) return kNoSurface;
    // Of a neighbour of the patch, or beside its end.
    foot.aside.setZero();
    return height_at(patch, at, foot.triangle);
  }
  foot = best;
  return highest;
}

}  // namespace thigma::detail
