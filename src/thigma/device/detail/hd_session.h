#pragma once
// An initialised device of the HD layer, and its frames in the vendor's thread.

#include <atomic>
#include <string>

#include <pthread.h>

#include "thigma/device/detail/hd_library.h"
#include "thigma/device/detail/trouble_line.h"
#include "thigma/device/haptic_device.h"

namespace thigma::detail {

/// Owns the device from hdInitDevice to hdDisableDevice.
/// Thread   [offline].
class HdHandle {
 public:
  /// Names are tried in order: the one given, or the usual ones. Errors: DeviceUnavailable.
  HdHandle(const HdLibrary& library, const std::string& name);
  ~HdHandle();
  HdHandle(const HdHandle&) = delete;
  HdHandle& operator=(const HdHandle&) = delete;

  unsigned id() const { return id_; }
  const std::string& name() const { return name_; }  // that opened
  std::string text(unsigned what) const;             // of the library, or ""
  int integer(unsigned what, int otherwise) const;

 private:
  const HdLibrary& library_;
  unsigned id_ = kHdNoDevice;
  std::string name_;
};

/// Runs a tick in every frame of the vendor's scheduler.
/// Invariant: forces are off before start and after stop; what a tick does not write is zero.
/// Thread   start and stop [offline]; the others within a tick [haptic].
class HdServo {
 public:
  HdServo(const HdLibrary& library, unsigned device) : library_(library), device_(device) {}
  ~HdServo() { stop(); }
  HdServo(const HdServo&) = delete;
  HdServo& operator=(const HdServo&) = delete;

  /// Errors: DeviceUnavailable for a rate that the scheduler does not take.
  void start(double rate, DeviceTick tick);

  /// Zero force in the frames that are left, 20 ms, forces off, scheduler stopped, unscheduled.
  void stop() noexcept;

  bool is_in_tick() const THIGMA_RT;
  /// What this frame read: pose and velocity in our frame and units, buttons.
  const DeviceState& sample() const THIGMA_RT { return sample_; }
  /// [N; our axes], and in the vendor's unit [our axes; null: none is sent].
  void send(const Vec3& force, const Vec3* torque) THIGMA_RT;
  /// Outside of a tick: the vendor's switch.
  void turn_off() THIGMA_RT { library_.disable(kHdForceOutput); }

  TroubleLine& trouble() THIGMA_RT { return trouble_; }
  const TroubleLine& trouble() const THIGMA_RT { return trouble_; }

 private:
  static unsigned on_frame(void* self) noexcept;
  void frame() noexcept;
  void read() noexcept;
  void look_for_errors() noexcept;

  const HdLibrary& library_;
  const unsigned device_;
  DeviceTick tick_;
  unsigned long task_ = 0;
  bool is_started_ = false;
  std::atomic<bool> is_stopping_{false};
  std::atomic<bool> is_in_frame_{false};
  std::atomic<pthread_t> thread_{};  // of the frame, while one is made
  // The vendor's thread only.
  bool has_sent_ = false, has_sent_torque_ = false;
  int warm_frames_ = 0;  // that motors are taken for warm after the last word of it
  DeviceState sample_;
  TroubleLine trouble_;
};

}  // namespace thigma::detail
