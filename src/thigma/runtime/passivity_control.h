#pragma once
// Time-domain passivity controller at the device's port: what late samples let a rendered world give away is taken
// back by damping the handle.

#include <array>
#include <cstdint>
#include <memory>

#include "thigma/core/rt.h"
#include "thigma/device/haptic_device.h"

namespace thigma {

/// Constant while a session runs.
struct PassivityParams {
  double period = 1e-3;      // of the haptic frames [s]
  double delay = 0.0;        // of the device's samples, as far as known; at most 255 frames [s]
  double max_damping = 5.0;  // most that is injected [N s/m]
  double max_angular_damping = 0.0;  // the same for rotation [N m s/rad]
  // Of the springs the hand feels: what they hold they will want to give back. 0: nothing is kept for them.
  double stiffness = 0.0, angular_stiffness = 0.0;  // [N/m, N m/rad; device]
};

/// Parameters for springs of these stiffnesses, as the hand feels them [N/m, N m/rad; device]: what a spring gives away by
/// being late is that of a negative damping K (T + delay), so as much at most is put in.
/// Thread    [haptic].
PassivityParams passivity_for(double stiffness, double angular_stiffness, double period,
                              double delay) THIGMA_RT;

/// What the controller remembers.
struct PassivityControl {
  static constexpr std::size_t kMostFrames = 256;
  std::array<Wrench, kMostFrames> sent{};  // ring of wrenches on the hand [device frame]
  std::uint64_t frame = 0;                 // samples seen
  Pose last;                               // handle of the last one
  double energy = 0.0;     // put in by the hand up to the time of the last sample [J]
  double predicted = 0.0;  // up to now, had the handle kept its last velocity [J]
  double damping = 0.0;    // injected in the last frame [N s/m]
  std::uint64_t damped_frames = 0;
};

/// Accounts for a sample of the handle: the motion it tells of was driven by the wrench sent `delay` before.
/// Thread    [haptic].
void observe_handle(const PassivityParams& params, const Motion& handle,
                    PassivityControl& control) THIGMA_RT;

/// The wrench to send for the one that is wanted: with as much damping along the handle's velocity as keeps the predicted
/// energy from falling below what the springs hold, and no more than max_damping. Rotation shares it in the ratio of the two maxima. A
/// wanted wrench of zero, as after a fault, stays zero.
///
/// handle   the sample given to observe_handle in this frame
/// wanted   on the hand about the handle [N, N m; device frame]
/// Thread   [haptic]; no failure.
/// Source   PROTOCOLS E4, after Hannaford and Ryu 2002; predictive: c = -E / (T |v|^2) with E what the next frame ends
///          with, and each motion charged to the wrench that drove it (docs/passivity.md).
Wrench passive_wrench(const PassivityParams& params, const Motion& handle, const Wrench& wanted,
                      PassivityControl& control) THIGMA_RT;

/// A device with the controller before its motors: the last stage, after all limits, which hold again behind it (the
/// device's own maxima). Rotation the device does not actuate is left out of the account.
///
/// device    outlives it; its wrenches pass through it
/// Thread    [offline] to make; read and write [haptic].
class PassiveDevice final : public HapticDevice {
 public:
  PassiveDevice(HapticDevice& device, const PassivityParams& params)
      : device_(device), params_(params) {}
  const DeviceLimits& limits() const override { return device_.limits(); }
  std::string name() const override { return device_.name(); }
  DeviceState read(double now) THIGMA_RT override;
  void write(const Wrench& wrench) THIGMA_RT override;
  /// Last wrench that went to the device, and the account.
  const Wrench& sent() const THIGMA_RT { return sent_; }
  const PassivityControl& control() const THIGMA_RT { return control_; }

 private:
  HapticDevice& device_;
  PassivityParams params_;
  PassivityControl control_;
  Motion handle_;
  Wrench sent_;
};

}  // namespace thigma
