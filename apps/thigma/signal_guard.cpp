#include "signal_guard.h"

#include <csignal>

namespace thigma::app {
namespace {

static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

constexpr int kSignals[] = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP};

void on_signal(int signal) {
  if (signal == SIGTSTP) was_suspended.store(true, std::memory_order_relaxed);
  stop_requested.store(true, std::memory_order_relaxed);
}

}  // namespace

std::atomic<bool> stop_requested{false};
std::atomic<bool> was_suspended{false};

SignalGuard::SignalGuard() {
  static_assert(sizeof kSignals / sizeof kSignals[0] == kCount);
  stop_requested = false;
  was_suspended = false;
  for (int i = 0; i < kCount; ++i) previous_[i] = std::signal(kSignals[i], on_signal);
}

SignalGuard::~SignalGuard() {
  for (int i = 0; i < kCount; ++i) std::signal(kSignals[i], previous_[i]);
}

}  // namespace thigma::app
