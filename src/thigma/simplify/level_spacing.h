#pragma once
// Which of many levels are kept.

#include <cstddef>
#include <vector>

namespace thigma {

struct SimplifiedLevel;

/// Drops levels between the first and the last so that patches at least halve from each to the
/// next, by about the same factor everywhere, and resolutions fall. Where triangles would fall to
/// less than a quarter in such a step, as on smooth surfaces of large patches, levels are kept
/// between whose triangles halve. Drops the last too when it has more than half the patches of the
/// first.
///
/// levels  at least one, patches fall; the parents of a level that stays lead to the next that does
/// Thread  [offline]; deterministic.
void space_levels(std::vector<SimplifiedLevel>& levels);

/// Of levels of the same resolution keeps the coarsest, so that resolutions fall strictly. The
/// first level stays.
///
/// Thread  [offline]; deterministic.
void drop_equal_resolutions(std::vector<SimplifiedLevel>& levels);

}  // namespace thigma
