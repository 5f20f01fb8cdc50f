// Forces, force mode, brakes, limits, status.
#include <cmath>

#include "drd.h"

namespace standin {
namespace {

bool is_finite(const Sent& sent) {
  return std::isfinite(norm(sent.force)) && std::isfinite(norm(sent.torque)) &&
         std::isfinite(sent.gripper);
}

Vec scaled_to(const Vec& v, double limit) {
  const double n = norm(v);
  return n <= limit || n == 0.0 ? v : Vec{v[0] * limit / n, v[1] * limit / n, v[2] * limit / n};
}

// Limits the application set first, then what motors can; gravity compensation is added on the
// host.
bool drive(int unit, const Sent& sent) {
  const DeviceType& type = type_of(unit);
  const double most = is_on(unit, k_max_force) ? get(unit, k_max_force) : type.max_force;
  const double most_torque = is_on(unit, k_max_torque) ? get(unit, k_max_torque) : type.max_torque;
  Vec force = sent.force;
  Vec torque = sent.torque;
  if (get(unit, k_limit_force) >= 0.0) {
    force = scaled_to(force, get(unit, k_limit_force));
  }
  if (get(unit, k_limit_torque) >= 0.0) {
    torque = scaled_to(torque, get(unit, k_limit_torque));
  }
  if (!type.active_wrist) {
    if (norm(torque) != 0.0) {
      add(unit, k_torque_ignored);
    }
    torque = {0, 0, 0};
  }
  const bool saturated =
      norm(force) > most || norm(torque) > most_torque || is_on(unit, k_saturate);
  force = scaled_to(force, most);
  torque = scaled_to(torque, most_torque);
  if (is_on(unit, k_gravity)) {
    force[2] += get(unit, k_weight);
  }
  apply(unit, force, torque);
  return saturated;
}

int send(signed char id, Sent sent) {
  const int unit = opened_unit(id, sent.call);
  if (unit < 0) {
    return -1;
  }
  communicate(unit);
  int error = fault(unit, k_fail_set);
  error = error == 0 && !is_finite(sent) ? static_cast<int>(kInvalid) : error;
  if (error != 0) {
    {
      const Locked lock;
      sent.code = -error;
      record(unit, sent);
    }
    return fail(unit, sent.call, error);
  }
  const Locked lock;
  advance(unit);
  if (is_on(unit, k_regulated)) {
    add(unit, k_set_while_regulated);
  } else if (drive(unit, sent)) {
    add(unit, k_saturations);
    sent.code = kMotorSaturatedReturn;
  }
  record(unit, sent);
  return sent.code;
}

int set_limit(signed char id, const char* call, Key key, double limit) {
  const int unit = opened_unit(id, call);
  if (unit < 0) {
    return -1;
  }
  const Locked lock;
  note(unit, call, 0, &limit, 1);
  put(unit, key, limit < 0.0 ? -1.0 : limit);
  return 0;
}

void fill_status(int unit, int* status) {
  const int mode = static_cast<int>(get(unit, k_mode));
  const bool there = !is_on(unit, k_unplug) && is_on(unit, k_plugged);
  const int values[] = {there ? 1 : 0,
                        there ? 1 : 0,
                        1,
                        is_on(unit, k_initialized) ? 0 : 1,
                        mode == kIdle ? 1 : 0,
                        mode == kForce ? 1 : 0,
                        mode == kBrake ? 1 : 0,
                        mode == kForce && type_of(unit).active_wrist ? 1 : 0,
                        type_of(unit).wrist ? 1 : 0,
                        there ? 0 : 1,
                        is_on(unit, k_gravity) ? 1 : 0,
                        get(unit, k_timeguard_us) > 0.0 ? 1 : 0,
                        is_on(unit, k_initialized) ? 1 : 0,
                        0,
                        static_cast<int>(get(unit, k_force_off_cause)),
                        0,
                        is_on(unit, k_initialized) ? 1 : 0};
  for (int i = 0; i < static_cast<int>(get(unit, k_status_count)) && i < 17; ++i) {
    status[i] = values[i];
  }
}

// An order to the device with one number.
template <class Act>
int order(signed char id, const char* call, double value, Act act) {
  const int unit = begin_call(id, call, k_fail_stop);
  if (unit < 0) {
    return -1;
  }
  const Locked lock;
  advance(unit);
  note(unit, call, 0, &value, 1);
  act(unit);
  return 0;
}

}  // namespace
}  // namespace standin

using namespace standin;

STANDIN_EXPORT int dhdSetForce(double fx, double fy, double fz, signed char id) {
  return send(id, {"dhdSetForce", {fx, fy, fz}, {0, 0, 0}, 0.0, 0});
}

STANDIN_EXPORT int dhdSetForceAndTorque(double fx, double fy, double fz, double tx, double ty,
                                        double tz, signed char id) {
  return send(id, {"dhdSetForceAndTorque", {fx, fy, fz}, {tx, ty, tz}, 0.0, 0});
}

#ifndef STANDIN_MISSING_SYMBOL
STANDIN_EXPORT int dhdSetForceAndTorqueAndGripperForce(double fx, double fy, double fz, double tx,
                                                       double ty, double tz, double fg,
                                                       signed char id) {
  return send(id, {"dhdSetForceAndTorqueAndGripperForce", {fx, fy, fz}, {tx, ty, tz}, fg, 0});
}
#endif

STANDIN_EXPORT int dhdGetForceAndTorqueAndGripperForce(double* fx, double* fy, double* fz,
                                                       double* tx, double* ty, double* tz,
                                                       double* fg, signed char id) {
  const int unit = opened_unit(id, "dhdGetForceAndTorqueAndGripperForce");
  if (unit < 0) {
    return -1;
  }
  double* out[7] = {fx, fy, fz, tx, ty, tz, fg};
  const Locked lock;
  for (int i = 0; i < 7; ++i) {
    *out[i] = i < 6 ? get(unit, static_cast<Key>(k_applied_fx + i)) : 0.0;
  }
  return 0;
}

STANDIN_EXPORT int dhdEnableForce(unsigned char on, signed char id) {
  return order(id, "dhdEnableForce", on, [on](int unit) {
    if (on != 0) {
      // It may have gone since the call began: then it stays off, for that cause.
      if (is_on(unit, k_unplug) || !is_on(unit, k_plugged)) return;
      put(unit, k_mode, kForce);
      put(unit, k_force_off_cause, kNone);
      put(unit, k_last_set_time, now());
    } else {
      forces_off(unit, kBrake, kSoftware, "device: forces disabled");
    }
  });
}

STANDIN_EXPORT int dhdStop(signed char id) {
  return order(id, "dhdStop", 0.0,
               [](int unit) { forces_off(unit, kBrake, kSoftware, "device: stopped, brake"); });
}

STANDIN_EXPORT int dhdSetBrakes(int on, signed char id) {
  return order(id, "dhdSetBrakes", on, [on](int unit) {
    if (on != 0) {
      forces_off(unit, kBrake, kSoftware, "device: brake");
    } else if (mode_of(unit) == kBrake) {
      put(unit, k_mode, kIdle);
    }
  });
}

STANDIN_EXPORT int dhdSetGravityCompensation(int on, signed char id) {
  return order(id, "dhdSetGravityCompensation", on,
               [on](int unit) { put(unit, k_gravity, on != 0 ? 1.0 : 0.0); });
}

STANDIN_EXPORT int dhdSetMaxForce(double limit, signed char id) {
  return set_limit(id, "dhdSetMaxForce", k_limit_force, limit);
}

STANDIN_EXPORT int dhdSetMaxTorque(double limit, signed char id) {
  return set_limit(id, "dhdSetMaxTorque", k_limit_torque, limit);
}

STANDIN_EXPORT int dhdGetStatus(int* status, signed char id) {
  const int unit = opened_unit(id, "dhdGetStatus");
  if (unit < 0) {
    return -1;
  }
  if (status == nullptr) {
    return fail(unit, "dhdGetStatus", kNullArgument);
  }
  {
    const Locked lock;
    advance(unit);
    fill_status(unit, status);
  }
  const int error = fault(unit, k_fail_read);
  return error == 0 ? 0 : fail(unit, "dhdGetStatus", error);
}
