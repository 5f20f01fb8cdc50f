#pragma once
// What a haptic step of a body in a hand works on: the bodies, rows and joints of its model as an
// island.

#include <span>

#include "thigma/multibody/hand_step.h"

namespace thigma::detail {

/// What a step works on. Thread of all that follows: [haptic].
struct HandWork {
  const HandModel& model;
  const BodyAtState& at;
  const StepForces& forces;
  double dt;
  bool goes;  // the bodies next to the one in the hand, in this step
  HandMemory& memory;
  HandScratch& s;
};

/// A pair at poses.
struct HandPairAt {
  BodyState relative;
  Mat3 rotation;
};
HandPairAt pair_at(const HandPair& pair, std::span<const BodyState> states) THIGMA_RT;

/// Which bodies are in the island, and the poses that the step begins at; their metrics and
/// velocities without rows; rows.
void place_bodies(const HandWork& work) THIGMA_RT;
void fill_bodies(const HandWork& work) THIGMA_RT;
void fill_rows(const HandWork& work) THIGMA_RT;

/// Rows of the joints, from where the step begins to where the velocities of the last turn lead.
///
/// is_first  there was none
void fill_joints(const HandWork& work, bool is_first) THIGMA_RT;

/// Where bodies are after a share of the step; momenta of what is solved are those of the velocity.
void go(const HandWork& work, double share) THIGMA_RT;

/// Rows that turning has closed ask for less; whether any does. As of the world's step.
bool correct_limits(const HandWork& work) THIGMA_RT;

/// Keeps the rows that pressed, at the poses after the step, for a solve without time.
void turn_rows(const HandWork& work) THIGMA_RT;

}  // namespace thigma::detail
