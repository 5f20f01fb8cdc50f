#include "thigma/loop/detail/move_body.h"

#include "thigma/core/index.h"
#include "thigma/dynamics/bristle.h"
#include "thigma/dynamics/constrained_step.h"
#include "thigma/loop/detail/clutch.h"
#include "thigma/loop/detail/taps.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

bool is_finite(const BodyState& y) THIGMA_RT {
  return y.position.allFinite() && y.orientation.coeffs().allFinite() &&
         y.linear_momentum.allFinite() && y.angular_momentum.allFinite();
}

double depth_at(const PlaneTerm& t, const BodyState& y) THIGMA_RT {
  const Vec3 point = y.position + y.orientation._transformVector(t.arm_body);
  return t.normal.dot(point - t.scene_point);
}

ActiveTerms active_terms(const LinearContactModel& model, const BodyState& y) THIGMA_RT {
  ActiveTerms result;
  for (const PlaneTerm& t : model.planes) {
    const double depth = depth_at(t, y);
    if (depth + t.tolerance > 0.0) ++result.count;
    if (!(depth > result.penetration)) continue;
    result.penetration = depth;
    result.sunk = depth - depth_at(t, model.state);
  }
  for (const DepthTerm& t : model.depths) {
    const double depth = depth_at(t, model.state, y);
    if (depth + t.tolerance > 0.0) ++result.count;
    if (!(depth > result.penetration)) continue;
    result.penetration = depth;
    result.sunk = depth - depth_at(t, model.state, model.state);
  }
  return result;
}

/// Steps 2-4: both wrenches linearised at t_{i-1} with the device sample of t_i, then the state at
/// t_i.
void advance_body(const HapticParams& params, const LinearContactModel& model,
                  const HapticSample& sample, HapticState& state) THIGMA_RT {
  const BodyState before = state.body;
  const BodyAtState at = at_state(params.body, state.body);
  WrenchJacobian by_coupling, by_contact;
  const Wrench pull = coupling_wrench(faded(state.coupling, state.last_device.weight),
                                      sample.handle, at, &by_coupling);
  const Wrench push = contact_wrench(model, at, sample.model_weight, &by_contact);
  const StepForces forces{pull + push, by_coupling + by_contact};
  state.body =
      bristle_step(at, forces, {model, sample.model_weight, sample.elapsed}, state.bristles);
  if (is_finite(state.body)) return;
  latch_fault(state.safety, Fault::not_finite, sample.time);
  state.body = before;
  let_go(state);
}

/// The strongest impact of a step rings.
void tap_impacts(const HapticParams& params, const Impacts& impacts, const Vec3& handle,
                 HapticState& state) THIGMA_RT {
  const Impact* strongest = nullptr;
  const Tap* rings = nullptr;
  for (const Impact& impact : impacts) {
    const std::size_t body = idx(impact.body);
    if (impact.body < 0 || body >= params.impacts.size()) continue;
    const Tap& tap = params.impacts[body].tap;
    if (strongest != nullptr && tap.amplitude * impact.speed <= rings->amplitude * strongest->speed)
      continue;
    strongest = &impact;
    rings = &tap;
  }
  if (strongest != nullptr) start_tap(*strongest, *rings, state.body.position, handle, state.taps);
}

/// Steps 2-4 of the constrained response: the coupling alone, then what the rows allow. Returns how
/// the rows stand.
ActiveTerms advance_constrained(const HapticParams& params, const HapticPorts& ports,
                                HapticSample& sample, HapticState& state) THIGMA_RT {
  ActiveTerms active;
  const BodyState before = state.body;
  const BodyAtState at = at_state(params.body, before);
  StepForces forces;
  forces.wrench = coupling_wrench(faded(state.coupling, state.last_device.weight), sample.handle,
                                  at, &forces.jacobian);
  const ConstraintModel& rows = ports.models->value().constraints;
  const ConstrainedStep step =
      ports.stepper.step != nullptr
          ? ports.stepper.step(ports.stepper.self, at, forces, sample.elapsed)
          : constrained_step(at, forces,
                             {rows, params.constraint, sample.elapsed, params.impacts, ports.clock},
                             state.rows);
  state.wanted_speed = sample.wanted_speed = step.wanted_speed;
  state.wanted_gain = step.wanted_gain;
  sample.solve_residual = step.solution.residual;
  sample.is_held_back = step.is_held_back;
  sample.is_squeezed = step.is_squeezed;
  sample.pressing = step.pressing;
  sample.contact = step.contact;
  sample.slip = step.slip;
  sample.solve_ns = step.solve_ns;
  active.count = step.solution.active;
  active.penetration = -step.least_gap;
  state.body = step.state;
  tap_impacts(params, step.impacts, sample.handle.pose.position, state);
  if (is_finite(state.body)) return active;
  latch_fault(state.safety, Fault::not_finite, sample.time);
  state.body = before;
  state.rows = {};
  state.wanted_speed = state.wanted_gain = 0.0;
  let_go(state);
  return active;
}

/// Instead of steps 2-4 of the direct response: the body is where the handle holds it, and moves as
/// the handle does.
void follow_handle(const HapticParams& params, const LinearContactModel& model,
                   const HapticSample& sample, HapticState& state) THIGMA_RT {
  const BodyState before = state.body;
  const Motion& hand = sample.handle;
  const Pose world_from_body = hand.pose * inverse(state.coupling.body_from_grasp);
  state.body.position = world_from_body.position;
  state.body.orientation = world_from_body.orientation.normalized();
  const Vec3 to_body = state.body.position - hand.pose.position;
  const Mat3 rotation = rotation_matrix(state.body.orientation);
  state.body.linear_momentum =
      params.body.mass * (hand.twist.linear + hand.twist.angular.cross(to_body));
  state.body.angular_momentum =
      rotation * (params.body.inertia * (rotation.transpose() * hand.twist.angular));
  if (is_finite(state.body)) {
    // What a stale model fades by comes with the limits.
    bend_bristles(at_state(params.body, before), at_state(params.body, state.body),
                  {model, 1.0, sample.elapsed}, state.bristles);
    return;
  }
  latch_fault(state.safety, Fault::not_finite, sample.time);
  state.body = before;
  let_go(state);
}

}  // namespace

ActiveTerms move_body(const HapticParams& params, const HapticPorts& ports, HapticSample& sample,
                      HapticState& state) THIGMA_RT {
  const LinearContactModel& model = ports.models->value();
  if (params.response == ResponseKind::constrained) {
    if (state.is_grasped) return advance_constrained(params, ports, sample, state);
    state.wanted_speed = state.wanted_gain = 0.0;
    return {};
  }
  if (state.is_grasped) {
    if (params.response == ResponseKind::direct)
      follow_handle(params, model, sample, state);
    else
      advance_body(params, model, sample, state);
    sample.slip = state.bristles.slip;
  }
  return active_terms(model, state.body);
}

}  // namespace thigma::detail
