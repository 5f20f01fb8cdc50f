#include "thigma/simulation/free_motion.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

RigidBody brick(double scale = 1.0, const Vec3& gravity = Vec3(0, 0, -9.81)) {
  return make_body(0.3 * scale * scale * scale,
                   scale * scale * scale * scale * scale * Vec3(1, 2, 3.5).asDiagonal() * 1e-4,
                   gravity);
}

TEST(FreeMotion, FallsAlongAParabola) {
  const RigidBody body = brick();
  BodyState start;
  start.position = Vec3(1, 2, 3);
  start.linear_momentum = body.mass * Vec3(0.5, 0, 2);
  const BodyState end = free_motion(body, start, 0.7);
  EXPECT_NEAR(end.position.z(), 3 + 2 * 0.7 - 0.5 * 9.81 * 0.49, 1e-14);
  EXPECT_NEAR(end.position.x(), 1.35, 1e-15);
  EXPECT_NEAR(end.linear_momentum.z() / body.mass, 2 - 9.81 * 0.7, 1e-14);
  EXPECT_NEAR(mechanical_energy(body, end), mechanical_energy(body, start), 1e-13);
}

// A top of equal moments about two axes precesses about its angular momentum with |L| / I.
TEST(FreeMotion, PrecessesAsASymmetricTop) {
  const RigidBody body = make_body(1.0, Vec3(2, 2, 3).asDiagonal() * 1e-3);
  BodyState start;
  start.angular_momentum = Vec3(3e-3, 0, 6e-3);
  const double precession = start.angular_momentum.norm() / 2e-3;
  const double period = 2.0 * std::numbers::pi / precession;
  const Vec3 axis = start.angular_momentum.normalized();
  for (const double turns : {0.3, 1.0, 20.0}) {
    const BodyState end = free_motion(body, start, turns * period);
    const Vec3 symmetry = end.orientation * Vec3::UnitZ();
    const Vec3 expected =
        rotation_from_vector(2.0 * std::numbers::pi * turns * axis) * Vec3::UnitZ();
    EXPECT_LE((symmetry - expected).norm(), 1e-6 * std::max(turns, 1.0)) << turns;
  }
}

TEST(FreeMotion, KeepsEnergyAndAngularMomentum) {
  Random random(3);
  for (const double scale : {1e-6, 1.0, 1e3}) {
    const RigidBody body = brick(scale, Vec3::Zero());
    for (int trial = 0; trial < 20; ++trial) {
      BodyState state;
      state.orientation = random.orientation();
      state.angular_momentum = body.inertia(1, 1) * 30.0 * random.direction();
      const double start = kinetic_energy(body, state);
      for (int i = 0; i < 50; ++i) state = free_motion(body, state, 0.037);
      EXPECT_NEAR(kinetic_energy(body, state), start, 1e-9 * start);
      EXPECT_NEAR(state.orientation.norm(), 1.0, 1e-12);
    }
  }
}

// Momenta are those of the wrench; half the step is right to a quarter of the error.
TEST(FreeMotion, FollowsAConstantPush) {
  const RigidBody body = brick();
  BodyState start;
  start.linear_momentum = Vec3(0.1, -0.2, 0.3);
  start.angular_momentum = Vec3(2e-3, 3e-3, 1e-3);
  const Wrench push{Vec3(1, 2, 3), Vec3(4e-3, -5e-3, 2e-3)};
  const double time = 0.02;
  BodyState exact = start;
  for (int i = 0; i < 2000; ++i) exact = pushed_motion(body, exact, push, time / 2000);
  const BodyState whole = pushed_motion(body, start, push, time);
  const BodyState halves =
      pushed_motion(body, pushed_motion(body, start, push, 0.5 * time), push, 0.5 * time);
  EXPECT_LE((whole.position - exact.position).norm(), 1e-12);
  EXPECT_LE((whole.linear_momentum - start.linear_momentum -
             time * (push.force + body.mass * body.gravity))
                .norm(),
            1e-15);
  EXPECT_LE((whole.angular_momentum - start.angular_momentum - time * push.torque).norm(), 1e-17);
  const double error = whole.orientation.angularDistance(exact.orientation);
  EXPECT_LE(halves.orientation.angularDistance(exact.orientation), 0.4 * error);
  EXPECT_GT(error, 1e-9);
  EXPECT_EQ(to_vector(pushed_motion(body, start, {}, time)),
            to_vector(free_motion(body, start, time)));
}

// Two halves are one whole, to the order of the scheme.
TEST(FreeMotion, DoesNotDependOnHowTimeIsCut) {
  const RigidBody body = brick();
  BodyState start;
  start.angular_momentum = Vec3(2e-3, 3e-3, 1e-3);
  const BodyState whole = free_motion(body, start, 0.2);
  BodyState parts = start;
  for (int i = 0; i < 20; ++i) parts = free_motion(body, parts, 0.01);
  EXPECT_LE((whole.orientation.toRotationMatrix() - parts.orientation.toRotationMatrix()).norm(),
            1e-5);
}

}  // namespace
}  // namespace thigma
