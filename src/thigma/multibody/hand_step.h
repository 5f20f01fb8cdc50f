#pragma once
// A haptic step of a body in a hand among others that move: it and those next to it, from the
// newest hand model. The world's own step stays the truth; this one is bounded.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/core/rt.h"
#include "thigma/dynamics/constrained_step.h"
#include "thigma/multibody/detail/row_cut.h"
#include "thigma/multibody/hand_model.h"
#include "thigma/multibody/island_solve.h"

namespace thigma {

/// Factors of the solves of a haptic step, at most: what takes more waits for the next step. Where
/// they end in a later turn of joints and turning, the turn before counts.
inline constexpr std::int32_t kHandNewton = 48;

/// What goes from one haptic step to the next. Copyable: a step is a function of it.
struct HandMemory {
  std::uint64_t sequence = 0;  // of the model that it is of
  // Of the world's next step, that the bodies next to the one in the hand may still make: no haptic
  // step takes them farther than the world will, however long it takes [s]
  double left = 0.0;
  std::array<BodyState, kHandBodies> states{};  // of the model's bodies; not of the first
  std::array<Vec6, kHandBodies> velocities{};   // [m/s, rad/s; world]
  std::array<Vec3, kHandRows> impulses{};       // of its rows [N s]
  std::array<bool, kHandRows> is_sliding{};
  std::array<detail::JointImpulses, kHandJoints> joints{};
  // Of the last step, for whoever counts: rows that it had, bodies that it moved, factors.
  std::int32_t rows = 0, bodies = 0, newton = 0;
  bool is_cut_short = false;  // factors ran out: the body waited
};

/// Working memory of steps: taken once, never after.
struct HandScratch {
  IslandScratch solve;
  detail::RowCut cut;
  std::vector<IslandBody> bodies;
  std::vector<IslandRow> rows;
  std::vector<IslandBody> kept_bodies;  // of the turn before
  std::vector<IslandRow> kept_rows;     // likewise
  std::vector<detail::RowSource> sources;
  detail::JointRowList joint_rows;
  std::array<BodyState, kHandBodies> states{}, next{};
  std::array<std::int32_t, kHandBodies> place{};  // in the island; -1: stands still in this step
  // Of an impact: what rows that met give back of what stopped them, and to whom, by place.
  std::array<double, kHandRows> spring{};
  std::array<Vec6, kHandBodies> bounce{};
};

/// Thread    [offline]; throws std::bad_alloc.
void reserve_hand_step(HandScratch& scratch);

/// What taking up a model did to the body in the hand.
struct HandCorrection {
  double way = 0.0;  // that its points were moved, at most, towards where the world has it [m]
};

/// Takes up a model. The body in the hand stays where it is, unless the world has something there
/// or has not looked there: then it goes back towards where the world has it, as little as it must.
///
/// model    with a number above memory's
/// held     of the haptic thread; its pose may change, its momenta do not
/// Thread   [haptic]; no failure, nothing allocated
HandCorrection take_hand_model(const HandModel& model, BodyState& held,
                               HandMemory& memory) THIGMA_RT;

/// One haptic step: bodies and rows of the model in one solve, as the world's step has them. What
/// is not solved keeps its velocity and takes what rows give it, so that nothing is stopped by what
/// the haptic thread does not know. The bodies next to the one in the hand go one step of the world
/// ahead and then stand still. Surfaces that meet stop each other and spring back as in the world's
/// step, where all of their bodies that move are solved and nothing is jointed.
///
/// model    the one that memory is of
/// at       the body in the hand, before
/// forces   of its coupling, with their Jacobian
/// dt       > 0 [s]
/// returns  as of constrained_step. Where the solve is not whole, or takes more than kHandNewton
///          factors, all bodies rest
/// Thread   [haptic]; no failure, nothing allocated after reserve_hand_step. The same bits for the
///          same calls
ConstrainedStep step_hand(const HandModel& model, const BodyAtState& at, const StepForces& forces,
                          double dt, HandMemory& memory, HandScratch& scratch) THIGMA_RT;

}  // namespace thigma
