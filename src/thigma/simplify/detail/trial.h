#pragma once
// May the collapsed vertex lie here? The tests that follow the linear program (Sec. 3.3.4 step 5).

#include "thigma/simplify/filtered_edge_collapse.h"

namespace thigma::detail {

/// Prepares the scratch for trials of the star gathered in it: marks, qualities before, vertices of
/// the patches afterwards.
void begin_trials(const PatchedSurface& surface, CollapseContext& context);

/// Tests a position of the new vertex, cheapest tests first. The positions of both ends are changed
/// for the time of the test and restored. Sets scratch.reason when it refuses.
bool try_position(PatchedSurface& surface, CollapseContext& context, const Vec3& position);

}  // namespace thigma::detail
