// Levels of detail of the procedural models and the shared meshes: every promise of a hierarchy,
// the deviations against samples both ways, and the statistics of Table 3.2. A few models of few
// triangles by default, all of them at their own size with --full.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

#include "support/check_hierarchy.h"
#include "support/check_levels.h"
#include "support/full.h"
#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/surface_deviation.h"
#include "thigma/import/load_mesh.h"
#include "thigma/math/random.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/surface_topology.h"
#include "thigma/models/make_model.h"
#include "thigma/simplify/simplify_surface.h"

namespace thigma {
namespace {

struct Asset {
  const char* name;
  int triangles;  // by default, 0: only with --full
  bool
      // at its own size its coarsest simplified level has at most 2 % of the original's patches
      reaches_two;
};

Vec3 sample(const HullView& hull, Random& random) {
  const HullTriangle& t =
      hull.triangles[random.below(static_cast<std::uint64_t>(hull.triangle_count))];
  double u = random.uniform(), v = random.uniform();
  if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
  return (1.0 - u - v) * hull.vertices[t.corner[0]] + u * hull.vertices[t.corner[1]] +
         v * hull.vertices[t.corner[2]];
}

/// Largest sampled distance over its bound s, and how many samples were farther.
struct DeviationSamples {
  double worst = 0.0;
  int count = 0, beyond = 0;
  void add(double distance, double bound) {
    ++count;
    beyond += distance > bound * (1.0 + 1e-9);
    if (bound > 0.0) worst = std::max(worst, distance / bound);
  }
};

DeviationSamples sample_deviations(const ClodHierarchy& h, const TriangleMesh& mesh,
                                   const Simplification& s) {
  DeviationSamples samples;
  Random random(81);
  std::vector<DeviationTarget> levels;
  for (const SimplifiedLevel& level : s.levels)
    levels.push_back(build_deviation_target(level.mesh));
  const DeviationTarget original = build_deviation_target(mesh);
  std::vector<std::int32_t> parent(h.nodes.size(), -1);
  std::int32_t guess = 0;
  for (std::size_t i = 0; i < h.nodes.size(); ++i) {
    const ClodNode& node = h.nodes[i];
    for (std::int32_t k = 0; k < node.child_count; ++k)
      parent[static_cast<std::size_t>(node.first_child + k)] = static_cast<std::int32_t>(i);
    const HullView surface = level_surface(h, static_cast<std::int32_t>(i));
    if (node.contact >= 0)
      for (int k = 0; k < 4; ++k)
        samples.add(nearest_distance(original, sample(surface, random), guess),
                    h.level_patches[static_cast<std::size_t>(node.contact)].deviation);
    if (node.patch < 0) continue;
    const Vec3 p = sample(surface, random);
    for (std::int32_t up = parent[i]; up >= 0; up = parent[static_cast<std::size_t>(up)]) {
      const ClodNode& above = h.nodes[static_cast<std::size_t>(up)];
      std::int32_t near = 0;
      if (above.contact >= 0)
        samples.add(nearest_distance(levels[static_cast<std::size_t>(above.level)], p, near),
                    h.level_patches[static_cast<std::size_t>(above.contact)].deviation);
    }
  }
  return samples;
}

/// Builds, checks and prints a row. returns the share of the patches on the coarsest level.
double expect_sound_asset(const std::string& name, const TriangleMesh& mesh, bool is_procedural) {
  SCOPED_TRACE(name);
  ClodParams params;
  params.threads = 2;
  ClodReport report;
  const ClodHierarchy h = build_clod(mesh, params, &report);
  const auto& levels = report.simplification->levels;
  const SimplifiedLevel& last = levels.back();
  const LevelCheck check = check_levels(*report.simplification, decompose_surface(mesh));
  EXPECT_EQ(check.misplaced_triangles, 0);
  EXPECT_EQ(check.reflex_edges + check.off_hull, 0);
  EXPECT_EQ(check.protruding_patches, 0);
  EXPECT_EQ(check.total(), 0);
  EXPECT_EQ(check_hierarchy(h, mesh).total(), 0);
  const DeviationSamples samples = sample_deviations(h, mesh, *report.simplification);
  EXPECT_EQ(samples.beyond, 0) << "of " << samples.count;
  for (std::size_t k = 2; k < levels.size() && is_procedural; ++k)
    EXPECT_LT(levels[k].resolution, levels[k - 1].resolution);
  const std::size_t free = h.levels.size() - levels.size();
  EXPECT_LE(free, 9u);
  const double share = static_cast<double>(last.patch_count) / levels[0].patch_count;
  const double r1 = levels.size() > 1 ? levels[1].resolution * h.radius : 0.0;
  std::printf(
      "  %-34s %7zu %6d | %5zu %4d (%5.2f %%) r %6.1f .. %5.2f | %zu free of %zu | volume %+5.1f "
      "%% | "
      "%d samples, at most %.2f of s | %lld of %zu without a node\n",
      name.c_str(), mesh.triangles.size(), levels[0].patch_count, last.mesh.triangles.size(),
      last.patch_count, 100.0 * share, r1, last.resolution * h.radius, free, h.levels.size(),
      100.0 * (mass_properties(last.mesh).volume / mass_properties(mesh).volume - 1.0),
      samples.count, samples.worst, static_cast<long long>(report.childless),
      h.level_patches.size());
  std::fflush(stdout);
  return share;
}

TEST(LevelAssets, ProceduralModels) {
  constexpr Asset assets[] = {
      {"jaw_lower", 8000, true}, {"jaw_upper", 0, true},    {"cup", 0, true},
      {"spoon", 6000, true},     {"ellipsoid", 2000, true}, {"ball", 20000, true},
      {"box", 1200, false},      {"plate", 2000, true},     {"cylinder", 2000, true},
      {"cone", 2000, true},      {"torus", 4000, true},     {"gear", 6000, true},
      {"peg", 4000, true},       {"hole", 4000, false}};
  for (const Asset& asset : assets) {
    if (asset.triangles == 0 && !test::is_full()) continue;
    models::ModelRequest request;
    request.name = asset.name;
    if (!test::is_full()) request.triangles = asset.triangles;
    const double share = expect_sound_asset(asset.name, models::make_model(request), true);
    if (test::is_full() && asset.reaches_two) {
      EXPECT_LE(share, 0.02) << asset.name;
    }
  }
}

TEST(LevelAssets, SharedMeshes) {
  THIGMA_NEEDS_SHARED(folder);
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "meshes"))
    if (entry.path().extension() == ".obj") paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  for (const auto& path : paths) {
    const std::string name = path.stem().string();
    if (!test::is_full() && name.find("spoon") == std::string::npos) continue;
    expect_sound_asset(name, load_usable_mesh(path.string(), 1.0, true), false);
  }
}

/// What a prototype reached on a real mesh (docs/journal/simplification.md), in its own unit: the
/// farthest vertex from the middle of the box. The mug: 750 there; 758 since new triangles stay
/// within 4.5 % of the radius instead of 8.
struct Coarsest {
  const char* name;
  std::size_t triangles;
  int patches;
};

TEST(LevelAssets, RealMeshesAreAsCoarseAsAsked) {
  THIGMA_NEEDS_SHARED(folder);
  constexpr Coarsest asked[] = {{"a02_dental_cast_lower", 600, 100},
                                {"a12_mug_ycb", 760, 250},
                                {"a01_dental_cast_upper", 600, 100},
                                {"a03_femur_right", 750, 60},
                                {"a04_hip_bone_right_mirrored", 750, 60},
                                {"a05_gear_large_60t", 2100, 140},
                                {"a06_gear_medium_40t", 2100, 140},
                                {"a07_bolt_m16_loose", 2100, 140},
                                {"a08_nut_m16_loose", 2100, 140},
                                {"a09_round_peg_16mm", 2100, 140},
                                {"a10_round_socket_tray_16mm", 2100, 140},
                                {"a11_spoon_ycb", 750, 250},
                                {"a13_hammer_scan", 750, 60},
                                {"a14_skull", 750, 60},
                                {"a15_koala", 750, 60},
                                {"a16_mountain_open", 750, 60}};
  for (const Coarsest& limit : test::is_full() ? std::span(asked) : std::span(asked).first(2)) {
    const auto path = folder / "meshes" / (std::string(limit.name) + ".obj");
    const TriangleMesh mesh = load_usable_mesh(path.string(), 1.0, true);
    const Bounds box = bounds_of(mesh.positions);
    double unit = 0.0;
    for (const Vec3& p : mesh.positions)
      unit = std::max(unit, (p - 0.5 * (box.min + box.max)).norm());
    SimplifyParams params;
    // no level of r < 8
    params.stages = simplify_stages(0.125 * (unit / enclosing_ball(mesh.positions).radius), 0.0);
    const Simplification s =
        simplify_surface({mesh, compute_topology(mesh), decompose_surface(mesh)}, params);
    const SimplifiedLevel& last = s.levels.back();
    std::printf("  %-30s %5zu/%4d at r %.2f, volume %+5.1f %%\n", limit.name,
                last.mesh.triangles.size(), last.patch_count, last.resolution * unit,
                100.0 * (mass_properties(last.mesh).volume / mass_properties(mesh).volume - 1.0));
    std::fflush(stdout);
    EXPECT_GE(last.resolution * unit, 8.0 * (1.0 - 1e-9)) << limit.name;
    EXPECT_LE(last.mesh.triangles.size(), limit.triangles) << limit.name;
    EXPECT_LE(last.patch_count, limit.patches) << limit.name;
  }
}

}  // namespace
}  // namespace thigma
