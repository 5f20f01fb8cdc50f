#pragma once
// What is carried from one constrained step to the next, and what is told of its rows.

#include "thigma/dynamics/row_solve.h"

namespace thigma::detail {

/// Impulses of the step before, for the rows of this model that were there.
/// Thread [haptic].
void recall(const ConstraintModel& model, const RowMemory& memory, RowImpulses& impulses) THIGMA_RT;

/// The rows that pressed, for the next step; bounces are left as they are.
/// Thread [haptic].
void keep(const ConstraintModel& model, const RowImpulses& impulses, RowMemory& memory) THIGMA_RT;

/// The rows that press, with their forces over a step of dt [s]; those beyond the room are the
/// weakest.
/// Thread [haptic].
void list_pressing(const ConstraintModel& model, const VelocityRows& rows,
                   const RowImpulses& impulses, double dt, PressingRows& pressing) THIGMA_RT;

}  // namespace thigma::detail
