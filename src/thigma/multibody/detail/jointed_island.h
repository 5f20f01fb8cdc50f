#pragma once
// Islands with joints: bodies that joints hold together, solved so that joints are met where a part
// of a step ends and do no work.

#include "thigma/multibody/detail/world_work.h"

namespace thigma::detail {

/// Where the bodies of an island go, into WorldScratch::next, as `solve_one` does for islands
/// without joints.
///
/// A body goes by V, w over the part: x + dt V, and turned by Cayley's map of dt w. In islands of
/// moving bodies alone these are means of the velocities before and after: M (V - v) = 1/2 (dt F +
/// J) + C, v' = v + M^-1 (dt F + J + C), J of joints and springs, C of contacts, limits and motors
/// at a speed, which act at the beginning. Then gravity, springs and joints change the energy by
/// what they store, to rounding (Gonzalez 1999; rotation: Simo and Wong 1991). Where a hand or a
/// prescribed body takes part, and where surfaces or limits press, V, w are the velocities after,
/// as without joints: that only loses energy, right to first order.
/// Thread   throws std::bad_alloc where memory grows
void solve_jointed(Part& part, Island& island);

/// A body of such an island after a share of the part.
BodyState after_jointed(const Part& part, std::int32_t body, const Vec6& velocity,
                        double share) noexcept;

/// Adds the impulses of a part that was made to those of the step.
void count_joints(Part& part, const Island& island) noexcept;

/// Rows of an island's joints at its end, into WorldScratch::joint_rows.
void list_joint_ends(Part& part, const Island& island, std::span<const BodyState> states);

/// Takes the impulses of the last solve as those of the ends.
void keep_joint_ends(Part& part) noexcept;

/// Largest error of a joint at states [m].
double joint_error(const World& world, std::span<const BodyState> states) noexcept;

}  // namespace thigma::detail
