#pragma once
// A simulated hand whose device owns the clock.

#include <algorithm>
#include <atomic>
#include <functional>
#include <string>
#include <thread>

#include "thigma/device/hand.h"
#include "thigma/device/open_device.h"
#include "thigma/session/rt_thread.h"

namespace thigma::test {

/// A hand whose own thread sets the pace.
class TickingHand final : public HapticDevice {
 public:
  explicit TickingHand(const HandParams& params) : hand_(params), limits_(hand_.limits()) {
    limits_.clock = DeviceClock::device;
  }
  ~TickingHand() override { stop_ticks(); }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "ticking"; }
  const char* trouble() const THIGMA_RT override { return is_out ? "it stopped ticking" : ""; }

  DeviceState read(double now) THIGMA_RT override {
    last_.status = DeviceStatus::lost;
    return is_in_tick() ? last_ = hand_.read(now) : last_;
  }
  void write(const Wrench& wrench) THIGMA_RT override {
    if (!is_in_tick()) {
      is_switched_off = true;
      return;
    }
    last_force = wrench.force.norm();
    most_force = std::max(most_force, last_force);
    hand_.write(wrench);
  }
  void start_ticks(double rate, DeviceTick tick) override {
    if (rate > 5000.0) throw DeviceUnavailable("ticking: too fast");
    thread_ = std::thread([this, rate, tick] { run(rate, tick); });
  }
  void stop_ticks() noexcept override {
    stops_ = true;
    if (thread_.joinable()) thread_.join();
  }

  double stays_away_from = 1e9, comes_back_at = 1e9;  // no tick in between [s]
  double last_force = 0.0, most_force = 0.0;
  std::atomic<bool> is_switched_off{false}, is_out{false};
  std::atomic<int> ticks_made{0}, ticks_after_break{0};
  std::function<void(DeviceTick)> around;  // calls a tick, in its thread; empty: nothing around it
  std::function<void()> begins;            // called in its thread, once

 private:
  bool is_in_tick() const { return thread_id_ == std::this_thread::get_id(); }
  void run(double rate, DeviceTick tick) {
    thread_id_ = std::this_thread::get_id();
    DeadlineClock clock = clock_of(rate);
    start_clock(clock);
    const std::int64_t begin = monotonic_ns();
    if (begins) begins();
    while (!stops_) {
      wait_for_tick(clock);
      const double now = 1e-9 * static_cast<double>(monotonic_ns() - begin);
      if (now > stays_away_from && now < comes_back_at) {
        is_out = true;
        continue;
      }
      around ? around(tick) : tick.call(tick.context);
      ++ticks_made;
      ticks_after_break += is_out ? 1 : 0;
    }
    thread_id_ = std::thread::id();
  }

  HandDevice hand_;
  DeviceLimits limits_;
  DeviceState last_;
  std::atomic<bool> stops_{false};
  std::atomic<std::thread::id> thread_id_{};
  std::thread thread_;
};

}  // namespace thigma::test
