#pragma once
// The mesh everything offline starts from.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/math/types.h"

namespace thigma {

/// Indexed triangles, counter-clockwise seen from outside.
/// Invariant of use: every index is in 0..positions.size()-1, every coordinate is finite.
struct TriangleMesh {
  std::vector<Vec3> positions;                         // [m; body frame] (n)
  std::vector<std::array<std::int32_t, 3>> triangles;  // (m)
};

}  // namespace thigma
