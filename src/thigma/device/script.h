#pragma once
// Timed poses: a file of them, a smooth motion through them, and a device that plays it.

#include <cstdint>
#include <istream>
#include <memory>
#include <string>
#include <vector>

#include "thigma/device/haptic_device.h"

namespace thigma {

/// One row of a script.
struct TimedPose {
  double time = 0.0;                      // [s], strictly increasing from row to row
  Pose pose;                              // [m; device frame]
  std::uint32_t buttons = kClutchButton;  // held from this row to the next
};

/// Reads `t,x,y,z,qx,qy,qz,qw[,buttons]` with that header line. Blank lines and lines that start
/// with # are skipped.
///
/// name     for messages
/// errors   InputError "NAME: what, line N, what was expected": wrong header or number of columns,
///          what is no finite number, time that does not increase, |q| off 1 by more than 1e-6, no
///          row, more than ten million rows.
/// Thread   [offline].
std::vector<TimedPose> parse_script(std::istream& text, const std::string& name);

/// As parse_script; InputError too when the file cannot be read.
/// Thread    [offline].
std::vector<TimedPose> read_script(const std::string& path);

/// Position in a script, for fast look-up of times that increase.
struct ScriptCursor {
  std::size_t row = 0;
};

/// Motion at `time` through a script of at least one row: once continuously differentiable, at rest
/// before the first and after the last row, never beyond the values of neighbouring rows in any
/// coordinate.
///
/// cursor    caller-owned; cost is constant for times that advance by less than a row, logarithmic
///           otherwise
/// returns   pose and its exact time derivative [device frame]
/// Thread    [haptic]; no failure.
/// Source    Fritsch, Butland 1984 (monotone cubic), on coordinates and on the sign-aligned
///           quaternion, normalised.
Motion script_motion(const std::vector<TimedPose>& script, double time,
                     ScriptCursor& cursor) THIGMA_RT;

/// Plays a script of at least one row from the first read on (row time 0 is then); status
/// `finished` after its last row, where it stays. Wrenches are accepted.
/// Thread    [offline].
std::unique_ptr<HapticDevice> make_script_device(std::vector<TimedPose> script,
                                                 const DeviceLimits& limits = {});

}  // namespace thigma
