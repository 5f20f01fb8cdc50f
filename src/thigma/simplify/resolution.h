#pragma once
// How fine an edge samples the surface (Sec. 3.3.2).

#include "thigma/math/types.h"

namespace thigma {

/// Length of an edge projected onto the plane normal to n.
///
/// edge, n  [m; same frame]; n of any length, zero projects nothing away
/// returns  [m]; 0 when the edge runs along n to 1e-12 of its length
/// Thread   [offline]; no failure. Source Eq. 3.1.
double projected_length(const Vec3& edge, const Vec3& n);

/// Sampling resolution of the edge from v1 to v2: the inverse of its projected length [1/m];
/// infinite for an edge along n. Source Eq. 3.1, with n normalised (docs/sources.md).
double edge_resolution(const Vec3& v1, const Vec3& v2, const Vec3& n);

}  // namespace thigma
