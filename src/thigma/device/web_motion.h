#pragma once
// From the samples of a page in the browser, 20 to 250 a second and late by turns, to a smooth
// motion at the haptic rate.

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
  // a pose up to this age counts fully: a picture drawn by the processor takes as long [s]
  double full_age = 0.3;
  // and not at all from here on; in between its weight falls linearly [s]
  double stale_age = 1.0;
  // poses that come again bring the weight back from 0 to 1 in no less [s]
  double return_time = 0.3;
  double lost_after = 5.0;  // without any message for so long the device is lost [s]
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
///
/// A page that is late is slow, not gone: its last pose is held, and DeviceState::weight falls with
/// the age of that pose, by the browser's own clock, until it is stale. Samples that come again
/// bring both back by themselves, the weight gently. What a page repeats with the time it had
/// before keeps the device from being lost, and the pose no younger.
/// Invariant: the speed of what read() returns never exceeds the limits; times in the history
/// increase. Thread: every member is [haptic], from one thread.
class WebMotion {
 public:
  explicit WebMotion(const WebMotionParams& params = {}) THIGMA_RT : params_(params) {}

  /// A page takes hold: what it sends next stands for where the handle is.
  void begin() THIGMA_RT;
  /// The page lets go in order: the handle stays, its clutch open.
  void release() THIGMA_RT;
  /// The page is gone.
  void lose() THIGMA_RT;
  /// A sample that arrived by `now` [s; session clock]. One as late as the newest stands for it,
  /// one before it says nothing but its buttons.
  void add(const WebSample& sample, double now) THIGMA_RT;
  /// Advances to `now` [s; session clock]: the pose, its velocity, its weight, the newest buttons.
  /// Every open clutch is there for a read at least, however many samples came between two. Status
  /// not_ready before the first sample, lost without any for params.lost_after or after lose().
  DeviceState read(double now) THIGMA_RT;

 private:
  enum class Hold : std::uint8_t { never, held, released, lost };

  void take_up() THIGMA_RT;
  void place_first(const WebSample& sample) THIGMA_RT;
  void press(std::uint32_t buttons) THIGMA_RT;
  void weigh(double now, double elapsed) THIGMA_RT;
  double session_from_page() const THIGMA_RT;
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
  std::uint32_t buttons_ = 0, next_buttons_ = 0;  // of the next read and of those after it
  bool is_read_ = true;                           // buttons_ has been there for a read
  double weight_ = 1.0;
  double last_arrival_ = 0.0, last_read_ = 0.0;
  double offset_ = 0.0, offset_before_ = 0.0, offset_since_ = 0.0;  // least delays of two windows
  Motion motion_;
};

}  // namespace thigma
