#include "thigma/session/session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/recording/replay_session.h"
#include "thigma/session/statistics.h"

namespace thigma {
namespace {

using test::HeldDevice;
using test::plane_hand;
using test::plane_session;

/// Records what a session tells.
struct Recorder {
  std::vector<HapticSample> samples;
  std::vector<ContactSample> models;
  SessionSinks sinks() {
    return {[this](const HapticSample& s) { samples.push_back(s); },
            [this](const ContactSample& s) { models.push_back(s); },
            {}};
  }
};

/// Timing of this machine must not decide a test: late frames are no fault here.
SessionConfig patient_session() {
  SessionConfig config = plane_session();
  config.duration = 0.6;
  config.haptic.safety.watchdog = 5.0;
  config.haptic.safety.model_full_age = 5.0;
  config.haptic.safety.model_stale_age = 10.0;
  config.haptic.safety.pose_jump = 1.0;
  return config;
}

TEST(Session, RunsOnThreadsAndReplaysToTheSameBits) {
  const SessionConfig config = patient_session();
  HandDevice device(plane_hand(HandPath::press, 0.005));
  Recorder recorder;
  Session session(config, device, recorder.sinks());
  session.start();
  const SessionSummary s = session.finish();
  EXPECT_EQ(s.end, SessionEnd::duration);
  EXPECT_EQ(s.dropped_samples, 0u);
  ASSERT_EQ(recorder.samples.size(), s.frames);
  EXPECT_EQ(recorder.models.size(), s.contact_updates);
  EXPECT_GE(s.frames + s.missed, 599u);
  for (std::size_t i = 0; i < recorder.samples.size(); ++i) ASSERT_EQ(recorder.samples[i].frame, i);

  HapticParams params = config.haptic;
  params.device = device.limits();
  const ReplayReport replay =
      replay_session(params, config.world_from_body, recorder.samples, recorder.models);
  EXPECT_TRUE(replay.identical) << replay.first_difference << ' ' << replay.reason;
  EXPECT_EQ(replay.state_hash, s.state_hash);
  EXPECT_EQ(device.applied_wrench().force, Vec3::Zero());
}

TEST(Session, StopsWhenAskedWithZeroForce) {
  SessionConfig config = patient_session();
  config.duration = 0.0;
  HeldDevice device;
  device.state.buttons = kClutchButton;
  Session session(config, device);
  EXPECT_FALSE(session.is_running());
  session.start();
  EXPECT_THROW(session.start(), std::logic_error);
  sleep_ns(50'000'000);
  EXPECT_TRUE(session.is_running());
  session.request_stop();
  EXPECT_EQ(session.finish().end, SessionEnd::stopped);
  EXPECT_FALSE(session.is_running());
  EXPECT_EQ(device.written.force, Vec3::Zero());
  EXPECT_GT(device.writes, 1);
}

TEST(Session, DestructorEndsARunningSession) {
  HeldDevice device;
  SessionConfig config = patient_session();
  config.duration = 0.0;
  {
    Session session(config, device);
    session.start();
    sleep_ns(20'000'000);
  }
  const int writes = device.writes;
  sleep_ns(20'000'000);
  EXPECT_EQ(device.writes, writes);
}

TEST(Session, WatchdogSendsZeroForceWhileTheHapticThreadHangs) {
  SessionConfig config = patient_session();
  config.haptic.safety.watchdog = 0.020;
  config.haptic.safety.start_ramp = 0.0;
  config.haptic.body.gravity = {0.0, 0.0, -9.81};
  config.world_from_body.position.z() = 1.0;
  config.faults = parse_faults("hang=0.3@0.2");
  HeldDevice device;
  device.state.buttons = kClutchButton;
  Recorder recorder;
  Session session(config, device, recorder.sinks());
  session.start();
  const SessionSummary s = session.finish();
  ASSERT_EQ(s.end, SessionEnd::fault);
  ASSERT_EQ(s.safety_events.size(), 1u);
  EXPECT_EQ(s.safety_events[0].detail, "watchdog");
  // not before it can have acted
  EXPECT_GE(s.safety_events[0].time, 0.2 + config.haptic.safety.watchdog);
  EXPECT_GE(s.missed, 250u);
  // More writes than frames: the watchdog's own, while nobody else wrote.
  EXPECT_GT(static_cast<std::uint64_t>(device.writes), s.frames + 1);
  EXPECT_EQ(device.written.force, Vec3::Zero());
  EXPECT_EQ(recorder.samples.back().command.force, Vec3::Zero());
}

TEST(Session, AGapIsToldCountedAndReplayedWhereNobodyIsHeld) {
  SessionConfig config = patient_session();
  config.haptic.safety.watchdog = 0.020;
  config.haptic.safety.rides_out_gaps = true;
  config.faults = parse_faults("hang=0.3@0.2");
  HandDevice device(plane_hand(HandPath::press, 0.005));
  Recorder recorder;
  std::vector<SessionEvent> late;
  SessionSinks sinks = recorder.sinks();
  sinks.event = [&](const SessionEvent& event) {
    if (event.kind == EventKind::late) late.push_back(event);
  };
  Session session(config, device, sinks);
  session.start();
  const SessionSummary s = session.finish();
  EXPECT_EQ(s.end, SessionEnd::duration);
  EXPECT_TRUE(s.safety_events.empty());
  ASSERT_GE(s.ridden_out.gaps, 1u);  // others are the machine's
  EXPECT_GE(s.ridden_out.longest_gap, 0.299);
  EXPECT_EQ(late.size(), s.ridden_out.gaps + s.ridden_out.stale_models);
  EXPECT_EQ(late[0].detail, "watchdog");
  HapticParams params = config.haptic;
  params.device = device.limits();
  const ReplayReport replay =
      replay_session(params, config.world_from_body, recorder.samples, recorder.models);
  EXPECT_TRUE(replay.identical) << replay.first_difference << ' ' << replay.reason;
  for (const HapticSample& sample : recorder.samples) {
    if (rode_out_gap(sample)) {
      EXPECT_EQ(sample.command.force, Vec3::Zero());
    }
  }
}

TEST(Session, WatchdogWatchesFromTheStartAndSaysHowLongNothingStepped) {
  SessionConfig config = patient_session();
  config.haptic.safety.watchdog = 0.020;
  config.faults = parse_faults("hang=0.3@0");
  HeldDevice device;
  Session session(config, device);
  session.start();
  const SessionSummary s = session.finish();
  ASSERT_EQ(s.end, SessionEnd::fault);
  ASSERT_EQ(s.safety_events.size(), 1u);
  EXPECT_EQ(s.safety_events[0].detail, "watchdog");
  EXPECT_EQ(s.safety_events[0].frame, 0u);  // the first step already knew
  double gap = 0.0;                         // [ms]
  ASSERT_EQ(std::sscanf(s.safety_events[0].text.c_str(), "watchdog: %lf ms", &gap), 1);
  EXPECT_GE(gap, 299.9);
  EXPECT_EQ(std::count(s.notes.begin(), s.notes.end(), s.safety_events[0].text), 1);
}

TEST(Session, StalledContactThreadFadesAndLatches) {
  SessionConfig config = patient_session();
  config.haptic.safety.model_full_age = 0.025;
  config.haptic.safety.model_stale_age = 0.050;
  config.faults = parse_faults("stall=0.2@0.2");
  HandDevice device(plane_hand(HandPath::rest));
  Session session(config, device);
  session.start();
  const SessionSummary s = session.finish();
  EXPECT_EQ(s.end, SessionEnd::fault);
  ASSERT_EQ(s.safety_events.size(), 1u);
  EXPECT_EQ(s.safety_events[0].detail, "contact_stale");
  EXPECT_EQ(device.applied_wrench().force, Vec3::Zero());
}

/// A handle that holds the cube from the start and goes 20 mm down within 0.2 s from 0.5 s on.
class SinkingDevice final : public HapticDevice {
 public:
  const DeviceLimits& limits() const override { return device_limits; }
  std::string name() const override { return "sinking"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    state.buttons = kClutchButton;
    state.motion.pose.position.z() = -0.02 * std::clamp((now - 0.5) / 0.2, 0.0, 1.0);
    return state;
  }
  void write(const Wrench&) THIGMA_RT override {}

  DeviceLimits device_limits;
};

/// Events "deep_contact" of a cube let down 15 mm below a plane.
std::vector<SessionEvent> deep_contacts(const char* faults) {
  SessionConfig config = patient_session();
  config.duration = 1.2;
  config.deep_contact = 5e-3;
  config.faults = parse_faults(faults);
  SinkingDevice device;
  std::vector<SessionEvent> told;
  const auto tell = [&](const SessionEvent& e) {
    if (e.kind == EventKind::deep_contact) told.push_back(e);
  };
  Session session(config, device, {{}, {}, tell});
  session.start();
  session.finish();
  return told;
}

TEST(Session, TellsOfContactsThatAreDeepOnAnOldModel) {
  // The contact thread stands still while the hand lets the cube down.
  const std::vector<SessionEvent> told = deep_contacts("stall=0.4@0.45");
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].detail, "contact_model_too_old");
  EXPECT_GE(told[0].time, 0.8);
  EXPECT_NE(told[0].text.find("mm deep"), std::string::npos) << told[0].text;
}

TEST(Session, ASinkThatThrowsEndsTheSessionInOrder) {
  HeldDevice device;
  SessionConfig config = patient_session();
  config.duration = 0.0;
  Session session(config, device,
                  {[](const HapticSample&) { throw std::runtime_error("disk full"); }, {}, {}});
  session.start();
  EXPECT_THROW(session.finish(), std::runtime_error);
  EXPECT_EQ(device.written.force, Vec3::Zero());
}

TEST(Session, FullRingsAreCounted) {
  HeldDevice device;
  SessionConfig config = patient_session();
  config.duration = 0.2;
  config.telemetry_frames = 2;
  std::uint64_t received = 0;
  Session session(config, device,
                  {[&](const HapticSample&) {
                     ++received;
                     sleep_ns(5'000'000);
                   },
                   {},
                   {}});
  session.start();
  const SessionSummary s = session.finish();
  EXPECT_GT(s.dropped_samples, 0u);
  EXPECT_LE(received, s.frames);
  EXPECT_GE(received + s.dropped_samples, s.frames);
}

}  // namespace
}  // namespace thigma
