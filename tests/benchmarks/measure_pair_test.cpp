#include "benchmarks/measure_pair.h"

#include <cmath>

#include "support/triangle_search.h"
#include <gtest/gtest.h>

namespace thigma::bench {
namespace {

const BenchPair& small_pair() {
  static const BenchPair pair = make_pair({.name = "small",
                                           .scene = "ellipsoid",
                                           .object_triangles = 2000,
                                           .scene_triangles = 3000,
                                           .path = {.turn = 0.3, .slide = 0.2}});
  return pair;
}

constexpr int kFrames = 400;

const std::vector<Pose>& small_path() {
  static const std::vector<Pose> path = make_path(small_pair(), kFrames);
  return path;
}

TEST(MeasurePair, PathMovesLittleAFrameAndTouchesAndParts) {
  const BenchPair& pair = small_pair();
  const std::vector<Pose>& path = small_path();
  ASSERT_EQ(path.size(), static_cast<std::size_t>(kFrames));
  int touching = 0, apart = 0;
  const test::TriangleTree scene = test::build_triangle_tree(pair.scene_mesh);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (i > 0) {
      const double step = (path[i].position - path[i - 1].position).norm();
      EXPECT_LT(step, 0.02 * pair.radius) << i;
    }
    if (i % 40 != 0) continue;
    const test::TriangleTree object = test::build_triangle_tree(pair.object_mesh, path[i]);
    const double gap = test::least_triangle_distance(object, scene);
    EXPECT_LT(gap, 0.02 * pair.radius);
    (gap == 0.0 ? touching : apart) += 1;
  }
  EXPECT_GT(touching, 1);
  EXPECT_GT(apart, 1);
}

TEST(MeasurePair, TruthIsThatOfAnIndependentSearch) {
  const BenchPair& pair = small_pair();
  const test::TriangleTree scene = test::build_triangle_tree(pair.scene_mesh);
  for (const std::size_t i : {20u, 130u, 250u}) {
    const Truth truth = find_truth(pair, small_path()[i]);
    const test::TriangleTree object = test::build_triangle_tree(pair.object_mesh, small_path()[i]);
    const double least = test::least_triangle_distance(object, scene);
    if (least > pair.tolerance) {
      EXPECT_FALSE(truth.report.least.has_value());
      continue;
    }
    ASSERT_TRUE(truth.report.least.has_value());
    EXPECT_NEAR(std::max(0.0, *truth.report.least), least, 1e-9 * pair.radius);
    EXPECT_GE(truth.regions, 1);
  }
}

TEST(MeasurePair, BaselinesAgreeOnTheSmallestSeparation) {
  const BenchPair& pair = small_pair();
  const std::vector<std::size_t> checked = {10, 60, 210, 260};
  std::vector<Truth> truths;
  for (const std::size_t i : checked) truths.push_back(find_truth(pair, small_path()[i]));
  const LevelTiming exact = measure_levels(pair, small_path(), Resolution{}, 1, checked, truths);
  EXPECT_EQ(exact.method.quality.recall.value(), 1.0);
  EXPECT_LT(exact.method.quality.error_max.value(), 1e-9);
  EXPECT_GT(exact.front, 0.0);
  EXPECT_GT(exact.method.us.p50, 0.0);
  EXPECT_GE(exact.method.us.p99, exact.method.us.p50);
  EXPECT_GE(exact.method.us.max.value(), exact.method.us.p999.value());
  const MethodTiming shell = measure_shell(pair, small_path(), checked, truths);
  // Points of meshes this coarse are a tenth of the radius apart.
  EXPECT_LT(shell.quality.error_max.value(), 0.01);
  EXPECT_EQ(shell.poses, kFrames);
  if (const auto fcl = measure_fcl(pair, small_path(), 0.1, checked, truths)) {
    EXPECT_LT(fcl->quality.error_max.value(), 1e-6);
    EXPECT_FALSE(fcl->quality.depth_error.has_value());
  }
  if (const auto bullet = measure_bullet(pair, small_path(), 0.1, checked, truths)) {
    EXPECT_LT(bullet->quality.error_max.value(), 1e-4);
  }
}

TEST(MeasurePair, QualityCountsWhatIsMissed) {
  const BenchPair& pair = small_pair();
  const double r = pair.radius;
  Truth truth;
  truth.report.points = {Vec3::Zero(), Vec3(0.5 * r, 0.0, 0.0), Vec3(0.51 * r, 0.0, 0.0)};
  truth.report.least = 0.2 * pair.tolerance;
  truth.region = {0, 1, 1};
  truth.regions = 2;
  Report report;
  report.points = {Vec3(0.5 * r, 0.015 * r, 0.0)};
  report.least = 0.7 * pair.tolerance;
  const Quality some = compare(pair, {truth}, {report});
  EXPECT_DOUBLE_EQ(some.recall.value(), 2.0 / 3.0);
  EXPECT_DOUBLE_EQ(some.regions.value(), 0.5);
  EXPECT_NEAR(some.error_max.value(), 0.5 * pair.tolerance / r, 1e-12);
  EXPECT_FALSE(some.depth_error.has_value());
  const Quality none = compare(pair, {truth}, {Report{}});
  EXPECT_EQ(none.recall.value(), 0.0);
  EXPECT_NEAR(none.error_max.value(), 0.8 * pair.tolerance / r, 1e-12);
  truth.report.least = -0.5 * pair.tolerance;
  report.least = -0.1 * pair.tolerance;
  const Quality deep = compare(pair, {truth}, {report});
  EXPECT_EQ(deep.error_max.value(), 0.0);
  EXPECT_NEAR(deep.depth_error.value(), 0.4 * pair.tolerance / r, 1e-12);
}

}  // namespace
}  // namespace thigma::bench
