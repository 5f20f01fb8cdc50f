#pragma once
// What the energy of an island is after a part of a step beside before, and what is done where it
// is more.

#include "thigma/multibody/detail/islands.h"
#include "thigma/multibody/detail/world_work.h"

namespace thigma::detail {

/// By how much an island has more energy after the part than before, but for what leading bodies
/// apart gives and what digits leave open, at least 0 [J]: only turning about contacts and its
/// corrections can do that, less so in a shorter part. 0 where a hand, a motor or a prescribed body
/// may give it.
double energy_gain(const Part& part, const Island& island) noexcept;

/// Takes a small gain back from the motion of an island that presses on what does not move: a body
/// that rolls over its corners goes along their tangents, above their arcs. Speeds less in one
/// proportion obey all rows that did not have to part. Whether it did; an island of free bodies
/// keeps its momentum.
bool take_back(const Part& part, const Island& island, double gain) noexcept;

}  // namespace thigma::detail
