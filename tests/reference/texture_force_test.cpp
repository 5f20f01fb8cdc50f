#include "reference/texture_force.h"

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

DepthGradient random_gradient(Random& random) {
  return {true, random.in_cube(1.0), random.in_cube(0.1)};
}

TEST(TextureForce, is_minus_the_gradient_of_the_energy_and_never_pulls) {
  Random random(1);
  const DepthGradient g = random_gradient(random);
  const Wrench w = texture_wrench(2e-3, g, 1500.0);
  EXPECT_LE((w.force + 3.0 * g.linear).norm(), 1e-15);
  EXPECT_LE((w.torque + 3.0 * g.angular).norm(), 1e-15);
  for (const double depth : {0.0, -1e-3, kNoDepth, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(texture_wrench(depth, g, 1500.0).force, Vec3::Zero());
    EXPECT_EQ(texture_jacobian(depth, g, 1500.0, Quat::Identity()).norm(), 0.0);
  }
  EXPECT_EQ(texture_wrench(1e-3, {}, 1500.0).force, Vec3::Zero());
}

// With a gradient that does not change, Gauss-Newton is the exact Jacobian: dW/dy by moving the
// depth along it.
TEST(TextureForce, jacobian_is_the_derivative_for_a_constant_gradient) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const DepthGradient g = random_gradient(random);
    const Quat q = random.orientation();
    const double depth = 1e-3, stiffness = 2000.0, step = 1e-7;
    const WrenchJacobian jacobian = texture_jacobian(depth, g, stiffness, q);
    for (int k = 0; k < 13; ++k) {
      double by = 0.0;  // of the depth
      if (k < 3) by = g.linear[k];
      if (k >= 3 && k < 7) {
        Quat there = q;
        there.coeffs()[k - 3] += step;
        by = g.angular.dot(vector_from_rotation(there * q.conjugate())) / step;
      }
      Vec6 want;
      want << -stiffness * by * g.linear, -stiffness * by * g.angular;
      EXPECT_LE((jacobian.col(k) - want).norm(), 1e-5 * stiffness) << k;
    }
    const Mat6 by_motion =
        (Mat6() << jacobian.leftCols<3>(), jacobian.middleCols<4>(3) * rate_matrix(q)).finished();
    EXPECT_LE((by_motion - by_motion.transpose()).norm(), 1e-10 * by_motion.norm());
    const Vec6 move = Vec6::NullaryExpr([&] { return random.uniform(-1.0, 1.0); });
    EXPECT_LE(move.dot(by_motion * move), 0.0);
  }
}

// Work on both bodies in a common rigid motion is none, whatever the points.
TEST(TextureForce, reaction_balances_force_and_moment) {
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    const Vec3 a = random.in_cube(1.0), b = random.in_cube(1.0), v = random.in_cube(1.0),
               w = random.in_cube(1.0);
    const Wrench on_object{random.in_cube(1.0), random.in_cube(1.0)};
    const Wrench on_scene = reaction(on_object, a, b);
    const auto power = [&](const Wrench& wrench, const Vec3& about) {
      return wrench.force.dot(v + w.cross(about)) + wrench.torque.dot(w);
    };
    EXPECT_NEAR(power(on_object, a) + power(on_scene, b), 0.0, 1e-14);
  }
}

// The reaction against moving the scene itself: differences of the exact energy by motions of the
// scene.
TEST(TextureForce, on_the_scene_is_the_derivative_by_its_motion) {
  test::Hills hills;
  hills.contact.object.world_from_body.position.z() = 1e-3;
  const auto backend = make_branch_depth({});
  const auto sample_of = [&](const DepthContact& contact) {
    DepthSamples sample;
    backend->sample({&contact, 1}, {}, {&sample, 1});
    return sample;
  };
  GradientScratch scratch;
  const double stiffness = 1000.0;
  const Vec3 centre(0.01, 0.02, 0.03);
  const DepthContact& contact = hills.contact;
  const DepthSamples sample = sample_of(contact);
  const DepthGradient gradient = depth_gradient(contact, sample, GradientKind::envelope, scratch);
  const Wrench got =
      reaction(texture_wrench(sample.depth[0], gradient, stiffness), contact.centre, centre);
  Vec6 want;
  for (int k = 0; k < 6; ++k) {
    const double step = k < 3 ? 4e-4 : 4e-4 / 0.04;
    double energy[2];
    for (int side = 0; side < 2; ++side) {
      const Vec6 by = (side ? -step : step) * Vec6::Unit(k);
      Pose motion;
      motion.orientation = rotation_from_vector(by.tail<3>());
      motion.position = by.head<3>() + centre - motion.orientation._transformVector(centre);
      DepthContact there = contact;
      there.scene.world_from_body = motion * contact.scene.world_from_body;
      const double depth = sample_of(there).depth[0];
      energy[side] = 0.5 * stiffness * depth * depth;
    }
    want[k] = -(energy[0] - energy[1]) / (2.0 * step);
  }
  const double tangential = want.head<2>().norm();
  EXPECT_GT(tangential, 5e-3);
  EXPECT_LE((got.force - want.head<3>()).norm(), 0.1 * tangential);
  EXPECT_LE((got.torque - want.tail<3>()).norm(), 0.1 * tangential * 0.04);
}

}  // namespace
}  // namespace thigma
