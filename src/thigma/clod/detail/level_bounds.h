#pragma once
// How far a contact patch and the finest patches below its node lie apart: what a contact measured
// on the one says about the other. s and h do not tell: s is taken against whole surfaces, h
// against the hull, and a patch drifts sideways against what is below it.

#include "thigma/clod/hierarchy.h"

namespace thigma::detail {

/// Fills from_below and to_below of the contact patches, vertex_to_below and triangle_to_below, and
/// raises h of contact patches until s + h covers from_below, to_below and h of the node.
/// All are upper bounds, rounding included. After s, h and the nodes' hulls; does nothing without
/// contact patches. The result does not depend on the number of threads.
void measure_level_bounds(int threads, ClodHierarchy& hierarchy);

}  // namespace thigma::detail
