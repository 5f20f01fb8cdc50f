#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/device/open_device.h"
#include "thigma/session/detail/check_config.h"

namespace thigma {
namespace {

using test::HeldDevice;
using test::plane_hand;
using test::plane_session;

SessionSummary run(const SessionConfig& config, HandParams hand, const SessionSinks& sinks = {}) {
  HandDevice device(hand);
  return run_lockstep(config, device, sinks);
}

TEST(Lockstep, SameInputsSameHashOtherSeedOtherHash) {
  SessionConfig config = plane_session();
  HandParams hand = plane_hand(HandPath::press);
  hand.tremor = 2e-5;
  const std::uint64_t first = run(config, hand).state_hash;
  EXPECT_EQ(run(config, hand).state_hash, first);
  hand.seed = 2;
  EXPECT_NE(run(config, hand).state_hash, first);
}

TEST(Lockstep, CountsWhatItDid) {
  SessionConfig config = plane_session();
  config.duration = 0.25;
  config.rate = 500.0;
  config.contact_every = 5;
  int frames = 0, models = 0;
  double last_time = -1.0;
  const SessionSummary s = run(config, plane_hand(HandPath::rest),
                               {[&](const HapticSample& sample) {
                                  EXPECT_GT(sample.time, last_time);
                                  EXPECT_DOUBLE_EQ(sample.elapsed, 1.0 / 500.0);
                                  last_time = sample.time;
                                  ++frames;
                                },
                                [&](const ContactSample&) { ++models; },
                                {}});
  EXPECT_EQ(s.end, SessionEnd::duration);
  EXPECT_EQ(s.frames, 125u);
  EXPECT_EQ(frames, 125);
  EXPECT_EQ(s.contact_updates, 26u);  // one before the first frame, then every fifth
  EXPECT_EQ(models, 26);
  EXPECT_EQ(s.missed, 0u);
  EXPECT_EQ(s.step_cpu.count, 125u);
  EXPECT_DOUBLE_EQ(s.seconds, 0.25);
}

TEST(Lockstep, ModelsAreUsedAfterTheirLatencyAndNotBefore) {
  SessionConfig config = plane_session();
  config.duration = 0.1;
  config.contact_every = 4;
  config.contact_latency = 7;
  std::vector<double> times;  // of the states the models were made for
  bool is_right = true;
  run(config, plane_hand(HandPath::rest),
      {[&](const HapticSample& sample) {
         // The newest model made at least seven frames ago.
         std::uint64_t expected = 1;
         for (std::size_t i = 1; i < times.size(); ++i) {
           if (times[i] * 1000.0 + 7.0 <= static_cast<double>(sample.frame) + 0.5) expected = i + 1;
         }
         is_right = is_right && sample.model_sequence == expected;
       },
       [&](const ContactSample& sample) { times.push_back(sample.model.time); },
       {}});
  EXPECT_TRUE(is_right);
  EXPECT_GT(times.size(), 20u);
}

TEST(Lockstep, StopsOnRequestAndWhenTheDeviceHasFinished) {
  HeldDevice device;
  std::atomic<bool> stop{false};
  SessionConfig config = plane_session();
  config.duration = 0.0;
  const SessionSummary stopped = run_lockstep(
      config, device, {[&](const HapticSample& s) { stop = s.frame == 41; }, {}, {}}, &stop);
  EXPECT_EQ(stopped.end, SessionEnd::stopped);
  EXPECT_EQ(stopped.frames, 42u);
  EXPECT_EQ(device.written.force, Vec3::Zero());
  device.state.status = DeviceStatus::finished;
  EXPECT_EQ(run_lockstep(config, device).end, SessionEnd::device_finished);
}

TEST(Lockstep, ASinkThatThrowsLeavesTheDeviceAtZeroForce) {
  HeldDevice device;
  device.state.buttons = kClutchButton;
  SessionConfig config = plane_session(0.0);
  config.haptic.safety.start_ramp = 0.0;
  config.world_from_body.position.z() = 1.0;
  config.haptic.body.gravity = {0.0, 0.0, -9.81};  // felt in the hand
  double felt = 0.0;
  EXPECT_THROW(run_lockstep(config, device,
                            {[&](const HapticSample& s) {
                               felt = s.command.force.norm();
                               if (s.frame == 300) throw std::runtime_error("disk full");
                             },
                             {},
                             {}}),
               std::runtime_error);
  EXPECT_NEAR(felt, 0.0981, 0.01);  // there was something to let go of
  EXPECT_EQ(device.written.force, Vec3::Zero());
  EXPECT_EQ(device.written.torque, Vec3::Zero());
}

TEST(Lockstep, RefusesNumbersThatMakeNoSense) {
  HeldDevice device;
  const auto refuses = [&](void (*change)(SessionConfig&)) {
    SessionConfig config = plane_session();
    change(config);
    EXPECT_THROW(run_lockstep(config, device), std::invalid_argument);
  };
  refuses([](SessionConfig& c) { c.rate = 0.0; });
  refuses([](SessionConfig& c) { c.rate = std::numeric_limits<double>::quiet_NaN(); });
  refuses([](SessionConfig& c) { c.duration = -1.0; });
  refuses([](SessionConfig& c) { c.contact_every = 0; });
  refuses([](SessionConfig& c) { c.contact.friction = {{0.3, 0.3}, {-0.1, 0.2}}; });
  refuses([](SessionConfig& c) { c.contact.friction = {{0.3, 0.2}}; });
  refuses([](SessionConfig& c) { c.contact_latency = 0; });
  refuses([](SessionConfig& c) { c.haptic.body.mass = 0.0; });
  refuses([](SessionConfig& c) { c.deep_contact = -1e-3; });
  refuses([](SessionConfig& c) { c.haptic.coupling.linear_stiffness = 0.0; });
  refuses([](SessionConfig& c) {
    c.haptic.safety.max_speed = std::numeric_limits<double>::quiet_NaN();
  });
  refuses([](SessionConfig& c) { c.haptic.safety.silent_device = -1.0; });
}

// Ramps of a virtual clock are over in no time, and a query holds the last force while it lasts.
TEST(Lockstep, RefusesADeviceThatHoldsAPersonAndWritesNothingToIt) {
  HeldDevice device;
  device.device_limits.holds_person = true;
  EXPECT_THROW(run_lockstep(plane_session(), device), DeviceUnavailable);
  EXPECT_EQ(device.writes, 0);
}

TEST(Lockstep, AWatchdogOfTenThousandYearsIsOneOfAnHour) {
  SessionConfig config = plane_session();
  config.haptic.safety.watchdog = 1e12;
  EXPECT_EQ(detail::effective_watchdog(config), 3600.0);
  HeldDevice device;
  EXPECT_EQ(run_lockstep(config, device).end, SessionEnd::duration);
}

TEST(Lockstep, WatchdogLeavesSlackAtLowRates) {
  HeldDevice device;
  SessionConfig config = plane_session();
  config.rate = 20.0;  // its period is longer than the watchdog's 20 ms
  config.faults = parse_faults("hang=0.1@0.2");
  EXPECT_EQ(run_lockstep(config, device).end, SessionEnd::duration);
  config.faults = parse_faults("hang=0.39@0.2");
  const SessionSummary s = run_lockstep(config, device);
  EXPECT_EQ(s.end, SessionEnd::fault);
  ASSERT_EQ(s.safety_events.size(), 1u);
  EXPECT_EQ(s.safety_events[0].detail, "watchdog");
  EXPECT_EQ(s.safety_events[0].text, "watchdog: 450.0 ms without a haptic step");
}

TEST(Lockstep, AHangIsAFaultUnlessGapsAreRiddenOut) {
  for (const bool rides_out : {false, true}) {
    SessionConfig config = plane_session();
    config.haptic.safety.rides_out_gaps = rides_out;
    config.faults = parse_faults("hang=0.1@0.2");
    HandDevice device(plane_hand(HandPath::press, 0.005));
    const SessionSummary s = run_lockstep(config, device);
    EXPECT_EQ(s.end, rides_out ? SessionEnd::duration : SessionEnd::fault);
    EXPECT_EQ(s.safety_events.size(), rides_out ? 0u : 1u);
    EXPECT_EQ(s.ridden_out.gaps, rides_out ? 1u : 0u);
  }
}

TEST(Lockstep, SaysOnceThatNothingArmsBecauseTheContactModelIsTooOld) {
  HeldDevice device;
  SessionConfig config = plane_session();
  config.duration = 3.0;
  config.contact_latency = 30;  // 30 ms, more than model_full_age
  std::vector<SessionEvent> told;
  const SessionSinks sinks{
      // The very first model is fresh: the hand takes hold after it.
      [&](const HapticSample& s) { device.state.buttons = s.frame > 100 ? kClutchButton : 0u; },
      {},
      [&](const SessionEvent& e) {
        if (e.kind == EventKind::not_armed) told.push_back(e);
      }};
  const SessionSummary s = run_lockstep(config, device, sinks);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_NE(told[0].text.find("too old, 30.0 ms at best"), std::string::npos) << told[0].text;
  EXPECT_EQ(std::count(s.notes.begin(), s.notes.end(), told[0].text), 1);
  config.contact_latency = 20;
  EXPECT_TRUE(run_lockstep(config, device, sinks).notes.empty());
}

/// Events of a cube that comes down on the plane at 0.2 m/s, twice, with contact frames `every`
/// milliseconds.
std::vector<SessionEvent> deep_contacts(int every, double deep, std::vector<std::string>& notes) {
  HeldDevice device;
  device.state.buttons = kClutchButton;
  SessionConfig config = plane_session(0.02);
  config.duration = 1.6;
  config.contact_every = config.contact_latency = every;
  config.deep_contact = deep;
  std::vector<SessionEvent> told;
  const SessionSinks sinks{
      [&](const HapticSample& s) {  // down 30 mm from 0.5 s on, up again, down again
        const double t = std::fmod(s.time, 0.8);
        const double way = t < 0.4 ? 0.2 * (t - 0.2) : 0.03 - 0.2 * (t - 0.4);
        device.state.motion.pose.position.z() = -std::clamp(way, 0.0, 0.03);
      },
      {},
      [&](const SessionEvent& e) {
        if (e.kind == EventKind::deep_contact) told.push_back(e);
      }};
  notes = run_lockstep(config, device, sinks).notes;
  return told;
}

TEST(Lockstep, TellsOfContactsThatAreDeepOnAnOldModel) {
  std::vector<std::string> notes;
  const std::vector<SessionEvent> told = deep_contacts(10, 1e-3, notes);
  ASSERT_EQ(told.size(), 2u);  // one a touch
  EXPECT_EQ(told[0].detail, "contact_model_too_old");
  double depth = 0.0, unseen = 0.0, age = 0.0;
  ASSERT_EQ(
      std::sscanf(told[0].text.c_str(),
                  "a contact is %lf mm deep, %lf mm of it unseen by a contact model %lf ms old",
                  &depth, &unseen, &age),
      3)
      << told[0].text;
  EXPECT_GT(depth, 1.0);
  EXPECT_GE(depth, unseen);
  EXPECT_GE(age, 10.0);
  EXPECT_LE(age, 20.0);
  EXPECT_TRUE(told[1].text.empty());
  EXPECT_EQ(std::count(notes.begin(), notes.end(), told[0].text), 1);
}

TEST(Lockstep, TellsOfNoDeepContactWhereModelsAreFreshOrDepthIsAllowed) {
  std::vector<std::string> notes;
  EXPECT_TRUE(deep_contacts(1, 1e-3, notes).empty());
  EXPECT_TRUE(deep_contacts(10, 0.05, notes).empty());
  EXPECT_TRUE(deep_contacts(10, 0.0, notes).empty());  // a source has no radius
  EXPECT_TRUE(notes.empty());
}

TEST(Lockstep, TellsWhatHappened) {
  SessionConfig config = plane_session();
  config.faults = parse_faults("nan@0.5");
  std::vector<SessionEvent> events;
  const SessionSummary s = run(config, plane_hand(HandPath::rest),
                               {{}, {}, [&](const SessionEvent& e) { events.push_back(e); }});
  ASSERT_EQ(events.size(), 5u);
  EXPECT_EQ(events[0].kind, EventKind::grasped);
  EXPECT_EQ(events[1].kind, EventKind::armed);
  EXPECT_EQ(events[2].kind, EventKind::fault);
  EXPECT_EQ(events[2].detail, "not_finite");
  EXPECT_DOUBLE_EQ(events[2].time, 0.5);
  ASSERT_EQ(s.safety_events.size(), 1u);
  EXPECT_EQ(s.safety_events[0].detail, "not_finite");
  EXPECT_EQ(s.end, SessionEnd::fault);
}

}  // namespace
}  // namespace thigma
