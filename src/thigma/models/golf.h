#pragma once
// A golf ball with its dimples and the head of a club.

#include <cstdint>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::models {

/// 42.67 mm across, 392 dimples of 4 mm on a Fibonacci lattice. Closed, genus 0, star-shaped, [m].
TriangleMesh make_golf_ball(int triangles);

/// Driver, 120 mm from heel to toe (along y), its face towards +x with score lines, hosel up.
/// Closed, genus 0, star-shaped, [m].
TriangleMesh make_golf_club(int triangles, std::uint64_t seed);

}  // namespace thigma::models
