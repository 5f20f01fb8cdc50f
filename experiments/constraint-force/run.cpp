// What the hand feels under constraints: against the coupling's law on the ideal proxy, over
// divisions of the surfaces, places and yaws, and from little to much travel of the hand.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "experiments/common/all_experiments.h"
#include "experiments/constraint-force/ideal_proxy.h"
#include "experiments/constraint-force/presses.h"

namespace thigma::experiments {
namespace constraint_force {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
void add(const char* series, const std::string& name, const ProxyPace& pace, const ProxyQuality& q,
         Outcome& outcome) {
  add_row(outcome.tables[0], {series, name, pace.seconds, 1000.0 / pace.every, pace.slop,
                              100.0 * q.magnitude, q.mean_angle / kDegree,
                              q.largest_angle / kDegree, q.largest, q.stray, 100.0 * q.held_back});
}

/// Claims on magnitude and direction.
void claim_scene(const std::string& id, const std::string& name, const ProxyQuality& q,
                 Outcome& outcome) {
  if (q.largest == 0.0) {
    outcome.claims.push_back(at_most("stray-" + id, name + ": largest force where none should be",
                                     1e3 * q.stray, 10.0, "mN"));
    return;
  }
  outcome.claims.push_back(
      at_most("magnitude-" + id, name + ": error of magnitude", 100.0 * q.magnitude, 1.0, "%"));
  outcome.claims.push_back(at_most("direction-" + id, name + ": error of direction, mean",
                                   q.mean_angle / kDegree, 1.0, "deg"));
}

/// How fast the hand may slide. An eighth of the circle is 39 mm.
void run_speeds(bool is_quick, Outcome& outcome) {
  const ProxySprings springs;
  constexpr double kCritical = 14.0;  // of 1 kN/m and 50 g: nothing rings [N s/m]
  for (const double seconds : {10.0, 2.5, 0.6}) {
    for (const int every : {1, 3, 10, 33}) {
      if (is_quick && every == 3) continue;
      const ProxyPace pace{.seconds = seconds, .every = every, .damping = kCritical};
      const ProxyQuality q = judge_proxy(finer_balls(100, 2.0, springs), springs, pace);
      add("speed", "twice as fine", pace, q, outcome);
      const double speed = 39.0 / seconds;  // [mm/s]
      if (every != 10 || seconds == 10.0) continue;
      char what[96];
      std::snprintf(what, sizeof what,
                    "spheres twice as fine at %.0f mm/s with contacts at 100 Hz: error of "
                    "direction, mean",
                    speed);
      outcome.claims.push_back(at_most(seconds == 2.5 ? "direction-2-seldom" : "direction-2-fast",
                                       what, q.mean_angle / kDegree, 2.0, "deg"));
    }
  }
}

void run_balls(bool is_quick, Outcome& outcome) {
  const ProxySprings springs;
  // Slow: what facets do, not what speed does.
  const ProxyPace slow{.seconds = 10.0};
  for (const double finer : {0.5, 1.0, 2.0, 4.0}) {
    char name[32];
    std::snprintf(name, sizeof name, "%g times as fine", finer);
    const ProxyQuality q = judge_proxy(finer_balls(100, finer, springs), springs, slow);
    add("balls", name, slow, q, outcome);
    if (finer != 1.0) continue;
    outcome.claims.push_back(stated("magnitude-2-coarse",
                                    "spheres of the meshes of e2-force-quality, an eighth of the "
                                    "circle: error of magnitude, by their facets",
                                    100.0 * q.magnitude, "%"));
    outcome.claims.push_back(stated("direction-2-coarse", "the same: error of direction, mean",
                                    q.mean_angle / kDegree, "deg"));
  }
  run_speeds(is_quick, outcome);
}

/// Pegs are turned slowly and cost much.
ProxyPace pace_of(const ProxyScene& scene) {
  return {.seconds = 20.0, .every = scene.scene.has_torque ? 20 : 1};
}

/// The peg of the widest hole: what its stand-off does on E2's path, and turned farther.
void run_widest(const ProxyScene& peg, Outcome& outcome) {
  const ProxySprings springs;
  const std::string& name = peg.scene.name;
  ProxyPace pace = pace_of(peg);
  for (const double slop : {10.0, 5.0, 2.0, 1.0}) {
    pace.slop = slop;
    add("slop", name, pace, judge_proxy(peg, springs, pace), outcome);
  }
  const ProxyScene farther = farther_peg(peg);
  const ProxyQuality q = judge_proxy(farther, springs, pace_of(farther));
  add("farther", name, pace_of(farther), q, outcome);
  claim_scene("6-farther", name + ", turned as far beyond the touch as E2's path in 0.02 mm", q,
              outcome);
}

void run_scenes(const Context& context, Outcome& outcome) {
  const ProxySprings springs;
  int index = 0;
  for (const ProxyScene& scene : proxy_scenes(context.quick ? 100 : 1000, springs)) {
    tell(context, scene.scene.name);
    const ProxyPace pace = pace_of(scene);
    const ProxyQuality q = judge_proxy(scene, springs, pace);
    add("scene", scene.scene.name, pace, q, outcome);
    claim_scene(std::to_string(++index), scene.scene.name, q, outcome);
    if (index == 6) run_widest(scene, outcome);
  }
}

}  // namespace
}  // namespace constraint_force

Outcome run_constraint_force(const Context& context) {
  using namespace constraint_force;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"series", "scene", "time of the path [s]", "contact rate [Hz]", "stand-off",
                   "magnitude error [%]", "direction error, mean [deg]", "largest [deg]",
                   "largest ideal [N or N m]", "stray [N or N m]", "frames held back [%]"}},
      {.name = "spread",
       .columns = {"series", "what", "force [N]", "force, potential [N]",
                   "potential law alone [N]"}},
      {.name = "law",
       .columns = {"series", "what", "travel [mm]", "force [N]", "law [N]", "off [%]",
                   "contacts"}}};
  outcome.figure = {.title = "Force in the hand over its travel beyond the touch, constraints",
                    .panels = {{.x = {.label = "travel [mm]"}, .y = {.label = "force [N]"}}},
                    .panel_height = 380};
  run_scenes(context, outcome);
  tell(context, "finer spheres");
  run_balls(context.quick, outcome);
  run_presses(context, outcome);
  return outcome;
}

}  // namespace thigma::experiments
