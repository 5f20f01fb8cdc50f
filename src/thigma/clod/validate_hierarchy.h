#pragma once
// Can a hierarchy be used at all? What a query relies on to stay within its arrays and to end.

#include <string>

#include "thigma/clod/hierarchy.h"

namespace thigma {

/// The first promise of ClodHierarchy that is broken, as "what, where, expected what"; empty when
/// it can be used.
///
/// Looks at every index, range, count and number, at the shape of the tree and at what follows from
/// the rest: masks, lanes, spheres, counts of levels. What needs the mesh is for check_hierarchy.
/// Thread  [offline]; linear in the size.
std::string find_flaw(const ClodHierarchy& hierarchy);

}  // namespace thigma
