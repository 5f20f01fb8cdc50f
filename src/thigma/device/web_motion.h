#pragma once
// From the samples of a page in the browser, 20 to 250 a second and late by turns, to a smooth motion
// at the haptic rate.

#include <array>
#include <cstddef>
#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/device/haptic_device.h"

namespace thigma {

/// What a page tells of its mouse or gamepad.
struct WebSample {
  double time = 0.0;  // of the browser's clock, whose offset is unknown [s]
  Pose pose;          // of the handle [m; device frame]; where it begins means nothing
  std::uint32_t buttons = 0;
};

struct WebMotionParams {
  double lost_after = 0.2;  // without a sample for so long the device is lost [s]
  double delay = 0.016;  // samples are played back so late, a frame of a display: what lies between
                         // two of them is then mostly known [s]
  double extrapolation = 0.020;     // beyond the newest sample for so long at most [s]
  double stiffness = 250.0;         // natural frequency of the smoothing; lags by 2 / this [rad/s]
  double max_speed = 1.2;           // of the handle: below what safety takes for a fault [m/s]
  double max_angular_speed = 12.0;  // [rad/s]
  double offset_memory = 2.0;  // the offset of the clocks is that of the least delayed sample of
                               // this long [s]
};

/// Plays the samples of one page after another as one handle: clock offset, interpolation, bounded
/// extrapolation, critically damped smoothing, speed limits. Whoever comes next, and whoever comes
/// back, goes on from where the handle is.
/// Invariant: the speed of what read() returns never exceeds the limits; times in the history increase.
/// Thread: every member is [haptic], from one thread.
class WebMotion {
 public:
  explicit WebMotion(const WebMotionParams& params = {}) THIGMA_RT : params_(params) {}

  /// A page takes hold: what it sends next stands for where the handle is.
  void begin() THIGMA_RT;
  /// The page lets go in order: the handle stays, its clutch open.
  void release() THIGMA_RT;
  /// The page is gone.
  void lose() THIGMA_RT;
  /// A sample that arrived by `now` [s; session clock]. One that is not later than the newest replaces
  /// nothing but its buttons.
  void add(const WebSample& sample, double now) THIGMA_RT;
  /// Advances to `now` [s; session clock]: the pose, its velocity, the newest buttons. Status not_ready
  /// before the first sample, lost without any for params.lost_after or after lose().
  DeviceState read(double now) THIGMA_RT;

 private:
  enum class Hold : std::uint8_t { never, held, released, lost };

  void place_first(const WebSample& sample) THIGMA_RT;
  void learn_offset(double offset, double now) THIGMA_RT;
  Pose target(double now) const THIGMA_RT;
  void follow(const Pose& target, double elapsed) THIGMA_RT;
  const WebSample& back(std::size_t age) const THIGMA_RT {
    return history_[(newest_ + kHistory - age) % kHistory];
  }

  static constexpr std::size_t kHistory = 32;
  WebMotionParams params_;
  Hold hold_ = Hold::never;
  std::array<WebSample, kHistory> history_{};  // poses as played
  std::size_t newest_ = 0, count_ = 0;
  Pose page_origin_, place_;  // this pose of the page is that pose of the handle
  bool has_pose_ = false;     // of the handle, ever
  bool has_place_ = false;    // since begin()
  std::uint32_t buttons_ = 0;
  double last_arrival_ = 0.0, last_read_ = 0.0;
  double offset_ = 0.0, offset_before_ = 0.0, offset_since_ = 0.0;  // least delays of two windows
  Motion motion_;
};

}  // namespace thigma
