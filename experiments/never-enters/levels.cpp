#include "experiments/never-enters/levels.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "experiments/never-enters/play.h"

#include "thigma/math/quantile.h"

namespace thigma::experiments::never_enters {
namespace {

constexpr double kMicro = 1e-6;
constexpr double kExact = 0.0;
constexpr std::array kThresholds{kExact, 0.0025, 0.01, 0.025, 0.05};
constexpr std::array kEvery{1, 3, 10};

/// Over all scenes.
struct Worst {
  double rest = 0.0;              // over what is allowed at rest
  double fast = 0.0, slow = 0.0;  // at 333 Hz and more, and below [um]
  double exact_coarse = 0.0, coarse = 0.0;
};

std::vector<PressedScene> scenes_of(const Context& context) {
  std::vector<PressedScene> chosen;
  for (PressedScene& scene : built_in_scenes(context.quick ? 2000 : 0)) {
    const bool is_first = scene.name == "jaws";
    if (is_first || (!context.quick && (scene.name == "gears" || scene.name == "ball joint")))
      chosen.push_back(std::move(scene));
  }
  if (context.quick) return chosen;
  for (PressedScene& scene : real_scenes())
    if (scene.name == "casts") chosen.push_back(std::move(scene));
  return chosen;
}

double share(const std::vector<double>& values, double at) {
  return values.empty() ? 0.0 : sample_quantile(values, at);
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         std::max(static_cast<double>(values.size()), 1.0);
}

void add(const LedPair& pair, const Play& how, const Ran& ran, Table& table) {
  const LedRun& run = ran.run;
  add_row(table, {pair.name, 100.0 * how.threshold, 1000.0 / how.every, ran.at_rest / kMicro,
                  ran.ever / kMicro, static_cast<double>(run.held_back),
                  static_cast<double>(run.frames), share(run.query, 0.5) / kMicro,
                  share(run.query, 0.99) / kMicro, mean(run.query) / kMicro, share(run.rows, 0.5),
                  share(run.rows, 1.0), share(run.coarse, 0.5), share(run.coarse, 1.0)});
}

void note(const LedPair& pair, const Play& how, const Ran& ran, Worst& worst) {
  const double allowed = std::max(1.0, 10.0 * pair.reach);  // 1e-5 of it, in micrometres
  worst.rest = std::max(worst.rest, ran.at_rest / kMicro / allowed);
  double& ever = how.every <= 3 ? worst.fast : worst.slow;
  ever = std::max(ever, ran.ever / kMicro);
  double& coarse = how.threshold == kExact ? worst.exact_coarse : worst.coarse;
  coarse = std::max(coarse, share(ran.run.coarse, 1.0));
}

void play_scene(const Context& context, const PressedScene& scene, Outcome& outcome, Worst& worst) {
  Seen seen{.pair = scene.make(), .object = {}, .scene = {}};
  tell(context, "levels: " + seen.pair.name);
  const LedPair exact = seen.pair, levelled = with_levels(seen.pair);
  seen.object = make_depth_surface(seen.pair.object);
  seen.scene = make_depth_surface(seen.pair.scene);
  for (const double threshold : kThresholds) {
    for (const int every : kEvery) {
      if (context.quick && (every != 3 || (threshold != kExact && threshold != 0.025))) continue;
      const Play how{true, every, context.quick ? 29 : 17, threshold};
      seen.pair = threshold == kExact ? exact : levelled;  // each on the tree that a user has
      const Ran ran = play(seen, scene, how);
      add(seen.pair, how, ran, outcome.tables.back());
      note(seen.pair, how, ran, worst);
    }
  }
}

}  // namespace

void play_levels(const Context& context, Outcome& outcome) {
  outcome.tables.push_back(
      {.name = "levels",
       .columns = {"scene", "s0 [% of the smaller radius; 0 exact]", "contact rate [Hz]",
                   "depth at rest [um]", "depth ever [um]", "frames held back", "frames",
                   "contact step p50 [us]", "contact step p99 [us]", "contact step mean [us]",
                   "rows p50", "rows most", "coarse pairs p50", "coarse pairs most"}});
  Worst worst;
  for (const PressedScene& scene : scenes_of(context)) play_scene(context, scene, outcome, worst);
  outcome.claims.push_back(at_most("levels-rest",
                                   "far pairs coarse, any s0: deepest at rest, of 1 um or 1e-5 of "
                                   "the object's radius",
                                   worst.rest, 1.0));
  outcome.claims.push_back(
      at_most("levels-fast", "the same ever, contacts at 1000 and 333 Hz", worst.fast, 20.0, "um"));
  if (!context.quick)
    outcome.claims.push_back(at_most("levels-slow", "at 100 Hz", worst.slow, 50.0, "um"));
  outcome.claims.push_back(
      at_least("levels-coarse", "pairs that stay coarse in a model, most", worst.coarse, 1.0));
  outcome.claims.push_back(
      at_most("levels-exact", "the same of exact contacts", worst.exact_coarse, 0.0));
}

}  // namespace thigma::experiments::never_enters
