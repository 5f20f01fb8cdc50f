#pragma once
// Do two triangles of one mesh meet where they should not?

#include <array>
#include <cstdint>
#include <span>

#include "thigma/math/types.h"

namespace thigma {

/// Whether two triangles have a point in common beyond the vertices or the edge they share.
/// Touching counts, coplanar overlap counts, triangles of the same three vertices count. Exact.
///
/// positions  finite; the corners are indices into them, equal positions have one index
/// a, b       neither is collinear
/// Thread     [offline]; no failure.
bool triangles_meet(std::span<const Vec3> positions, std::array<std::int32_t, 3> a,
                    std::array<std::int32_t, 3> b);

}  // namespace thigma
