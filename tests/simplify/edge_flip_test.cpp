#include "thigma/simplify/edge_flip.h"

#include <algorithm>
#include <numeric>

#include "simplify/simplify_support.h"
#include <gtest/gtest.h>

#include "thigma/core/index.h"
#include "thigma/mesh/halfedge_flip.h"
#include "thigma/mesh/measure.h"

namespace thigma {
namespace {

struct FlipBench : test::SurfaceBench {
  using SurfaceBench::SurfaceBench;
  std::array<std::int64_t, kFlipOutcomes> outcomes{};

  std::int64_t flip_all() {
    return flip_reflex_edges(surface, context, {context.scratch.search.limit, 0.0, 0.0}, successor,
                             outcomes);
  }
  std::int64_t count(FlipOutcome outcome) const {
    return outcomes[static_cast<std::size_t>(outcome)];
  }
};

std::int32_t count_reflex(const PatchedSurface& s) {
  std::int32_t reflex = 0;
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(s.mesh.twin.size()); ++h) {
    const std::int32_t twin = s.mesh.twin[idx(h)];
    if (twin < h) continue;
    const std::int32_t apex = tail_of(s.mesh, previous_halfedge(twin));
    reflex += height_over(s, h / 3, s.mesh.positions[idx(apex)]) > s.flat;
  }
  return reflex;
}

void expect_sound(const PatchedSurface& s) {
  EXPECT_EQ(count_halfedge_faults(s.mesh), 0);
  std::int32_t alive = 0;
  for (std::size_t i = 0; i < s.patches.size(); ++i) {
    const SurfacePatch& patch = s.patches[i];
    alive += !patch.triangles.empty();
    std::vector<std::int32_t> used, listed = patch.vertices;
    for (const std::int32_t t : patch.triangles) {
      EXPECT_EQ(s.patch_of[idx(t)], static_cast<std::int32_t>(i));
      const auto& v = s.mesh.triangles[idx(t)];
      used.insert(used.end(), v.begin(), v.end());
      for (const std::int32_t w : patch.vertices)
        EXPECT_LE(height_over(s, t, s.mesh.positions[idx(w)]), s.flat);
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    std::sort(listed.begin(), listed.end());
    EXPECT_EQ(used, listed);
    for (std::int32_t t = 0; t < static_cast<std::int32_t>(s.patch_of.size()); ++t)
      if (s.patch_of[idx(t)] != static_cast<std::int32_t>(i)) {
        EXPECT_FALSE(intrudes(s, t, patch.half_spaces, patch.box)) << i;
      }
  }
  EXPECT_EQ(alive, s.patch_count);
}

/// A ball with edges turned, no two of one triangle: its vertices are convex, its faces are not.
TriangleMesh dented_ball(int frequency) {
  HalfedgeMesh m = build_halfedge_mesh(make_ball(1.0, frequency));
  std::vector<char> is_turned(m.triangles.size(), 0);
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(m.twin.size()); h += 7) {
    if (!can_flip(m, h)) continue;
    const auto [one, two] = quad_of(m, h).triangle;
    if (is_turned[idx(one)] || is_turned[idx(two)]) continue;
    is_turned[idx(one)] = is_turned[idx(two)] = 1;
    flip_edge(m, h);
  }
  return compact(m).mesh;
}

TEST(EdgeFlip, ChangesNothingWhenItRefuses) {
  FlipBench bench(test::wavy_ball(5), 0.03);
  bench.context.volume = {mass_properties(bench.mesh).volume, mass_properties(bench.mesh).volume,
                          0.02};
  int flipped = 0, refused = 0;
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(bench.surface.mesh.twin.size()); ++h) {
    const PatchedSurface before = bench.surface;
    const double volume = bench.context.volume.now;
    const FlipOutcome outcome = flip_reflex_edge(bench.surface, bench.context, h, bench.successor);
    if (outcome == FlipOutcome::flipped) {
      ++flipped;
      EXPECT_LE(bench.surface.patch_count, before.patch_count);
      EXPECT_GT(bench.context.volume.now, volume);
      continue;
    }
    refused += outcome != FlipOutcome::convex;
    EXPECT_TRUE(test::same(before, bench.surface));
    EXPECT_EQ(bench.context.volume.now, volume);
  }
  EXPECT_GT(flipped, 20);
  EXPECT_GT(refused, 20);
  expect_sound(bench.surface);
}

TEST(EdgeFlip, MakesDentedConvexBodiesConvex) {
  FlipBench bench(dented_ball(3), 0.5);
  const std::int32_t patches = bench.surface.patch_count;
  const double volume = mass_properties(make_ball(1.0, 3)).volume;
  EXPECT_GT(count_reflex(bench.surface), 10);
  bench.context.volume = {volume, mass_properties(bench.mesh).volume, volume};
  EXPECT_GT(bench.flip_all(), 10);
  EXPECT_EQ(count_reflex(bench.surface), 0);
  EXPECT_NEAR(bench.context.volume.now, volume, 1e-12) << "the hull of its vertices again";
  EXPECT_NEAR(mass_properties(compact(bench.surface.mesh).mesh).volume, volume, 1e-12);
  EXPECT_LT(2 * bench.surface.patch_count, patches);
  expect_sound(bench.surface);
}

TEST(EdgeFlip, PairsTheTrianglesOfACavity) {
  TriangleMesh cavity = make_ball(1.0, 4);
  for (auto& t : cavity.triangles) std::swap(t[1], t[2]);
  FlipBench bench(cavity, 0.1);
  const auto triangles = static_cast<std::int32_t>(cavity.triangles.size());
  EXPECT_EQ(bench.surface.patch_count, triangles) << "every edge is reflex";
  EXPECT_GT(bench.flip_all(), triangles / 5);
  EXPECT_LT(10 * bench.surface.patch_count, 7 * triangles);
  EXPECT_EQ(bench.surface.mesh.triangle_count, triangles);
  expect_sound(bench.surface);
}

TEST(EdgeFlip, NamesItsReasons) {
  FlipBench flat(make_sheet(1, 1, 4, 4), 0.1);
  EXPECT_EQ(flat.flip_all(), 0);
  EXPECT_EQ(flat.count(FlipOutcome::convex),
            std::accumulate(flat.outcomes.begin(), flat.outcomes.end(), std::int64_t{0}));
  FlipBench tight(test::wavy_ball(5), 1e-7);
  EXPECT_EQ(tight.flip_all(), 0);
  EXPECT_GT(tight.count(FlipOutcome::deviation), 20);
  FlipBench full(test::wavy_ball(5), 0.05);
  const double volume = mass_properties(full.mesh).volume;
  full.context.volume = {volume, volume, 0.0};
  EXPECT_EQ(full.flip_all(), 0);
  EXPECT_GT(full.count(FlipOutcome::volume), 20);
}

TEST(EdgeFlip, HandsTheOriginalsVerticesOver) {
  FlipBench bench(test::wavy_ball(5), 0.03);
  ASSERT_GT(bench.flip_all(), 0);
  std::vector<int> times(bench.mesh.positions.size(), 0);
  for (const std::int32_t first : bench.context.guard.first_sample)
    for (std::int32_t v = first; v >= 0; v = bench.context.guard.next_sample[idx(v)])
      ++times[idx(v)];
  EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(times.size()));
}

}  // namespace
}  // namespace thigma
