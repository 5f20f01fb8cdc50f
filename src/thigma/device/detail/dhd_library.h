#pragma once
// The functions of the Force Dimension SDK that the driver calls. Types re-typed from the public
// interface of SDK 3.17 (docs/devices.md); no vendor header.

#include <cstdint>

#include "thigma/core/shared_library.h"

namespace thigma::detail {

/// Return value of most of them: below 0 an error; 0 done, 1 too soon after the last call (the
/// value before is repeated), 2 a motor gave all it has: all three are successes.
inline constexpr bool is_dhd_error(int result) { return result < 0; }

/// Number of the last error that a velocity has while there are too few positions for one.
inline constexpr int kDhdTimeout = 7;

/// Places in what dhdGetStatus gives. The array has grown over versions: 64 are room for more.
inline constexpr int kDhdStatusRoom = 64;
inline constexpr int kDhdStatusForce = 5, kDhdStatusForceOffCause = 14;

/// Owns the library. Functions after `optional` may be null.
/// Thread   [offline] to make; functions as the driver says.
struct DhdLibrary {
  SharedLibrary library;
  int (*count)() = nullptr;
  int (*get_pose)(double*, double*, double*, double (*)[3], char) = nullptr;
  int (*get_linear_velocity)(double*, double*, double*, char) = nullptr;
  int (*get_angular_velocity)(double*, double*, double*, char) = nullptr;
  unsigned (*get_buttons)(char) = nullptr;
  int (*set_wrench)(double, double, double, double, double, double, double, char) = nullptr;
  int (*enable_force)(unsigned char, char) = nullptr;
  int (*stop)(char) = nullptr;
  // optional
  int (*open)(char) = nullptr;  // of drd where that is there, else of dhd; one of them is
  int (*close)(char) = nullptr;
  bool (*is_initialized)(char) = nullptr;
  int (*auto_init)(char) = nullptr;
  int (*stop_regulation)(bool, char) = nullptr;
  int (*get_type)(char) = nullptr;
  const char* (*get_name)(char) = nullptr;
  int (*get_serial)(std::uint16_t*, char) = nullptr;
  bool (*has_gripper)(char) = nullptr;
  int (*emulate_button)(unsigned char, char) = nullptr;
  double (*get_max_force)(char) = nullptr;
  double (*get_max_torque)(char) = nullptr;
  int (*get_status)(int*, char) = nullptr;
  int (*last_error_number)() = nullptr;
  const char* (*last_error)() = nullptr;
};

/// Opens it. Errors: DeviceUnavailable, one line with what to do.
/// Thread   [offline].
DhdLibrary open_dhd_library();

/// What the library says of the last error, or "".
/// Thread   [haptic].
const char* last_dhd_error(const DhdLibrary& library) noexcept;

}  // namespace thigma::detail
