#pragma once
// The fine surface of a sheet as its triangles, found along lines.

#include <vector>

#include "thigma/models/textured_sheet.h"

namespace thigma::models {

/// The triangles that make_fine_sheets makes of a sheet, over (u, v).
class FineGrid {
 public:
  explicit FineGrid(const TexturedSheet& sheet);

  /// The point of (u, v); u of any number of turns, v in [0, 1] [m].
  Vec3 at(const Vec2& uv) const;

  /// Where the line through a point meets a triangle that faces along `direction`, walking from
  /// triangle to triangle.
  ///
  /// start   (u, v) to walk from
  /// other   what to return where the walk finds none, or only one more than twice as far away as
  ///         this
  Vec3 along(const Vec3& point, const Vec3& direction, const Vec2& start, const Vec3& other) const;

 private:
  const Vec3& corner(int i, int j) const;
  int around_, along_;
  bool is_ring_;
  std::vector<Vec3> corners_;  // around x (along + 1), row by row
};

}  // namespace thigma::models
