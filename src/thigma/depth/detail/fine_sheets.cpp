// A line along the contact's normal through the displaced texels of a triangle: cells of the
// pyramid say where it may meet them, and between four texels it is met in closed form. Nothing
// here asks which way the coarse triangle lies.
#include "thigma/depth/detail/fine_sheets.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/depth/detail/climb.h"
#include "thigma/depth/detail/inside_triangle.h"
#include "thigma/math/infinity.h"
#include "thigma/math/plane_cross.h"
#include "thigma/texture/texel_vector.h"

namespace thigma::detail {
namespace {

// Of the side of a facet: less would leave cracks.
constexpr double kSlack = 1e-9;

/// The line, and the highest place of one triangle's fine surface on it.
class SheetLine {
 public:
  SheetLine(const ProjectedPatch& patch, const Vec2& at, double highest) noexcept
      : patch_(patch), texture_(*patch.texture), at_(at), highest_(highest) {
    turn_ = patch.contact_from_body;
    turn_.row(2) = patch.direction_body.transpose();
  }

  /// Raises the highest place to that of a triangle where it is above.
  void meet(std::int32_t triangle) noexcept {
    const auto& vertices = texture_.coarse.triangles[idx(triangle)];
    corners_ = texture_.corners[idx(triangle)];
    std::array<Vec3, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = patch_.contact_from_body * texture_.coarse.positions[idx(vertices[k])] + patch_.shift;
      if (patch_.facing == Facing::against) p[k].z() = -p[k].z();
    }
    const Vec2 first = corners_[1] - corners_[0], second = corners_[2] - corners_[0];
    area_ = cross(first, second);
    const Vec3 along = p[1] - p[0], other = p[2] - p[0];
    by_x_ = (along * second.y() - other * first.y()) / area_;
    by_y_ = (other * first.x() - along * second.x()) / area_;
    origin_ = p[0] - corners_[0].x() * by_x_ - corners_[0].y() * by_y_;
    low_ = corners_[0].cwiseMin(corners_[1]).cwiseMin(corners_[2]);
    high_ = corners_[0].cwiseMax(corners_[1]).cwiseMax(corners_[2]);
    const int top = static_cast<int>(texture_.pyramid.size());
    const BoundsLevel& whole = texture_.pyramid[idx(top - 1)];
    for (int row = 0; row < whole.rows; ++row)
      for (int column = 0; column < whole.columns; ++column) open(top, column, row);
  }

  double highest() const noexcept { return highest_; }

 private:
  // Texels of a cell along one axis: those at the border of the map hold for what lies beyond it.
  static std::pair<int, int> texels_of(int cell, int level, int cells, int texels) noexcept {
    const int side = 1 << level;
    return {cell == 0 ? -1 : cell * side, cell == cells - 1 ? texels : (cell + 1) * side};
  }

  void open(int level, int column, int row) noexcept {
    const BoundsLevel& bounds = texture_.pyramid[idx(level - 1)];
    const auto [left, right] = texels_of(column, level, bounds.columns, texture_.width);
    const auto [bottom, top] = texels_of(row, level, bounds.rows, texture_.height);
    if (!may_meet(bounds.cells[idx(row * bounds.columns + column)], Vec2(left, bottom),
                  Vec2(right, top)))
      return;
    if (level == 1) {
      for (int j = bottom; j < top; ++j)
        for (int i = left; i < right; ++i) meet_facet(i, j);
      return;
    }
    const BoundsLevel& finer = texture_.pyramid[idx(level - 2)];
    for (int k = 0; k < 4; ++k) {
      const int i = 2 * column + k % 2, j = 2 * row + k / 2;
      if (i < finer.columns && j < finer.rows) open(level - 1, i, j);
    }
  }

  /// Whether displacements within bounds may bring a box of texels over the place, and above what
  /// is known.
  bool may_meet(const TexelBounds& bounds, const Vec2& first, const Vec2& last) const noexcept {
    constexpr double kRounding = 1e-6;  // texels
    const Vec2 low = first.cwiseMax(low_), high = last.cwiseMin(high_);
    const Vec2 half = 0.5 * (high - low) + Vec2::Constant(kRounding), middle = 0.5 * (low + high);
    if (!(half.array() > 0.0).all()) return false;
    const Vec3 least = texel_vector(bounds.low).head<3>(),
               most = texel_vector(bounds.high).head<3>();
    const Vec3 from = 0.5 * (least + most), by = 0.5 * (most - least);
    const Vec3 centre = origin_ + middle.x() * by_x_ + middle.y() * by_y_ + turn_ * from;
    const Vec3 reach =
        half.x() * by_x_.cwiseAbs() + half.y() * by_y_.cwiseAbs() + turn_.cwiseAbs() * by;
    return std::fabs(centre.x() - at_.x()) <= reach.x() &&
           std::fabs(centre.y() - at_.y()) <= reach.y() && centre.z() + reach.z() > highest_;
  }

  Vec3 fine_point(int column, int row) const noexcept {
    const Texel& t = texel_at(texture_, std::clamp(column, 0, texture_.width - 1),
                              std::clamp(row, 0, texture_.height - 1));
    return origin_ + column * by_x_ + row * by_y_ + turn_ * Vec3(texel_vector(t).head<3>());
  }

  // Between four texels the fine point is p + u b + v c + u v d: over the place for roots v of a
  // parabola.
  void meet_facet(int column, int row) noexcept {
    if (column + 1 < low_.x() || column > high_.x() || row + 1 < low_.y() || row > high_.y())
      return;
    Vec3 p = fine_point(column, row);
    const Vec3 b = fine_point(column + 1, row) - p, c = fine_point(column, row + 1) - p,
               d = fine_point(column + 1, row + 1) - p - b - c;
    p.head<2>() -= at_;
    const Vec2 p2 = p.head<2>(), b2 = b.head<2>(), c2 = c.head<2>(), d2 = d.head<2>();
    const double square = cross(c2, d2), linear = cross(p2, d2) + cross(c2, b2),
                 constant = cross(p2, b2);
    const double root = linear * linear - 4.0 * square * constant;
    if (!(root >= 0.0)) return;
    const double q = -0.5 * (linear + std::copysign(std::sqrt(root), linear));
    for (const double v : {q / square, constant / q}) {
      if (!(v >= -kSlack && v <= 1.0 + kSlack)) continue;
      const Vec2 way = b2 + v * d2;
      const double u = -way.dot(p2 + v * c2) / way.squaredNorm();
      if (!(u >= -kSlack && u <= 1.0 + kSlack)) continue;
      const bool is_front = is_outward(cross(way, Vec2(c2 + u * d2)));
      if (!is_front || !is_on(Vec2(column + u, row + v))) continue;
      highest_ = std::max(highest_, p.z() + u * b.z() + v * c.z() + u * v * d.z());
    }
  }

  // Charts may be mirrored.
  bool is_outward(double turn) const noexcept {
    return (patch_.facing == Facing::along) == (turn * area_ > 0.0) && turn != 0.0;
  }

  bool is_on(const Vec2& texel) const noexcept {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 edge = corners_[(k + 1) % 3] - corners_[k];
      if (!(cross(edge, Vec2(texel - corners_[k])) / area_ >= -kSlack)) return false;
    }
    return true;
  }

  const ProjectedPatch& patch_;
  const HapticTexture& texture_;
  Mat3 turn_;  // of a displacement: along u, v and the facing direction
  Vec2 at_;
  double highest_;
  // Of the triangle. Its coarse point at texel t is origin + t.x by_x + t.y by_y.
  std::array<Vec2, 3> corners_;
  Vec2 low_, high_;
  double area_ = 0.0;  // twice, in texels
  Vec3 origin_, by_x_, by_y_;
};

// Of all sheets; where there is none of the patch itself as without them.
double height_of(const ProjectedPatch& patch, const Vec2& at) noexcept {
  const double height = sheet_height(patch, at);
  if (height != kNoSurface) return height;
  std::int32_t near = -1;
  return height_at(patch, at, near);
}

double depth_of(const PreparedContact& prepared, const Vec2& at) noexcept {
  const double object = height_of(prepared.object, at);
  return object == kNoSurface ? kNoDepth : object + height_of(prepared.scene, at);
}

}  // namespace

double sheet_height(const ProjectedPatch& patch, const Vec2& at) noexcept {
  SheetLine line(patch, at, kNoSurface);
  bool has_ground = false;
  for (const ProjectedTriangle& t : patch.triangles) {
    has_ground = has_ground || covers(t, at);
    if (contains(t.fine, at)) line.meet(t.triangle);
  }
  if (!has_ground && line.highest() == kNoSurface) return kNoSurface;
  for (const ProjectedTriangle& t : patch.around)
    if (contains(t.fine, at)) line.meet(t.triangle);
  for (const HiddenTriangle& t : patch.hidden)
    if (contains({t.box.low + patch.sideways.low, t.box.high + patch.sideways.high}, at))
      line.meet(t.triangle);
  return line.highest();
}

void settle_height_field(const PreparedContact& prepared, const Vec2& spacing,
                         DepthSamples& result) noexcept {
  result.is_height_field = is_upright(prepared, result.at);
  if (result.is_height_field) return;
  constexpr int kSide = 12;          // samples each way
  constexpr double kAround = 1.5;    // spacings
  constexpr double kFinest = 0.125;  // of a texel, as other climbs
  Vec2 at = result.at;
  double depth = depth_of(prepared, at);
  const Vec2 around = kAround * spacing;
  const MapGrid grid{intersection({at - around, at + around}, prepared.box), kSide, kSide};
  for (int i = 0; i < kSide * kSide; ++i) {
    const Vec2 there = grid.at(i % kSide, i / kSide);
    const double sample = depth_of(prepared, there);
    if (!(sample > depth)) continue;
    depth = sample;
    at = there;
  }
  if (depth == kNoDepth) return;
  const auto depth_there = [&](const Vec2& there, NearTriangles&) {
    return depth_of(prepared, there);
  };
  const ClimbField field{prepared.object, prepared.scene,           prepared.box,
                         Vec2::Zero(),    kFinest * prepared.texel, -1.0};
  depth = Climb<NearTriangles, decltype(depth_there)>(field, depth_there)
              .run(2.0 * grid.spacing(), {}, at);
  // Sheets reach beyond the ends of patches, where no gradient is known.
  if (!surface_jet(prepared.object, at).is_covered || !surface_jet(prepared.scene, at).is_covered)
    return;
  result.depth[0] = depth;
  result.at = at;
  result.is_of_sheets = true;
  result.remaining = kInfinity;  // the bound was of the other depth
}

}  // namespace thigma::detail
