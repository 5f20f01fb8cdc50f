// Devices: initialising, current one, capabilities, calibration.
#include <cstring>

#include "hd.h"

namespace standin {
namespace {

constexpr int kCalibrationOk = 0x5000;
constexpr int kStyleInkwell = 4;

// The device of a name, -1 where none has it. Bits of key `names`: 1 null, 2 and 4 the two default
// names.
int find_device(const char* name) {
  const int names = static_cast<int>(get(0, k_names));
  if (name == nullptr) {
    return (names & 1) != 0 ? 0 : -1;
  }
  if (std::strcmp(name, "Default Device") == 0) {
    return (names & 2) != 0 ? 0 : -1;
  }
  if (std::strcmp(name, "Default PHANToM") == 0) {
    return (names & 4) != 0 ? 0 : -1;
  }
  if (std::strcmp(name, "Left Device") == 0) {
    return 0;
  }
  return std::strcmp(name, "Right Device") == 0 && get(0, k_count) > 1 ? 1 : -1;
}

unsigned refuse(int unit, int error) {
  push_error(unit, "hdInitDevice", error);
  return kNoHandle;
}

// The key that a capability switches; kKeyCount where there is no such capability.
Key key_of(unsigned capability) {
  switch (capability) {
    case 0x4000:
      return k_force_output;
    case 0x4001:
      return k_clamping;
    case 0x4002:
      return k_ramping;
    case 0x4003:
      return k_force_check;
    case 0x4004:
      return k_one_frame;
    case 0x2606:
      return k_velocity_check;
    case 0x2607:
      return k_impulse_check;
    case 0x2900:
      return k_status_light;
    default:
      return kKeyCount;
  }
}

void switch_capability(const char* call, unsigned capability, bool on) {
  const int unit = current_unit(call);
  const Key key = key_of(capability);
  if (unit < 0) {
    return;
  }
  if (key == kKeyCount) {
    push_error(unit, call, kInvalidEnum);
    return;
  }
  const Locked lock;
  const double value = capability;
  note(unit, call, 0, &value, 1);
  put(unit, key, on ? 1.0 : 0.0);
  if (key == k_force_output) {
    update_mode(unit);
  }
}

}  // namespace

void update_mode(int unit) {
  const bool on = is_on(unit, k_opened) && is_on(unit, k_force_output) && scheduler_runs() &&
                  !is_unplugged(unit);
  if (on && mode_of(unit) != kForce) {
    put(unit, k_mode, kForce);
    put(unit, k_last_set_time, now());
    frame_of(unit).ramp_start = now();
    frame_of(unit).last_force = Vec{};
  } else if (!on && mode_of(unit) == kForce) {
    forces_off(unit, kIdle, kSoftware, "device: motors off");
  }
}

}  // namespace standin

using namespace standin;

STANDIN_EXPORT unsigned hdInitDevice(const char* name) {
  const int unit = find_device(name);
  if (unit < 0 || get(0, k_count) <= unit || is_on(unit, k_unplug)) {
    return refuse(unit, kDeviceFault);
  }
  if (is_on(unit, k_opened)) {
    return refuse(unit, kAlreadyInitiated);
  }
  if (is_on(unit, k_fail_open)) {
    return refuse(unit, static_cast<int>(get(unit, k_fail_open)));
  }
  start_device();
  const Locked lock;
  open_unit(unit);
  put(unit, k_force_output, 0);
  frame_of(unit) = Frame();
  note(unit, "hdInitDevice", 0);
  make_current(unit);
  return static_cast<unsigned>(unit);
}

STANDIN_EXPORT void hdDisableDevice(unsigned handle) {
  const int unit = unit_of(handle, "hdDisableDevice");
  if (unit >= 0) {
    const Locked lock;
    note(unit, "hdDisableDevice", 0);
    close_unit(unit);
  }
}

STANDIN_EXPORT void hdMakeCurrentDevice(unsigned handle) {
  const int unit = unit_of(handle, "hdMakeCurrentDevice");
  if (unit >= 0) {
    make_current(unit);
  }
}

STANDIN_EXPORT unsigned hdGetCurrentDevice() {
  const int unit = current_unit("hdGetCurrentDevice");
  return unit < 0 ? kNoHandle : static_cast<unsigned>(unit);
}

STANDIN_EXPORT void hdEnable(unsigned capability) {
  switch_capability("hdEnable", capability, true);
}
STANDIN_EXPORT void hdDisable(unsigned capability) {
  switch_capability("hdDisable", capability, false);
}
STANDIN_EXPORT unsigned char hdIsEnabled(unsigned capability) {
  const int unit = current_unit("hdIsEnabled");
  const Key key = key_of(capability);
  if (unit >= 0 && key == kKeyCount) {
    push_error(unit, "hdIsEnabled", kInvalidEnum);
  }
  return unit >= 0 && key != kKeyCount && is_on(unit, key) ? 1 : 0;
}

STANDIN_EXPORT unsigned hdCheckCalibration() {
  const int unit = current_unit("hdCheckCalibration");
  if (unit < 0) {
    return 0;
  }
  if (is_unplugged(unit)) {
    push_error(unit, "hdCheckCalibration", kDeviceFault);
  }
  return static_cast<unsigned>(get(unit, k_calibration));
}

STANDIN_EXPORT unsigned hdCheckCalibrationStyle() {
  const int unit = current_unit("hdCheckCalibrationStyle");
  return unit < 0 ? 0 : static_cast<unsigned>(get(unit, k_calibration_style));
}

STANDIN_EXPORT void hdUpdateCalibration(unsigned style) {
  const int unit = current_unit("hdUpdateCalibration");
  if (unit < 0) {
    return;
  }
  const bool supported = (style & static_cast<unsigned>(get(unit, k_calibration_style))) != 0;
  if (!supported || is_unplugged(unit) || is_on(unit, k_fail_init)) {
    push_error(unit, "hdUpdateCalibration", kDeviceFault);
    return;
  }
  const Locked lock;
  const double value = style;
  note(unit, "hdUpdateCalibration", 0, &value, 1);
  if (style != kStyleInkwell || is_on(unit, k_inkwell)) {
    put(unit, k_calibration, kCalibrationOk);
  }
}
