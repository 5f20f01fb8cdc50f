#pragma once
// A session of a driver in contact: its stand-in's hand presses the handle down onto a plane.

#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "standins/client.h"
#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/session/session.h"

namespace thigma::test {

/// Limits of time that a loaded machine keeps, too; those of the device's faults stay.
inline SessionConfig pressing_session() {
  SessionConfig config = plane_session();
  config.duration = 30.0;
  config.haptic.safety.watchdog = 0.2;
  config.haptic.safety.model_full_age = 2.0;
  config.haptic.safety.model_stale_age = 4.0;
  config.haptic.safety.max_speed = 5.0;
  config.haptic.safety.pose_jump = 0.030;
  return config;
}

/// What a session in contact came to.
struct PressedSession {
  SessionSummary summary;
  double pressed = 0.0;      // force sent when the fault was made [N]
  double zero_after = -1.0;  // from the fault to a sent force of zero; below 0: never [s]
  std::unique_ptr<HapticDevice> device{};  // where it was opened for the session
};

/// Runs until the device is pushed back by about 2 N, then `fault`, and waits for the end.
/// press   moves the stand-in's target down; `sent` is the norm of the last force it was sent [N]
inline PressedSession press_once(HapticDevice& device, const std::function<void(double)>& press,
                                 const std::function<double()>& sent,
                                 const std::function<void()>& fault) {
  PressedSession result;
  Session session(pressing_session(), device);
  session.start();
  usleep(800'000);  // armed, ramped up
  double depth = 0.0;
  for (int i = 0; i < 400 && sent() < 2.0; ++i) {
    press(depth += 2e-4);
    usleep(10'000);
  }
  usleep(100'000);
  result.pressed = sent();
  const std::int64_t begin = monotonic_ns();
  fault();
  while (monotonic_ns() - begin < 3'000'000'000) {
    if (sent() == 0.0) {
      result.zero_after = 1e-9 * static_cast<double>(monotonic_ns() - begin);
      break;
    }
    usleep(200);
  }
  for (int i = 0; i < 3000 && session.is_running(); ++i) usleep(1000);
  session.request_stop();
  result.summary = session.finish();
  return result;
}

/// That with a device of `open`, again where the session ended before the fault was made: on a
/// loaded machine a stale force may push the handle farther than a jump.
inline PressedSession press_and_fail(const std::function<std::unique_ptr<HapticDevice>()>& open,
                                     const std::function<void(double)>& press,
                                     const std::function<double()>& sent,
                                     const std::function<void()>& fault) {
  PressedSession result;
  for (int attempt = 0; attempt < 5 && result.pressed < 1.5; ++attempt) {
    result = {};  // one at a time
    std::unique_ptr<HapticDevice> device = open();
    result = press_once(*device, press, sent, fault);
    result.device = std::move(device);
  }
  return result;
}

inline void print_fault_heads() {
  std::printf("fault in contact     force before    zero after   end    cause\n");
}

/// What every driver keeps, and a row of the table: pressed, then ended by a fault.
/// zero  what stands for the time until zero force
inline void expect_fault(const char* name, const PressedSession& s, const HapticDevice& device,
                         const std::string& zero) {
  EXPECT_GT(s.pressed, 1.5) << name;
  EXPECT_EQ(s.summary.end, SessionEnd::fault) << name;
  const std::string cause =
      s.summary.safety_events.empty() ? "none" : s.summary.safety_events[0].detail;
  std::printf("%-20s %8.2f N %13s   %-6s %s: %s\n", name, s.pressed, zero.c_str(),
              end_name(s.summary.end), cause.c_str(), device.trouble());
}

inline std::string zero_text(const PressedSession& s) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f ms", 1e3 * s.zero_after);
  return text;
}

}  // namespace thigma::test
