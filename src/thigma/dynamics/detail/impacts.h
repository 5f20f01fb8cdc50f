#pragma once
// Contacts that begin in a constrained step, and how they throw the body back in the next.

#include "thigma/dynamics/constrained_step.h"

namespace thigma::detail {

/// What is known of a step once its rows are solved.
struct SolvedRows {
  const StepBounds& bounds;
  const VelocityRows& rows;
  const RowImpulses& impulses;
  const Vec6& before;  // velocity [m/s, rad/s; world]
  const Vec6& free;    // were there no rows
};

/// Contacts that press now, did not in the step before, and came together faster than what acts on
/// the body makes it in a few steps. The speed is that at the place of contact: of a body that
/// falls, with the gravity of the part of the step until there.
///
/// memory    of the step before
/// Thread    [haptic]; no failure.
Impacts find_impacts(const SolvedRows& solved, const RowMemory& memory) THIGMA_RT;

/// Notes the impacts of pairs with restitution, for the next step.
/// Thread    [haptic].
void note_bounces(const Impacts& impacts, const StepBounds& bounds, RowMemory& memory) THIGMA_RT;

/// Adds a row for each contact that throws the body back now: it leaves with at least its speed.
/// Without friction. What does not fit is left out.
/// Thread    [haptic].
void add_bounces(const RowMemory& memory, VelocityRows& rows) THIGMA_RT;

}  // namespace thigma::detail
