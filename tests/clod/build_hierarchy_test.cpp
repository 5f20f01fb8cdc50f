#include "thigma/clod/build_hierarchy.h"

#include <bit>
#include <cstring>
#include <limits>

#include "support/check_hierarchy.h"
#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/convex/gjk.h"
#include "thigma/core/error.h"
#include "thigma/import/read_mesh.h"
#include "thigma/math/random.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

void expect_sound(const TriangleMesh& mesh, const char* name) {
  BuildReport report;
  const ClodHierarchy h = build_exact_hierarchy(mesh, {}, &report);
  const HierarchyCheck check = check_hierarchy(h, mesh);
  EXPECT_EQ(check.misplaced_nodes, 0) << name;
  EXPECT_EQ(check.misplaced_triangles, 0) << name;
  EXPECT_EQ(check.wrong_corners, 0) << name;
  EXPECT_EQ(check.reflex_edges, 0) << name;
  EXPECT_EQ(check.off_hull, 0) << name;
  EXPECT_EQ(check.protruding_patches, 0) << name;
  EXPECT_EQ(check.wrong_features, 0) << name;
  EXPECT_EQ(check.uncovered_nodes, 0) << name << ", by " << check.worst_uncovered;
  EXPECT_EQ(report.patches, static_cast<std::int32_t>(h.patches.size()));
  EXPECT_EQ(h.nodes.size(), 2 * h.patches.size() - 1);
  std::size_t nodes = 0;
  for (const ClodLevel& level : h.levels) nodes += static_cast<std::size_t>(level.node_count);
  EXPECT_EQ(nodes, h.nodes.size());
  // Nothing is missing from it, which is what meets levels of another body in the metric.
  EXPECT_EQ(h.levels[0].resolution, std::numeric_limits<double>::infinity());
}

TEST(BuildExactHierarchy, IsSoundOnShapes) {
  expect_sound(make_box({1, 2, 3}), "box");
  expect_sound(make_box({1, 2, 3}, {5, 5, 5}), "divided box");
  expect_sound(make_ball(1e-9, 8), "ball of a nanometre");
  expect_sound(make_torus(1e4, 3e3, 40, 24), "torus of kilometres");
  expect_sound(make_l_shape(1.0, 0.3), "L");
  expect_sound(make_sheet(1, 1, 12, 12), "flat sheet");
  expect_sound(make_hollow_ball(1.0, 0.99, 6), "thin shell");
  expect_sound(make_cylinder(1.0, 1e-6, 40), "coin of no thickness");
}

// Noise of every size, squashed, rounded to single precision, welded at random: slivers, folds,
// lenses, crossings.
TEST(BuildExactHierarchy, IsSoundOnDamagedShapes) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    TriangleMesh mesh = round % 3 == 0   ? make_torus(1, random.uniform(0.2, 1.4), 9, 7)
                        : round % 3 == 1 ? make_ball(1, 3)
                                         : make_box({1, 1, 1}, {4, 3, 2});
    const double noise = std::array{0.0, 1e-16, 1e-9, 1e-6, 1e-3, 0.05}[random.below(6)];
    const Vec3 squash(1, std::array{1.0, 1e-3, 1e-7}[random.below(3)], 1);
    const double scale = std::array{1.0, 1e-9, 1e9}[random.below(3)];
    const Quat turn = random.orientation();
    const bool is_single = random.below(2) == 0;
    for (Vec3& p : mesh.positions) {
      p = turn * (p + noise * random.in_cube(1.0)).cwiseProduct(squash);
      if (is_single) p = p.cast<float>().cast<double>();
      p *= scale;
    }
    for (Vec3& p : mesh.positions)
      if (random.below(20) == 0) p = mesh.positions[random.below(mesh.positions.size())];
    const ClodHierarchy h = build_exact_hierarchy(mesh);
    EXPECT_EQ(check_hierarchy(h, mesh).total(), 0) << "round " << round;
  }
}

TEST(BuildExactHierarchy, IsSoundOnRealMeshes) {
  THIGMA_NEEDS_SHARED(folder);
  for (const char* name : {"a01_dental_cast_upper", "a02_dental_cast_lower", "a03_femur_right",
                           "a05_gear_large_60t", "a07_bolt_m16_loose", "a16_mountain_open"})
    expect_sound(read_mesh((folder / "meshes" / (std::string(name) + ".obj")).string()).mesh, name);
}

/// Leaves whose hulls come within d, found without any tree.
std::vector<std::int32_t> leaves_of(const ClodHierarchy& h) {
  std::vector<std::int32_t> leaves;
  for (const ClodPatch& patch : h.patches) leaves.push_back(patch.node);
  return leaves;
}

bool is_near(const ClodHierarchy& a, std::int32_t i, const ClodHierarchy& b, std::int32_t j,
             const RelativePose& pose, double d) {
  GjkCache cache;
  const double separation = closest_points(hull_view(a, i), hull_view(b, j), pose,
                                           std::numeric_limits<double>::infinity(), cache)
                                .distance;
  return separation - a.nodes[static_cast<std::size_t>(i)].hausdorff -
             b.nodes[static_cast<std::size_t>(j)].hausdorff <=
         d;
}

std::int64_t descend(const ClodHierarchy& a, std::int32_t i, const ClodHierarchy& b, std::int32_t j,
                     const RelativePose& pose, double d) {
  if (!is_near(a, i, b, j, pose, d)) return 0;
  const ClodNode &m = a.nodes[static_cast<std::size_t>(i)],
                 &n = b.nodes[static_cast<std::size_t>(j)];
  if (m.child_count == 0 && n.child_count == 0) return 1;
  std::int64_t found = 0;
  if (n.child_count == 0 || (m.child_count > 0 && m.radius >= n.radius)) {
    for (std::int32_t k = 0; k < m.child_count; ++k)
      found += descend(a, m.first_child + k, b, j, pose, d);
  } else {
    for (std::int32_t k = 0; k < n.child_count; ++k)
      found += descend(a, i, b, n.first_child + k, pose, d);
  }
  return found;
}

TEST(BuildExactHierarchy, PrunesNoLeafPairWithinTheTolerance) {
  const ClodHierarchy a = build_exact_hierarchy(make_torus(1.0, 0.4, 24, 14));
  const ClodHierarchy b = build_exact_hierarchy(make_l_shape(1.5, 0.4));
  const ClodHierarchy c = build_exact_hierarchy(make_hollow_ball(0.9, 0.8, 4));
  Random random(21);
  std::int64_t total = 0;
  for (int round = 0; round < 24; ++round) {
    const Vec3 position = random.uniform(0.0, 1.6) * random.direction();
    const RelativePose pose = relative_pose(Pose{}, Pose{position, random.orientation()});
    const ClodHierarchy& other = round % 2 ? b : c;
    for (const double d : {0.0, 0.05}) {
      std::int64_t expected = 0;
      for (const std::int32_t i : leaves_of(a))
        for (const std::int32_t j : leaves_of(other)) expected += is_near(a, i, other, j, pose, d);
      EXPECT_EQ(descend(a, 0, other, 0, pose, d), expected);
      total += expected;
    }
  }
  EXPECT_GT(total, 500);
}

TEST(BuildExactHierarchy, RealFeaturesOfABoxAreItsSixFacesAndTwelveEdges) {
  const TriangleMesh box = make_box({1, 2, 3});
  const ClodHierarchy h = build_exact_hierarchy(box);
  ASSERT_EQ(h.patches.size(), 1u);
  const HullView hull = hull_view(h, 0);
  EXPECT_EQ(hull.vertex_count, 8);
  EXPECT_EQ(hull.face_count, 6);
  EXPECT_EQ(hull.edge_count, 12);
  EXPECT_EQ(hull.triangle_count, 12);
  EXPECT_DOUBLE_EQ(hull.thickness, 1.0);
  for (int f = 0; f < hull.face_count; ++f) {
    EXPECT_EQ(std::popcount(hull.faces[f].vertices), 4);
    EXPECT_DOUBLE_EQ(hull.faces[f].normal.cwiseAbs().maxCoeff(), 1.0);
  }
  for (int e = 0; e < hull.edge_count; ++e) EXPECT_GE(hull.edges[e].face_right, 0);
}

TEST(BuildExactHierarchy, EdgesOfAnLShapedFaceLeaveOutTheNotch) {
  TriangleMesh sheet;  // a flat L: the hull's edge spans the notch, and no edge in the notch is one
                       // of the hull
  sheet.positions = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  sheet.triangles = {{0, 1, 3}, {1, 2, 3}, {0, 3, 4}, {0, 4, 5}};
  const ClodHierarchy h = build_exact_hierarchy(sheet);
  ASSERT_EQ(h.patches.size(), 1u);
  const HullView hull = hull_view(h, 0);
  EXPECT_EQ(hull.vertex_count, 6);
  EXPECT_EQ(hull.face_count, 1);
  EXPECT_EQ(hull.edge_count, 4);
  EXPECT_EQ(hull.thickness, 0.0);
  for (int e = 0; e < hull.edge_count; ++e) EXPECT_EQ(hull.edges[e].face_right, -1);
}

TEST(BuildExactHierarchy, LanesAreAlignedAndRepeatTheVertices) {
  const ClodHierarchy h = build_exact_hierarchy(make_torus(1.0, 0.4, 24, 14));
  for (std::size_t i = 0; i < h.nodes.size(); ++i) {
    const HullView hull = hull_view(h, static_cast<std::int32_t>(i));
    EXPECT_EQ(std::bit_cast<std::uintptr_t>(hull.lanes) % 32, 0u);
    EXPECT_EQ(hull.lane_count % 8, 0);
    EXPECT_LE(hull.vertex_count, kMaxHullVertices);
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < hull.lane_count; ++k)
        EXPECT_EQ(hull.lanes[axis * hull.lane_count + k],
                  static_cast<float>(hull.vertices[std::min(k, hull.vertex_count - 1)][axis] -
                                     hull.center[axis]));
  }
}

TEST(BuildExactHierarchy, IsTheSameEveryTime) {
  const TriangleMesh mesh = make_torus(1.0, 0.4, 40, 24);
  const ClodHierarchy a = build_exact_hierarchy(mesh), b = build_exact_hierarchy(mesh);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  EXPECT_EQ(std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(Vec3)), 0);
  EXPECT_EQ(a.triangle_ids, b.triangle_ids);
  EXPECT_EQ(a.lanes, b.lanes);
}

TEST(BuildExactHierarchy, RefusesAMeshWithoutArea) {
  EXPECT_THROW(build_exact_hierarchy(TriangleMesh{}), InputError);
}

}  // namespace
}  // namespace thigma
