#include "benchmarks/baselines/point_shell.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma::bench {
namespace {

using Found = std::set<std::pair<bool, std::int32_t>>;

Found found(const std::vector<ShellContact>& contacts) {
  Found out;
  for (const ShellContact& c : contacts) out.insert({c.is_of_object, c.index});
  return out;
}

double deepest(const std::vector<ShellContact>& contacts) {
  double depth = -1e300;
  for (const ShellContact& c : contacts) depth = std::max(depth, c.depth);
  return depth;
}

Pose pose_at(const Vec3& position, const Quat& orientation = Quat::Identity()) {
  Pose pose;
  pose.position = position;
  pose.orientation = orientation;
  return pose;
}

TEST(PointShell, BallsAreApartByTheDistanceOfTheirCentres) {
  const TriangleMesh mesh = make_ball(1.0, 24);
  const PointShell shell = build_point_shell(mesh, {.field = {.cells = 80}});
  std::vector<ShellContact> contacts;
  Random random(1);
  for (const double gap : {-0.02, -0.005, 0.004, 0.015}) {
    const Vec3 towards = random.direction();
    const Pose object = pose_at((2.0 + gap) * towards, random.orientation());
    const Pose scene = pose_at(Vec3::Zero(), random.orientation());
    query_shells(shell, object, shell, scene, 0.03, contacts);
    ASSERT_FALSE(contacts.empty()) << gap;
    // Balls of triangles lie inside round ones, and the deepest vertex off the line of centres.
    EXPECT_NEAR(-deepest(contacts), gap, 0.25 * shell.field.cell);
    for (const ShellContact& c : contacts) {
      EXPECT_GT(c.normal.dot(-towards), 0.95);
      const double own = c.is_of_object ? (c.point - object.position).norm() : c.point.norm();
      EXPECT_NEAR(own, 1.0, 1e-5);
    }
  }
}

TEST(PointShell, FindsExactlyThePointsThatBruteForceFinds) {
  const TriangleMesh ball = make_ball(1.0, 17), box = make_box(Vec3(2.0, 1.4, 1.1), {9, 8, 7});
  const PointShell a = build_point_shell(ball, {.field = {.cells = 60}});
  const PointShell b = build_point_shell(box, {.field = {.cells = 60}});
  Random random(7);
  std::vector<ShellContact> contacts;
  std::size_t total = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose pose = pose_at(random.uniform(1.2, 1.9) * random.direction(), random.orientation());
    query_shells(a, pose, b, Pose{}, 0.05, contacts);
    Found expected;
    auto test = [&](const TriangleMesh& mesh, const PointShell& other, const Pose& to_other,
                    bool is_of_object) {
      for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3 p = transform_point(to_other, mesh.positions[v]);
        const FieldCell cell = find_cell(other.field, static_cast<float>(p.x()),
                                         static_cast<float>(p.y()), static_cast<float>(p.z()));
        const double distance =
            cell.corner != nullptr ? cell_distance(cell) : cell.bound + other.field.brick_radius;
        if (std::fabs(distance - 0.05) < 1e-5)
          expected.insert({is_of_object, -1});  // either answer is right
        if (distance < 0.05 - 1e-5) expected.insert({is_of_object, static_cast<std::int32_t>(v)});
      }
    };
    test(ball, b, pose, true);
    test(box, a, inverse(pose), false);
    const std::size_t unsure = expected.erase({true, -1}) + expected.erase({false, -1});
    const Found ours = found(contacts);
    EXPECT_TRUE(std::includes(ours.begin(), ours.end(), expected.begin(), expected.end()));
    EXPECT_LE(ours.size(), expected.size() + (unsure == 0 ? 0u : 4u));
    EXPECT_EQ(ours.size(), contacts.size());
    total += contacts.size();
  }
  EXPECT_GT(total, 1000u);
}

TEST(PointShell, SpacingPutsPointsOnLargeTriangles) {
  const TriangleMesh box = make_box(Vec3(1.0, 1.0, 1.0));
  const PointShell coarse = build_point_shell(box, {.field = {.cells = 24}});
  const PointShell fine = build_point_shell(box, {.field = {.cells = 24}, .spacing = 0.1});
  EXPECT_EQ(coarse.normals.size(), 8u);
  std::vector<ShellContact> contacts;
  // Edges across each other, corners far away: vertices alone see nothing.
  const Pose pose =
      pose_at(Vec3(0.0, 0.0, 1.002), Quat(Eigen::AngleAxisd(0.785398, Vec3::UnitZ())));
  const Pose shifted = pose_at(pose.position + Vec3(0.8, 0.0, 0.0), pose.orientation);
  query_shells(fine, shifted, fine, Pose{}, 0.01, contacts);
  EXPECT_GT(contacts.size(), 20u);
  EXPECT_NEAR(-deepest(contacts), 0.002, 0.3 * fine.field.cell);
  // Every lattice point once.
  std::set<std::array<long, 3>> places;
  for (const ShellLeaf& leaf : fine.leaves) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(leaf.count); ++i) {
      places.insert({std::lround(1e5 * leaf.x[i]), std::lround(1e5 * leaf.y[i]),
                     std::lround(1e5 * leaf.z[i])});
    }
  }
  EXPECT_EQ(places.size(), fine.normals.size());
}

TEST(PointShell, SpheresHoldTheirPoints) {
  const PointShell shell =
      build_point_shell(make_torus(1.0, 0.3, 40, 20), {.field = {.cells = 40}});
  std::set<std::int32_t> seen;
  std::vector<std::pair<std::int32_t, std::vector<std::array<double, 4>>>> stack = {{0, {}}};
  while (!stack.empty()) {
    const auto [index, above] = stack.back();
    stack.pop_back();
    const ShellNode& node = shell.nodes[static_cast<std::size_t>(index)];
    for (std::size_t c = 0; c < static_cast<std::size_t>(node.count); ++c) {
      auto spheres = above;
      spheres.push_back({node.x[c], node.y[c], node.z[c], node.radius[c]});
      if (node.child[c] >= 0) {
        stack.push_back({node.child[c], spheres});
        continue;
      }
      const ShellLeaf& leaf = shell.leaves[static_cast<std::size_t>(-1 - node.child[c])];
      for (std::size_t i = 0; i < static_cast<std::size_t>(leaf.count); ++i) {
        EXPECT_TRUE(seen.insert(leaf.point[i]).second);
        for (const auto& s : spheres) {
          EXPECT_LE((Vec3(leaf.x[i], leaf.y[i], leaf.z[i]) - Vec3(s[0], s[1], s[2])).norm(), s[3]);
        }
      }
    }
  }
  EXPECT_EQ(seen.size(), shell.normals.size());
}

TEST(PointShell, DeepInsideAPointKeepsItsOwnNormal) {
  const TriangleMesh large = make_ball(1.0, 16), small = make_ball(0.1, 4);
  const PointShell a = build_point_shell(small, {.field = {.cells = 20}});
  const PointShell b = build_point_shell(large, {.field = {.cells = 60}});
  std::vector<ShellContact> contacts;
  query_shells(a, pose_at(Vec3(0.0, 0.0, 0.5)), b, Pose{}, 0.01, contacts);
  ASSERT_EQ(contacts.size(), small.positions.size());
  for (const ShellContact& c : contacts) {
    EXPECT_NEAR(c.depth, 1.0 - c.point.norm(), 2.0 * b.field.brick_radius);
    EXPECT_GT(c.normal.dot((c.point - Vec3(0.0, 0.0, 0.5)).normalized()), 0.99);
  }
}

}  // namespace
}  // namespace thigma::bench
