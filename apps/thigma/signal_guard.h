#pragma once
// Signals that end what may push a hand, in order.

#include <atomic>

namespace thigma::app {

/// Set by a signal while a SignalGuard lives.
extern std::atomic<bool> stop_requested;
extern std::atomic<bool> was_suspended;  // by Ctrl-Z, which ends as well

/// Ctrl-C and its kin end the work in order while this lives; twice Ctrl-C does not hurry it: it
/// takes milliseconds. So does Ctrl-Z: a suspended process would leave its last force on the
/// device. One at a time.
class SignalGuard {
 public:
  SignalGuard();
  ~SignalGuard();
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

 private:
  static constexpr int kCount = 5;
  void (*previous_[kCount])(int) = {};
};

}  // namespace thigma::app
