// Devices that hold people in a world by the clock: each on its own clock, and one fault ends all.

#include "thigma/session/detail/hand_thread.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <thread>
#include <vector>

#include "session/pushing_world.h"
#include <gtest/gtest.h>

#include "thigma/device/open_device.h"
#include "thigma/session/live_ports.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/world_replay.h"
#include "thigma/session/world_threads.h"

namespace thigma {
namespace {

using namespace test;

/// Waits until it is so; a minute, should it never be. Whether it is.
template <class Condition>
bool comes(Condition condition) {
  for (int i = 0; i < 60'000 && !condition(); ++i) sleep_ns(1'000'000);
  return condition();
}

/// A device that holds a person, whose handle goes along x; told what to do by the test.
class PersonDevice : public HapticDevice {
 public:
  explicit PersonDevice(double speed) : speed_(speed) {
    limits_.max_force = 8.0;
    limits_.max_torque = 0.5;
  }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "person"; }
  const char* trouble() const THIGMA_RT override { return is_lost ? "unplugged" : ""; }
  DeviceState read(double now) THIGMA_RT override {
    ++reads;
    now_ = now;
    while (is_stuck) sleep_ns(1'000'000);
    DeviceState state;
    state.time = now;
    state.buttons = buttons;
    state.motion.pose.position.x() = speed_ * std::min(now, 0.3);
    if (now < 0.3) state.motion.twist.linear.x() = speed_;
    if (is_lost) state.status = DeviceStatus::lost;
    if (is_nan) state.motion.twist.angular.y() = std::nan("");
    if (has_jumped) state.motion.pose.position.z() = 20.0;  // too far for any tick
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override {
    const double size = wrench.force.norm();
    above_ramp = std::max(above_ramp, size - limits_.max_force * now_ / ramp);
    most_torque = std::max(most_torque, wrench.torque.norm());
    force = size;
    most = std::max(most, size);
    is_zero = !(size > 0.0) && !(wrench.torque.norm() > 0.0);
  }

  std::atomic<bool> is_stuck{false}, is_lost{false}, is_nan{false}, has_jumped{false};
  std::atomic<bool> is_zero{true};
  std::atomic<double> force{0.0};  // sent last
  std::atomic<std::uint32_t> buttons{kClutchButton};
  std::atomic<std::uint64_t> reads{0};
  double most = 0.0, most_torque = 0.0;
  double ramp = 1e-3;        // that it expects [s]
  double above_ramp = -1e9;  // most of the force beyond that [N]
  DeviceLimits limits_;

 private:
  double speed_, now_ = 0.0;
};

/// Limits of time that a loaded machine keeps; forces are there at once.
SafetyLimits patient() {
  SafetyLimits limits;
  limits.watchdog = 30.0;
  limits.model_full_age = limits.rows_full_age = 60.0;
  limits.model_stale_age = limits.rows_stale_age = 120.0;
  limits.max_speed = 100.0;
  limits.pose_jump = 0.1;
  limits.start_ramp = 0.01;
  return limits;
}

/// Two people, each with a block of their own, who push against a third.
struct TwoPeople {
  WorldBench bench;
  WorldSessionConfig config = with_two_hands(bench, false);
  PersonDevice first{0.05}, second{-0.05};
  HapticDevice* devices[2] = {&first, &second};
  WorldShell shell;
  RecordedApart recorded;

  TwoPeople() {
    config.duration = 60.0;
    recorded.ticks.resize(2);
    recorded.seen.resize(2);
    for (WorldHand& hand : config.hands) {
      hand.limits = patient();
      hand.has_clutch = true;
    }
    shell.ticks = [this](std::span<const HandTick> ticks) {
      for (const HandTick& tick : ticks)
        recorded.ticks[static_cast<std::size_t>(tick.hand)].push_back(tick);
    };
  }
  /// What each frame does, beside what is recorded.
  void each(const std::function<void(const WorldFrame&)>& frame) {
    shell.sink = [this, frame](const WorldFrame& now) {
      for (std::size_t i = 0; i < 2; ++i) recorded.seen[i].push_back(now.haptic.seen[i]);
      frame(now);
    };
  }
  WorldSummary run() { return run_world_on_threads(config, devices, shell); }
  bool is_let_go() const { return first.is_zero && second.is_zero; }
  bool are_pulled() const { return first.force > 0.5 && second.force > 0.5; }
};

TEST(HandThread, TwoPeopleHoldTheirBodiesAndTheirSessionComesAgain) {
  TwoPeople two;
  two.config.duration = 1.0;
  for (WorldHand& hand : two.config.hands) hand.limits.start_ramp = 1.0;
  two.first.ramp = two.second.ramp = 1.0;
  two.each([](const WorldFrame&) {});
  const WorldSummary run = two.run();
  EXPECT_FALSE(run.has_fault()) << fault_name(run.fault);
  EXPECT_TRUE(two.is_let_go());
  for (const PersonDevice* person : {&two.first, &two.second}) {
    EXPECT_GT(person->most, 1.0);
    EXPECT_LE(person->above_ramp, 1e-9);
  }
  two.config.duration = static_cast<double>(run.frames) / two.config.rate;
  const DeviceLimits limits[] = {two.first.limits(), two.second.limits()};
  const WorldSummary again = replay_world_apart(two.config, limits, two.recorded);
  EXPECT_EQ(again.frames, run.frames);
  EXPECT_EQ(again.state_hash, run.state_hash);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(again.haptic[i].state_hash, run.haptic[i].state_hash);
}

TEST(HandThread, EachFaultOfOnePersonsDeviceLeavesBothAtZeroForce) {
  struct Case {
    Fault fault;
    std::atomic<bool> PersonDevice::*trouble;
  };
  const Case cases[] = {{Fault::device_lost, &PersonDevice::is_lost},
                        {Fault::not_finite, &PersonDevice::is_nan},
                        {Fault::pose_jump, &PersonDevice::has_jumped}};
  for (const Case& c : cases) {
    for (const bool is_second : {false, true}) {
      TwoPeople two;
      PersonDevice& bad = is_second ? two.second : two.first;
      bool was_pulled = false;
      two.each([&](const WorldFrame&) {
        if (!two.are_pulled()) return;
        was_pulled = true;
        bad.*c.trouble = true;
        EXPECT_TRUE(comes([&] { return two.is_let_go(); }));  // this frame takes until then
      });
      const WorldSummary run = two.run();
      EXPECT_TRUE(was_pulled);
      EXPECT_EQ(run.fault, c.fault) << fault_name(run.fault);
      EXPECT_EQ(run.hands[is_second ? 1 : 0].fault, c.fault);
      EXPECT_EQ(run.hands[is_second ? 0 : 1].fault, Fault::none);
      EXPECT_TRUE(two.is_let_go());
      if (c.fault == Fault::device_lost)
        EXPECT_EQ(run.hands[is_second ? 1 : 0].trouble, "unplugged");
    }
  }
}

TEST(HandThread, AReadThatHangsLeavesTheOtherAtZeroForceAndEndsTheSession) {
  TwoPeople two;
  two.config.hands[0].limits.watchdog = 0.2;
  bool was_pulled = false;
  two.each([&](const WorldFrame&) {
    if (!two.are_pulled() || was_pulled) return;
    was_pulled = true;
    two.first.is_stuck = true;
    EXPECT_TRUE(comes([&] { return two.second.is_zero.load(); }));
    two.first.is_stuck = false;
  });
  const WorldSummary run = two.run();
  EXPECT_TRUE(was_pulled);
  EXPECT_EQ(run.fault, Fault::watchdog) << fault_name(run.fault);
  EXPECT_EQ(run.hands[0].fault, Fault::watchdog);
  EXPECT_GE(run.hands[0].hung, 0.2);
  EXPECT_EQ(run.hands[1].fault, Fault::none);
  EXPECT_TRUE(two.is_let_go());
}

TEST(HandThread, AReadThatHangsHoldsUpNoOtherHand) {
  TwoPeople two;
  two.config.duration = 0.3;
  two.first.limits_.holds_person = false;  // its gap is ridden out
  two.config.hands[0].limits.watchdog = 0.05;
  bool was_answered = false, was_stopped = false;
  two.each([&](const WorldFrame& frame) {
    if (frame.frame != 100) return;
    two.first.is_stuck = true;
    sleep_ns(2'000'000);  // it is in its read
    const std::uint64_t before = two.second.reads;
    was_answered = comes([&] { return two.second.reads > before + 100; });
    two.first.is_stuck = false;
    const std::uint64_t reads = two.first.reads;
    was_stopped = comes([&] { return two.first.reads > reads; });
  });
  const WorldSummary run = two.run();
  EXPECT_FALSE(run.has_fault()) << fault_name(run.fault);
  EXPECT_TRUE(was_answered);
  EXPECT_TRUE(was_stopped);
  EXPECT_GE(run.haptic_missed, 90u);
}

TEST(HandThread, AHandThatHangsInsideAWorldThatGoesOnIsNoSilentDevice) {
  TwoPeople two;
  two.config.duration = 0.6;
  two.first.limits_.holds_person = false;
  two.each([&](const WorldFrame& frame) {
    if (frame.frame == 100) two.first.is_stuck = true;
    if (frame.frame == 300) two.first.is_stuck = false;  // silent_device is 50 ms
  });
  const WorldSummary run = two.run();
  EXPECT_FALSE(run.has_fault()) << fault_name(run.fault);
  EXPECT_EQ(run.frames, 600u);
  EXPECT_GE(run.haptic_missed, 100u);
  two.config.duration = static_cast<double>(run.frames) / two.config.rate;
  const DeviceLimits limits[] = {two.first.limits(), two.second.limits()};
  EXPECT_EQ(replay_world_apart(two.config, limits, two.recorded).state_hash, run.state_hash);
}

TEST(HandThread, AWorldThatDoesNotAnswerIsAFaultWhereAPersonIsHeld) {
  TwoPeople two;
  SafetyLimits& limits = two.config.hands[0].limits;
  limits.model_full_age = limits.rows_full_age = 0.3;
  limits.model_stale_age = limits.rows_stale_age = 0.6;
  bool was_pulled = false, is_let_go = false;
  two.each([&](const WorldFrame&) {
    if (!two.are_pulled() || was_pulled) return;
    was_pulled = true;
    is_let_go = comes([&] { return two.is_let_go(); });
  });
  const WorldSummary run = two.run();
  EXPECT_TRUE(was_pulled);
  EXPECT_TRUE(is_let_go);
  EXPECT_EQ(run.fault, Fault::contact_stale) << fault_name(run.fault);
}

TEST(HandThread, APersonLetsGoByTheClutchAndTakesHoldAgainWhereItWas) {
  TwoPeople two;
  std::vector<std::int32_t> held;
  int phase = 0;
  double force = -1.0;
  std::uint64_t since = 0;
  std::atomic<bool> stop{false};
  two.shell.stop = &stop;
  two.each([&](const WorldFrame& frame) {
    if (phase == 0 && two.first.force > 0.5) {
      two.first.buttons = 0;
      phase = comes([&] { return two.first.is_zero.load(); }) ? 1 : 9;
      since = frame.frame;
    } else if (phase == 1 && frame.frame == since + 50) {
      EXPECT_EQ(frame.grips[0].body, -1);
      two.first.buttons = kClutchButton;
      phase = 2;
    } else if (phase == 2 && frame.grips[0].body >= 0) {
      EXPECT_EQ(frame.grips[0].body, two.config.hands[0].body);
      EXPECT_EQ(frame.grips[0].number, 2u);
      const WorldAim at{1, Vec3(0.0, -0.02, 0.0)};  // as at the start
      const BodyState& y = frame.bodies[1];
      const Vec3 grasped = transform_point(frame.grips[0].body_from_grasp, Vec3::Zero());
      EXPECT_LT((grasped - at.point).norm(), 1e-3) << y.position.transpose();
      force = two.first.force;
      stop = true;
      phase = 3;
    }
  });
  const WorldSummary run = two.run();
  EXPECT_FALSE(run.has_fault()) << fault_name(run.fault);
  EXPECT_EQ(phase, 3);
  EXPECT_LT(force, 0.5);  // both springs at rest, and over the ramp
  EXPECT_TRUE(two.is_let_go());
}

TEST(HandThread, NothingIsPausedWhereAPersonIsHeld) {
  TwoPeople two;
  two.config.duration = 0.1;
  LivePorts ports;
  ports.is_paused = true;
  two.shell.live = &ports;
  const WorldSummary run = two.run();
  EXPECT_EQ(run.frames, 100u);
}

TEST(HandThread, ButtonsTurnWhatSensesNoRotationAndItGetsNoTorque) {
  TwoPeople two;
  two.config.duration = 0.4;
  two.first.limits_.senses_rotation = two.first.limits_.actuates_rotation = false;
  two.first.buttons = kClutchButton | kTurnButtons[4];
  Quat last = Quat::Identity();
  two.each([&](const WorldFrame& frame) { last = frame.handles[0].pose.orientation; });
  const WorldSummary run = two.run();
  EXPECT_FALSE(run.has_fault()) << fault_name(run.fault);
  EXPECT_EQ(two.first.most_torque, 0.0);
  EXPECT_GT(two.second.most_torque + two.second.most, 0.0);
  const double angle = 2.0 * std::atan2(last.z(), last.w());
  EXPECT_NEAR(angle, kButtonTurnRate * 0.4, 0.05);
}

/// A device that owns the clock: ticks of a thread of its own, while it is told to.
class TickingDevice final : public PersonDevice {
 public:
  TickingDevice() : PersonDevice(0.05) { limits_.clock = DeviceClock::device; }
  ~TickingDevice() override { TickingDevice::stop_ticks(); }
  void start_ticks(double rate, DeviceTick tick) override {
    if (is_refused) throw DeviceUnavailable("ticking: not at this rate");
    is_over = false;
    thread_ = std::thread([this, rate, tick] {
      while (!is_over) {
        if (!is_silent) {
          is_in_tick = true;
          tick.call(tick.context);
          is_in_tick = false;
        }
        sleep_ns(static_cast<std::int64_t>(1e9 / rate));
      }
    });
  }
  void stop_ticks() noexcept override {
    is_over = true;
    if (thread_.joinable()) thread_.join();
    is_zero = true;
  }
  DeviceState read(double now) THIGMA_RT override {
    outside += is_in_tick ? 0 : 1;
    return PersonDevice::read(now);
  }
  std::atomic<bool> is_silent{false}, is_over{false}, is_in_tick{false};
  std::atomic<int> outside{0};  // reads
  bool is_refused = false;

 private:
  std::thread thread_;
};

TEST(HandThread, ADeviceThatOwnsTheClockIsSteppedInItsTicks) {
  TwoPeople two;
  TickingDevice ticking;
  two.devices[0] = &ticking;
  bool was_pulled = false;
  std::atomic<bool> stop{false};
  two.shell.stop = &stop;
  two.each([&](const WorldFrame&) {
    was_pulled = was_pulled || (ticking.force > 0.5 && two.second.force > 0.5);
    stop = was_pulled;
  });
  const WorldSummary run = two.run();
  EXPECT_FALSE(run.has_fault()) << fault_name(run.fault);
  EXPECT_TRUE(was_pulled);
  EXPECT_EQ(ticking.outside, 0);
  EXPECT_TRUE(ticking.is_over);
  EXPECT_EQ(ticking.force, 0.0);  // in its ticks, before they were stopped
  EXPECT_EQ(run.haptic[0].steps, ticking.reads);
  two.config.duration = static_cast<double>(run.frames) / two.config.rate;
  const DeviceLimits limits[] = {ticking.limits(), two.second.limits()};
  EXPECT_EQ(replay_world_apart(two.config, limits, two.recorded).state_hash, run.state_hash);
}

TEST(HandThread, TicksThatStayAwayLeaveBothAtZeroForce) {
  for (const bool is_silent_from_the_start : {false, true}) {
    TwoPeople two;
    TickingDevice ticking;
    two.devices[0] = &ticking;
    two.config.hands[0].limits.watchdog = 0.2;
    ticking.is_silent = is_silent_from_the_start;
    two.each([&](const WorldFrame&) {
      if (ticking.force > 0.5 && two.second.force > 0.5) ticking.is_silent = true;
    });
    const WorldSummary run = two.run();
    const Fault expected = is_silent_from_the_start ? Fault::device_lost : Fault::watchdog;
    EXPECT_EQ(run.fault, expected) << fault_name(run.fault);
    EXPECT_EQ(run.hands[0].fault, expected);
    EXPECT_TRUE(ticking.is_zero && two.second.is_zero);
    EXPECT_TRUE(ticking.is_over);
  }
}

TEST(HandThread, ADeviceThatRefusesItsRateEndsBeforeAnyForce) {
  TwoPeople two;
  TickingDevice ticking;
  ticking.is_refused = true;
  two.devices[1] = &ticking;
  EXPECT_THROW(two.run(), DeviceUnavailable);
  EXPECT_TRUE(two.first.is_zero && ticking.is_zero);
}

TEST(HandThread, AnErrorWhileTwoPeopleAreHeldEndsAtZeroForce) {
  TwoPeople two;
  two.each([&](const WorldFrame&) {
    if (two.are_pulled()) throw std::runtime_error("the disk is full");
  });
  EXPECT_THROW(two.run(), std::runtime_error);
  EXPECT_TRUE(two.is_let_go());
  EXPECT_GT(two.first.most, 0.5);
}

}  // namespace
}  // namespace thigma
