// Areas of one surface inside another against closed forms.
#include "thigma/response/overlap_area.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTolerance = 2e-4, kDepth = 7e-4, kAll = kTolerance + kDepth;

SolidSurface solid(const TriangleMesh& mesh) {
  return make_solid_surface(build_exact_hierarchy(mesh));
}

SolidSurface plate(std::array<int, 3> segments = {1, 1, 1}) {
  return solid(
      transformed(make_box({0.1, 0.1, 0.02}, segments), {{0.0, 0.0, -0.01}, Quat::Identity()}));
}

/// Integral of w^p over `from` inside `into`, the object standing at a pose.
struct Area {
  double sum = 0.0;
  Vec3 force = Vec3::Zero();  // integral of w^(p-1) times the push
  OverlapStats stats;
};
Area area_of(const SolidSurface& object, const SolidSurface& scene, const Pose& pose, int exponent,
             bool is_object) {
  OverlapTask task{is_object ? object : scene, is_object ? scene : object,
                   is_object ? pose : Pose{}, is_object ? Pose{} : pose};
  task.centre = pose.position;
  task.is_object = is_object;
  task.tolerance = kTolerance;
  task.exponent = exponent;
  task.size = 0.017;
  PotentialMoments moments;
  OverlapScratch scratch;
  reserve_overlap(task.from, scratch);
  Area area;
  area.stats = add_overlap(task, scratch, moments);
  area.sum = moments.sum(0, 0);
  area.force = moments.sum.col(0).segment<3>(1);
  return area;
}

double integral(double from, double to, const std::function<double(double)>& f) {
  constexpr int kSteps = 20000;  // even
  const double h = (to - from) / kSteps;
  double sum = f(from) + f(to);
  for (int i = 1; i < kSteps; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * f(from + i * h);
  return sum * h / 3.0;
}

TEST(OverlapArea, OfACubeOnAPlate) {
  constexpr double kSide = 0.02;
  const Pose pose{{0.003, -0.002, 0.5 * kSide - kDepth}, rotation_from_vector({0.0, 0.0, 0.3})};
  for (const int n : {1, 5}) {
    const SolidSurface cube = solid(make_box(Vec3::Constant(kSide), {n, n, n}));
    for (const int p : {2, 4}) {
      // Its lower face, and the sides as far as they are within reach.
      const double lower = kSide * kSide * std::pow(kAll, p);
      const double sides = 4.0 * kSide * std::pow(kAll, p + 1) / (p + 1);
      const Area own = area_of(cube, plate(), pose, p, true);
      EXPECT_NEAR(own.sum, lower + sides, 2e-3 * (lower + sides)) << n << ", p " << p;
      EXPECT_NEAR(own.force.z(), -(lower / kAll + sides * (p + 1) / (p * kAll)),
                  -2e-3 * own.force.z());
      // The plate's points below it are as deep as the nearest of its faces.
      const auto at_least = [&](double w) {
        const double out = kTolerance - w, side = kSide + 2.0 * std::min(out, 0.0);
        const double round = std::max(out, 0.0);
        return p * std::pow(w, p - 1) * (side * side + 4.0 * side * round + kPi * round * round);
      };
      const double other =
          integral(0.0, kTolerance, at_least) + integral(kTolerance, kAll, at_least);
      EXPECT_NEAR(area_of(cube, plate(), pose, p, false).sum, other, 5e-3 * other)
          << n << ", p " << p;
    }
  }
}

TEST(OverlapArea, OfABallOnAPlate) {
  constexpr double kRadius = 0.01;
  const SolidSurface ball = solid(make_ball(kRadius, 60));
  const Pose pose{{0.003, -0.002, kRadius - kDepth}, rotation_from_vector({0.2, 0.1, 0.3})};
  for (const int p : {2, 4}) {
    // Of a sphere as much lies between two planes as of the cylinder about it.
    const double own = 2.0 * kPi * kRadius * std::pow(kAll, p + 1) / (p + 1);
    const Area found = area_of(ball, plate(), pose, p, true);
    EXPECT_NEAR(found.sum, own, 0.01 * own) << "p " << p;
    EXPECT_NEAR(found.force.z(), -own * (p + 1) / (p * kAll), -0.01 * found.force.z());
    const double other = 2.0 * kPi *
                         ((kRadius + kTolerance) * std::pow(kAll, p + 1) / (p + 1) -
                          std::pow(kAll, p + 2) / (p + 2));
    EXPECT_NEAR(area_of(ball, plate(), pose, p, false).sum, other, 0.015 * other) << "p " << p;
  }
}

TEST(OverlapArea, DoesNotDependOnHowSurfacesAreDivided) {
  const Pose pose{{0.003, -0.002, 0.0093}, rotation_from_vector({0.01, 0.017, 0.3})};
  double least[2] = {1e300, 1e300}, most[2] = {0.0, 0.0};
  for (const int n : {1, 3, 16}) {
    const SolidSurface cube = solid(make_box(Vec3::Constant(0.02), {n, n, n}));
    for (const int m : {1, 7, 30}) {
      for (const bool is_object : {true, false}) {
        const double sum = area_of(cube, plate({m, m, 1}), pose, 4, is_object).sum;
        least[is_object] = std::min(least[is_object], sum);
        most[is_object] = std::max(most[is_object], sum);
      }
    }
  }
  for (const int i : {0, 1}) EXPECT_LT(most[i] - least[i], 5e-3 * most[i]) << i;
}

TEST(OverlapArea, OfWhatIsApartIsNothingAndAsksLittle) {
  const SolidSurface ball = solid(make_ball(0.01, 20));
  const Area area = area_of(ball, plate(), {{0.0, 0.0, 0.012}, Quat::Identity()}, 2, true);
  EXPECT_EQ(area.sum, 0.0);
  EXPECT_EQ(area.stats.cells, 0);
  EXPECT_LT(area.stats.points, 200);
}

}  // namespace
}  // namespace thigma
