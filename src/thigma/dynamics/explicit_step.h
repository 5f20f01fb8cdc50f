#pragma once
// Explicit schemes, for comparison (Figs. 5.6, 5.8), and the choice between all schemes at run
// time.

#include <concepts>
#include <cstdint>

#include "thigma/dynamics/implicit_step.h"
#include "thigma/math/rotation.h"

namespace thigma {

/// How to advance the body by a step. Only implicit_tangent is meant for a person's hand.
enum class Integrator : std::uint8_t {
  implicit_tangent,  // implicit_step
  implicit_6,        // implicit_step_6
  implicit_13,       // implicit_step_13
  forward_euler,
  runge_kutta,  // fourth order; the device sample is held over the step
};

/// What acts on the body: a callable `Wrench f(const BodyState&, WrenchJacobian* jacobian)`, about
/// the centre of mass, without gravity; it sets *jacobian unless that is null. Explicit schemes ask
/// for no Jacobian and hand it states with |q| != 1.
template <class F>
concept BodyForces = requires(const F& forces, const BodyState& state, WrenchJacobian* jacobian) {
  { forces(state, jacobian) } -> std::convertible_to<Wrench>;
};

/// y + scale * rate, without normalising q.
/// Thread    [haptic].
inline BodyState displaced(const BodyState& state, const Vec13& rate, double scale) THIGMA_RT {
  return from_vector(to_vector(state) + scale * rate);
}

/// One step of forward Euler, q normalised after it.
/// Thread    [haptic].
template <BodyForces F>
BodyState forward_euler_step(const RigidBody& body, const BodyState& state, const F& forces,
                             double dt) THIGMA_RT {
  BodyState next = displaced(state, state_rate(body, state, forces(state, nullptr)), dt);
  next.orientation = unit(next.orientation);
  return next;
}

/// One step of the classical Runge-Kutta scheme, q normalised after it only.
/// Thread    [haptic].
template <BodyForces F>
BodyState runge_kutta_step(const RigidBody& body, const BodyState& state, const F& forces,
                           double dt) THIGMA_RT {
  const auto rate = [&](const BodyState& y) { return state_rate(body, y, forces(y, nullptr)); };
  const Vec13 k1 = rate(state);
  const Vec13 k2 = rate(displaced(state, k1, 0.5 * dt));
  const Vec13 k3 = rate(displaced(state, k2, 0.5 * dt));
  const Vec13 k4 = rate(displaced(state, k3, dt));
  BodyState next = displaced(state, k1 + 2.0 * k2 + 2.0 * k3 + k4, dt / 6.0);
  next.orientation = unit(next.orientation);
  return next;
}

/// One step of length dt [s] by the chosen scheme.
/// Thread    [haptic].
template <BodyForces F>
BodyState step_body(Integrator integrator, const RigidBody& body, const BodyState& state,
                    const F& forces, double dt) THIGMA_RT {
  if (integrator == Integrator::forward_euler) return forward_euler_step(body, state, forces, dt);
  if (integrator == Integrator::runge_kutta) return runge_kutta_step(body, state, forces, dt);
  WrenchJacobian jacobian;
  const Wrench wrench = forces(state, &jacobian);
  if (integrator == Integrator::implicit_13)
    return implicit_step_13(body, state, wrench, jacobian, dt);
  if (integrator == Integrator::implicit_6)
    return implicit_step_6(body, state, wrench, jacobian, dt);
  return implicit_step(body, state, wrench, jacobian, dt);
}

}  // namespace thigma
