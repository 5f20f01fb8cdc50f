#pragma once
// Memory of levels of detail.

#include "thigma/clod/hierarchy.h"

namespace thigma::experiments {

/// Bytes that the arrays of a hierarchy hold, without what they have in reserve.
double hierarchy_bytes(const ClodHierarchy& h);

}  // namespace thigma::experiments
