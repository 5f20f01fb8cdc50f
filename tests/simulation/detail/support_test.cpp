#include "thigma/simulation/detail/support.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/simulation/detail/safe_time.h"
#include "thigma/simulation/free_motion.h"

namespace thigma {
namespace {

/// A brick of 10 x 6 x 4 cm held at points of its own.
struct Held {
  SimulationWorld world;
  BodyState state;
  ContactSet set;
  std::vector<std::int32_t> all;
  std::vector<SupportPoint> points;

  Held() {
    const double m = 0.24;
    world.body =
        make_body(m, m / 12.0 * Vec3(0.0052, 0.0116, 0.0136).asDiagonal(), Vec3(0, 0, -9.81));
    world.tolerance = 1e-4;
  }
  void touch(const Vec3& point, const Vec3& normal, double gap) {
    Contact c;
    c.point = point;
    c.normal = normal;
    c.depth = -gap;
    all.push_back(static_cast<std::int32_t>(set.contacts.size()));
    set.contacts.push_back(c);
  }
  Wrench support(double time, double lift) {
    return detail::support_wrench(world, state, {set, all}, {time, lift}, points);
  }
  Vec3 mean_velocity(const Wrench& push, const Vec3& arm, double time) const {
    const Twist v = velocity(world.body, state);
    const Mat3 R = state.orientation.toRotationMatrix();
    const Vec3 turning = R * (world.body.inverse_inertia * (R.transpose() * push.torque));
    return v.linear + 0.5 * time * (world.body.gravity + push.force / world.body.mass) +
           (v.angular + 0.5 * time * turning).cross(arm);
  }
};

TEST(Support, CarriesABrickOnItsCorners) {
  Held held;
  for (const double x : {-0.05, 0.05}) {
    for (const double y : {-0.03, 0.03}) held.touch(Vec3(x, y, -0.02), -Vec3::UnitZ(), 2e-5);
  }
  const double weight = held.world.body.mass * 9.81;
  const Wrench push = held.support(1e-3, 0.2);
  EXPECT_LE((push.force - Vec3(0, 0, weight)).norm(), 1e-6 * weight);
  EXPECT_LE(push.torque.norm(), 1e-8 * weight);
}

// On a slope beyond the angle of friction it slides with what friction leaves.
TEST(Support, LetsABrickSlideDownASlope) {
  for (const double mu : {0.2, 0.9}) {
    Held held;
    held.world.law.friction = mu;
    const double angle = 0.6;
    const Vec3 out(std::sin(angle), 0, std::cos(angle)), down(std::cos(angle), 0, -std::sin(angle));
    held.state.orientation = Quat(Eigen::AngleAxisd(angle, Vec3::UnitY()));
    for (const double x : {-0.05, 0.05}) {
      for (const double y : {-0.03, 0.03})
        held.touch(held.state.orientation * Vec3(x, y, -0.02), -out, 2e-5);
    }
    const Wrench push = held.support(1e-3, 0.2);
    const Vec3 acceleration = held.world.body.gravity + push.force / held.world.body.mass;
    const double slides = std::max(9.81 * (std::sin(angle) - mu * std::cos(angle)), 0.0);
    EXPECT_LE((acceleration - slides * down).norm(), 1e-5 * 9.81) << mu;
  }
}

// A ball of 5 cm that rolls: braked by 5/7 g rolling / R, and no further than to a stop; one that
// spins in place as well.
TEST(Support, BrakesWhatRolls) {
  constexpr double kRadius = 0.05, kMass = 0.2, kTime = 1e-3, kRolling = 1e-3;
  const double inertia = 0.4 * kMass * kRadius * kRadius;
  const auto ball = [&](const Vec3& spin, double rolling) {
    Held held;
    held.world.body = make_body(kMass, inertia * Mat3::Identity(), Vec3(0, 0, -9.81));
    held.world.law = {.restitution = 0.0, .friction = 0.5, .rolling = rolling};
    held.state.linear_momentum = kMass * spin.cross(Vec3(0, 0, kRadius));
    held.state.angular_momentum = inertia * spin;
    held.touch(Vec3(0, 0, -kRadius), -Vec3::UnitZ(), 2e-5);
    return held;
  };
  Held rolls = ball(Vec3(0, 10, 0), kRolling);
  const Wrench push = rolls.support(kTime, 0.0);
  EXPECT_NEAR(push.force.x() / kMass, -5.0 / 7.0 * 9.81 * kRolling / kRadius, 1e-6);
  Held free = ball(Vec3(0, 10, 0), 0.0);
  EXPECT_NEAR(free.support(kTime, 0.0).force.x(), 0.0, 1e-9);
  Held spins = ball(Vec3(0, 0, 10), kRolling);
  EXPECT_NEAR(spins.support(kTime, 0.0).torque.z(), -kRolling * kMass * 9.81, 1e-9);
  // Nearly still: the mean of the flight is at rest, no more.
  Held still = ball(Vec3(0, 1e-5, 0), kRolling);
  const Wrench stop = still.support(kTime, 0.0);
  EXPECT_NEAR(1e-5 + 0.5 * kTime * stop.torque.y() / inertia, 0.0, 1e-8);
}

// Any contacts at all: forces lie in their cones, nothing comes nearer, friction opposes, and work
// is that of lifting at most.
TEST(Support, HoldsWithoutGivingWork) {
  Random random(5);
  int loaded = 0, sliding = 0, settled = 0;
  for (int trial = 0; trial < 200; ++trial) {
    Held held;
    held.world.law.friction = random.uniform(0.0, 1.0);
    held.state.orientation = random.orientation();
    const double time = 1e-3;
    for (int i = 0; i < 3; ++i) {
      const Vec3 normal = (random.direction() - 1.5 * Vec3::UnitZ()).normalized();
      held.touch(random.in_cube(0.05), normal, random.uniform(-1e-5, 2.5e-5));
    }
    const double lift = trial % 2 == 0 ? 0.0 : 0.2;
    const Wrench push = held.support(time, lift);
    double work = 0.0, lifting = 0.0;
    for (const SupportPoint& p : held.points) {
      const double pressing = p.force.dot(p.out);
      const Vec3 mean = held.mean_velocity(push, p.arm, time);
      const double rate = p.out.dot(mean);
      const Vec3 slide = mean - rate * p.out, along = p.force - pressing * p.out;
      ASSERT_GE(pressing, 0.0);
      ASSERT_LE(along.norm(), held.world.law.friction * pressing * (1.0 + 1e-9));
      const double gained = 9.81 * time;  // in free fall; sweeps may end before the last digit
      ASSERT_GE(rate, p.speed - 0.01 * gained) << trial;
      ASSERT_LE(along.dot(slide), 0.01 * pressing * gained) << trial;
      ASSERT_LE(pressing * (rate - p.speed), 0.01 * pressing * gained) << trial;
      settled += std::abs(pressing * (rate - p.speed)) <= 1e-6 * pressing * gained &&
                 rate >= p.speed - 1e-6 * gained;
      loaded += pressing > 0.0;
      sliding += slide.norm() > 0.01 * 9.81 * time;
      work += p.force.dot(mean);
      lifting += pressing * p.speed;
    }
    ASSERT_LE(work, lifting + 0.01 * push.force.norm() * 9.81 * time);
  }
  EXPECT_GT(loaded, 200);
  EXPECT_GT(settled, 540);  // of 600
  EXPECT_GT(sliding, 100);
}

}  // namespace
}  // namespace thigma
