#include "device.h"

#include <algorithm>
#include <cmath>

#include "board.h"

namespace standin {
namespace {

constexpr double kWatchdogUnit = 125e-6;  // s

bool finite(const Vec& v) {
  return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

void put_applied(int unit, const Vec& force, const Vec& torque) {
  for (int i = 0; i < 3; ++i) {
    put(unit, static_cast<Key>(k_applied_fx + i), force[i]);
    put(unit, static_cast<Key>(k_applied_tx + i), torque[i]);
  }
}

void watch(int unit, double time) {
  if (is_on(unit, k_unplug) && is_on(unit, k_plugged)) {
    put(unit, k_plugged, 0.0);
    forces_off(unit, kIdle, kUnplugged, "device: unplugged");
  }
  if (mode_of(unit) != kForce) {
    return;
  }
  if (is_on(unit, k_cut)) {  // the user's button, a dead man's switch
    forces_off(unit, kBrake, static_cast<Cause>(static_cast<int>(get(unit, k_cut))), "device: cut");
    return;
  }
  // The vendor's regulation thread, in the client, is what feeds the watchdog while it runs.
  if (is_on(unit, k_regulated) && (board().device.load() <= 0 || !is_dead(board().client.load()))) {
    put(unit, k_last_set_time, time);
  }
  const double silence = time - get(unit, k_last_set_time);
  if (is_on(unit, k_watchdog) && silence > kWatchdogUnit * get(unit, k_watchdog)) {
    add(unit, k_watchdog_trips);
    forces_off(unit, kBrake, kWatchdog, "device: watchdog");
  } else if (is_on(unit, k_comm_timeout_ms) && silence > 1e-3 * get(unit, k_comm_timeout_ms)) {
    add(unit, k_watchdog_trips);
    forces_off(unit, kIdle, kWatchdog, "device: silence of the host");
  } else if (is_on(unit, k_velocity_threshold) &&
             norm({get(unit, k_vx), get(unit, k_vy), get(unit, k_vz)}) >
                 get(unit, k_velocity_threshold)) {
    add(unit, k_velocity_trips);
    forces_off(unit, kBrake, kVelocity, "device: velocity");
  }
}

void heat(int unit, double seconds) {
  if (is_on(unit, k_heating)) {
    const double f =
        norm({get(unit, k_applied_fx), get(unit, k_applied_fy), get(unit, k_applied_fz)});
    const double t = get(unit, k_motor_temperature);
    put(unit, k_motor_temperature,
        std::clamp(t + seconds * (get(unit, k_heating) * f - 0.01 * t), 0.0, 1.0));
  }
}

}  // namespace

Mode mode_of(int unit) { return static_cast<Mode>(static_cast<int>(get(unit, k_mode))); }

void open_unit(int unit) {
  put(unit, k_opened, 1.0);
  put(unit, k_plugged, 1.0);
  put(unit, k_mode, kIdle);
  put(unit, k_force_off_cause, kNone);
  put(unit, k_start_time, now());
  put(unit, k_step_time, now());
  put(unit, k_last_set_time, now());
  for (int i = 0; i < 3; ++i) {
    put(unit, static_cast<Key>(k_px + i), get(unit, static_cast<Key>(k_target_x + i)));
    put(unit, static_cast<Key>(k_vx + i), 0.0);
    put(unit, static_cast<Key>(k_wx + i), 0.0);
  }
  const Quat q = turn({get(unit, k_target_rx), get(unit, k_target_ry), get(unit, k_target_rz)});
  put(unit, k_qw, q[0]);
  put(unit, k_qx, q[1]);
  put(unit, k_qy, q[2]);
  put(unit, k_qz, q[3]);
}

void close_unit(int unit) {
  forces_off(unit, kIdle, kSoftware, "device: closed");
  put(unit, k_opened, 0.0);
}

void advance(int unit) {
  const double time = now();
  const double before = get(unit, k_step_time);
  move_handle(unit, time);
  heat(unit, time - before);
  watch(unit, time);
}

void record(int unit, const Sent& sent) {
  const double v[7] = {sent.force[0],  sent.force[1],  sent.force[2], sent.torque[0],
                       sent.torque[1], sent.torque[2], sent.gripper};
  note(unit, sent.call, sent.code, v, 7);
  add(unit, k_sets);
  if (!finite(sent.force) || !finite(sent.torque) || !std::isfinite(sent.gripper)) {
    add(unit, k_non_finite);
  }
  for (int i = 0; i < 7; ++i) {
    put(unit, static_cast<Key>(k_last_fx + i), v[i]);
  }
  put(unit, k_force_max, std::fmax(get(unit, k_force_max), norm(sent.force)));
  put(unit, k_torque_max, std::fmax(get(unit, k_torque_max), norm(sent.torque)));
  if (norm(sent.torque) != 0.0) {
    add(unit, k_torque_nonzero);
  }
  put(unit, k_last_set_time, now());
}

void apply(int unit, const Vec& force, const Vec& torque) {
  if (mode_of(unit) != kForce) {
    add(unit, k_set_while_off);
  } else if (finite(force) && finite(torque)) {
    put_applied(unit, force, torque);
  }
}

void forces_off(int unit, Mode mode, Cause cause, const char* why) {
  if (mode_of(unit) == kForce) {
    put(unit, k_force_off_time, now());
    put(unit, k_force_off_cause, cause);
  }
  put(unit, k_mode, mode);
  put_applied(unit, {0, 0, 0}, {0, 0, 0});
  note(unit, why, cause);
}

void run_device(bool own_process) {
  double client_seen = now();
  while (board().quit.load() == 0) {
    {
      const Locked lock;
      for (int unit = 0; unit < kUnits; ++unit) {
        if (is_on(unit, k_opened)) {
          advance(unit);
        }
      }
    }
    if (!is_dead(board().client.load())) {
      client_seen = now();
    } else if (own_process && now() - client_seen > get(0, k_linger_s)) {
      return;
    }
    sleep_until(now() + 0.001);
  }
}

}  // namespace standin
