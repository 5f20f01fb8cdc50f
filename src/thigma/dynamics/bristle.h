#pragma once
// Friction of contacts that are springs: a bristle for each term bends as its surfaces slide, up to
// Coulomb's cone.

#include <cstdint>

#include "thigma/core/static_vector.h"
#include "thigma/dynamics/body.h"
#include "thigma/dynamics/constrained_step.h"
#include "thigma/dynamics/linear_contact_model.h"

namespace thigma {

/// A bristle in a step.
struct Bristle {
  const PlaneTerm* plane = nullptr;  // its term: one of the two
  const DepthTerm* depth = nullptr;
  const BodyState* taken_at = nullptr;  // state of the model of a depth term
  double scale = 1.0;                   // of the model
  // as the step finds it, with stiffness and normal of the present term
  BristleMemory::Entry entry{};
  double damping = 0.0;           // b_t [N s/m]
  Friction friction{};            // of the term
  Vec3 arm_body = Vec3::Zero();   // of the point it holds, from the centre of mass [m; body frame]
  Vec3 start = Vec3::Zero();      // where that is before the step [m; world]
  bool slides = false;            // the step ends beyond the cone: Coulomb's force acts instead
  Vec3 direction = Vec3::Zero();  // against that force, unit [world]
};
using Bristles = StaticVector<Bristle, kMaxBristles>;

/// What friction acts by in a step.
struct BristleContact {
  const LinearContactModel& model;
  double scale = 1.0;  // fading of a stale model, as of contact_wrench
  double dt = 0.0;     // > 0 [s]
};

/// Bristles of the terms that have friction and are within reach; a new term's is straight.
///
/// Stiffness and damping of a bristle are those of its term: a surface is as stiff along as across.
/// What memory holds is turned with the normal and stretched by sqrt(k_t before / k_t), so that its
/// energy k_t e^2 / 2 stays; without a term it is lost.
/// Thread    [haptic]; no failure.
Bristles bristles_of(const BristleContact& contact, const BodyAtState& at,
                     const BristleMemory& memory) THIGMA_RT;

/// Friction of a bristle at a state: it holds with -(k_t (e + way) + b_t v), along the surface, or,
/// where it slides, with the kinetic coefficient times the normal force.
///
/// way       of its point since the step began, v its velocity, both across the normal
/// jacobian  null, or where d(force, torque)/dy is added (6 x 13)
/// returns   force [N] and torque about the centre of mass [N m]; world
/// Thread    [haptic]; no failure.
Wrench bristle_wrench(const Bristle& bristle, const BodyAtState& at,
                      WrenchJacobian* jacobian = nullptr) THIGMA_RT;

/// One step of a body with all that acts on it and the friction of its contacts.
///
/// at       mass properties and y_{n-1}
/// forces   all but friction and gravity, with their Jacobian
/// memory   bristles before and after; empty is a valid start
/// returns  y_n; without friction implicit_step, bit for bit
/// Thread   [haptic]; no failure, nothing allocated.
/// Source   A bristle for each contact, its force returned to Coulomb's cone at the end of the
///          step. What stays bent is its elastic part alone, so that it never stores more than the
///          motion has put in.
BodyState bristle_step(const BodyAtState& at, const StepForces& forces,
                       const BristleContact& contact, BristleMemory& memory) THIGMA_RT;

/// The same for a body that is led from one state to the next, whatever acts on it.
/// Thread   [haptic]; no failure.
void bend_bristles(const BodyAtState& before, const BodyAtState& after,
                   const BristleContact& contact, BristleMemory& memory) THIGMA_RT;

}  // namespace thigma
