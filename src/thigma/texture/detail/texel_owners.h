#pragma once
// Which triangle each texel of a map belongs to.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/math/types.h"

namespace thigma::detail {

/// Of each texel the triangle it lies on, or the nearest one if that is within the margin; -1
/// beyond.
struct TexelOwners {
  std::vector<std::int32_t> triangle;  // (width x height)
};

/// corners  texture coordinates of every triangle [texels], each with an area
/// margin   [texels]
/// Thread   [offline]; deterministic: of two triangles as near, the first.
TexelOwners find_texel_owners(const std::vector<std::array<Vec2, 3>>& corners, int width,
                              int height, double margin);

/// Weights of the corners of a triangle for a point of its plane; outside they are negative in
/// part.
Vec3 corner_weights(const std::array<Vec2, 3>& corners, const Vec2& at);

}  // namespace thigma::detail
