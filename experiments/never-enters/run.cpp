// Whether objects enter each other: pressed, slid, twisted and tapped at four contact rates, with
// the constrained response and beside it with the penalty, looked at by code outside the engine.

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/common/all_experiments.h"
#include "experiments/never-enters/levels.h"
#include "experiments/never-enters/play.h"

#include "thigma/math/infinity.h"
#include "thigma/math/quantile.h"

namespace thigma::experiments {
namespace never_enters {
namespace {

constexpr int kEvery[] = {1, 3, 10, 33};
constexpr double kMicro = 1e-6;
constexpr double kEntered = 50.0;  // [um]

double share(const std::vector<double>& values, double at) {
  return values.empty() ? 0.0 : sample_quantile(values, at);
}

void add(const LedPair& pair, const Play& how, const Ran& ran, Outcome& outcome) {
  const LedRun& run = ran.run;
  add_row(outcome.tables[0], {pair.name,
                              how.is_constrained ? "constraint" : "penalty",
                              1000.0 / how.every,
                              ran.at_rest / kMicro,
                              ran.ever / kMicro,
                              static_cast<double>(run.held_back),
                              static_cast<double>(run.frames),
                              run.energy_min,
                              run.energy_end,
                              ran.force,
                              1e3 * ran.buzz,
                              1e6 * ran.drift,
                              share(run.query, 0.5) / kMicro,
                              share(run.query, 0.99) / kMicro,
                              share(run.solve, 0.5) / kMicro,
                              share(run.solve, 0.99) / kMicro,
                              run.summary.step_cpu.p50 / kMicro,
                              share(run.rows, 0.5),
                              share(run.rows, 1.0),
                              run.summary.end == SessionEnd::fault ? 1.0 : 0.0});
}

/// Deepest of a scene's runs, in micrometres.
struct Deepest {
  double rest = 0.0, fast = 0.0, slow = 0.0, penalty = 0.0, energy = 0.0;
  double late = 0.0;                              // with models that come late
  double buzz = 0.0, buzz_30 = 0.0, drift = 0.0;  // [N, N, m/s]
  double pressed = kInfinity;                     // force at the end, least [N]
  int unlike = 0, faults = 0;
};

void note(const Play& how, const Ran& ran, Deepest& deepest) {
  const double ever = ran.ever / kMicro;
  if (!how.is_constrained) {
    deepest.penalty = std::max(deepest.penalty, ever);
    return;
  }
  deepest.rest = std::max(deepest.rest, ran.at_rest / kMicro);
  double& rate = how.every <= 3 ? deepest.fast : deepest.slow;
  rate = std::max(rate, ever);
  deepest.energy = std::min(deepest.energy, ran.run.energy_min);
  deepest.pressed = std::min(deepest.pressed, ran.force);
  double& buzz = how.every == 33 ? deepest.buzz_30 : deepest.buzz;
  buzz = std::max(buzz, ran.buzz);
  deepest.drift = std::max(deepest.drift, ran.drift);
  deepest.unlike += ran.run.unlike;
  deepest.faults += ran.run.summary.end == SessionEnd::fault;
}

void claim(const LedPair& pair, const Deepest& deepest, Outcome& outcome) {
  const std::string& name = pair.name;
  std::string id = name;
  std::replace(id.begin(), id.end(), ' ', '-');
  const double rest = std::max(1.0, 10.0 * pair.reach);  // 1e-5 of it, in micrometres
  outcome.claims.push_back(at_most("rest-" + id,
                                   name + ": deepest at rest, at any contact rate (1 um, or "
                                          "1e-5 of the object's radius)",
                                   deepest.rest, rest, "um"));
  outcome.claims.push_back(at_most("fast-" + id,
                                   name + ": deepest ever with contacts at 1000 and 333 Hz",
                                   deepest.fast, 20.0, "um"));
  outcome.claims.push_back(
      at_most("slow-" + id, name + ": the same at 100 and 30 Hz", deepest.slow, 50.0, "um"));
}

/// Claims on an object at rest under a hand at rest.
void claim_rest(const Deepest& worst, Outcome& outcome) {
  outcome.claims.push_back(at_most("buzz",
                                   "force above 50 Hz under a hand at rest, rms, the worst scene, "
                                   "contacts at 1000, 333 and 100 Hz",
                                   1e3 * worst.buzz, 1.0, "mN"));
  outcome.claims.push_back(at_most("buzz-30", "the same at 30 Hz", 1e3 * worst.buzz_30, 1.0, "mN"));
  // What it was when models of rows faded by their age, as others do.
  for (const double age : {0.025, 0.030, 0.035, 0.045})
    add_row(outcome.tables[1], {1e3 * age, 1e3 * buzz_of_age(age)});
  outcome.claims.push_back(
      at_most("drift", "drift of the object there, any rate", 1e6 * worst.drift, 1.0, "um/s"));
}

/// Tables and the figure, empty.
Outcome blank() {
  Outcome outcome;
  outcome.tables = {
      {.columns = {"scene",
                   "response",
                   "contact rate [Hz]",
                   "depth at rest [um]",
                   "depth ever [um]",
                   "frames held back",
                   "frames",
                   "least energy [J]",
                   "energy at the end [J]",
                   "force at the end [N]",
                   "above 50 Hz at rest [mN rms]",
                   "drift at rest [um/s]",
                   "contact step p50 [us]",
                   "contact step p99 [us]",
                   "solve p50 [us]",
                   "solve p99 [us]",
                   "haptic step p50 [us]",
                   "rows p50",
                   "rows most",
                   "fault"}},
      {.name = "age",
       .columns = {"models count fully up to [ms]", "cube at rest, 30 Hz: above 50 Hz [mN rms]"}},
      {.name = "late",
       .columns = {"scene", "models late by [ms]", "depth ever [um]", "depth at rest [um]",
                   "frames held back", "frames"}}};
  outcome.figure = {
      .title = "How deep objects enter each other, pressed by 9 mm of hand travel at 1 kN/m",
      .note =
          "the larger of depths at four contact rates; looked at from outside the engine; what "
          "is less than 0.01 um is drawn there",
      .panels = {{.x = {.label = "scene"}, .y = {.label = "depth [um]", .is_log = true}}},
      .panel_height = 420};
  outcome.figure.panels[0].series = {{.label = "constraint", .mark = plot::Mark::points},
                                     {.label = "penalty", .mark = plot::Mark::points}};
  outcome.figure.panels[0].guides = {{"333 Hz and more", 20.0}, {"30 Hz and more", 50.0}};
  return outcome;
}

/// Models that come late: the object has moved since they were made, and may have passed rows that
/// they have and those before did not.
void play_late(const Seen& seen, const PressedScene& scene, Outcome& outcome, Deepest& deepest) {
  for (const int latency : {4, 8, 12}) {
    const Play how{.is_constrained = true, .every = 1, .look = 7, .latency = latency};
    const Ran ran = play(seen, scene, how);
    add_row(outcome.tables[2],
            {seen.pair.name, static_cast<double>(latency), ran.ever / kMicro, ran.at_rest / kMicro,
             static_cast<double>(ran.run.held_back), static_cast<double>(ran.run.frames)});
    deepest.late = std::max(deepest.late, ran.ever / kMicro);
  }
}

/// Plays one scene in all ways.
Deepest run_scene(const Context& context, const PressedScene& scene, Outcome& outcome) {
  Seen seen{.pair = scene.make(), .object = {}, .scene = {}};
  tell(context, seen.pair.name);
  seen.object = make_depth_surface(seen.pair.object);
  seen.scene = make_depth_surface(seen.pair.scene);
  Deepest deepest;
  for (const bool is_constrained : {true, false}) {
    for (const int every : kEvery) {
      // The penalty is only there to be seen beside it.
      if (context.quick && !is_constrained && every != 10) continue;
      const Play how{is_constrained, every, context.quick ? 29 : 5};
      const Ran ran = play(seen, scene, how);
      add(seen.pair, how, ran, outcome);
      note(how, ran, deepest);
    }
  }
  if (scene.name == "jaws" || scene.name == "ball joint") play_late(seen, scene, outcome, deepest);
  claim(seen.pair, deepest, outcome);
  plot::Panel& panel = outcome.figure.panels[0];
  for (plot::Series& series : panel.series)
    series.x.push_back(static_cast<double>(panel.x.categories.size()));
  panel.series[0].y.push_back(std::max({deepest.fast, deepest.slow, 0.01}));
  panel.series[1].y.push_back(std::max(deepest.penalty, 0.01));
  panel.x.categories.push_back(seen.pair.name);
  return deepest;
}

}  // namespace
}  // namespace never_enters

Outcome run_never_enters(const Context& context) {
  using namespace never_enters;
  Outcome outcome = blank();
  std::vector<PressedScene> scenes = built_in_scenes(context.quick ? 2000 : 0);
  const std::vector<PressedScene> real = real_scenes();
  if (real.empty()) tell(context, "real meshes: left out, THIGMA_SHARED names no folder with them");
  if (!context.quick) scenes.insert(scenes.end(), real.begin(), real.end());
  int entered_by_penalty = 0;
  Deepest worst;
  for (const PressedScene& scene : scenes) {
    const Deepest deepest = run_scene(context, scene, outcome);
    entered_by_penalty += deepest.penalty > kEntered;
    worst.energy = std::min(worst.energy, deepest.energy);
    worst.pressed = std::min(worst.pressed, deepest.pressed);
    worst.buzz = std::max(worst.buzz, deepest.buzz);
    worst.buzz_30 = std::max(worst.buzz_30, deepest.buzz_30);
    worst.drift = std::max(worst.drift, deepest.drift);
    worst.late = std::max(worst.late, deepest.late);
    worst.unlike += deepest.unlike;
    worst.faults += deepest.faults;
  }
  outcome.claims.push_back(
      at_least("penalty", "share of the scenes that the penalty lets in by more than 50 um",
               static_cast<double>(entered_by_penalty) / static_cast<double>(scenes.size()), 0.8));
  outcome.claims.push_back(at_least(
      "pressed", "force at the end of any run, constraint: the object is there to be pressed",
      worst.pressed, 0.1, "N"));
  outcome.claims.push_back(at_least("energy",
                                    "least energy at the port of any scene and rate, constraint",
                                    worst.energy, -1e-6, "J"));
  claim_rest(worst, outcome);
  outcome.claims.push_back(at_most("late",
                                   "jaws and ball joint, models 4, 8 and 12 ms late: deepest ever",
                                   worst.late, 20.0, "um"));
  play_levels(context, outcome);
  outcome.claims.push_back(
      at_most("faults", "runs that a fault ended, constraint", worst.faults, 0.0));
  outcome.claims.push_back(at_most("counted",
                                   "frames that come out otherwise when they are computed again "
                                   "to count those held back",
                                   worst.unlike, 0.0));
  return outcome;
}

}  // namespace thigma::experiments
