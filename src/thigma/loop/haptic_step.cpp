// One frame of the haptic thread, Sec. 5.1.2 steps 1-6, with the safety layer around it.

#include "thigma/loop/haptic_step.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/dynamics/bristle.h"
#include "thigma/dynamics/constrained_step.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

bool is_finite(const BodyState& y) THIGMA_RT {
  return y.position.allFinite() && y.orientation.coeffs().allFinite() &&
         y.linear_momentum.allFinite() && y.angular_momentum.allFinite();
}

void hold_still(BodyState& y) THIGMA_RT {
  y.linear_momentum.setZero();
  y.angular_momentum.setZero();
}

/// The clutch has closed: the handle stands for the grasp point, or stays where it is, and both
/// springs are at rest.
void take_hold(const HapticParams& params, const Pose& handle, HapticState& state) THIGMA_RT {
  if (params.grasp_place == GraspPlace::grasp_point) {
    const Pose world_from_body{state.body.position, state.body.orientation};
    const Pose place{transform_point(world_from_body, params.grasp_point),
                     params.workspace.world_from_device.orientation * handle.orientation};
    state.anchor = anchor_at(handle, place);
  }
  const Motion still{handle, Twist{}};
  const Motion world =
      world_motion(params.workspace, state.anchor, still, params.device.senses_rotation);
  grasp(state.coupling, state.body, world.pose);
  state.is_grasped = true;
}

void let_go(HapticState& state) THIGMA_RT {
  release(state.coupling);
  hold_still(state.body);
  state.is_grasped = false;
  state.bristles = {};
}

/// A device that was lost and answers again: a new press of the clutch clears the fault, the next
/// frame takes hold.
void resume_by_clutch(const DeviceState& device, HapticState& state) THIGMA_RT {
  if (device.status != DeviceStatus::ok) return;
  const bool is_pressed = (device.buttons & kClutchButton) != 0;
  if (is_pressed && !state.was_pressed) {
    clear_fault(state.safety);
  } else {
    state.was_pressed = is_pressed;
  }
}

void follow_clutch(const HapticParams& params, const DeviceState& device, bool is_usable,
                   HapticState& state) THIGMA_RT {
  if (state.safety.fault != Fault::none) {
    if (state.is_grasped) let_go(state);
    if (is_resumable(params, state.safety.fault)) resume_by_clutch(device, state);
    return;
  }
  if (!is_usable) return;
  const bool is_pressed = (state.last_device.buttons & kClutchButton) != 0;
  if (is_pressed && !state.was_pressed) take_hold(params, state.last_device.motion.pose, state);
  if (!is_pressed && state.is_grasped) let_go(state);
  state.was_pressed = is_pressed;
}

/// How the terms of a model stand at a state.
struct ActiveTerms {
  std::int32_t count = 0;                                         // terms within reach
  double penetration = -std::numeric_limits<double>::infinity();  // deepest [m]
  double sunk = 0.0;  // how much deeper that one is than at the state the model was made for [m]
};

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

/// The tick as told, or a fault in its place where it has no time or no length. Recordings hold
/// what this returns, so that they replay.
HapticTick checked(const HapticTick& tick, HapticState& state) THIGMA_RT {
  HapticTick result = tick;
  if (!std::isfinite(tick.now) || !std::isfinite(tick.elapsed) || !(tick.elapsed > 0.0)) {
    constexpr double kUsual = 1e-3;  // only there for a division to be done
    result = {state.time, kUsual, Fault::not_finite};
  }
  state.time = result.now;
  return result;
}

/// Step 1: the device sample, whether it may be believed, and the newest contact model.
void read_inputs(const HapticParams& params, const HapticPorts& ports, const HapticTick& tick,
                 HapticState& state, HapticSample& sample) THIGMA_RT {
  SafetyState& safety = state.safety;
  sample.frame = state.frame++;
  sample.time = tick.now;
  sample.elapsed = tick.elapsed;
  sample.external_fault = tick.external_fault;
  sample.step_cpu = state.step_cpu;
  sample.wake_late = state.wake_late;
  sample.device = ports.device->read(tick.now);
  if (tick.external_fault == Fault::watchdog && params.safety.rides_out_gaps) {
    ride_out_gap(safety, tick.now);
  } else if (tick.external_fault != Fault::none) {
    latch_fault(safety, tick.external_fault, tick.now);
  }
  const bool is_usable = check_device(params.safety, sample.device, tick.now, tick.elapsed, safety);
  if (is_usable && sample.device.status != DeviceStatus::not_ready) {
    state.last_device = sample.device;
    const DeviceState& device = sample.device;
    observe_motion(state.energy, device.has_true_handle ? device.true_handle : device.motion.pose);
    if (params.passivity.is_on)
      observe_handle(params.passivity, device.motion, tick.now, state.passivity);
  }
  ports.models->fetch();
  const LinearContactModel& model = ports.models->value();
  sample.model_sequence = model.sequence;
  sample.model_age =
      model.sequence == 0 ? std::numeric_limits<double>::infinity() : tick.now - model.time;
  sample.model_weight =
      model_weight(params.safety, sample.model_age, tick.now, tick.elapsed, safety);
  sample.input_digest = input_digest(sample);
  follow_clutch(params, sample.device, is_usable, state);
  if (!params.device.senses_rotation && state.is_grasped) {
    turn_by_buttons(params.workspace, state.last_device.buttons, params.turn_rate, tick.elapsed,
                    state.anchor);
  }
  sample.handle = world_motion(params.workspace, state.anchor, state.last_device.motion,
                               params.device.senses_rotation);
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

/// Steps 2-4 of the constrained response: the coupling alone, then what the rows allow. Returns how
/// the rows stand.
ActiveTerms advance_constrained(const HapticParams& params, const LinearContactModel& model,
                                std::int64_t (*clock)() noexcept, HapticSample& sample,
                                HapticState& state) THIGMA_RT {
  ActiveTerms active;
  const BodyState before = state.body;
  const BodyAtState at = at_state(params.body, before);
  StepForces forces;
  forces.wrench = coupling_wrench(faded(state.coupling, state.last_device.weight), sample.handle,
                                  at, &forces.jacobian);
  const ConstrainedStep step = constrained_step(
      at, forces, {model.constraints, params.constraint, sample.elapsed, params.impacts, clock},
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

/// Steps 2-4 of any response; returns how the contacts stand after them.
ActiveTerms move_body(const HapticParams& params, const HapticPorts& ports, HapticSample& sample,
                      HapticState& state) THIGMA_RT {
  const LinearContactModel& model = ports.models->value();
  if (params.response == ResponseKind::constrained) {
    if (state.is_grasped) return advance_constrained(params, model, ports.clock, sample, state);
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

/// Wrench of the contacts on the body about its centre of mass, with friction.
Wrench all_contact(const LinearContactModel& model, const RigidBody& body, double scale,
                   const HapticState& state) THIGMA_RT {
  const Wrench push = contact_wrench(model, body, state.body, scale);
  return state.bristles.entries.empty() ? push : push + state.bristles.wrench;
}

/// The wrench of the contacts on the body as the hand feels it, about the handle. What a stale
/// model fades by comes with the limits.
Wrench contact_on_hand(const LinearContactModel& model, const RigidBody& body, const Motion& hand,
                       const HapticState& state) THIGMA_RT {
  const Wrench push = all_contact(model, body, 1.0, state);
  return {push.force, push.torque + (state.body.position - hand.pose.position).cross(push.force)};
}

/// The command made passive. The device's maxima hold behind the damping as they did before it.
void make_passive(const HapticParams& params, HapticState& state, HapticSample& sample) THIGMA_RT {
  Wrench sent = passive_wrench(params.passivity, state.last_device.motion, sample.command,
                               sample.time, state.passivity);
  sent.force = clamped(sent.force, std::min(params.safety.max_force, params.device.max_force));
  sent.torque = clamped(sent.torque, std::min(params.safety.max_torque, params.device.max_torque));
  correct_sent(sent, state.passivity);
  sample.command = sent;
}

/// What a frame works on.
struct FrameWork {
  const HapticParams& params;
  const HapticPorts& ports;
  const LinearContactModel& model;
  HapticState& state;
  HapticSample& sample;
};

/// The wrench of coupling or contacts on the hand about the handle, before the limits [world].
Wrench wrench_on_hand(const FrameWork& frame) THIGMA_RT {
  const HapticParams& params = frame.params;
  const HapticState& state = frame.state;
  HapticSample& sample = frame.sample;
  if (params.response == ResponseKind::direct)
    return contact_on_hand(frame.model, params.body, sample.handle, state);
  sample.coupling = coupling_wrench(faded(state.coupling, state.last_device.weight), sample.handle,
                                    params.body, state.body);
  return coupling_reaction(state.coupling, sample.handle, params.body, state.body);
}

/// Steps 5 and 6: what the hand gets, within the limits.
void send_wrench(const FrameWork& frame, const ActiveTerms& active) THIGMA_RT {
  const HapticParams& params = frame.params;
  HapticState& state = frame.state;
  HapticSample& sample = frame.sample;
  SafetyState& safety = state.safety;
  // Nothing arms on a model that does not count fully.
  const bool may_be_armed = state.is_grasped && (safety.is_armed || sample.model_weight >= 1.0);
  // Rows keep the object outside: taken hold of in contact, its springs are at rest.
  const bool is_constrained = params.response == ResponseKind::constrained;
  const bool is_inside = !is_constrained && active.count > 0;
  update_arming(params.safety, may_be_armed, is_inside, sample.time, safety);
  if (params.response == ResponseKind::coupled) {
    sample.contact = all_contact(frame.model, params.body, sample.model_weight, state);
  } else if (!is_constrained) {  // whose bristles do not fade
    sample.contact = sample.model_weight * all_contact(frame.model, params.body, 1.0, state);
  }
  const Wrench wanted = device_wrench(params.workspace, wrench_on_hand(frame));
  const double weight = sample.model_weight * state.last_device.weight;
  sample.feedback = limit_wrench(params.safety, params.device, {wanted, weight},
                                 {sample.time, sample.elapsed}, safety);
  sample.command = sample.feedback;
  if (!params.device.actuates_rotation) sample.command.torque.setZero();
  if (!params.device.actuates_translation) sample.command.force.setZero();
  if (params.passivity.is_on) make_passive(params, state, sample);
  frame.ports.device->write(sample.command);
  observe_wrench(state.energy, sample.command);
}

}  // namespace

void use_device_limits(const DeviceLimits& limits, HapticParams& params) {
  params.device = limits;
  if (limits.holds_person) params.safety.rides_out_gaps = false;
}

HapticState initial_state(const HapticParams& params, const Pose& world_from_body) THIGMA_RT {
  HapticState state;
  state.body.position = world_from_body.position;
  state.body.orientation = world_from_body.orientation;
  state.coupling = params.coupling;
  release(state.coupling);
  state.anchor = base_anchor(params.workspace);
  return state;
}

HapticSample haptic_step(const HapticParams& params, const HapticPorts& ports,
                         const HapticTick& told, HapticState& state) THIGMA_RT {
  const HapticTick tick = checked(told, state);
  HapticSample sample;
  read_inputs(params, ports, tick, state, sample);
  const LinearContactModel& model = ports.models->value();
  const ActiveTerms active = move_body(params, ports, sample, state);
  send_wrench({params, ports, model, state, sample}, active);
  if (state.safety.fault != Fault::none && state.is_grasped) let_go(state);

  sample.body = state.body;
  sample.penetration = active.penetration;
  sample.touching = active.count;
  sample.sunk = active.sunk;
  sample.stretch = coupling_stretch(state.coupling, sample.handle.pose, state.body).linear.norm();
  sample.energy = state.energy.energy;
  sample.is_grasped = state.is_grasped;
  sample.is_armed = state.safety.is_armed;
  sample.fault = state.safety.fault;
  // 7. What the others see.
  if (ports.bodies != nullptr)
    ports.bodies->publish(
        {state.body, tick.now, sample.frame, state.wanted_speed, state.wanted_gain});
  if (ports.telemetry != nullptr) ports.telemetry->push(sample);
  return sample;
}

}  // namespace thigma
