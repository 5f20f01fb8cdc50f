#pragma once
// May the collapsed vertex lie here? The tests that follow the linear program (Sec. 3.3.4 step 5).

#include "thigma/simplify/filtered_edge_collapse.h"

namespace thigma::detail {

/// Prepares the scratch for trials of the star gathered in it: marks, qualities before, vertices of
/// the patches afterwards.
void begin_trials(const PatchedSurface& surface, CollapseScratch& scratch);

/// Tests a position of the new vertex, cheapest tests first. Sets scratch.reason when it refuses.
bool try_position(const PatchedSurface& surface, const CollapseContext& context,
                  const Vec3& position, CollapseScratch& scratch);

}  // namespace thigma::detail
