// Finding, opening, initialising and closing devices; what kind they are.
#include <algorithm>

#include "drd.h"

namespace standin {
namespace {

int device_count() { return std::clamp(static_cast<int>(get(0, k_count)), 0, kUnits); }

int open_index(const char* call, int index) {
  if (index < 0 || index >= device_count()) {
    return fail(0, call, index < 0 ? kInvalidIndex : kNoDeviceFound);
  }
  if (is_on(index, k_unplug)) {
    return fail(index, call, kNoDeviceFound);
  }
  if (is_on(index, k_fail_open)) {
    return fail(index, call, static_cast<int>(get(index, k_fail_open)));
  }
  start_device();
  const Locked lock;
  if (!is_on(index, k_opened)) {
    put(index, k_up_axis, 2);
    open_unit(index);
    put(index, k_regulated, 0);
    put(index, k_expert, 0);
    put(index, k_limit_force, -1);
    put(index, k_limit_torque, -1);
    forget_poses(index);
  }
  note(index, call, index);
  set_default_unit(index);
  return index;
}

int open_first(const char* call) {
  for (int i = 0; i < device_count(); ++i) {
    if (!is_on(i, k_opened)) {
      return open_index(call, i);
    }
  }
  return fail(0, call, kNoDeviceFound);
}

int close_id(const char* call, signed char id) {
  const int unit = opened_unit(id, call);
  if (unit < 0) {
    return -1;
  }
  const Locked lock;
  put(unit, k_regulated, 0);
  note(unit, call, 0);
  close_unit(unit);
  return 0;
}

// Regulation: the SDK's own thread holds the pose, forces of the application do nothing.
void regulate(int unit) {
  put(unit, k_regulated, 1);
  put(unit, k_mode, kForce);
  put(unit, k_last_set_time, now());
}

// The regulation thread is what feeds the watchdog while it runs: the application does not.
int end_regulation(int unit, bool keep_force) {
  put(unit, k_regulated, 0);
  put(unit, k_last_set_time, now());
  if (!keep_force) {
    forces_off(unit, kBrake, kSoftware, "device: brake after regulation");
  }
  return 0;
}

int initialise(signed char id, const char* call) {
  const int unit = begin_call(id, call, k_fail_init);
  if (unit < 0) {
    return -1;
  }
  sleep_until(now() + 1e-3 * get(unit, k_init_ms));
  if (fault(unit, k_fail_init) != 0) {
    return fail(unit, call, fault(unit, k_fail_init));
  }
  const Locked lock;
  put(unit, k_initialized, 1);
  regulate(unit);
  note(unit, call, 0);
  return 0;
}

}  // namespace
}  // namespace standin

using namespace standin;

STANDIN_EXPORT int dhdGetDeviceCount() {
  return is_on(0, k_unplug) && device_count() <= 1 ? 0 : device_count();
}
STANDIN_EXPORT int dhdGetAvailableCount() {
  int free = 0;
  for (int i = 0; i < device_count(); ++i) {
    free += is_on(i, k_opened) || is_on(i, k_unplug) ? 0 : 1;
  }
  return free;
}
STANDIN_EXPORT void dhdEnableSimulator(bool on) { note(0, "dhdEnableSimulator", on ? 1 : 0); }
STANDIN_EXPORT int dhdOpen() { return open_first("dhdOpen"); }
STANDIN_EXPORT int dhdOpenID(signed char id) { return open_index("dhdOpenID", id); }
STANDIN_EXPORT int drdOpen() { return open_first("drdOpen"); }
STANDIN_EXPORT int drdOpenID(signed char id) { return open_index("drdOpenID", id); }
STANDIN_EXPORT int dhdClose(signed char id) { return close_id("dhdClose", id); }
STANDIN_EXPORT int drdClose(signed char id) { return close_id("drdClose", id); }

STANDIN_EXPORT int dhdSetDevice(signed char id) {
  if (id < 0 || id >= kUnits || !is_on(id, k_opened)) {
    return fail(0, "dhdSetDevice", kInvalidIndex);
  }
  set_default_unit(id);
  return 0;
}
STANDIN_EXPORT int drdSetDevice(signed char id) { return dhdSetDevice(id); }
STANDIN_EXPORT int dhdGetDeviceID() { return default_unit(); }
STANDIN_EXPORT int drdGetDeviceID() { return default_unit(); }

STANDIN_EXPORT bool drdIsInitialized(signed char id) {
  const int unit = opened_unit(id, "drdIsInitialized");
  return unit >= 0 && is_on(unit, k_initialized);
}
STANDIN_EXPORT bool drdIsSupported(signed char id) {
  return opened_unit(id, "drdIsSupported") >= 0;
}
STANDIN_EXPORT bool drdIsRunning(signed char id) {
  const int unit = opened_unit(id, "drdIsRunning");
  return unit >= 0 && is_on(unit, k_regulated);
}
STANDIN_EXPORT bool drdIsMoving(signed char) { return false; }
STANDIN_EXPORT int drdAutoInit(signed char id) { return initialise(id, "drdAutoInit"); }
STANDIN_EXPORT int drdCheckInit(signed char id) { return initialise(id, "drdCheckInit"); }

STANDIN_EXPORT int drdStart(signed char id) {
  const int unit = begin_call(id, "drdStart", k_fail_init);
  if (unit < 0) {
    return -1;
  }
  if (!is_on(unit, k_initialized)) {
    return fail(unit, "drdStart", kDeviceNotReady);
  }
  const Locked lock;
  regulate(unit);
  note(unit, "drdStart", 0);
  return 0;
}

STANDIN_EXPORT int drdStop(bool keep_force, signed char id) {
  const int unit = begin_call(id, "drdStop", k_fail_stop);
  if (unit < 0) {
    return -1;
  }
  const Locked lock;
  const double value = keep_force ? 1.0 : 0.0;
  note(unit, "drdStop", 0, &value, 1);
  return end_regulation(unit, keep_force);
}

STANDIN_EXPORT int dhdGetSystemType(signed char id) {
  const int unit = opened_unit(id, "dhdGetSystemType");
  return unit < 0 ? -1 : type_of(unit).number;
}
STANDIN_EXPORT const char* dhdGetSystemName(signed char id) {
  const int unit = opened_unit(id, "dhdGetSystemName");
  return unit < 0 ? nullptr : type_of(unit).name;
}
STANDIN_EXPORT int dhdGetSerialNumber(unsigned short* number, signed char id) {
  const int unit = opened_unit(id, "dhdGetSerialNumber");
  if (unit >= 0) {
    *number = static_cast<unsigned short>(get(unit, k_serial) + unit);
  }
  return unit < 0 ? -1 : 0;
}
STANDIN_EXPORT void dhdGetSDKVersion(int* major, int* minor, int* release, int* revision) {
  *major = static_cast<int>(get(0, k_sdk_major));
  *minor = static_cast<int>(get(0, k_sdk_minor));
  *release = static_cast<int>(get(0, k_sdk_release));
  *revision = static_cast<int>(get(0, k_sdk_revision));
}

#define STANDIN_FEATURE(function, member)        \
  STANDIN_EXPORT bool function(signed char id) { \
    const int unit = opened_unit(id, #function); \
    return unit >= 0 && type_of(unit).member;    \
  }
STANDIN_FEATURE(dhdHasWrist, wrist)
STANDIN_FEATURE(dhdHasActiveWrist, active_wrist)
STANDIN_FEATURE(dhdHasGripper, gripper)
STANDIN_FEATURE(dhdHasActiveGripper, active_gripper)
STANDIN_FEATURE(dhdIsLeftHanded, left)
STANDIN_EXPORT bool dhdHasBase(signed char id) { return opened_unit(id, "dhdHasBase") >= 0; }
