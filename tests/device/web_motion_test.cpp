#include "thigma/device/web_motion.h"

#include <cmath>
#include <vector>

#include "device/tick.h"
#include <gtest/gtest.h>

#include "thigma/math/elementary.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using test::kTick;

WebSample sample(double time, const Vec3& position, std::uint32_t buttons = kClutchButton) {
  return {time, {position, Quat::Identity()}, buttons};
}

/// A page that draws 60 frames a second, its clock `offset` behind the session's, its messages late
/// by up to `jitter`, following `path`.
template <class Path>
double worst_error(WebMotion& motion, double offset, double jitter, double duration, double lag,
                   Path path) {
  Random random(7);
  double worst = 0.0, next_sent = 0.0, arrives = 0.0;
  for (int k = 0; k < static_cast<int>(duration / kTick); ++k) {
    const double now = kTick * k;
    while (arrives <= now) {
      motion.add(sample(next_sent - offset, path(next_sent)), now);
      next_sent += 1.0 / 60.0;
      arrives = next_sent + jitter * random.uniform();
    }
    const DeviceState s = motion.read(now);
    if (now < 1.0) continue;
    const double error = (s.motion.pose.position - path(now - lag)).norm();
    if (error > worst) worst = error;
  }
  return worst;
}

TEST(WebMotion, NothingIsThereBeforeTheFirstSample) {
  WebMotion motion;
  EXPECT_EQ(motion.read(0.0).status, DeviceStatus::not_ready);
  motion.add(sample(5.0, {1.0, 2.0, 3.0}), 0.0);  // of nobody that holds it
  EXPECT_EQ(motion.read(0.001).status, DeviceStatus::not_ready);
  motion.begin();
  EXPECT_EQ(motion.read(0.5).status, DeviceStatus::not_ready);
}

TEST(WebMotion, ConstantVelocityComesOutExactlyButForAKnownDelay) {
  const Vec3 v(0.05, -0.02, 0.01);
  for (const double offset : {-1000.0, 0.0, 12345.0}) {
    WebMotion motion;
    motion.begin();
    // The delay of playing back and twice the time of the smoothing.
    const double lag = WebMotionParams{}.delay + 2.0 / WebMotionParams{}.stiffness;
    const auto line = [&](double t) { return Vec3(t * v); };
    // Samples may wait for the next tick before they are seen.
    EXPECT_LT(worst_error(motion, offset, 0.0, 3.0, lag, line), 1.5e-3 * v.norm()) << offset;
  }
}

TEST(WebMotion, LateMessagesDoNotShake) {
  WebMotion motion;
  motion.begin();
  const auto swing = [](double t) { return Vec3(0.02 * sine(6.0 * t), 0.0, 0.0); };
  const double lag = WebMotionParams{}.delay + 2.0 / WebMotionParams{}.stiffness;
  EXPECT_LT(worst_error(motion, 3.0, 0.012, 5.0, lag, swing), 1e-3);
}

TEST(WebMotion, NoMouseIsFasterThanTheLimits) {
  WebMotion motion;
  motion.begin();
  const WebMotionParams limits;
  Random random(11);
  Pose last;
  bool has_last = false;
  for (int k = 0; k < 3000; ++k) {
    const double now = kTick * k;
    if (k % 9 == 0) {
      WebSample wild = sample(now, random.in_cube(1.0));
      wild.pose.orientation = random.orientation();
      motion.add(wild, now);
    }
    const DeviceState s = motion.read(now);
    ASSERT_TRUE(s.motion.pose.position.allFinite());
    ASSERT_LE(s.motion.twist.linear.norm(), limits.max_speed * (1.0 + 1e-12));
    ASSERT_LE(s.motion.twist.angular.norm(), limits.max_angular_speed * (1.0 + 1e-12));
    if (has_last) {
      const Vec3 turn =
          vector_from_rotation(s.motion.pose.orientation * last.orientation.conjugate());
      ASSERT_LE((s.motion.pose.position - last.position).norm(), limits.max_speed * kTick * 1.0001);
      ASSERT_LE(turn.norm(), limits.max_angular_speed * kTick * 1.0001);
    }
    last = s.motion.pose;
    has_last = true;
  }
}

TEST(WebMotion, SilenceForLongIsALostDeviceAndTheHandleGoesOnFromWhereItWas) {
  const WebMotionParams params;
  WebMotion motion;
  motion.begin();
  double now = 0.0;
  for (; now < 0.3; now += kTick) {
    motion.add(sample(now, {now * 0.1, 0.0, 0.0}), now);
    motion.read(now);
  }
  const double silent_from = now;
  DeviceState s;
  for (; now < silent_from + params.lost_after - 2.0 * kTick; now += kTick) {
    s = motion.read(now);
    ASSERT_EQ(s.status, DeviceStatus::ok) << now;
  }
  for (; now < silent_from + params.lost_after + 0.1; now += kTick) s = motion.read(now);
  EXPECT_EQ(s.status, DeviceStatus::lost);
  const Vec3 left_at = s.motion.pose.position;
  motion.add(sample(now, {5.0, 5.0, 5.0}, 0), now);
  s = motion.read(now);
  EXPECT_EQ(s.status, DeviceStatus::ok);
  EXPECT_EQ(s.motion.pose.position, left_at);
  EXPECT_EQ(s.buttons, 0u);
}

/// A page that moves at `v` and falls behind from `late_from` to `late_to`: silent, or, where it
/// `repeats`, saying its last sample again as a page does whose main thread stands still. What was
/// read at every tick.
std::vector<DeviceState> read_late_page(const Vec3& v, double late_from, double late_to,
                                        bool repeats, double duration) {
  constexpr double kClock = -77.0;  // of the browser
  WebMotion motion;
  motion.begin();
  std::vector<DeviceState> states;
  WebSample last;
  for (int k = 0; k < static_cast<int>(duration / kTick + 0.5); ++k) {
    const double now = kTick * k;
    if (k % 16 == 0) {
      const bool is_late = now > late_from && now < late_to;
      if (!is_late) last = sample(now - kClock, now * v);
      if (!is_late || repeats) motion.add(last, now);
    }
    states.push_back(motion.read(now));
  }
  return states;
}

std::size_t tick_at(double time) { return static_cast<std::size_t>(time / kTick + 0.5); }

TEST(WebMotion, ALatePageIsSlowNotGone) {
  const WebMotionParams params;
  const Vec3 v(0.2, 0.0, 0.0);
  for (const bool repeats : {false, true}) {
    const std::vector<DeviceState> read = read_late_page(v, 1.0, 3.0, repeats, 4.0);
    for (const DeviceState& s : read) {
      ASSERT_EQ(s.status, DeviceStatus::ok) << s.time;
      ASSERT_GE(s.weight, 0.0);
      ASSERT_LE(s.weight, 1.0);
      if (s.time > 0.1) {
        ASSERT_EQ(s.buttons, kClutchButton) << s.time;
      }
    }
    // The pose of 0.992 s was the last: full at first, half in the middle, nothing from the stated
    // age on.
    const double last = 0.992;
    EXPECT_EQ(read[tick_at(last + params.full_age) - 2].weight, 1.0);
    EXPECT_NEAR(read[tick_at(last + 0.5 * (params.full_age + params.stale_age))].weight, 0.5, 0.01);
    EXPECT_EQ(read[tick_at(last + params.stale_age) + 2].weight, 0.0);
    EXPECT_EQ(read[tick_at(2.9)].weight, 0.0);
    // Held where it was last known to be, not where it was guessed.
    EXPECT_NEAR(read[tick_at(2.9)].motion.pose.position.x(), last * v.x(), 1e-6);
    EXPECT_LT(read[tick_at(2.9)].motion.twist.linear.norm(), 1e-6);
    // And back by itself, no faster than stated.
    EXPECT_LT(read[tick_at(3.0 + 0.5 * params.return_time)].weight, 0.55);
    EXPECT_EQ(read[tick_at(3.05 + params.return_time)].weight, 1.0);
    EXPECT_NEAR(read.back().motion.pose.position.x(), v.x() * 3.976, 0.01);
  }
}

TEST(WebMotion, NothingJumpsWhenALatePageComesBack) {
  const WebMotionParams params;
  const std::vector<DeviceState> read = read_late_page({0.3, -0.2, 0.1}, 0.7, 2.2, true, 4.0);
  for (std::size_t k = 1; k < read.size(); ++k) {
    const double way = (read[k].motion.pose.position - read[k - 1].motion.pose.position).norm();
    ASSERT_LE(way, params.max_speed * kTick * 1.0001) << k;
    const double fall = read[k - 1].weight - read[k].weight;
    ASSERT_LE(-fall, kTick / params.return_time * 1.0001) << k;
    ASSERT_LE(fall, kTick / (params.stale_age - params.full_age) * 1.0001) << k;
  }
}

TEST(WebMotion, AHandHeldStillIsNotLate) {
  WebMotion motion;
  motion.begin();
  for (int k = 0; k < 20000; ++k) {
    const double now = kTick * k;
    if (k % 50 == 0) motion.add(sample(now, {0.01, 0.0, 0.0}), now);
    ASSERT_EQ(motion.read(now).weight, 1.0);
  }
}

TEST(WebMotion, ThePoseOfASampleAsLateAsTheNewestStandsForIt) {
  WebMotion motion;
  motion.begin();
  motion.add(sample(1.0, Vec3::Zero()), 0.0);
  motion.read(0.0);
  motion.add(sample(1.0, {0.001, 0.0, 0.0}), 0.001);
  double now = 0.001;
  for (; now < 0.3; now += kTick) motion.read(now);
  EXPECT_NEAR(motion.read(now).motion.pose.position.x(), 0.001, 1e-9);
}

TEST(WebMotion, AnOpenClutchIsSeenHoweverShortItWas) {
  WebMotion motion;
  motion.begin();
  motion.add(sample(1.0, Vec3::Zero(), kClutchButton), 0.0);
  EXPECT_EQ(motion.read(0.0).buttons, kClutchButton);
  motion.add(sample(1.1, Vec3::Zero(), 0), 0.1);
  motion.add(sample(1.1, Vec3::Zero(), kClutchButton), 0.1);
  EXPECT_EQ(motion.read(0.1).buttons, 0u);
  EXPECT_EQ(motion.read(0.101).buttons, kClutchButton);
  motion.begin();  // another page, or the same one anew
  motion.add(sample(1.2, Vec3::Zero(), kClutchButton), 0.2);
  EXPECT_EQ(motion.read(0.2).buttons, 0u);
  EXPECT_EQ(motion.read(0.201).buttons, kClutchButton);
}

TEST(WebMotion, ExtrapolationIsBounded) {
  WebMotion motion;
  motion.begin();
  const double v = 0.5;
  double now = 0.0;
  for (; now < 0.2; now += kTick) {
    motion.add(sample(now, {v * now, 0.0, 0.0}), now);
    motion.read(now);
  }
  const double newest = v * (now - kTick);
  for (int k = 0; k < 150; ++k, now += kTick) {
    const double x = motion.read(now).motion.pose.position.x();
    ASSERT_LE(x, newest + v * WebMotionParams{}.extrapolation + 1e-9);
  }
}

TEST(WebMotion, AnotherPageTakesOverWithoutAJump) {
  WebMotion motion;
  motion.begin();
  double now = 0.0;
  for (; now < 0.2; now += kTick) {
    motion.add(sample(now, {0.1, 0.0, 0.0}), now);
    motion.read(now);
  }
  motion.release();
  DeviceState s = motion.read(now);
  EXPECT_EQ(s.status, DeviceStatus::ok);
  EXPECT_EQ(s.buttons, 0u);
  const Vec3 place = s.motion.pose.position;
  EXPECT_EQ(motion.read(now + 10.0).status, DeviceStatus::ok);  // nobody has to hold it
  motion.begin();
  now += 20.0;
  motion.add(sample(-7.0, {-3.0, 2.0, 1.0}), now);
  s = motion.read(now);
  EXPECT_EQ(s.motion.pose.position, place);
  EXPECT_EQ(s.buttons, kClutchButton);
  motion.lose();
  EXPECT_EQ(motion.read(now + kTick).status, DeviceStatus::lost);
}

TEST(WebMotion, ClockOffsetFollowsABrowserClockThatDrifts) {
  WebMotion motion;
  motion.begin();
  // 1 ms a second slow: without forgetting, the delay would have grown by 20 ms after 20 s.
  double lag = 0.0;
  for (int k = 0; k < 20000; ++k) {
    const double now = kTick * k;
    if (k % 16 == 0) motion.add(sample(0.999 * now, {0.02 * now, 0.0, 0.0}), now);
    lag = now - motion.read(now).motion.pose.position.x() / 0.02;
  }
  EXPECT_LT(lag, WebMotionParams{}.delay + 2.0 / WebMotionParams{}.stiffness + 0.004);
}

}  // namespace
}  // namespace thigma
