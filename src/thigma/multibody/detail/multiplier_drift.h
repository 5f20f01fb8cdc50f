#pragma once
// Multipliers of an island that go the same way round after round, as where more rows hold a body
// than it has freedoms: how far they may go at once.

#include <span>

#include "thigma/multibody/island_solve.h"

namespace thigma::detail {

/// The multipliers of an island after a round.
struct Multipliers {
  std::span<const IslandRow> rows;  // with their impulses
  std::span<const JointRow> joints;
  std::span<const double> weight, joint_weight;  // changes over it are speeds [kg]
};

/// By which a round changed them.
struct MultiplierChange {
  std::span<const Vec3> rows;      // [N s]
  std::span<const double> joints;  // [N s]
};

/// How many changes more bring the multipliers to the first bound on their way: of a normal, of
/// friction that sticks or of a joint. 0: the last two changes are not the same, or nothing ends
/// their way.
///
/// last, before  the last two changes
/// Thread        [haptic]; no failure. The same bits for the same input
/// Source        This project's. Rows that hold the same freedoms more than once share their load
///               in more ways than one, and the method of multipliers goes from one to another by
///               a constant step, as small as the speed that tells the rows apart. Any multipliers
///               are a start for the next round (Rockafellar 1976): a step that was too long costs
///               a round.
double changes_to_bound(const Multipliers& now, const MultiplierChange& last,
                        const MultiplierChange& before) noexcept;

}  // namespace thigma::detail
