#pragma once
// Does a triangle reach into a convex body? Decided by clipping, not by samples.

#include <array>
#include <vector>

#include "thigma/math/types.h"

namespace thigma {

struct Quickhull;

/// Half-space normal . p <= offset. Unit normal [any unit].
struct HalfSpace {
  Vec3 normal = Vec3::Zero();
  double offset = 0.0;
};

/// The half-spaces whose intersection is the hull, in the hull's own centred and scaled
/// coordinates, moved inwards.
///
/// hull    of dimension 3
/// inset   [m]
/// Thread  [offline]; no failure.
void list_half_spaces(const Quickhull& hull, double inset, std::vector<HalfSpace>& half_spaces);

/// True when some point of the triangle lies in all half-spaces: Sutherland-Hodgman clipping leaves
/// something over.
/// Thread    [offline]; no failure.
bool reaches_into(const std::array<Vec3, 3>& triangle, const std::vector<HalfSpace>& half_spaces);

}  // namespace thigma
