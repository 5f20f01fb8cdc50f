// What every driver over a link keeps, without a service.
#include "thigma/device/detail/link_device.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "thigma/device/detail/bubble_device.h"
#include "thigma/device/detail/rotated_device.h"
#include "thigma/device/detail/stream_socket.h"
#include "thigma/device/null_device.h"
#include "thigma/device/open_device.h"
#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

DeviceLimits three_axes() {
  DeviceLimits limits;
  limits.max_force = 4.0;
  limits.actuates_rotation = false;
  return limits;
}

/// A link without a thread that speaks: the test is the service.
struct TestLink {
  explicit TestLink(bool stays = false)
      : device("test", three_axes(), stays, [this](LinkEnds& e) {
          ends = &e;
          is_there.store(true, std::memory_order_release);
        }) {
    while (!is_there.load(std::memory_order_acquire)) usleep(100);
  }
  void publish(const Vec3& place, const Vec3& velocity, double interval) {
    ++sample.count;
    sample.motion.pose.position = place;
    sample.motion.twist.linear = velocity;
    sample.interval = interval;
    ends->samples.publish(sample);
  }
  LinkEnds* ends = nullptr;
  std::atomic<bool> is_there{false};
  LinkSample sample;
  LinkDevice device;
};

TEST(LinkDevice, commands_are_cut_and_carry_where_the_handle_was) {
  TestLink link;
  link.publish({0.01, 0.02, 0.03}, Vec3::Zero(), 0.0);
  link.device.read(0.0);
  LinkForce force;
  link.device.write({{0.0, 3.0, 0.25}, {0.1, 0.0, 0.0}});
  const LinkCommand sent = force.newest(*link.ends, kMillisecond);
  EXPECT_EQ(sent.force, Vec3(0.0, 3.0, 0.25));
  EXPECT_EQ(sent.at, Vec3(0.01, 0.02, 0.03));
  link.device.write({{0.0, 0.0, 100.0}, Vec3::Zero()});
  EXPECT_NEAR(force.newest(*link.ends, kMillisecond).force.norm(), 4.0, 1e-12);
  link.device.write({{0.0, std::nan(""), 0.0}, Vec3::Zero()});
  EXPECT_EQ(force.newest(*link.ends, kMillisecond).force, Vec3(Vec3::Zero()));
}

TEST(LinkDevice, a_command_that_nothing_renews_becomes_zero) {
  TestLink link;
  LinkForce force;
  link.device.write({{0.0, 0.0, 2.0}, Vec3::Zero()});
  EXPECT_EQ(force.newest(*link.ends, 0).force.z(), 2.0);
  EXPECT_EQ(force.newest(*link.ends, 49 * kMillisecond).force.z(), 2.0);
  EXPECT_EQ(force.newest(*link.ends, 51 * kMillisecond).force.z(), 0.0);
  link.device.write({{0.0, 0.0, 2.0}, Vec3::Zero()});
  EXPECT_EQ(force.newest(*link.ends, 52 * kMillisecond).force.z(), 2.0);
  link.ends->trouble.lose("test");
  EXPECT_EQ(force.newest(*link.ends, 52 * kMillisecond).force.z(), 0.0);
}

TEST(LinkDevice, a_service_that_falls_silent_is_an_old_sample) {
  TestLink link;
  EXPECT_EQ(link.device.read(0.0).status, DeviceStatus::not_ready);
  link.publish(Vec3::Zero(), Vec3::Zero(), 0.0);
  EXPECT_EQ(link.device.read(1.0).time, 1.0);
  EXPECT_EQ(link.device.read(1.1).time, 1.0);
  EXPECT_EQ(link.device.read(1.1).status, DeviceStatus::ok);
  link.ends->trouble.lose("gone");
  EXPECT_EQ(link.device.read(1.2).status, DeviceStatus::lost);
  EXPECT_STREQ(link.device.trouble(), "gone");
  TestLink tracker(true);
  tracker.publish(Vec3::Zero(), Vec3::Zero(), 0.0);
  tracker.device.read(1.0);
  EXPECT_EQ(tracker.device.read(1.1).time, 1.1);
}

TEST(LinkDevice, what_comes_often_is_not_changed) {
  TestLink link;
  for (int i = 0; i < 50; ++i) {
    const Vec3 place(1e-3 * i, 0.0, 0.0), velocity(0.9, 0.0, 0.1);
    link.publish(place, velocity, 0.9e-3);
    const Motion motion = link.device.read(1e-3 * i).motion;
    EXPECT_EQ(motion.pose.position, place);
    EXPECT_EQ(motion.twist.linear, velocity);
  }
}

/// Reads a handle at 1 kHz that is told every `step` ms; the largest distance from where it is
/// and the largest step of a millisecond beyond the way that it goes.
struct Followed {
  double off = 0.0, leap = 0.0, velocity_off = 0.0;
};
Followed follow(int step, const std::function<Motion(double)>& path) {
  TestLink link;
  Followed result;
  Motion last;
  for (int i = 0; i < 2000; ++i) {
    const double t = 1e-3 * i;
    const Motion now = path(t);
    if (i % step == 0) link.publish(now.pose.position, now.twist.linear, 1e-3 * step);
    const Motion told = link.device.read(t).motion;
    if (i > 500) {
      result.off = std::max(result.off, (told.pose.position - now.pose.position).norm());
      const double way = (told.pose.position - last.pose.position).norm();
      result.leap = std::max(result.leap, way);
      result.velocity_off =
          std::max(result.velocity_off, (told.twist.linear - now.twist.linear).norm());
    }
    last = told;
  }
  return result;
}

TEST(LinkDevice, a_slow_device_is_followed_without_leaps) {
  const auto line = [](double t) {
    Motion m;
    m.pose.position.x() = 0.2 * t;
    m.twist.linear.x() = 0.2;
    return m;
  };
  const auto swing = [](double t) {
    Motion m;
    m.pose.position.x() = 0.03 * std::sin(6.28 * t);
    m.twist.linear.x() = 0.03 * 6.28 * std::cos(6.28 * t);
    return m;
  };
  std::printf("told every     off      leap of a ms   velocity off\n");
  for (const int step : {2, 4, 8, 16}) {
    const Followed straight = follow(step, line), swung = follow(step, swing);
    std::printf("%6d ms   %.2e m  %.2e m      %.2e m/s\n", step, swung.off, swung.leap,
                swung.velocity_off);
    EXPECT_LT(straight.off, 1e-6) << step;             // a straight way is known
    EXPECT_LT(straight.leap, 1.01 * 0.2e-3) << step;   // as it goes, whatever comes between
    EXPECT_LT(swung.off, 0.19 * 1e-3 * step) << step;  // less than it goes between two samples
    EXPECT_LT(swung.leap, 1.6 * 0.19e-3) << step;
  }
}

TEST(LinkDevice, a_slow_device_that_falls_silent_comes_to_rest) {
  TestLink link;
  for (int i = 0; i <= 80; ++i) {
    if (i % 8 == 0) link.publish({0.2e-3 * i, 0.0, 0.0}, {0.2, 0.0, 0.0}, 8e-3);
    link.device.read(1e-3 * i);
  }
  DeviceState state;
  for (int i = 81; i < 300; ++i) state = link.device.read(1e-3 * i);
  EXPECT_LT(state.motion.twist.linear.norm(), 1e-6);
  EXPECT_LT(state.motion.pose.position.x(), 0.2e-3 * 80 + 0.2 * 0.016);
}

TEST(LinkDevice, jumps_are_told_from_fast_motion) {
  const Vec3 o = Vec3::Zero();
  EXPECT_FALSE(is_jump(o, Vec3(0.005, 0.0, 0.0), 0.001));
  EXPECT_TRUE(is_jump(o, Vec3(0.007, 0.0, 0.0), 0.001));
  EXPECT_FALSE(is_jump(o, Vec3(0.02, 0.0, 0.0), 0.016));
  EXPECT_TRUE(is_jump(o, Vec3(std::nan(""), 0.0, 0.0), 0.016));
  const Quat q = rotation_from_vector(Vec3(0.12, 0.0, 0.0));
  EXPECT_FALSE(is_jump(Quat::Identity(), q, 0.001));
  EXPECT_TRUE(is_jump(Quat::Identity(), q, 0.0005));
  EXPECT_FALSE(is_jump(q, Quat(-q.coeffs()), 0.001));
}

TEST(RotatedDevice, takes_place_and_force_of_one_and_rotation_of_the_other) {
  const auto device = open_device("hand:?dof=3&rotation=null:");
  EXPECT_TRUE(device->limits().senses_rotation);
  EXPECT_FALSE(device->limits().actuates_rotation);
  const auto alone = open_device("hand:?dof=3");
  for (int i = 0; i < 100; ++i) {
    device->write({Vec3::UnitZ(), Vec3::Zero()});
    alone->write({Vec3::UnitZ(), Vec3::Zero()});
    EXPECT_EQ(device->read(1e-3 * i).motion.pose.position,
              alone->read(1e-3 * i).motion.pose.position);
  }
  EXPECT_THROW(open_device("hand:?dof=6&rotation=null:"), DeviceAddressError);
  EXPECT_THROW(open_device("hand:?dof=3&rotation=hand:?dof=3"), DeviceAddressError);
}

TEST(RotatedDevice, a_turner_that_is_lost_turns_no_more_and_is_told_of) {
  struct Turner final : HapticDevice {
    DeviceLimits own;
    DeviceState state;
    const DeviceLimits& limits() const override { return own; }
    std::string name() const override { return "turner"; }
    DeviceState read(double now) THIGMA_RT override {
      state.time = now;
      return state;
    }
    void write(const Wrench&) THIGMA_RT override {}
    const char* trouble() const THIGMA_RT override {
      return state.status == DeviceStatus::lost ? "the turner is gone" : "";
    }
  };
  auto turner = std::make_unique<Turner>();
  turner->own.holds_person = false;
  turner->state.motion.pose.orientation = rotation_from_vector(Vec3(0.0, 0.0, 0.3));
  turner->state.motion.twist.angular = Vec3(0.0, 0.0, 1.0);
  DeviceState& told = turner->state;
  const auto device = make_rotated_device(open_device("hand:?dof=3"), std::move(turner));
  EXPECT_NEAR(device->read(0.0).motion.pose.orientation.z(), std::sin(0.15), 1e-12);
  EXPECT_EQ(device->read(0.0).motion.twist.angular.z(), 1.0);
  told.status = DeviceStatus::lost;
  told.motion.pose.orientation = Quat::Identity();
  const DeviceState state = device->read(0.001);
  EXPECT_EQ(state.status, DeviceStatus::ok);
  EXPECT_NEAR(state.motion.pose.orientation.z(), std::sin(0.15), 1e-12);
  EXPECT_EQ(state.motion.twist.angular.z(), 0.0);
  EXPECT_STREQ(device->trouble(), "the turner is gone");
}

/// A handle that goes along x as it is told.
struct Pushed final : HapticDevice {
  DeviceLimits own;
  double x = 0.0, v = 0.0;
  std::uint32_t buttons = kClutchButton;
  Wrench sent;
  const DeviceLimits& limits() const override { return own; }
  std::string name() const override { return "pushed"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    state.motion.pose.position.x() = x;
    state.motion.twist.linear.x() = v;
    state.buttons = buttons;
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override { sent = wrench; }
};

TEST(BubbleDevice, inside_nothing_changes_and_outside_the_place_drifts) {
  auto made = std::make_unique<Pushed>();
  Pushed& hand = *made;
  hand.x = 0.1;
  const auto device = make_bubble_device(std::move(made), 0.04);
  EXPECT_EQ(device->read(0.0).motion.pose.position.x(), 0.1);  // the centre from here on
  hand.x = 0.1399;
  EXPECT_EQ(device->read(0.001).motion.pose.position.x(), 0.1399);
  hand.x = 0.15;  // 10 mm outside: 50 mm/s
  double last = device->read(0.002).motion.pose.position.x();
  for (int i = 3; i < 1003; ++i) {
    const DeviceState state = device->read(1e-3 * i);
    EXPECT_NEAR(state.motion.pose.position.x() - last, 0.05e-3, 1e-12);
    EXPECT_NEAR(state.motion.twist.linear.x(), 0.05, 1e-12);
    last = state.motion.pose.position.x();
  }
  EXPECT_NEAR(last, 0.15 + 0.05 * 1.001, 1e-9);
  hand.x = 0.1;  // back inside: it stays where it drifted to
  EXPECT_NEAR(device->read(1.003).motion.pose.position.x(), last - 0.05, 1e-12);
  EXPECT_EQ(device->read(1.004).motion.twist.linear.x(), 0.0);
  hand.x = 9.0;
  EXPECT_NEAR(device->read(1.005).motion.twist.linear.x(), 0.2, 1e-12);  // at most
  device->write({Vec3::UnitZ(), Vec3::Zero()});
  EXPECT_EQ(hand.sent.force, Vec3(Vec3::UnitZ()));  // the border adds no force
}

TEST(BubbleDevice, an_open_hand_does_not_drift_and_takes_the_bubble_along) {
  auto made = std::make_unique<Pushed>();
  Pushed& hand = *made;
  const auto device = make_bubble_device(std::move(made), 0.02);
  device->read(0.0);
  hand.buttons = 0;
  hand.x = 0.08;
  for (int i = 1; i < 100; ++i) EXPECT_EQ(device->read(1e-3 * i).motion.pose.position.x(), 0.08);
  hand.buttons = kClutchButton;
  for (int i = 100; i < 200; ++i) EXPECT_EQ(device->read(1e-3 * i).motion.pose.position.x(), 0.08);
  hand.x = 0.11;  // 10 mm outside of where it took hold
  device->read(0.2);
  EXPECT_NEAR(device->read(0.201).motion.twist.linear.x(), 0.05, 1e-12);
}

TEST(OpenDevice, bubble_and_rotation_stand_in_any_address) {
  const auto refusal = [](const char* address) {
    try {
      open_device(address);
    } catch (const DeviceAddressError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal("null:?bubble=0.04"), "");
  EXPECT_EQ(refusal("hand:?bubble=0.04&dof=3&seed=2&rotation=null:?clutch=0"), "");
  EXPECT_EQ(refusal("hand:?dof=3&bubble=0.04&seed=2"), "");
  EXPECT_EQ(refusal("null:?bubble=4"), "bubble = '4', expected 0.005 to 0.5 m");
  EXPECT_EQ(refusal("null:?bubble="), "bubble= has no value");
  EXPECT_EQ(refusal("null:?buble=0.1"), "null: no parameter 'buble', nearest is 'clutch'");
  EXPECT_EQ(open_device("hand:?dof=3&bubble=0.04&rotation=null:")->name().find("hand"), 0u);
}

}  // namespace
}  // namespace thigma::detail
