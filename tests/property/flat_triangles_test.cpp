// Meshes with triangles that have no area to rounding: whatever is usable builds, exactly and with
// levels, and answers queries as the search over its triangles does.

#include <array>
#include <cstdio>

#include "support/check_hierarchy.h"
#include "support/check_levels.h"
#include "support/full.h"
#include "support/level_check.h"
#include "support/query_check.h"
#include "support/zero_area.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/clod/validate_hierarchy.h"
#include "thigma/import/inspect.h"
#include "thigma/mesh/shapes.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

TriangleMesh base_of(Random& random) {
  switch (random.below(6)) {
    case 0:
      return make_ball(1.0, 2 + static_cast<int>(random.below(4)));
    case 1:
      return make_torus(1.0, 0.4, 12, 8);
    case 2:
      return make_box({1, 1, 1}, {3, 3, 3});
    case 3:
      return make_sheet(1.5, 1.5, 6, 6);
    case 4:
      return make_cylinder(0.7, 1.2, 12, 2);
    default:
      return make_hollow_ball(1.0, 0.8, 3);
  }
}

/// A mesh with flaws, usable, at any scale.
TriangleMesh flawed_mesh(int number, double& scale) {
  Random random(1200 + static_cast<std::uint64_t>(number));
  for (;;) {
    TriangleMesh mesh = base_of(random);
    test::add_random_flaws(mesh, random, 1 + static_cast<int>(random.below(12)), 1.0);
    scale = std::array{1.0, 1e-9, 1e3, 0.01}[random.below(4)];
    const Quat turn = random.orientation();
    const Vec3 at = std::array{0.0, 0.0, 5.0}[random.below(3)] * random.in_cube(1.0);
    for (Vec3& p : mesh.positions) p = scale * (turn * p + at);
    mesh = merge_equal_positions(std::move(mesh)).mesh;
    if (inspect_mesh(mesh, {.self_intersections = false}).verdict == MeshVerdict::usable)
      return mesh;
  }
}

struct Tally {
  int meshes = 0, flat = 0, levels = 0;
};

void build_both_ways(const TriangleMesh& mesh, Tally& tally) {
  const ClodHierarchy exact = build_exact_hierarchy(mesh);
  EXPECT_EQ(find_flaw(exact), "");
  EXPECT_EQ(check_hierarchy(exact, mesh).total(), 0);
  ClodReport report;
  const ClodHierarchy h = build_clod(mesh, {}, &report);
  EXPECT_EQ(find_flaw(h), "");
  const HierarchyCheck check = check_hierarchy(h, mesh);
  EXPECT_EQ(check.total(), 0) << check.reflex_edges << ' ' << check.off_hull << ' '
                              << check.protruding_patches << ' ' << check.wrong_features << ' '
                              << check.uncovered_nodes << ' ' << check.worst_uncovered;
  const LevelCheck levels = check_levels(*report.simplification, decompose_surface(mesh));
  EXPECT_EQ(levels.total() - levels.changed_surfaces, 0)
      << levels.misplaced_triangles << ' ' << levels.empty_patches << ' ' << levels.unhalved_levels
      << ' ' << levels.wrong_parents << ' ' << levels.off_hull << ' ' << levels.reflex_edges << ' '
      << levels.protruding_patches;
  ++tally.meshes;
  for (const double height : compute_topology(mesh).height) tally.flat += height <= 0.0;
  tally.levels += static_cast<int>(report.simplification->levels.size());
}

TEST(FlatTriangles, a_ball_with_five_builds_with_levels) {
  for (const double scale : {1.0, 1e-9, 1e3}) {
    TriangleMesh ball = make_ball(1.0, 8);
    for (std::size_t i = 0; i < 5; ++i) test::flatten(ball, 100 * i + 7, i % 3, 0.5);
    for (Vec3& p : ball.positions) p *= scale;
    ASSERT_EQ(inspect_mesh(ball).verdict, MeshVerdict::usable);
    Tally tally;
    build_both_ways(ball, tally);
    EXPECT_GE(tally.flat, 4);
    EXPECT_GE(tally.levels, 3);
  }
}

TEST(FlatTriangles, a_ball_with_five_of_their_own_builds_with_levels) {
  for (const double scale : {1.0, 1e-9, 1e3}) {
    TriangleMesh ball = make_ball(1.0, 8);
    for (int i = 0; i < 5; ++i) test::add_stray(ball, {0.1 * i, 0, 0}, {0.1 * i, 0.5, 0});
    for (Vec3& p : ball.positions) p *= scale;
    ASSERT_EQ(inspect_mesh(ball).verdict, MeshVerdict::usable);
    Tally tally;
    build_both_ways(ball, tally);
    EXPECT_EQ(tally.flat, 5);
    EXPECT_GE(tally.levels, 3);
  }
}

TEST(FlatTriangles, whatever_is_usable_builds) {
  const int rounds = test::is_full() ? 2000 : 60;
  Tally tally;
  for (int number = 0; number < rounds; ++number) {
    SCOPED_TRACE("mesh " + std::to_string(number));
    double scale = 1.0;
    build_both_ways(flawed_mesh(number, scale), tally);
  }
  std::printf("  %d meshes, %d triangles without an area, %d levels\n", tally.meshes, tally.flat,
              tally.levels);
  EXPECT_GT(tally.flat, rounds);
  EXPECT_GT(tally.levels, rounds);  // simplified ones, of meshes of a few hundred triangles
}

/// Takes triangles of no patch out of the search: without an area they lie on others, or are no
/// surface.
void search_surface_alone(const TriangleMesh& mesh, test::TriangleTree& tree,
                          std::vector<int>& patch) {
  TriangleMesh part{mesh.positions, {}};
  std::vector<int> of_part;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (patch[t] < 0) continue;
    part.triangles.push_back(mesh.triangles[t]);
    of_part.push_back(patch[t]);
  }
  tree = test::build_triangle_tree(part);
  patch = std::move(of_part);
}

TEST(FlatTriangles, queries_find_what_a_search_finds) {
  const int pairs = test::is_full() ? 100 : 10;
  for (int number = 0; number < pairs; ++number) {
    SCOPED_TRACE("pair " + std::to_string(number));
    double scale = 1.0, ignored = 1.0;
    const TriangleMesh object = flawed_mesh(number, scale);
    TriangleMesh scene = flawed_mesh(5000 + number, ignored);
    for (Vec3& p : scene.positions) p *= scale / ignored;
    scene = merge_equal_positions(std::move(scene)).mesh;
    test::LevelPairCheck pair = test::make_level_pair("flawed", object, scene);
    search_surface_alone(object, pair.exact.object_tree, pair.exact.object_patch);
    search_surface_alone(scene, pair.exact.scene_tree, pair.exact.scene_patch);
    const test::PatchSurfaces objects(pair.exact.object, object), scenes(pair.exact.scene, scene);
    const double d = 0.02 * pair.exact.radius;
    ContactQuery exact{.tolerance = d}, coarse{.tolerance = d};
    exact.resolution.is_exact = true;
    coarse.resolution.is_exact = false;
    coarse.resolution.deviation_cap = kNoCap;
    ContactFront front;
    ContactSet set;
    set.contacts.reserve(200'000);
    test::CheckCounts counts;
    Random random(77 + static_cast<std::uint64_t>(number));
    std::int64_t true_pairs = 0;
    for (int i = 0; i < 20; ++i) {
      const Pose pose = test::random_pose_near(pair.exact, random);
      clear(set);
      clear_front(front);
      query_contacts({pair.exact.object, pose}, {pair.exact.scene}, exact, front, set);
      ASSERT_EQ(set.dropped, 0);
      test::check_against_search(pair.exact, pose, d, set, counts);
      clear(set);
      clear_front(front);
      query_contacts({pair.exact.object, pose}, {pair.exact.scene}, coarse, front, set);
      EXPECT_EQ(test::count_missed(pair, objects, scenes, pose, d - 1e-9 * pair.exact.radius, set,
                                   true_pairs),
                0);
      for (const Contact& c : set.contacts) EXPECT_NEAR(c.normal.norm(), 1.0, 1e-9);
    }
    if (HasFailure()) return;
  }
}

}  // namespace
}  // namespace thigma
