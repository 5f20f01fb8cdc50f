#pragma once
// The page's mouse or gamepad as a device, `web:`.

#include <atomic>
#include <cstdint>
#include <memory>

#include "thigma/core/spsc_ring.h"
#include "thigma/device/haptic_device.h"
#include "thigma/device/web_motion.h"

namespace thigma {

/// Where a page's samples wait for the haptic thread.
/// Thread: push, begin, release and lose from one thread, the page's server; take from one other
/// [haptic].
class WebDeviceChannel {
 public:
  enum class Hold : std::uint8_t { free, held, lost };

  /// A page takes hold of the device.
  void begin() noexcept;
  /// It lets go in order: no fault.
  void release() noexcept;
  /// It is gone: a fault of the device, if it held it.
  void lose() noexcept;
  /// A sample of the page that holds the device; false when the haptic thread does not take them.
  bool push(const WebSample& sample) noexcept;

  /// Hands what has happened since the last call to `motion`. Thread [haptic].
  void take(double now, WebMotion& motion, std::uint32_t& seen) THIGMA_RT;

 private:
  struct Tagged {
    std::uint32_t turn = 0;
    WebSample sample;
  };
  void set(Hold hold) noexcept;

  SpscRing<Tagged> samples_{512};
  std::uint32_t turn_ = 0;  // counts begin(); the server's
  Hold hold_ = Hold::free;  // the server's
  // Turn and hold in one word, so that no full ring can lose them.
  std::atomic<std::uint32_t> state_{0};
};

/// Limits as a desktop device has them, so that scenes feel alike; nothing pushes the hand, the
/// page shows the wrench. link outlives the device.
/// Thread    [offline].
std::unique_ptr<HapticDevice> make_web_device(WebDeviceChannel& link,
                                              const WebMotionParams& params = {});

}  // namespace thigma
