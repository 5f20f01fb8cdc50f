#include "thigma/simplify/simplify_surface.h"

#include <cmath>
#include <cstring>

#include "simplify/simplify_support.h"
#include "support/check_levels.h"
#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/clod/surface_deviation.h"
#include "thigma/convex/quickhull.h"
#include "thigma/import/inspect.h"
#include "thigma/import/load_mesh.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/self_intersections.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

void expect_sound(const TriangleMesh& mesh, const char* name, const Simplification& s,
                  const ConvexDecomposition& decomposition) {
  const LevelCheck check = check_levels(s, decomposition);
  EXPECT_EQ(check.misplaced_triangles, 0) << name;
  EXPECT_EQ(check.empty_patches, 0) << name;
  EXPECT_EQ(check.reflex_edges, 0) << name;
  EXPECT_EQ(check.off_hull, 0) << name;
  EXPECT_EQ(check.protruding_patches, 0) << name;
  EXPECT_EQ(check.oversized_patches, 0) << name;
  EXPECT_EQ(check.wrong_parents, 0) << name;
  EXPECT_EQ(check.changed_surfaces, 0) << name;
  EXPECT_EQ(check.unhalved_levels, 0) << name;
  EXPECT_EQ(check.rising_resolutions, 0) << name;
  EXPECT_LE(find_self_intersections(s.levels.back().mesh).pairs,
            find_self_intersections(mesh).pairs)
      << name;
}

Simplification expect_simplified(const TriangleMesh& mesh, const char* name,
                                 const SimplifyParams& params = test::generous(),
                                 const detail::SimplifyForm& form = {}) {
  const ConvexDecomposition decomposition = decompose_surface(mesh);
  Simplification s =
      detail::simplify_in_form({mesh, compute_topology(mesh), decomposition}, params, form);
  expect_sound(mesh, name, s, decomposition);
  return s;
}

TEST(SimplifySurface, KeepsItsPromisesOnShapes) {
  for (const double size : {1e-9, 1.0, 1e4})
    EXPECT_GE(expect_simplified(test::wavy_ball(10, size), "wavy ball").levels.size(), 4u) << size;
  EXPECT_GE(expect_simplified(make_torus(1.0, 0.4, 48, 32), "torus").levels.size(), 4u);
  EXPECT_GE(expect_simplified(make_hollow_ball(1.0, 0.6, 8), "hollow ball").levels.size(), 4u);
  expect_simplified(make_sheet(2, 1, 16, 8), "flat sheet");
  expect_simplified(make_dome(1.0, 32, 12), "dome");
  expect_simplified(make_l_shape(1.0, 0.3), "L");
  expect_simplified(make_tetrahedron(1.0), "tetrahedron");
  expect_simplified(make_cylinder(1.0, 4.0, 48, 12), "cylinder");
}

TEST(SimplifySurface, MakesABoxOutOfADividedBox) {
  const TriangleMesh mesh = make_box({1, 2, 3}, {5, 5, 5});
  SimplifyParams params;
  params.stages = simplify_stages(10.0, 0.5);
  params.deviation_limit = 1e-3;
  // relaxation rounds edges within the limit
  const Simplification s = test::simplify(mesh, params, {.is_relaxed = false});
  EXPECT_LE(s.levels.back().patch_count, 3);
  EXPECT_NEAR(mass_properties(s.levels.back().mesh).volume, 6.0, 0.05);
  EXPECT_LT(s.levels.back().mesh.triangles.size(), 60u);
}

TEST(SimplifySurface, StaysWithinTheLimits) {
  const TriangleMesh mesh = test::wavy_ball(12);
  const double radius = enclosing_ball(mesh.positions).radius;
  SimplifyParams params = test::generous();
  params.stages = simplify_stages(0.3, 0.0, 0.0);
  const Simplification wide = test::simplify(mesh, params);
  params.deviation_limit = 0.004;
  const Simplification tight = test::simplify(mesh, params);
  EXPECT_GT(tight.levels.back().mesh.triangles.size(), wide.levels.back().mesh.triangles.size());
  EXPECT_GT(tight.outcomes[static_cast<std::size_t>(CollapseOutcome::deviation)], 0);
  EXPECT_GE(wide.levels.back().resolution * radius, 1.0 / 0.3 * (1.0 - 1e-12));
  for (const Vec3& p : tight.levels.back().mesh.positions) {
    double nearest = 1e300;
    for (const auto& t : mesh.triangles)
      nearest = std::min(nearest,
                         point_triangle_distance(p, mesh.positions[static_cast<std::size_t>(t[0])],
                                                 mesh.positions[static_cast<std::size_t>(t[1])],
                                                 mesh.positions[static_cast<std::size_t>(t[2])]));
    EXPECT_LE(nearest, 0.004 * radius * (1.0 + 1e-9));
  }
  const TriangleMesh& last = tight.levels.back().mesh;
  for (const Vec3& p : mesh.positions) {
    double nearest = 1e300;
    for (const auto& t : last.triangles)
      nearest = std::min(nearest,
                         point_triangle_distance(p, last.positions[static_cast<std::size_t>(t[0])],
                                                 last.positions[static_cast<std::size_t>(t[1])],
                                                 last.positions[static_cast<std::size_t>(t[2])]));
    EXPECT_LE(nearest, 0.004 * radius * (1.0 + 1e-9)) << "from the original too";
  }
  EXPECT_NEAR(mass_properties(wide.levels.back().mesh).volume / mass_properties(mesh).volume, 1.0,
              0.2);
}

TEST(SimplifySurface, KeepsTheVolumeOfLongThings) {
  const TriangleMesh mesh = make_capsule(1.0, 20.0, 24, 30);
  const double volume = mass_properties(mesh).volume;
  const auto lost = [&](bool keeps_volume) {
    const Simplification s = test::simplify(mesh, {}, {.keeps_volume = keeps_volume});
    return 1.0 - mass_properties(s.levels.back().mesh).volume / volume;
  };
  EXPECT_LT(std::fabs(lost(true)), 0.12);
  EXPECT_LT(std::fabs(lost(true)), std::fabs(lost(false)));
}

TEST(SimplifySurface, GoesOnPastTheEdgeWhileManyPatchesAreLeft) {
  const TriangleMesh ball = make_ball(1.0, 16);
  SimplifyParams params;
  const Simplification far = test::simplify(ball, params);
  params.stages = simplify_stages(0.125, 0.0, 0.0);
  const Simplification near = test::simplify(ball, params);
  const auto share = [](const Simplification& s) {
    return static_cast<double>(s.levels.back().patch_count) / s.levels.front().patch_count;
  };
  EXPECT_GT(share(near), params.coarsest_share);
  EXPECT_LT(share(far), 0.5 * share(near));
  EXPECT_GE(near.levels.back().resolution, 8.0 * (1.0 - 1e-9));
  EXPECT_LT(far.levels.back().resolution, 8.0);
}

TEST(SimplifySurface, IsAsNearTheOriginalAsItIsFine) {
  const TriangleMesh mesh = test::wavy_ball(24);
  const double radius = enclosing_ball(mesh.positions).radius;
  SimplifyParams params;
  params.deviation_early = 0.1;
  const auto worst_share = [&](const Simplification& s) {
    // deviation of corners and middles, over the length of the edges collapsed so far
    double worst = 0.0;
    const DeviationTarget original = build_deviation_target(mesh);
    for (std::size_t k = 1; k < s.levels.size() && s.levels[k].resolution * radius > 8.5; ++k)
      for (const auto& t : s.levels[k].mesh.triangles) {
        const auto& x = s.levels[k].mesh.positions;
        std::int32_t nearest = 0;
        const auto at = [&](int i) {
          return x[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
        };
        for (const Vec3& p : {at(0), Vec3((at(0) + at(1) + at(2)) / 3.0)})
          worst = std::max(worst, nearest_distance(original, p, nearest) * s.levels[k].resolution);
      }
    return worst;
  };
  EXPECT_LE(worst_share(expect_simplified(mesh, "near", params)), 0.1 * (1.0 + 1e-9));
  params.deviation_early = 10.0;  // as good as none
  EXPECT_GT(worst_share(test::simplify(mesh, params)), 0.1);
}

TEST(SimplifySurface, StaysNearBetweenTheCornersOfLargeTriangles) {
  // Two towers side by side on a plate: a triangle from top to top has its corners on the surface,
  // and nothing below it.
  const auto height = [](double x) {
    return (x > 0.3 && x < 0.45) || (x > 0.55 && x < 0.7) ? 0.25 : 0.0;
  };
  TriangleMesh mesh = make_sheet(1.0, 1.0, 40, 40);
  for (Vec3& p : mesh.positions)
    p.z() += height(p.x() + 0.5) * (std::fabs(p.y()) < 0.3 ? 1.0 : 0.0);
  const double radius = enclosing_ball(mesh.positions).radius;
  SimplifyParams params;
  params.stages = simplify_stages(1.0, 0.5);
  const Simplification s = test::simplify(mesh, params);
  const DeviationTarget original = build_deviation_target(mesh);
  double worst = 0.0;
  for (const SimplifiedLevel& level : s.levels) {
    DeviationRange range;
    std::int32_t nearest = 0;
    for (const auto& t : level.mesh.triangles) {
      const auto at = [&](int i) {
        return level.mesh.positions[static_cast<std::size_t>(t[static_cast<std::size_t>(i)])];
      };
      extend_deviation(original, {at(0), at(1), at(2)}, 0.1, range, nearest);
    }
    worst = std::max(worst, range.met);
  }
  EXPECT_GT(s.levels.size(), 2u);
  EXPECT_LE(worst, 1.9 * std::max(params.deviation_limit, params.farthest_deviation) * radius);
}

TEST(SimplifySurface, LosesNoMoreVolumeThanItMay) {
  const TriangleMesh mesh = test::wavy_ball(10);
  const double volume = mass_properties(mesh).volume;
  SimplifyParams params = test::generous();
  params.farthest_deviation = params.deviation_limit = 0.5;
  params.stages = simplify_stages(1.0, 0.25);
  params.volume_limit = 0.004;
  const Simplification s = test::simplify(mesh, params, {.keeps_volume = false});
  EXPECT_GT(s.outcomes[static_cast<std::size_t>(CollapseOutcome::volume)], 0);
  for (const SimplifiedLevel& level : s.levels)
    EXPECT_NEAR(mass_properties(level.mesh).volume, volume, 0.004 * volume * (1.0 + 1e-9));
}

TEST(SimplifySurface, IsCoarserWithAConvexStartAndALaterDeviation) {
  const TriangleMesh mesh = make_torus(1.0, 0.4, 64, 32);
  SimplifyParams params;
  params.stages = simplify_stages(0.125, 0.0);
  const auto triangles = [&](const detail::SimplifyForm& form) {
    return test::simplify(mesh, params, form).levels.back().mesh.triangles.size();
  };
  const std::size_t both = triangles({});
  EXPECT_LT(both, triangles({.seeks_convex_start = false}));
  params.stages = simplify_stages(0.125, 0.0, 0.0);
  EXPECT_LT(both, triangles({}));
}

TEST(SimplifySurface, HasFewerPatchesWhereEdgesFlip) {
  for (const TriangleMesh& mesh : {make_torus(1.0, 0.4, 40, 20), test::wavy_ball(8)}) {
    SimplifyParams params;
    params.stages = simplify_stages(0.125, 0.0);
    const Simplification with = expect_simplified(mesh, "flipped", params);
    EXPECT_GT(with.flips[static_cast<std::size_t>(FlipOutcome::flipped)], 5);
    const Simplification without =
        expect_simplified(mesh, "not flipped", params, {.flips_edges = false});
    EXPECT_EQ(without.flips[static_cast<std::size_t>(FlipOutcome::flipped)], 0);
    EXPECT_LT(10 * with.levels.back().patch_count, 9 * without.levels.back().patch_count);
  }
}

TEST(SimplifySurface, IsDeterministicAndScaleFree) {
  const Simplification one = test::simplify(test::wavy_ball(9)),
                       two = test::simplify(test::wavy_ball(9)),
                       large = test::simplify(test::wavy_ball(9, 1024.0));
  ASSERT_EQ(one.levels.size(), two.levels.size());
  ASSERT_EQ(one.levels.size(), large.levels.size());
  for (std::size_t i = 0; i < one.levels.size(); ++i) {
    EXPECT_EQ(one.levels[i].mesh.positions, two.levels[i].mesh.positions);
    EXPECT_EQ(one.levels[i].mesh.triangles, two.levels[i].mesh.triangles);
    EXPECT_EQ(one.levels[i].parent, two.levels[i].parent);
    EXPECT_EQ(one.levels[i].patch_of_triangle, two.levels[i].patch_of_triangle);
    EXPECT_EQ(one.levels[i].mesh.triangles, large.levels[i].mesh.triangles) << "a power of two";
  }
}

TEST(SimplifySurface, KeepsTheRimOfAFlatSheetInPlace) {
  const Simplification s = test::simplify(make_sheet(2, 1, 16, 8));
  EXPECT_NEAR(mass_properties(s.levels.back().mesh).area, 2.0, 0.3);
  for (const Vec3& p : s.levels.back().mesh.positions) EXPECT_EQ(p.z(), 0.0);
}

TEST(SimplifySurface, CarriesSupportAndCornerValues) {
  const TriangleMesh mesh = test::wavy_ball(6);
  std::vector<std::array<double, 2>> support;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    support.push_back({1.0 + static_cast<double>(v), 2000.0 - static_cast<double>(v)});
  CornerAttributes values;
  values.width = 1;
  for (const Vec3& p : mesh.positions) values.values.push_back(p.x());
  for (const auto& t : mesh.triangles)
    values.of_corner.insert(values.of_corner.end(), t.begin(), t.end());
  const Simplification s = simplify_surface({mesh, compute_topology(mesh), decompose_surface(mesh)},
                                            test::generous(), support, values);
  const SimplifiedLevel& last = s.levels.back();
  ASSERT_EQ(last.support.size(), last.mesh.positions.size());
  double least = 1e300, largest = 0.0;
  for (const auto& d : last.support) {
    least = std::min(least, d[0]);
    largest = std::max(largest, d[0]);
    EXPECT_LE(d[0] + d[1], 2001.0) << "the least of each on its own";
  }
  EXPECT_EQ(least, 1.0) << "the least of all survives";
  EXPECT_LT(largest, static_cast<double>(mesh.positions.size()));
  double error = 0.0;  // the value was x: still near it
  for (std::size_t t = 0; t < last.mesh.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const auto value = static_cast<std::size_t>(last.attributes.of_corner[3 * t + k]);
      const auto v = static_cast<std::size_t>(last.mesh.triangles[t][k]);
      error =
          std::max(error, std::fabs(last.attributes.values[value] - last.mesh.positions[v].x()));
    }
  EXPECT_LT(error, 0.4);
}

TEST(SimplifySurface, IsSoundOnRealMeshes) {
  THIGMA_NEEDS_SHARED(folder);
  for (const char* name :
       {"a01_dental_cast_upper", "a07_bolt_m16_loose", "a08_nut_m16_loose", "a12_mug_ycb"}) {
    const auto path = folder / "meshes" / (std::string(name) + ".obj");
    const TriangleMesh mesh = load_usable_mesh(path.string(), 1.0, true);
    EXPECT_GE(expect_simplified(mesh, name, {}).levels.size(), 5u) << name;
  }
}

}  // namespace
}  // namespace thigma
