#pragma once
// Which way a turn in the plane goes.
#include "thigma/math/types.h"

namespace thigma {

/// Twice the signed area of the triangle (0, a, b) in the plane: positive where b lies
/// anticlockwise of a.
[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b) noexcept {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace thigma
