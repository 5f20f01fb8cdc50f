// One frame of the haptic thread, Sec. 5.1.2 steps 1-6, with the safety layer around it.

#include "thigma/loop/haptic_step.h"

#include <cmath>
#include <limits>

#include "thigma/loop/detail/clutch.h"
#include "thigma/loop/detail/move_body.h"
#include "thigma/loop/detail/send_wrench.h"

namespace thigma {
namespace {

using namespace detail;

/// The tick as told, or a fault in its place where it has no time or no length, or goes back, as
/// models and samples of later would seem new. Recordings hold what this returns, so that they
/// replay.
HapticTick checked(const HapticTick& tick, HapticState& state) THIGMA_RT {
  HapticTick result = tick;
  const bool goes_back = state.frame > 0 && tick.now < state.time;
  if (goes_back || !std::isfinite(tick.now) || !std::isfinite(tick.elapsed) ||
      !(tick.elapsed > 0.0)) {
    constexpr double kUsual = 1e-3;  // only there for a division to be done
    result = {state.time, kUsual, Fault::not_finite};
  }
  state.time = result.now;
  return result;
}

/// The newest contact model, under constraints where its rows hold.
void take_model(const HapticParams& params, const HapticPorts& ports,
                const HapticState& state) THIGMA_RT {
  const LinearContactModel* offered = ports.models->offered();
  if (offered == nullptr) return;
  const bool has_rows = params.response == ResponseKind::constrained && state.is_grasped &&
                        ports.stepper.step == nullptr;
  if (has_rows && !may_take(offered->constraints, ports.models->value().constraints, state.body))
    return;
  ports.models->take();
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
  take_model(params, ports, state);
  const LinearContactModel& model = ports.models->value();
  sample.model_sequence = model.sequence;
  sample.model_age =
      model.sequence == 0 ? std::numeric_limits<double>::infinity() : tick.now - model.time;
  const ModelAge age{sample.model_age, model.time, model.sequence,
                     params.response == ResponseKind::constrained};
  sample.model_weight = model_weight(params.safety, age, tick.now, tick.elapsed, safety);
  sample.input_digest = input_digest(sample);
  follow_clutch(params, sample.device, is_usable, state);
  if (!params.device.senses_rotation && state.is_grasped) {
    turn_by_buttons(params.workspace, state.last_device.buttons, params.turn_rate, tick.elapsed,
                    state.anchor);
  }
  sample.handle = world_motion(params.workspace, state.anchor, state.last_device.motion,
                               params.device.senses_rotation);
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
  state.handle = sample.handle.pose;

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
