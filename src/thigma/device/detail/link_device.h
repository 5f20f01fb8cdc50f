#pragma once
// A device behind a thread of its own that speaks with a service: the haptic step only exchanges
// newest values with it.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <thread>

#include "thigma/core/latest.h"
#include "thigma/device/detail/trouble_line.h"
#include "thigma/device/haptic_device.h"

namespace thigma::detail {

/// What the service told last.
struct LinkSample {
  std::uint64_t count = 0;  // of samples; 0: none yet
  Motion motion;            // [device frame]
  std::uint32_t buttons = 0;
  double interval = 0.0;       // between positions of late, 0: as good as none [s]
  double turn_interval = 0.0;  // between orientations of late [s]
};

/// What the haptic step asked for last.
struct LinkCommand {
  std::uint64_t count = 0;
  Vec3 force = Vec3::Zero();  // of a device's limits, finite [N; device frame]
  Vec3 at = Vec3::Zero();     // where the handle was then [m; device frame]
};

/// Both ends of the exchange.
struct LinkEnds {
  Latest<LinkSample> samples;    // from the service
  Latest<LinkCommand> commands;  // to the service
  TroubleLine trouble;           // the service's thread writes
  std::atomic<bool> is_over{false};
};

/// Speaks with a service until ends.is_over; of a device with force, leaves with zero force sent.
using LinkTalk = std::function<void(LinkEnds& ends)>;

/// The thread that speaks with a service, and the ends of its exchange. What the talk throws is a
/// loss with its text. Ends and joins at the end of its life.
class LinkThread {
 public:
  /// is_urgent  asks for a real-time priority just below the haptic thread's, where the system
  ///            allows it: a force that waits for other programs is late
  explicit LinkThread(LinkTalk talk, bool is_urgent = false);
  ~LinkThread();

  LinkEnds& ends() const { return *ends_; }

 private:
  const std::unique_ptr<LinkEnds> ends_;
  std::thread thread_;
};

/// The newest command, for the thread that sends it. A command that nothing renews for 50 ms is
/// zero force: the service does not see that the haptic thread hangs. Zero as well where the device
/// is lost or ends.
/// Thread: the one that speaks with the service.
class LinkForce {
 public:
  /// now  of driver_time_ns
  const LinkCommand& newest(LinkEnds& ends, std::int64_t now);

 private:
  static constexpr std::int64_t kOld = 50'000'000;  // [ns]
  LinkCommand command_;
  std::int64_t renewed_ = 0;
};

/// A device over a link. Its samples say when the haptic step first saw them, so that a service
/// that falls silent is a silent device. What comes less often than each millisecond is smoothed.
class LinkDevice final : public HapticDevice {
 public:
  /// stays    a service that has nothing new to say is not silent: it told every change
  LinkDevice(std::string name, const DeviceLimits& limits, bool stays, LinkTalk talk);

  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return name_; }
  const char* trouble() const THIGMA_RT override { return link_.ends().trouble.text(); }
  DeviceState read(double now) THIGMA_RT override;
  void write(const Wrench& wrench) THIGMA_RT override;

 private:
  const std::string name_;
  const DeviceLimits limits_;
  const bool stays_;
  DeviceState last_;
  double last_read_ = 0.0, arrival_ = 0.0;
  std::uint64_t seen_ = 0, sent_ = 0;
  const LinkThread link_;
};

/// Whether a handle cannot have come from one place to another, or turned: at 1.5 m/s and 5 mm
/// beyond it, or 25 rad/s and 0.1 rad, as the safety layer has it. Smoothing would hide it there.
///
/// seconds  in between
/// Thread   [any].
bool is_jump(const Vec3& from, const Vec3& to, double seconds);
bool is_jump(const Quat& from, const Quat& to, double seconds);

/// Mean time between events of late; a pause of a tenth of a second or more is none.
class Interval {
 public:
  /// time  of driver_time_ns; returns the mean [s], 0 before the second event
  double add(std::int64_t time) {
    constexpr double kShare = 0.05, kPause = 0.1;
    const double step = 1e-9 * static_cast<double>(time - last_);
    if (last_ != 0 && step < kPause) mean_ = mean_ == 0.0 ? step : mean_ + kShare * (step - mean_);
    last_ = time;
    return mean_;
  }

 private:
  std::int64_t last_ = 0;
  double mean_ = 0.0;
};

}  // namespace thigma::detail
