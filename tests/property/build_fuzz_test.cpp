// Builds of perturbed and broken meshes: built, or refused with a reason. `scripts/test` runs a
// few, `--full` the thousand; the sanitizer presets turn every slip of memory into a failure.

#include <cstdio>
#include <map>

#include "support/broken_mesh.h"
#include "support/check_hierarchy.h"
#include "support/check_levels.h"
#include "support/full.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/core/error.h"
#include "thigma/import/inspect.h"
#include "thigma/import/repair.h"

namespace thigma {
namespace {

struct Outcomes {
  int built_as_is = 0, built_repaired = 0, levels = 0;
  std::map<std::string, int> refused;  // by the end of the reason, which names no numbers
};

/// Half of the builds at limits under which so few triangles have levels at all.
ClodParams params_of(int number) {
  ClodParams params;
  if (number % 2 == 0) return params;
  params.simplify.stages = simplify_stages(0.5, 0.5);
  params.simplify.deviation_limit = 0.08;
  return params;
}

void build(const TriangleMesh& mesh, int number, Outcomes& outcomes) {
  ClodReport report;
  const ClodHierarchy h = build_clod(mesh, params_of(number), &report);
  EXPECT_EQ(check_hierarchy(h, mesh).total(), 0);
  const LevelCheck check = check_levels(*report.simplification, decompose_surface(mesh));
  EXPECT_EQ(check.total() - check.changed_surfaces, 0);
  outcomes.levels += static_cast<int>(report.simplification->levels.size());
}

TEST(BuildFuzz, BuildsOrSaysWhyNot) {
  const int rounds = test::is_full() ? 1000 : 60;
  Outcomes outcomes;
  for (int number = 0; number < rounds; ++number) {
    SCOPED_TRACE("mesh " + std::to_string(number));
    TriangleMesh mesh = test::broken_mesh(number);
    ASSERT_LE(mesh.triangles.size(), 5000u);
    const bool is_impossible = number % 10 == 9;
    if (is_impossible) mesh = test::with_impossible_value(std::move(mesh), number);
    try {
      // As the program does it, and, for two in three of the possible ones, without a second look.
      const bool is_usable =
          inspect_mesh(mesh, {.self_intersections = false}).verdict == MeshVerdict::usable;
      if (is_impossible || (number % 3 == 0 && !is_usable)) {
        build(repair_mesh(mesh, "mesh").mesh, number, outcomes);
        ++outcomes.built_repaired;
      } else {
        build(mesh, number, outcomes);
        ++outcomes.built_as_is;
      }
    } catch (const InputError& error) {
      const std::string reason = error.what();
      EXPECT_GT(reason.size(), 20u);
      ++outcomes.refused[reason.substr(reason.rfind(", ") + 2)];
    }
  }
  std::printf("  %d builds as they are, %d after repair, %d levels\n", outcomes.built_as_is,
              outcomes.built_repaired, outcomes.levels);
  for (const auto& [reason, count] : outcomes.refused)
    std::printf("  %4d refused: %s\n", count, reason.c_str());
  EXPECT_GT(outcomes.built_as_is, rounds / 4);
  EXPECT_GT(outcomes.built_repaired, 0);
  EXPECT_FALSE(outcomes.refused.empty());
}

}  // namespace
}  // namespace thigma
