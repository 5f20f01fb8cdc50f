#include "thigma/simulation/collision.h"

#include <gtest/gtest.h>

#include "thigma/math/finite_difference.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

struct Case {
  RigidBody body;
  BodyState state;
  Vec3 arm, normal;
  CollisionLaw law;
};

Case random_case(Random& random) {
  Case c;
  const Vec3 moments = Vec3(1.0, 1.2, 1.9) * 1e-3;
  const Mat3 axes = random.orientation().toRotationMatrix();
  c.body = make_body(0.2 + random.uniform(), axes * moments.asDiagonal() * axes.transpose());
  c.state.orientation = random.orientation();
  c.state.linear_momentum = random.in_cube(1.0);
  c.state.angular_momentum = random.in_cube(0.01);
  c.arm = random.in_cube(0.2);
  c.normal = random.direction();
  c.law = {random.uniform(), 2.0 * random.uniform()};
  return c;
}

TEST(Collision, MatrixIsTheChangeOfVelocityByAnImpulse) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const Case c = random_case(random);
    const Mat3 K = collision_matrix(c.body, c.state, c.arm);
    EXPECT_EQ(K, K.transpose());
    const Vec3 impulse = random.in_cube(1.0);
    const Vec3 before = point_velocity(c.body, c.state, c.arm);
    const Vec3 after = point_velocity(c.body, with_impulse(c.state, c.arm, impulse), c.arm);
    EXPECT_LE((after - before - K * impulse).norm(), 1e-12 * K.norm() * impulse.norm());
  }
}

TEST(Collision, StaysInTheConeAndGainsNoEnergy) {
  Random random(2);
  int slides = 0, sticks = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const Case c = random_case(random);
    const Mat3 K = collision_matrix(c.body, c.state, c.arm);
    const Vec3 u = point_velocity(c.body, c.state, c.arm);
    const Vec3 p = collision_impulse(K, u, c.normal, c.law);
    if (c.normal.dot(u) <= 0.0) {
      ASSERT_EQ(p, Vec3::Zero());
      continue;
    }
    const BodyState next = with_impulse(c.state, c.arm, p);
    const Vec3 after = point_velocity(c.body, next, c.arm);
    ASSERT_LE(c.normal.dot(after), 1e-9 * u.norm()) << trial;  // approaches no more
    const double pressing = -c.normal.dot(p);
    ASSERT_GT(pressing, 0.0);
    ASSERT_LE((p + pressing * c.normal).norm(), c.law.friction * pressing * (1.0 + 1e-9)) << trial;
    ASSERT_LE(kinetic_energy(c.body, next), kinetic_energy(c.body, c.state) * (1.0 + 1e-12))
        << trial;
    const double sliding = (after - c.normal.dot(after) * c.normal).norm();
    ++(sliding <= 1e-9 * u.norm() ? sticks : slides);
  }
  EXPECT_GT(slides, 1000);
  EXPECT_GT(sticks, 500);
}

// What the normal impulse gives back is e^2 of what it took: all the energy there is, without
// friction.
TEST(Collision, GivesBackTheEnergyAskedFor) {
  Random random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    Case c = random_case(random);
    c.law.friction = 0.0;
    const Mat3 K = collision_matrix(c.body, c.state, c.arm);
    const Vec3 u = point_velocity(c.body, c.state, c.arm);
    if (c.normal.dot(u) <= 0.0) continue;
    const Vec3 p = collision_impulse(K, u, c.normal, c.law);
    const Vec3 after = u + K * p;
    ASSERT_NEAR(c.normal.dot(after), -c.law.restitution * c.normal.dot(u), 1e-9 * u.norm());
    ASSERT_LE((p + p.dot(-c.normal) * c.normal).norm(), 1e-12 * p.norm());
  }
}

// A point mass: friction is mu times the normal impulse, against the motion.
TEST(Collision, SlidesByCoulombsLaw) {
  const RigidBody body = make_body(2.0, Mat3::Identity());
  BodyState state;
  state.linear_momentum = Vec3(10, 0, -2);  // 5 and -1 m/s
  const Vec3 arm = Vec3::Zero();
  const Vec3 p = collision_impulse(collision_matrix(body, state, arm),
                                   point_velocity(body, state, arm), -Vec3::UnitZ(), {0.5, 0.25});
  EXPECT_NEAR(p.z(), 3.0, 1e-12);
  EXPECT_NEAR(p.x(), -0.75, 1e-12);
  EXPECT_NEAR(p.y(), 0.0, 1e-15);
}

}  // namespace
}  // namespace thigma
