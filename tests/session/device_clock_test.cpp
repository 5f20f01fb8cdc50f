
#include "support/plane_session.h"
#include "support/ticking_hand.h"
#include <gtest/gtest.h>

#include "thigma/device/open_device.h"
#include "thigma/recording/replay_session.h"
#include "thigma/session/fault_injection.h"
#include "thigma/session/session.h"

namespace thigma {
namespace {

using test::plane_hand;
using test::plane_session;
using test::TickingHand;

SessionConfig patient_session() {
  SessionConfig config = plane_session();
  config.duration = 1.2;  // the hand takes hold, comes down and presses
  config.haptic.safety.watchdog = 5.0;
  config.haptic.safety.model_full_age = 5.0;
  config.haptic.safety.model_stale_age = 10.0;
  config.haptic.safety.pose_jump = 1.0;
  return config;
}

TEST(DeviceClock, a_session_runs_in_the_ticks_of_a_device_and_replays_to_the_same_bits) {
  const SessionConfig config = patient_session();
  TickingHand device(plane_hand(HandPath::press, 0.005));
  std::vector<HapticSample> samples;
  std::vector<ContactSample> models;
  Session session(config, device,
                  {[&](const HapticSample& s) { samples.push_back(s); },
                   [&](const ContactSample& s) { models.push_back(s); },
                   {}});
  session.start();
  const SessionSummary s = session.finish();
  EXPECT_EQ(s.end, SessionEnd::duration);
  EXPECT_GE(s.frames + s.missed, 1199u);
  EXPECT_GT(device.most_force, 0.0);
  EXPECT_EQ(device.last_force, 0.0);
  EXPECT_EQ(s.step_cpu.count, 0u);  // no system call in the device's thread
  HapticParams params = config.haptic;
  params.device = device.limits();
  const ReplayReport replay = replay_session(params, config.world_from_body, samples, models);
  EXPECT_TRUE(replay.identical) << replay.first_difference << ' ' << replay.reason;
}

TEST(DeviceClock, ticks_that_stay_away_are_a_fault_and_the_device_is_switched_off) {
  SessionConfig config = patient_session();
  config.duration = 20.0;
  config.haptic.safety.watchdog = 0.3;
  TickingHand device(plane_hand(HandPath::press, 0.005));
  device.stays_away_from = 0.5;
  std::vector<HapticSample> samples;
  Session session(config, device, {[&](const HapticSample& s) { samples.push_back(s); }, {}, {}});
  session.start();
  const SessionSummary s = session.finish();
  EXPECT_EQ(s.end, SessionEnd::fault);
  ASSERT_EQ(s.safety_events.size(), 1u);
  EXPECT_TRUE(device.is_switched_off);
  EXPECT_EQ(samples.back().command.force, Vec3::Zero());
  ASSERT_FALSE(s.notes.empty());
  EXPECT_NE(s.notes.back().find("it stopped ticking"), std::string::npos) << s.notes.back();
}

/// Of a session that another thread has taken over: its samples, in their order.
void expect_one_thread_at_a_time(const std::vector<HapticSample>& samples) {
  for (std::size_t i = 1; i < samples.size(); ++i)
    ASSERT_GT(samples[i].time, samples[i - 1].time) << i;
}

TEST(DeviceClock, ticks_that_come_back_find_the_session_taken_over) {
  SessionConfig config = patient_session();
  config.duration = 20.0;
  config.after_fault = 1.0;  // still at its end when they come back
  config.haptic.safety.watchdog = 0.3;
  TickingHand device(plane_hand(HandPath::press, 0.005));
  device.stays_away_from = 0.5;
  device.comes_back_at = 1.2;
  std::vector<HapticSample> samples;
  Session session(config, device, {[&](const HapticSample& s) { samples.push_back(s); }, {}, {}});
  session.start();
  const SessionSummary s = session.finish();
  EXPECT_EQ(s.end, SessionEnd::fault);
  EXPECT_GT(device.ticks_after_break, 0);
  EXPECT_EQ(device.last_force, 0.0);
  expect_one_thread_at_a_time(samples);
  ASSERT_EQ(s.safety_events.size(), 1u);
  double gap = 0.0;  // [ms]; not the age of the machine
  if (std::sscanf(s.safety_events[0].text.c_str(), "watchdog: %lf ms", &gap) == 1) {
    EXPECT_LT(gap, 1e5) << s.safety_events[0].text;
  }
}

TEST(DeviceClock, a_tick_that_hangs_does_not_go_on_beside_the_thread_that_took_over) {
  SessionConfig config = patient_session();
  config.duration = 20.0;
  config.after_fault = 1.0;
  config.haptic.safety.watchdog = 0.3;
  config.faults = parse_faults("hang=0.9@0.5");
  TickingHand device(plane_hand(HandPath::press, 0.005));
  std::vector<HapticSample> samples;
  Session session(config, device, {[&](const HapticSample& s) { samples.push_back(s); }, {}, {}});
  session.start();
  const SessionSummary s = session.finish();
  EXPECT_EQ(s.end, SessionEnd::fault);
  EXPECT_EQ(device.last_force, 0.0);
  expect_one_thread_at_a_time(samples);
}

TEST(DeviceClock, a_session_without_ticks_can_be_stopped) {
  SessionConfig config = patient_session();
  config.duration = 0.0;
  TickingHand device(plane_hand(HandPath::press, 0.005));
  Session session(config, device);
  session.start();
  sleep_ns(30'000'000);
  session.request_stop();
  EXPECT_EQ(session.finish().end, SessionEnd::stopped);
  EXPECT_EQ(device.last_force, 0.0);
}

TEST(DeviceClock, a_device_that_does_not_start_is_told_of_at_the_start) {
  SessionConfig config = patient_session();
  config.rate = 8000.0;
  TickingHand device(plane_hand(HandPath::press, 0.005));
  Session session(config, device);
  EXPECT_THROW(session.start(), DeviceUnavailable);
  EXPECT_FALSE(session.is_running());
  EXPECT_THROW(session.start(), std::logic_error) << "its watchdog has ended";
}

TEST(DeviceClock, lockstep_refuses_a_device_that_sets_the_pace) {
  TickingHand device(plane_hand(HandPath::press, 0.005));
  EXPECT_THROW(run_lockstep(patient_session(), device), DeviceUnavailable);
}

}  // namespace
}  // namespace thigma
