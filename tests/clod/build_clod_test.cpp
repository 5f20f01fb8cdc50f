#include "thigma/clod/build_clod.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clod/asset_samples.h"
#include "clod/distance_by_loop.h"
#include "support/check_hierarchy.h"
#include "support/check_levels.h"
#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/clod/clod_file.h"
#include "thigma/clod/detail/build_levels.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/convex/gjk.h"
#include "thigma/convex/quickhull.h"
#include "thigma/import/load_mesh.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

using test::generous;
using test::wavy_ball;

constexpr detail::TreeForm kOfTheText{.is_reparented = false, .has_culling_hulls = false};

void expect_sound(const TriangleMesh& mesh, const ClodParams& params, const char* name,
                  const detail::TreeForm& form = {}) {
  ClodReport report;
  const ClodHierarchy h = detail::build_levels(mesh, params, form, &report);
  EXPECT_EQ(check_hierarchy(h, mesh).total(), 0) << name;
  EXPECT_EQ(check_levels(*report.simplification, decompose_surface(mesh)).total(), 0) << name;
  const auto& levels = report.simplification->levels;
  std::size_t patches = 0, nodes = 0;
  for (std::size_t k = 0; k < h.levels.size(); ++k) {
    nodes += static_cast<std::size_t>(h.levels[k].node_count);
    EXPECT_EQ(h.levels[k].is_free, k >= levels.size());
    if (k > 0 && k < levels.size()) patches += static_cast<std::size_t>(levels[k].patch_count);
  }
  EXPECT_EQ(nodes, h.nodes.size()) << name;
  EXPECT_LE(1 << (h.levels.size() - levels.size()), 2 * levels.back().patch_count)
      << name << ": free levels";
  EXPECT_EQ(h.level_patches.size(), patches) << name;
  for (const ClodNode& node : h.nodes) {
    EXPECT_EQ(node.contact >= 0,
              node.level > 0 && !h.levels[static_cast<std::size_t>(node.level)].is_free);
    for (std::int32_t k = 0; k < node.child_count; ++k)
      EXPECT_LT(h.nodes[static_cast<std::size_t>(node.first_child + k)].level, node.level) << name;
  }
}

TEST(BuildClod, IsSoundOnShapes) {
  expect_sound(wavy_ball(10), generous(), "wavy ball");
  expect_sound(make_torus(1.0, 0.4, 32, 20), generous(), "torus");
  expect_sound(make_dome(1.0, 24, 10), generous(), "dome");
  expect_sound(make_box({1, 2, 3}), {}, "box");
  expect_sound(wavy_ball(10), generous(), "wavy ball, as in the text", kOfTheText);
}

TEST(BuildClod, IsSoundOnRealMeshes) {
  THIGMA_NEEDS_SHARED(folder);
  for (const char* name : {"a02_dental_cast_lower", "a07_bolt_m16_loose", "a08_nut_m16_loose"})
    expect_sound(
        load_usable_mesh((folder / "meshes" / (std::string(name) + ".obj")).string(), 1.0, true),
        {}, name);
}

/// Every contact patch and the hulls of all nodes below its node.
TEST(BuildClod, HausdorffDistancesReachEveryDescendant) {
  for (const bool reparented : {false, true}) {
    const ClodHierarchy h =
        detail::build_levels(wavy_ball(8), generous(), {.is_reparented = reparented}, nullptr);
    std::vector<std::int32_t> parent(h.nodes.size(), -1);
    for (std::size_t i = 0; i < h.nodes.size(); ++i)
      for (std::int32_t k = 0; k < h.nodes[i].child_count; ++k)
        parent[static_cast<std::size_t>(h.nodes[i].first_child + k)] = static_cast<std::int32_t>(i);
    int tight = 0, checked = 0;
    std::vector<double> largest(h.nodes.size(), 0.0);
    for (std::size_t i = 0; i < h.nodes.size(); ++i) {
      const HullView inner = level_surface(h, static_cast<std::int32_t>(i));
      if (h.nodes[i].contact < 0 && h.nodes[i].patch < 0) continue;
      for (std::int32_t up = parent[i]; up >= 0; up = parent[static_cast<std::size_t>(up)]) {
        const std::int32_t contact = h.nodes[static_cast<std::size_t>(up)].contact;
        if (contact < 0) continue;
        std::vector<Vec3> points;
        const HullView outer = level_surface(h, up);
        for (int v = 0; v < inner.vertex_count; ++v) {
          GjkCache cache;
          HullView one = inner;  // the hull of one vertex
          one.vertices = inner.vertices + v;
          one.vertex_count = 1;
          const double distance = closest_points(outer, one, RelativePose{},
                                                 std::numeric_limits<double>::infinity(), cache)
                                      .distance;
          EXPECT_LE(distance, h.level_patches[static_cast<std::size_t>(contact)].hausdorff);
          largest[static_cast<std::size_t>(up)] =
              std::max(largest[static_cast<std::size_t>(up)], distance);
        }
      }
    }
    for (std::size_t i = 0; i < h.nodes.size(); ++i) {
      if (h.nodes[i].contact < 0) continue;
      ++checked;
      const LevelPatch& c = h.level_patches[static_cast<std::size_t>(h.nodes[i].contact)];
      // Either a hull below reaches so far out, or s + h has to cover one of these.
      const double covered = std::max({c.from_below, c.to_below, h.nodes[i].hausdorff});
      tight += largest[i] >= 0.999 * c.hausdorff - 1e-11 ||
               covered >= 0.999 * (c.hausdorff + c.deviation) - 1e-11;
    }
    EXPECT_EQ(tight, checked) << "no larger than needed";
  }
}

TEST(BuildClod, DeviationsBoundBothDirections) {
  const TriangleMesh mesh = wavy_ball(8);
  ClodReport report;
  const ClodHierarchy h = build_clod(mesh, generous(), &report);
  Random random(51);
  double worst = 0.0;
  for (const LevelPatch& c : h.level_patches) {
    const HullView hull = [&] {
      HullView v;
      v.vertices = h.vertices.data() + c.first_vertex;
      return v;
    }();
    for (std::int32_t i = 0; i < c.patch.triangle_count; ++i) {
      const HullTriangle& t =
          h.hull_triangles[static_cast<std::size_t>(c.patch.first_triangle + i)];
      double u = random.uniform(), v = random.uniform();
      if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
      const Vec3 p = (1.0 - u - v) * hull.vertices[t.corner[0]] + u * hull.vertices[t.corner[1]] +
                     v * hull.vertices[t.corner[2]];
      const double distance = test::distance_by_loop(mesh, p);
      EXPECT_LE(distance, c.deviation * (1.0 + 1e-9));
    }
    worst = std::max(worst, c.deviation);
  }
  EXPECT_LT(worst, 0.3) << "and is no empty promise";
  // From the original: every vertex of a finest patch to the surface of each level above it.
  std::vector<std::int32_t> parent(h.nodes.size(), -1);
  for (std::size_t i = 0; i < h.nodes.size(); ++i)
    for (std::int32_t k = 0; k < h.nodes[i].child_count; ++k)
      parent[static_cast<std::size_t>(h.nodes[i].first_child + k)] = static_cast<std::int32_t>(i);
  for (const ClodPatch& patch : h.patches) {
    const HullView hull = hull_view(h, patch.node);
    for (std::int32_t up = parent[static_cast<std::size_t>(patch.node)]; up >= 0;
         up = parent[static_cast<std::size_t>(up)]) {
      const ClodNode& node = h.nodes[static_cast<std::size_t>(up)];
      if (node.contact < 0) continue;
      const TriangleMesh& level =
          report.simplification->levels[static_cast<std::size_t>(node.level)].mesh;
      const auto v = random.below(static_cast<std::uint64_t>(hull.vertex_count));
      EXPECT_LE(test::distance_by_loop(level, hull.vertices[v]),
                h.level_patches[static_cast<std::size_t>(node.contact)].deviation * (1.0 + 1e-9));
    }
  }
}

TEST(BuildClod, SupportComesDownWithTheVertices) {
  const TriangleMesh mesh = wavy_ball(8);
  ClodReport report;
  ClodParams params = generous();
  params.contact_tolerance = 0.2;  // the faces of so coarse a mesh are high
  const ClodHierarchy h = build_clod(mesh, params, &report);
  ASSERT_EQ(h.support.size(), h.vertices.size());
  for (const ClodPatch& patch : h.patches) {
    const ClodNode& node = h.nodes[static_cast<std::size_t>(patch.node)];
    for (std::int32_t v = node.first_vertex; v < node.first_vertex + node.vertex_count; ++v) {
      EXPECT_GT(h.support[static_cast<std::size_t>(v)][0], 0.0);
      EXPECT_GE(h.support[static_cast<std::size_t>(v)][1],
                h.support[static_cast<std::size_t>(v)][0]);
    }
  }
  double least = 1e300;
  for (const auto& d : report.simplification->levels[0].support) least = std::min(least, d[1]);
  for (const LevelPatch& c : h.level_patches)
    for (std::int32_t v = c.first_vertex; v < c.first_vertex + c.vertex_count; ++v)
      EXPECT_GE(h.support[static_cast<std::size_t>(v)][1], least);
}

std::vector<std::array<std::int32_t, 2>> pairs_of(const ContactSet& set) {
  std::vector<std::array<std::int32_t, 2>> pairs;
  for (const Contact& c : set.contacts) pairs.push_back({c.object_patch, c.scene_patch});
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

TEST(BuildClod, ExactQueriesAreThoseOfTheExactHierarchy) {
  const TriangleMesh one = wavy_ball(8), two = make_torus(1.0, 0.4, 32, 20);
  const ClodHierarchy exact_one = build_exact_hierarchy(one),
                      exact_two = build_exact_hierarchy(two);
  for (const detail::TreeForm& form : {detail::TreeForm{}, kOfTheText}) {
    const ClodHierarchy clod_one = detail::build_levels(one, generous(), form, nullptr),
                        clod_two = detail::build_levels(two, generous(), form, nullptr);
    Random random(61);
    std::size_t found = 0;
    for (int round = 0; round < 20; ++round) {
      const Pose pose{random.uniform(1.2, 2.4) * random.direction(), random.orientation()};
      const auto query = [&](const ClodHierarchy& a, const ClodHierarchy& b) {
        ContactFront front;
        ContactSet set;
        set.contacts.reserve(20000);
        query_contacts({a, pose}, {b}, {.tolerance = 0.03}, front, set);
        return pairs_of(set);
      };
      const auto expected = query(exact_one, exact_two);
      EXPECT_EQ(query(clod_one, clod_two), expected);
      found += expected.size();
    }
    EXPECT_GT(found, 100u);
  }
}

TEST(BuildClod, TellsHowFarItIs) {
  std::vector<double> shares;
  ClodParams params = generous();
  params.simplify.progress = [&](double share) { shares.push_back(share); };
  build_clod(wavy_ball(8), params);
  EXPECT_GT(shares.size(), 20u);
  EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
  EXPECT_GT(shares.front(), 0.0);
  EXPECT_EQ(shares.back(), 1.0);
}

TEST(BuildClod, IsTheSameWithAnyNumberOfThreads) {
  const std::string alone = format_clod(build_clod_asset(wavy_ball(7), generous()));
  for (const int threads : {2, 3, 4, 16}) {
    ClodParams params = generous();
    params.threads = threads;
    EXPECT_TRUE(format_clod(build_clod_asset(wavy_ball(7), params)) == alone) << threads;
  }
}

TEST(BuildClod, OfOtherShapesIsTheSameWithAnyNumberOfThreads) {
  for (const TriangleMesh& mesh :
       {make_hollow_ball(1.0, 0.9, 8), make_sheet(2, 1, 24, 12), make_torus(1.0, 0.1, 60, 12)}) {
    const std::string alone = format_clod(build_clod_asset(mesh, generous()));
    ClodParams params = generous();
    params.threads = 3;
    EXPECT_TRUE(format_clod(build_clod_asset(mesh, params)) == alone);
  }
}

}  // namespace
}  // namespace thigma
