// Figs. 3.18, with small models, and 3.19. Claims about time are not tests.
#include "experiments/common/spoon_drop.h"

#include <algorithm>
#include <string>
#include <vector>

#include "experiments/common/all_experiments.h"
#include <gtest/gtest.h>

#include "thigma/scene/asset_cache.h"
#include "thigma/simulation/free_motion.h"

namespace thigma::experiments {
namespace {

ClodHierarchy kept_levels(const std::string& uri) {
  ClodSource source;
  source.name = uri;
  source.params.threads = 1;
  return load_clod_cached(source).hierarchy;
}

Assets& kept_assets() {
  static Assets assets{.kept = kept_levels};
  return assets;
}

Outcome run_quick(Outcome (*experiment)(const Context&)) {
  Context context;
  context.quick = true;
  context.assets = &kept_assets();
  return experiment(context);
}

void expect_claim(const Outcome& outcome, const std::string& id) {
  for (const Claim& claim : outcome.claims) {
    if (claim.id != id) continue;
    EXPECT_EQ(claim.kind, ClaimKind::checked) << id;
    EXPECT_FALSE(is_broken(claim)) << id << ": " << claim.value.value_or(-1.0);
    return;
  }
  ADD_FAILURE() << "no claim " << id;
}

TEST(SpoonDrop, VelocityMetricCoarsensTheFall) {
  const Outcome outcome = run_quick(run_fig_3_18);
  expect_claim(outcome, "coarser");
  expect_claim(outcome, "triangles");
}

// Fronts are counts: no time is in them. Where the query has much to look at the exact front leaps,
// and that with levels does not.
TEST(SpoonDrop, FrontIsSteadierWithLevelsWhereThereIsMuchToLookAt) {
  const Outcome outcome = run_quick(run_fig_3_19);
  const auto sweep = std::find_if(outcome.tables.begin(), outcome.tables.end(),
                                  [](const Table& t) { return t.name == "sweep"; });
  ASSERT_NE(sweep, outcome.tables.end());
  std::vector<double> steadier;
  for (const auto& row : sweep->rows) steadier.push_back(std::get<double>(row[3]));
  ASSERT_EQ(steadier.size(), 5u);
  EXPECT_LE(steadier.front(), 1.0);
  EXPECT_LT(steadier.back(), 0.5 * steadier.front());
}

// Energy never grows, surfaces never meet, and the same drop ends the same: at rest on the bottom,
// after sliding and rocking.
TEST(SpoonDrop, StaysInTheCup) {
  BodyState ends[2];
  for (BodyState& end : ends) {
    SpoonDrop drop = spoon_drop(kept_assets(), 8000);
    const RigidBody& body = drop.world.body;
    SimulationScratch scratch = reserve_simulation(drop.world);
    double gain = 0.0, growth = 0.0, energy = mechanical_energy(body, drop.start.body);
    SimulationPorts ports;
    ports.event = [&](const CollisionEvent& e) { gain = std::max(gain, e.energy_change); };
    ports.query = [&](const SimulationState& s, const ContactSet&) {
      const double now = mechanical_energy(body, s.body);
      growth = std::max(growth, now - energy);
      energy = now;
    };
    const SimulationCounts counts = simulate(drop.world, 10.0, drop.start, scratch, ports);
    const double scale = body.mass * 9.81 * 0.1;
    EXPECT_LE(gain, 1e-12 * scale);
    EXPECT_LE(growth, 1e-6 * scale);
    EXPECT_LE(counts.deepest, drop.world.tolerance);
    EXPECT_GT(counts.events, 5);
    EXPECT_GT(counts.supported, 100);
    EXPECT_EQ(counts.unresolved, 0);
    end = drop.start.body;
  }
  EXPECT_EQ(to_vector(ends[0]), to_vector(ends[1]));
}

}  // namespace
}  // namespace thigma::experiments
