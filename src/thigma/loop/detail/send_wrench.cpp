#include "thigma/loop/detail/send_wrench.h"

#include <algorithm>

#include "thigma/loop/detail/taps.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

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

/// Nothing along axes that the device does not actuate.
void leave_actuated(const DeviceLimits& device, Wrench& wrench) THIGMA_RT {
  if (!device.actuates_rotation) wrench.torque.setZero();
  if (!device.actuates_translation) wrench.force.setZero();
}

/// The command made passive. The device's maxima hold behind the damping as they did before it, and
/// what it cannot give is neither damped nor counted as given.
void make_passive(const HapticParams& params, HapticState& state, HapticSample& sample) THIGMA_RT {
  PassivityParams passivity = params.passivity;
  if (!params.device.actuates_rotation) passivity.max_angular_damping = 0.0;
  Wrench sent = passive_wrench(passivity, state.last_device.motion, sample.command, sample.time,
                               state.passivity);
  sent.force = clamped(sent.force, std::min(params.safety.max_force, params.device.max_force));
  sent.torque = clamped(sent.torque, std::min(params.safety.max_torque, params.device.max_torque));
  leave_actuated(params.device, sent);
  correct_sent(sent, state.passivity);
  sample.command = sent;
}

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

/// Whether impacts may ring.
bool is_tapped(const HapticParams& params) THIGMA_RT {
  return params.response == ResponseKind::constrained && !params.impacts.empty();
}

/// Adds what rings; its change is not slowed down as that of other forces is.
void add_taps(const FrameWork& frame, AskedWrench& asked) THIGMA_RT {
  HapticState& state = frame.state;
  const Pose& now = frame.sample.handle.pose;
  const Pose& last = state.handle;
  Vec6 moved;
  moved << now.position - last.position,
      vector_from_rotation(now.orientation * last.orientation.conjugate());
  const Wrench before = state.taps.asked;
  const Wrench tap = frame.sample.tap = next_taps(moved, frame.sample.elapsed, state.taps);
  const Workspace& workspace = frame.params.workspace;
  const Wrench change =
      device_wrench(workspace, {tap.force - before.force, tap.torque - before.torque});
  asked.wanted = asked.wanted + device_wrench(workspace, tap);
  asked.force_change = change.force.norm();
  asked.torque_change = change.torque.norm();
}

/// What of the taps has passed the limits is what they are charged for.
void hold_taps(const AskedWrench& asked, const Wrench& sent, TapState& taps) THIGMA_RT {
  const auto share = [](const Vec3& part, const Vec3& whole) {
    const double size = whole.norm();
    return size > 0.0 ? std::min(part.norm() / size, 1.0) : 0.0;
  };
  taps.held.force = share(sent.force, asked.wanted.force) * taps.asked.force;
  taps.held.torque = share(sent.torque, asked.wanted.torque) * taps.asked.torque;
}

}  // namespace

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
  if (params.response == ResponseKind::coupled || params.response == ResponseKind::potential) {
    sample.contact = all_contact(frame.model, params.body, sample.model_weight, state);
  } else if (!is_constrained) {  // whose bristles do not fade
    sample.contact = sample.model_weight * all_contact(frame.model, params.body, 1.0, state);
  }
  AskedWrench asked;
  asked.wanted = device_wrench(params.workspace, wrench_on_hand(frame));
  asked.weight = sample.model_weight * state.last_device.weight;
  if (is_tapped(params)) add_taps(frame, asked);
  sample.feedback =
      limit_wrench(params.safety, params.device, asked, {sample.time, sample.elapsed}, safety);
  if (is_tapped(params)) hold_taps(asked, sample.feedback, state.taps);
  sample.command = sample.feedback;
  leave_actuated(params.device, sample.command);
  if (params.passivity.is_on) make_passive(params, state, sample);
  frame.ports.device->write(sample.command);
  observe_wrench(state.energy, sample.command);
}

}  // namespace thigma::detail
