#pragma once
// Who may talk to a device.

#include <atomic>

namespace thigma::detail {

/// The haptic thread holds it during a step, the watchdog while it sends zero.
class DeviceToken {
 public:
  bool try_take() noexcept { return !is_taken_.exchange(true, std::memory_order_acquire); }
  void give_back() noexcept { is_taken_.store(false, std::memory_order_release); }

 private:
  std::atomic<bool> is_taken_{false};
};

}  // namespace thigma::detail
