// Frames: state is read at the beginning, forces go to the motors at the end.
#include <cmath>
#include <limits>

#include "hd.h"

namespace standin {
namespace {

Vec scaled_to(const Vec& v, double limit) {
  const double n = norm(v);
  return n <= limit || n == 0.0 ? v : Vec{v[0] * limit / n, v[1] * limit / n, v[2] * limit / n};
}

State read_state(int unit) {
  State state;
  state.pose = told_pose(unit);
  if (get(unit, k_calibration) != 0x5000) {
    state.pose.position[1] += get(unit, k_uncalibrated_offset);
  }
  for (int i = 0; i < 3; ++i) {
    state.velocity[i] = get(unit, static_cast<Key>(k_vx + i));
    state.turning[i] = get(unit, static_cast<Key>(k_wx + i));
  }
  if (is_on(unit, k_nan_velocity)) {
    state.velocity[0] = std::numeric_limits<double>::quiet_NaN();
  }
  state.buttons = static_cast<int>(get(unit, k_buttons));
  return state;
}

// The error that the checks of the library find, 0: none.
int check(int unit, const Frame& frame, const Vec& force) {
  if (!std::isfinite(norm(frame.force)) || !std::isfinite(norm(frame.torque))) {
    return kForceError;
  }
  if (get(unit, k_motor_temperature) >= 1.0) {
    return kWarmMotors;
  }
  if (is_on(unit, k_force_check) && norm(force) > max_force_of(unit) * (1.0 + 1e-9)) {
    return kExceededMaxForce;
  }
  const Vec change{force[0] - frame.last_force[0], force[1] - frame.last_force[1],
                   force[2] - frame.last_force[2]};
  const double ms = frame.end_time > 0.0 ? std::fmax(1.0, 1e3 * (now() - frame.end_time)) : 1.0;
  if (is_on(unit, k_impulse_check) && norm(force) > 0.0 &&
      norm(change) > ms * get(unit, k_impulse_limit)) {
    return kExceededMaxForceImpulse;
  }
  if (is_on(unit, k_velocity_check) &&
      norm({get(unit, k_vx), get(unit, k_vy), get(unit, k_vz)}) > get(unit, k_velocity_limit)) {
    return kExceededMaxVelocity;
  }
  return static_cast<int>(get(unit, k_fail_set));
}

// Motors get the force that is left after the library's checks; the error, 0: none.
int drive(int unit, Frame& frame) {
  Vec force = frame.force;
  if (is_on(unit, k_clamping)) {
    force = scaled_to(force, max_force_of(unit));
  }
  const int error = check(unit, frame, force);
  frame.end_time = now();
  frame.last_force = error == 0 ? force : Vec{};
  Vec torque{};
  if (error != 0) {
    force = Vec{};
    frame.ramp_start = now();
  } else if (model_of(unit).output_dof == 6) {
    for (int i = 0; i < 3; ++i) {
      torque[i] = frame.torque[i] * get(unit, k_torque_unit);
    }
    torque = scaled_to(torque, model_of(unit).max_torque);
  }
  if (is_on(unit, k_ramping)) {
    force = scaled_to(force, get(unit, k_ramp_rate) * (now() - frame.ramp_start));
  }
  if (mode_of(unit) == kForce || norm(force) > 0.0 || norm(torque) > 0.0) {
    apply(unit, force, torque);
  }
  return error;
}

int end_frame(int unit) {
  Frame& frame = frame_of(unit);
  const Locked lock;
  advance(unit);
  const int error = is_unplugged(unit) ? static_cast<int>(kCommError) : drive(unit, frame);
  if (frame.force_set || frame.torque_set) {
    record(unit, {"hdEndFrame", frame.force, frame.torque, 0.0, error});
  }
  frame.done_tick = servo_tick();
  return error;
}

}  // namespace
}  // namespace standin

using namespace standin;

STANDIN_EXPORT void hdBeginFrame(unsigned handle) {
  const int unit = unit_of(handle, "hdBeginFrame");
  if (unit < 0) {
    return;
  }
  while (is_on(unit, k_hang)) {
    sleep_until(now() + 0.001);
  }
  make_current(unit);
  Frame& frame = frame_of(unit);
  if (frame.depth == 0 && on_scheduler_thread() && is_on(unit, k_one_frame) &&
      frame.done_tick == servo_tick()) {
    push_error(unit, "hdBeginFrame", kIllegalBegin);
    return;
  }
  if (++frame.depth > 1) {
    return;
  }
  {
    const Locked lock;
    advance(unit);
    add(unit, k_frames);
    if (!on_scheduler_thread()) {
      add(unit, k_off_scheduler);
    }
    frame.force_set = frame.torque_set = false;
    frame.force = frame.torque = Vec{};
    if (!is_unplugged(unit)) {
      frame.last = frame.current;
      frame.current = read_state(unit);
      add(unit, k_reads);
    }
  }
  const int error =
      is_unplugged(unit) ? static_cast<int>(kCommError) : static_cast<int>(get(unit, k_fail_read));
  if (error != 0) {
    push_error(unit, "hdBeginFrame", error);
  }
}

STANDIN_EXPORT void hdEndFrame(unsigned handle) {
  const int unit = unit_of(handle, "hdEndFrame");
  if (unit < 0) {
    return;
  }
  Frame& frame = frame_of(unit);
  if (frame.depth == 0) {
    push_error(unit, "hdEndFrame", kIllegalEnd);
    return;
  }
  if (--frame.depth > 0) {
    return;
  }
  const int error = end_frame(unit);
  if (error != 0) {
    push_error(unit, "hdEndFrame", error);
  }
}
