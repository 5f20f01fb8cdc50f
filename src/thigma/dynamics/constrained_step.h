#pragma once
// One step of a body that must not enter: the implicit step of the coupling, then the velocity
// nearest to it that no row forbids.

#include <cstdint>
#include <span>

#include "thigma/dynamics/body.h"
#include "thigma/dynamics/constraint_model.h"
#include "thigma/dynamics/row_solve.h"

namespace thigma {

/// What acts on the body in a step but its gravity and the rows.
struct StepForces {
  Wrench wrench;  // about the centre of mass, at the state before [N, N m; world]
  WrenchJacobian jacobian = WrenchJacobian::Zero();  // d(force, torque)/dy
};

/// Result of a step.
struct ConstrainedStep {
  BodyState state;
  Wrench contact;  // of the rows, mean over the step, about the centre of mass [N, N m; world]
  RowSolution solution;
  double least_gap = 0.0;     // of the rows before the step; infinite without [m]
  bool is_held_back = false;  // the travel of the model ended the motion early
  // rows nearer than the slop asked to be left in ways that contradict each other: they only hold
  bool is_squeezed = false;
  PressingRows pressing;  // the strongest first
  // how far a step goes that nothing holds back, over its length: what a query has to look ahead
  // for [m/s]
  double wanted_speed = 0.0;
  double wanted_gain = 0.0;   // and by how much faster that is than before, >= 0 [m/s^2]
  SlipCount slip;             // how friction held
  Impacts impacts;            // contacts that began
  std::int64_t solve_ns = 0;  // that the row solves took, by StepBounds::clock
};

/// What bounds a step.
struct StepBounds {
  const ConstraintModel& model;  // rows and how far they hold
  const ConstraintParams& params;
  double dt = 0.0;  // > 0 [s]
  // of the static objects, by their number; none beyond the end
  std::span<const ImpactPair> pairs{};
  std::int64_t (*clock)() noexcept = nullptr;  // [ns]; null: solves are not timed
};

/// One step under constraints.
///
/// at       mass properties and y_{n-1}
/// forces   of the coupling, with its Jacobian
/// bounds   without rows and with infinite travel the step is implicit_step, bit for bit
/// memory   warm start and its successor; empty is a valid start
/// returns  y_n with every gap of the model at least 0 where it was so before. Where rows
///          contradict each other the body rests.
/// Thread   [haptic]; no failure, nothing allocated.
/// Source   Gauss's principle of least constraint in the metric of Eq. 5.7's system.
ConstrainedStep constrained_step(const BodyAtState& at, const StepForces& forces,
                                 const StepBounds& bounds, RowMemory& memory) THIGMA_RT;

/// A = M - h D - h^2 K of a step, D and K the derivatives of the wrench by velocity and by motion,
/// symmetric part (6 x 6).
/// Thread    [haptic].
Mat6 step_metric(const BodyAtState& at, const WrenchJacobian& jacobian, double dt) THIGMA_RT;

}  // namespace thigma
