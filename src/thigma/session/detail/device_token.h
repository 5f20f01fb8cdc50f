#pragma once
// Who may talk to a device.

#include <atomic>

#include "thigma/session/rt_thread.h"

namespace thigma::detail {

/// The haptic thread holds it during a step, the watchdog while it sends zero.
class DeviceToken {
 public:
  bool try_take() noexcept { return !is_taken_.exchange(true, std::memory_order_acquire); }
  /// Waits until the other gives it back; the watchdog has it only while it is sending zero.
  void take() noexcept {
    while (!try_take()) sleep_ns(20'000);
  }
  void give_back() noexcept { is_taken_.store(false, std::memory_order_release); }

 private:
  std::atomic<bool> is_taken_{false};
};

}  // namespace thigma::detail
