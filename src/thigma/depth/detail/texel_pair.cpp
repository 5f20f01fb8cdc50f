#include "thigma/depth/detail/texel_pair.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "thigma/math/plane_cross.h"
#include "thigma/texture/texel_lookup.h"
#include "thigma/texture/texel_vector.h"

namespace thigma::detail {
namespace {

// As in projected_patch: a texel on the edge of two triangles belongs to both.
constexpr double kEdgeSlack = 1e-9;

// The least of direction . way over a box of ways, negated where that is below 0.
double moved_by(const PlaneBox& ways, const Vec2& direction) noexcept {
  return -std::min(
      direction.cwiseProduct(ways.low).cwiseMin(direction.cwiseProduct(ways.high)).sum(), 0.0);
}

// Adds the limit direction . s + offset >= 0 on points s of the plane. ways: how displacements may
// move them.
void add_limit(TexelPair& pair, const Vec2& direction, double offset,
               const PlaneBox& ways) noexcept {
  TexelPair::Limit& limit = pair.limits[static_cast<std::size_t>(pair.limit_count++)];
  limit.normal = pair.at_by_texel.transpose() * direction;
  limit.offset = offset + direction.dot(pair.at_origin);
  limit.reach = limit.normal.lpNorm<1>();
  // The most that a way brings a point further in.
  limit.slack = kEdgeSlack + moved_by({-ways.high, -ways.low}, direction);
}

void add_edges(TexelPair& pair, const ProjectedTriangle& t, const PlaneBox& ways) noexcept {
  const double area = cross(t.at[1] - t.at[0], t.at[2] - t.at[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 edge = t.at[(k + 1) % 3] - t.at[k];
    const Vec2 direction(-edge.y() / area, edge.x() / area);
    add_limit(pair, direction, -direction.dot(t.at[k]), ways);
  }
}

void add_box(TexelPair& pair, const PlaneBox& box, const PlaneBox& ways) noexcept {
  const Vec2 size = box.high - box.low;
  for (int k = 0; k < 2; ++k) {
    const Vec2 direction = Vec2::Unit(k) / size[k];
    add_limit(pair, direction, -box.low[k] / size[k], ways);
    add_limit(pair, -direction, box.high[k] / size[k], ways);
  }
}

// Largest displacement times `by` between texture coordinates low and high.
double largest_between(const HapticTexture& texture, const Vec3& by, const Vec2& low,
                       const Vec2& high) noexcept {
  const Vec2 last(texture.width - 1.0, texture.height - 1.0);
  const Vec2 from = low.cwiseMax(0.0).cwiseMin(last), to = high.cwiseMax(0.0).cwiseMin(last);
  // Cells at least as large as the range: it touches no more than two each way. Level k has cells
  // of 2^(k + 1) texels.
  const unsigned size = static_cast<unsigned>(std::ceil((to - from).maxCoeff()));
  const int level = std::min(std::max(static_cast<int>(std::bit_width(size - (size > 0))) - 1, 0),
                             static_cast<int>(texture.pyramid.size()) - 1);
  const BoundsLevel& bounds = texture.pyramid[static_cast<std::size_t>(level)];
  const auto cell = [&](double at, int count) {
    return std::min(static_cast<int>(at) >> (level + 1), count - 1);
  };
  const int first_column = cell(from.x(), bounds.columns),
            last_column = cell(to.x(), bounds.columns);
  const int first_row = cell(from.y(), bounds.rows), last_row = cell(to.y(), bounds.rows);
  double largest = kNoDepth;
  for (int row = first_row; row <= last_row; ++row) {
    for (int column = first_column; column <= last_column; ++column) {
      const std::size_t i =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(bounds.columns) +
          static_cast<std::size_t>(column);
      largest = std::max(largest, largest_along(by, bounds.cells[i]));
    }
  }
  return largest;
}

// Texture coordinates of the other side: by how much ways along the plane move them.
void add_ways(TexelPair& pair, const ProjectedTriangle& b, const PlaneBox& ways) noexcept {
  for (int k = 0; k < 2; ++k) {
    const Vec2 row = b.texel_by_at.row(k).transpose();
    pair.other_low[k] = -moved_by(ways, row);
    pair.other_high[k] = moved_by({-ways.high, -ways.low}, row);
  }
}

// The box of texels in which both triangles lie.
void add_texel_box(TexelPair& pair, const ProjectedTriangle& a, const ProjectedTriangle& b,
                   const PlaneBox& ways) noexcept {
  PlaneBox own, others;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 of_own = a.texel_origin + a.texel_by_at * a.at[k];
    const Vec2 of_others = a.texel_origin + a.texel_by_at * b.at[k];
    own = {own.low.cwiseMin(of_own), own.high.cwiseMax(of_own)};
    others = {others.low.cwiseMin(of_others), others.high.cwiseMax(of_others)};
  }
  for (int k = 0; k < 2; ++k) {
    const Vec2 row = a.texel_by_at.row(k).transpose();
    others.low[k] -= moved_by({-ways.high, -ways.low}, row);
    others.high[k] += moved_by(ways, row);
  }
  pair.low = own.low.cwiseMax(others.low);
  pair.high = own.high.cwiseMin(others.high);
}

bool is_within(const TexelPair& pair, const Vec2& t) noexcept {
  for (int k = 0; k < pair.own_count; ++k) {
    const TexelPair::Limit& limit = pair.limits[static_cast<std::size_t>(k)];
    if (limit.normal.dot(t) + limit.offset < -kEdgeSlack) return false;
  }
  return true;
}

}  // namespace

TexelPair make_texel_pair(const PatchTriangle& driver_side, const PatchTriangle& other_side,
                          const PlaneBox& box, bool is_bounded) noexcept {
  const ProjectedPatch &driver = driver_side.patch, &other = other_side.patch;
  const ProjectedTriangle &a = driver_side.triangle, &b = other_side.triangle;
  TexelPair pair;
  pair.driver = &driver;
  pair.other = &other;
  pair.driver_triangle = a.triangle;
  pair.other_triangle = b.triangle;
  pair.under = &b;
  pair.box = is_bounded ? box : kWholePlane;
  pair.at_origin = a.at_origin;
  pair.at_by_texel = a.at_by_texel;
  pair.other_by_texel = b.texel_by_at * a.at_by_texel;
  pair.other_origin = b.texel_origin + b.texel_by_at * a.at_origin;
  const Vec2 by_at = a.height_by_at + b.height_by_at;
  pair.height_by_texel = a.at_by_texel.transpose() * by_at;
  pair.height_reach = pair.height_by_texel.lpNorm<1>();
  pair.other_reach = pair.other_by_texel.cwiseAbs().rowwise().sum();
  pair.height_origin = a.height_origin + b.height_origin + by_at.dot(a.at_origin);
  // The fine point of the driver lies its displacement aside of its coarse one, where the other
  // triangle is higher by its slope; the other side's coarse point lies its own displacement before
  // that.
  pair.own_by =
      driver.direction_body + driver.contact_from_body.topRows<2>().transpose() * b.height_by_at;
  pair.others_by =
      other.direction_body - other.contact_from_body.topRows<2>().transpose() * b.height_by_at;
  const PlaneBox ways{driver.sideways.low - other.sideways.high,
                      driver.sideways.high - other.sideways.low};
  const PlaneBox none{Vec2::Zero(), Vec2::Zero()};
  add_edges(pair, a, none);
  pair.own_count = pair.limit_count;
  add_edges(pair, b, ways);
  if (is_bounded) add_box(pair, box, driver.sideways);
  add_ways(pair, b, ways);
  add_texel_box(pair, a, b, ways);
  return pair;
}

CellBound upper_bound(const TexelPair& pair, const TexelCell& cell, double others,
                      double floor) noexcept {
  const HapticTexture& texture = *pair.driver->texture;
  // Cells at the far border of the map are bounded as if they were whole.
  const double half = 0.5 * static_cast<double>(1 << cell.level);
  const Vec2 centre = 2.0 * half * Vec2(cell.column + 0.5, cell.row + 0.5);
  const BoundsLevel& bounds = texture.pyramid[static_cast<std::size_t>(cell.level - 1)];
  const std::size_t i =
      static_cast<std::size_t>(cell.row) * static_cast<std::size_t>(bounds.columns) +
      static_cast<std::size_t>(cell.column);
  const double own = pair.height_origin + pair.height_by_texel.dot(centre) +
                     half * pair.height_reach + largest_along(pair.own_by, bounds.cells[i]);
  if (!(own + others > floor)) return {};
  for (int k = 0; k < pair.limit_count; ++k) {
    const TexelPair::Limit& limit = pair.limits[static_cast<std::size_t>(k)];
    const double nearest = limit.normal.dot(centre) + half * limit.reach + limit.offset;
    if (nearest < -limit.slack) return {};
  }
  const Vec2 other_centre = pair.other_origin + pair.other_by_texel * centre;
  const Vec2 other_half = half * pair.other_reach;
  others = std::min(others, largest_between(*pair.other->texture, pair.others_by,
                                            other_centre - other_half + pair.other_low,
                                            other_centre + other_half + pair.other_high));
  return {own + others, others};
}

TexelDepth depth_at_texel(const TexelPair& pair, int column, int row) noexcept {
  const Vec2 t(column, row);
  if (!is_within(pair, t)) return {};
  const Texel& texel = texel_at(*pair.driver->texture, column, row);
  const Vec3 own = texel_vector(texel).head<3>();
  const Vec2 coarse = pair.at_origin + pair.at_by_texel * t;
  const Vec2 at = coarse + pair.driver->contact_from_body.topRows<2>() * own;
  if (!(at.array() >= pair.box.low.array()).all() || !(at.array() <= pair.box.high.array()).all())
    return {};
  Vec2 place;
  if (!find_below(*pair.other, *pair.under, at, place)) return {};
  const Vec2 from = pair.under->texel_origin + pair.under->texel_by_at * place;
  const Vec3 others = displacement_at(*pair.other->texture, from);
  return {pair.height_origin + pair.height_by_texel.dot(t) + pair.own_by.dot(own) +
              pair.others_by.dot(others),
          at};
}

TexelRange texels_of(const HapticTexture& texture, const TexelCell& cell) noexcept {
  const BoundsLevel& bounds = texture.pyramid[static_cast<std::size_t>(cell.level - 1)];
  const int side = 1 << cell.level;
  TexelRange range{cell.column * side, (cell.column + 1) * side - 1, cell.row * side,
                   (cell.row + 1) * side - 1};
  if (cell.column == bounds.columns - 1) range.last_column = texture.width - 1;
  if (cell.row == bounds.rows - 1) range.last_row = texture.height - 1;
  return range;
}

}  // namespace thigma::detail
