// Rows whose friction their own normal impulse bounds: the nearest point of Coulomb's cone.

#include <gtest/gtest.h>

#include "thigma/math/finite_difference.h"
#include "thigma/math/random.h"
#include "thigma/multibody/detail/island_newton.h"

namespace thigma::detail {
namespace {

/// Where z lies: inside the cone, inside the cone that has nothing but the tip nearest, or between.
enum class Place { inside, tip, side };

Place place_of(const Vec3& z, double friction) {
  const double across = z.tail<2>().norm();
  if (across < friction * z.x()) return Place::inside;
  return z.x() + friction * across < 0.0 ? Place::tip : Place::side;
}

/// How far from the boundaries between them, of |z|.
double room_of(const Vec3& z, double friction) {
  const double across = z.tail<2>().norm(), scale = std::hypot(1.0, friction) * z.norm();
  return std::min(std::fabs(across - friction * z.x()), std::fabs(z.x() + friction * across)) /
         scale;
}

/// A cone and what it is asked about, of any size.
struct Drawn {
  double friction;
  Vec3 z;
};

Drawn draw(Random& random, int i) {
  const double friction = random.uniform(0.05, 2.0), scale = std::pow(10.0, i % 13 - 6);
  return {friction, random.in_cube(scale)};
}

TEST(FrictionCone, TheForceIsTheNearestInTheCone) {
  Random random(11);
  int seen[3] = {};
  for (int i = 0; i < 3000; ++i) {
    const auto [friction, z] = draw(random, i);
    ++seen[static_cast<int>(place_of(z, friction))];
    const Vec3 f = cone_force_of(z, friction), left = z - f;
    const double rounding = 1e-14 * z.norm();
    // A closed convex cone: f is in it, what is left over is in its polar cone, and they are at a
    // right angle (Moreau).
    EXPECT_LE(f.tail<2>().norm(), friction * f.x() + rounding);
    EXPECT_LE(left.x() + friction * left.tail<2>().norm(), rounding);
    EXPECT_LE(std::fabs(f.dot(left)), rounding * z.norm());
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

TEST(FrictionCone, ItsSlopeIsThatOfDifferences) {
  Random random(12);
  int seen[3] = {};
  for (int i = 0; i < 3000; ++i) {
    const auto [friction, z] = draw(random, i);
    constexpr double kStep = 1e-4;  // of |z|
    if (room_of(z, friction) < 4.0 * kStep || z.tail<2>().norm() < 0.05 * z.norm()) continue;
    ++seen[static_cast<int>(place_of(z, friction))];
    const Vec3 steps = Vec3::Constant(kStep * z.norm());
    const auto force = [mu = friction](const Vec3& at) { return cone_force_of(at, mu); };
    const Mat3 expected = finite_difference_jacobian<3, 3>(force, z, steps);
    const Mat3 slope = cone_slope_of(z, friction);
    EXPECT_LE((slope - expected).cwiseAbs().maxCoeff(), 1e-9) << z.transpose() << " " << friction;
    EXPECT_LE((slope - slope.transpose()).cwiseAbs().maxCoeff(), 1e-14);
  }
  for (const int count : seen) EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace thigma::detail
