#pragma once
// The build of levels of detail with the tree of this project or that of the text.

#include "thigma/clod/build_clod.h"

namespace thigma::detail {

/// How the tree over the levels differs from that of the text, where both are false.
struct TreeForm {
  bool is_reparented = true;      // parents by geometry; false: by merging
  bool has_culling_hulls = true;  // nodes bounded by hulls of the finest surface below them; false:
                                  // by their own patch and h
};

/// build_clod with either form.
ClodHierarchy build_levels(const TriangleMesh& mesh, const ClodParams& params, const TreeForm& form,
                           ClodReport* report);

}  // namespace thigma::detail
