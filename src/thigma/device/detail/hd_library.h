#pragma once
// The functions of OpenHaptics' HD layer that the driver calls. Types and numbers re-typed from its
// public interface (docs/devices.md); no vendor header.

#include "thigma/core/shared_library.h"

namespace thigma::detail {

/// As the library returns it, by value.
struct HdError {
  unsigned code = 0;
  int internal = 0;
  unsigned device = 0;
};

/// Names of what is read, written and switched.
enum HdName : unsigned {
  kHdButtons = 0x2000,
  kHdVelocity = 0x2051,         // [mm/s]
  kHdTransform = 0x2052,        // 16 numbers, column-major, translation last [mm]
  kHdAngularVelocity = 0x2053,  // [rad/s]
  kHdModel = 0x2501,
  kHdSerial = 0x2504,
  kHdUsableWorkspace = 0x2551,  // least x, y, z, greatest x, y, z [mm]
  kHdOutputDof = 0x2554,
  kHdMaxForce = 0x2603,  // [N]
  kHdForce = 0x2700,     // [N]
  kHdTorque = 0x2701,    // of the unit that the profile of the device confirms
  kHdForceOutput = 0x4000,
};

inline constexpr unsigned kHdNoDevice = 0xFFFFFFFFu;
inline constexpr unsigned kHdCalibrated = 0x5000, kHdCanUpdate = 0x5001, kHdNeedsHand = 0x5002;
inline constexpr int kHdInkwell = 4;
inline constexpr unsigned kHdWarmMotors = 0x0200;

/// Owns the library. The last ones may be null.
/// Thread   [offline] to make; functions as the driver says.
struct HdLibrary {
  SharedLibrary library;
  unsigned (*init)(const char*) = nullptr;
  void (*disable_device)(unsigned) = nullptr;
  void (*begin_frame)(unsigned) = nullptr;
  void (*end_frame)(unsigned) = nullptr;
  HdError (*get_error)() = nullptr;
  void (*enable)(unsigned) = nullptr;
  void (*disable)(unsigned) = nullptr;
  void (*get_doubles)(unsigned, double*) = nullptr;
  void (*set_doubles)(unsigned, const double*) = nullptr;
  unsigned long (*schedule)(unsigned (*)(void*), void*, unsigned short) = nullptr;
  void (*unschedule)(unsigned long) = nullptr;
  void (*start_scheduler)() = nullptr;
  void (*stop_scheduler)() = nullptr;
  // optional
  void (*make_current)(unsigned) = nullptr;
  void (*get_integers)(unsigned, int*) = nullptr;
  const char* (*get_string)(unsigned) = nullptr;
  const char* (*error_string)(unsigned) = nullptr;
  void (*set_rate)(unsigned long) = nullptr;
  unsigned (*check_calibration)() = nullptr;
  int (*calibration_style)() = nullptr;
  void (*update_calibration)(unsigned) = nullptr;
};

/// Opens it. Errors: DeviceUnavailable, one line with what to do.
/// Thread   [offline].
HdLibrary open_hd_library();

/// The oldest error that the library still holds, of code 0 where there is none; it holds none
/// afterwards.
/// Thread   [haptic].
HdError take_hd_error(const HdLibrary& library) noexcept;

/// What the library calls an error, or "".
/// Thread   [haptic].
const char* hd_error_text(const HdLibrary& library, unsigned code) noexcept;

}  // namespace thigma::detail
