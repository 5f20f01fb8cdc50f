#include "benchmarks/baselines/distance_field.h"

#include <cmath>

#include "benchmarks/baselines/nearest_point.h"
#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma::bench {
namespace {

// Signed distance of a box about the origin.
double box_distance(const Vec3& half, const Vec3& p) {
  const Vec3 q = p.cwiseAbs() - half;
  return q.cwiseMax(Vec3::Zero()).norm() + std::min(q.maxCoeff(), 0.0);
}

FieldCell cell_at(const DistanceField& field, const Vec3& p) {
  return find_cell(field, static_cast<float>(p.x()), static_cast<float>(p.y()),
                   static_cast<float>(p.z()));
}

// The surface of a unit of length L, from a nanometre part to a kilometre one.
class FieldOfLength : public ::testing::TestWithParam<double> {};

TEST_P(FieldOfLength, IsTheDistanceOfABoxToAFractionOfACell) {
  const double length = GetParam();
  const Vec3 half = length * Vec3(0.5, 0.3, 0.2);
  const DistanceField field = build_distance_field(make_box(2.0 * half, {10, 6, 4}), {.cells = 40});
  Random random(3);
  int sampled = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p = random.in_cube(0.8 * length);
    const double truth = box_distance(half, p);
    const FieldCell cell = cell_at(field, p);
    if (cell.corner == nullptr) {
      EXPECT_LE(cell.bound, truth + 1e-5 * length) << p.transpose();
      EXPECT_GT(std::fabs(truth), 0.99 * field.band);
      continue;
    }
    if (std::fabs(truth) > field.band) {  // samples that far say "at least"
      EXPECT_LE(std::fabs(cell_distance(cell)), std::fabs(truth) + 0.45 * field.cell);
      continue;
    }
    ++sampled;
    // Trilinear: off where the nearest face changes within a cell.
    EXPECT_NEAR(cell_distance(cell), truth, 0.45 * field.cell) << p.transpose();
  }
  EXPECT_GT(sampled, 500);
}

INSTANTIATE_TEST_SUITE_P(Sizes, FieldOfLength, ::testing::Values(1e-9, 1.0, 1e3));

TEST(DistanceField, IsTheDistanceAtItsSamples) {
  const TriangleMesh ball = make_ball(1.0, 8);
  const DistanceField field = build_distance_field(ball, {.cells = 30});
  int checked = 0;
  for (std::size_t b = 0; b < field.table.size(); b += 3) {
    if (field.table[b].first < 0) continue;
    const int i = 4 * static_cast<int>(b % field.bricks[0]),
              j = 4 * static_cast<int>(b / field.bricks[0] % field.bricks[1]),
              k = 4 * static_cast<int>(b / field.bricks[0] / field.bricks[1]);
    const Vec3 p = Vec3(field.origin[0], field.origin[1], field.origin[2]) +
                   static_cast<double>(field.cell) * Vec3(i, j, k);
    double least = 1e300;
    for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
      least = std::min(least, nearest_point(ball, static_cast<std::int32_t>(t), p).distance2);
    }
    least = std::sqrt(least);
    const float sample =
        field.samples[static_cast<std::size_t>(field.table[b].first) * DistanceField::kSamples];
    if (least > field.band + 2.0f * field.cell) {
      EXPECT_LE(std::fabs(sample), least);
    } else {
      EXPECT_NEAR(std::fabs(sample), least, 0.05 * field.cell);  // sweeps miss thin Voronoi cells
      EXPECT_EQ(sample < 0.0f, p.norm() < 0.99) << p.norm();
      ++checked;
    }
  }
  EXPECT_GT(checked, 50);
}

TEST(DistanceField, GradientIsThatOfTheInterpolation) {
  const DistanceField field = build_distance_field(make_ball(1.0, 12), {.cells = 40});
  Random random(5);
  const double step = 0.01 * field.cell;
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = random.uniform(0.93, 1.07) * random.direction();
    const FieldCell cell = cell_at(field, p);
    ASSERT_NE(cell.corner, nullptr);
    const std::array<float, 3> rise = cell_rise(cell);
    const Vec3 gradient = Vec3(rise[0], rise[1], rise[2]) / field.cell;
    EXPECT_GT(gradient.dot(p.normalized()), 0.93) << p.transpose();
    for (int a = 0; a < 3; ++a) {
      const FieldCell next = cell_at(field, p + step * Vec3::Unit(a));
      if (next.corner != cell.corner) continue;
      EXPECT_NEAR((cell_distance(next) - cell_distance(cell)) / step, gradient[a], 0.02);
    }
  }
}

TEST(DistanceField, BoundsTheDistanceFarOutside) {
  const DistanceField field = build_distance_field(make_ball(1.0, 8), {.cells = 30});
  for (const double r : {1.5, 2.0, 10.0}) {
    const float bound = least_distance_at(field, static_cast<float>(r), 0.0f, 0.0f);
    EXPECT_LE(bound, r - 0.98);
    EXPECT_GT(bound, 0.3 * (r - 1.0));
  }
}

}  // namespace
}  // namespace thigma::bench
