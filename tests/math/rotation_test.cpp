#include "thigma/math/rotation.h"

#include <gtest/gtest.h>

#include "thigma/math/elementary.h"
#include "thigma/math/finite_difference.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

Quat quat(const Vec4& v) { return Quat(v[3], v[0], v[1], v[2]); }

Vec4 any_quaternion(Random& random) {
  Vec4 q;
  q << random.in_cube(1.0), random.uniform(-1.0, 1.0);
  return q;
}

TEST(Rotation, matrix_rotates_as_the_sandwich_product_and_scales_with_the_square) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Quat q = random.orientation();
    const Vec3 v = random.in_cube(2.0);
    EXPECT_LE((rotation_matrix(q) * v - q._transformVector(v)).norm(), 1e-14);
    const Quat twice = quat(2.0 * q.coeffs());
    EXPECT_LE((rotation_matrix(twice) - 4.0 * rotation_matrix(q)).norm(), 1e-14);
    EXPECT_LE((rotation_matrix(q) * rotation_matrix(q).transpose() - Mat3::Identity()).norm(),
              1e-14);
  }
}

TEST(Rotation, skew_is_the_cross_product) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3 a = random.in_cube(1.0), b = random.in_cube(1.0);
    EXPECT_EQ(skew(a) * b, a.cross(b));
  }
}

TEST(Rotation, derivatives_of_the_matrix_agree_with_differences) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Vec4 q = any_quaternion(random);
    const Vec3 v = random.in_cube(1.0);
    const Vec4 steps = Vec4::Constant(1e-2);
    const Mat34 forward = finite_difference_jacobian<3, 4>(
        [&](const Vec4& p) -> Vec3 { return rotation_matrix(quat(p)) * v; }, q, steps);
    const Mat34 backward = finite_difference_jacobian<3, 4>(
        [&](const Vec4& p) -> Vec3 { return rotation_matrix(quat(p)).transpose() * v; }, q, steps);
    EXPECT_LE((rotated_derivative(quat(q), v) - forward).norm(), 1e-12);
    EXPECT_LE((inverse_rotated_derivative(quat(q), v) - backward).norm(), 1e-12);
    const std::array<Mat3, 4> d = rotation_matrix_derivatives(quat(q));
    for (int k = 0; k < 4; ++k) EXPECT_LE((d[k] * v - forward.col(k)).norm(), 1e-12);
  }
}

TEST(Rotation, rate_matrix_is_the_derivative_of_turning) {
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Quat q = random.orientation();
    const Mat43 numeric = finite_difference_jacobian<4, 3>(
        [&](const Vec3& phi) -> Vec4 { return (rotation_from_vector(phi) * q).coeffs(); },
        Vec3(Vec3::Zero()), Vec3(Vec3::Constant(1e-2)));
    EXPECT_LE((rate_matrix(q) - numeric).norm(), 1e-9);
    const Vec3 w = random.in_cube(3.0);
    EXPECT_LE((rate_matrix(q) * w - rate_derivative(w) * q.coeffs()).norm(), 1e-14);
    EXPECT_LE((4.0 * rate_matrix(q).transpose() * rate_matrix(q) - Mat3::Identity()).norm(), 1e-14);
    const Quat b = random.orientation();
    EXPECT_LE((left_product_matrix(q) * b.coeffs() - (q * b).coeffs()).norm(), 1e-15);
  }
}

TEST(Rotation, vector_and_quaternion_are_inverse_at_every_size) {
  Random random(5);
  for (double angle = 3.14; angle > 1e-300; angle *= 0.41) {
    const Vec3 u = angle * random.direction();
    const Quat q = rotation_from_vector(u);
    EXPECT_NEAR(q.norm(), 1.0, 1e-15);
    EXPECT_LE((vector_from_rotation(q) - u).norm(), 2e-15 * angle) << angle;
    EXPECT_EQ(vector_from_rotation(quat(-q.coeffs())), vector_from_rotation(q)) << angle;
  }
  EXPECT_EQ(vector_from_rotation(Quat::Identity()), Vec3::Zero());
  EXPECT_EQ(vector_from_rotation(Quat(-1.0, 0.0, 0.0, 0.0)), Vec3::Zero());
  EXPECT_EQ(rotation_from_vector(Vec3::Zero()).coeffs(), Quat::Identity().coeffs());
}

TEST(Rotation, vector_does_not_depend_on_the_length_of_the_quaternion) {
  Random random(6);
  for (int i = 0; i < 200; ++i) {
    const Quat q = random.orientation();
    const Vec3 u = vector_from_rotation(q);
    EXPECT_LE((vector_from_rotation(quat(37.0 * q.coeffs())) - u).norm(), 1e-14);
    EXPECT_LE(u.norm(), kPi * (1.0 + 1e-15));
  }
}

TEST(Rotation, derivative_of_the_vector_agrees_with_differences_on_both_covers) {
  Random random(7);
  const double angles[] = {0.0, 1e-12, 1e-8, 1.9e-4, 2.1e-4, 1e-2, 1.0, 3.0};
  for (const double angle : angles) {
    for (const double cover : {1.0, -1.0}) {
      const Vec4 q = cover * rotation_from_vector(angle * random.direction()).coeffs();
      Mat34 analytic;
      vector_from_rotation(quat(q), &analytic);
      const Mat34 numeric = finite_difference_jacobian<3, 4>(
          [](const Vec4& p) -> Vec3 { return vector_from_rotation(quat(p)); }, q,
          Vec4(Vec4::Constant(1e-3)));
      EXPECT_LE((analytic - numeric).norm(), 1e-8) << angle << ' ' << cover << '\n'
                                                   << analytic << '\n'
                                                   << numeric;
    }
  }
  Mat34 at_identity;
  vector_from_rotation(Quat::Identity(), &at_identity);
  EXPECT_EQ((at_identity.leftCols<3>()), 2.0 * Mat3::Identity());
  EXPECT_EQ(at_identity.col(3), Vec3::Zero());
}

TEST(Rotation, half_turn_is_finite_and_of_length_pi) {
  Mat34 derivative;
  const Vec3 u = vector_from_rotation(Quat(0.0, 0.6, 0.0, 0.8), &derivative);
  EXPECT_NEAR(u.norm(), kPi, 1e-15);
  EXPECT_TRUE(derivative.allFinite());
}

}  // namespace
}  // namespace thigma
