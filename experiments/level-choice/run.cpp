// What s0 buys: the shipped scenes in the hand, queried again at thresholds from 0.05 to 20 %, exactly, and by a point
// shell; and whether s0 between 1 and 5 % decides the level of a contact by its area (Sec. 3.4.3, 3.5.2).

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/common/all_experiments.h"
#include "experiments/level-choice/casts.h"
#include "experiments/level-choice/study.h"

namespace thigma::experiments {
namespace level_choice {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();
constexpr double kPath = 0.025;  // the path is led at this
const std::vector<double> kThresholds = {0.0, 0.0005, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.2, kNone};
const std::vector<double> kFewThresholds = {0.0, 0.01, 0.025, 0.05, kNone};
const std::vector<double> kAsked = {0.01, 0.025, 0.05, kNone};  // between them levels have to change

struct Scene {
  const char* name;
  double seconds;  // of the session
  int quick_triangles;
};

constexpr Scene kScenes[] = {{"jaws", 3.0, 0},
                             {"golf", 3.0, 24'000},
                             {"ball_joint", 2.0, 24'000},
                             {"cup_spoon", 3.0, 24'000}};

std::size_t place_of(const std::vector<double>& thresholds, double s0) {
  return static_cast<std::size_t>(std::find(thresholds.begin(), thresholds.end(), s0) - thresholds.begin());
}

/// Least factor by which something grows from one of the asked thresholds to the next.
template <class Get>
double least_growth(const std::vector<double>& thresholds, const std::vector<Choice>& choices, Get get) {
  double least = kNone;
  for (std::size_t i = 1; i < kAsked.size(); ++i)
    least = std::min(least, get(choices[place_of(thresholds, kAsked[i])]) /
                                get(choices[place_of(thresholds, kAsked[i - 1])]));
  return least;
}

/// Compared with a bound where it is known to hold; otherwise a number beside the goal, which the text of the claim names.
Claim judge(bool is_judged, Claim claim) {
  return is_judged ? claim : stated(claim.id, claim.text, claim.value.value_or(std::nan("")), claim.unit);
}

void add_claims(const std::string& name, double radius, const std::vector<double>& thresholds,
                const std::vector<Choice>& choices, std::vector<Claim>& claims) {
  const Choice& main = choices[place_of(thresholds, kPath)];
  claims.push_back(judge(name != "cup_spoon",
                         at_least("grows-" + name,
                                  name + ": original triangles below a contact, from s0 = 1 to 2.5, 5 % and no metric at all: "
                                         "least growth from one to the next (goal 1.3)",
                                  least_growth(thresholds, choices, [](const Choice& c) { return c.triangles; }), 1.3)));
  if (name == "jaws" || name == "casts")
    claims.push_back(judge(name == "jaws",
                           at_least("at-once-" + name,
                                    name + ": levels among the contacts of one frame at 2.5 %, most (goal 4)",
                                    main.levels_at_once, 4.0)));
  claims.push_back(stated("costs-" + name, name + ": least growth of the error of the force between the same (goal 1)",
                          least_growth(thresholds, choices, [](const Choice& c) { return c.force_error; })));
  claims.push_back(stated("area-" + name,
                          name + ": rank correlation of a contact's level at 2.5 % with its area by the exact query (goal 0.5)",
                          main.area_rank));
  // Either is enough: an interval as small as 1 % of the radius says something whatever the error.
  claims.push_back(stated("interval-" + name,
                          name + ": interval the bounds leave for the least separation at 2.5 %, median: over 20 times its "
                                 "error or over 1 % of the radius, the lesser (goal 1)",
                          std::fmin(main.interval_ratio / 20.0, main.interval / radius / 0.01)));
}

void add_rows(const std::string& name, double radius, const std::vector<Setting>& settings,
              const std::vector<Choice>& choices, Outcome& outcome) {
  plot::Series error{.label = name, .mark = plot::Mark::line_and_points}, time = error, below = error;
  for (std::size_t k = 0; k < settings.size(); ++k) {
    const Choice& c = choices[k];
    add_row(outcome.tables[0],
            {name, settings[k].name, c.triangles, c.contacts, c.front, c.query, c.force_error, c.recall,
             c.separation_error / radius, c.interval / radius, c.interval_ratio, c.area_rank,
             static_cast<double>(c.levels_at_once)});
    if (!(settings[k].threshold > 0.0) || !std::isfinite(settings[k].threshold)) continue;
    for (plot::Series* one : {&error, &time, &below}) one->x.push_back(100.0 * settings[k].threshold);
    error.y.push_back(c.force_error);
    time.y.push_back(1e6 * c.query);
    below.y.push_back(c.triangles);
  }
  outcome.figure.panels[0].series.push_back(error);
  outcome.figure.panels[1].series.push_back(time);
  outcome.figure.panels[2].series.push_back(below);
}

plot::Panel panel_of(const char* title, const char* label) {
  return {.title = title,
          .x = {.label = "s0 [% of the radius]", .is_log = true},
          .y = {.label = label, .is_log = true},
          .guides = {{"2.5 %", 2.5, true}}};
}

}  // namespace
}  // namespace level_choice

Outcome run_level_choice(const Context& context) {
  using namespace level_choice;
  Outcome outcome;
  outcome.tables = {{.columns = {"scene", "s0", "triangles below a contact", "contacts", "front",
                                 "query CPU p50 [s]", "force error", "recall", "least separation error / radius",
                                 "interval / radius", "interval / error", "rank of level and area",
                                 "levels at once"}}};
  outcome.figure = {.title = "What s0 buys",
                    .note = "shipped scenes in the simulated hand, paths led at 2.5 %; levels against the exact contacts",
                    .panels = {panel_of("Error of the force", "RMS error / RMS exact"),
                               panel_of("Query", "CPU time p50 [us]"),
                               panel_of("Level", "original triangles below a contact")},
                    .columns = 3,
                    .width = 1500,
                    .panel_height = 360};
  const std::vector<double>& thresholds = context.quick ? kFewThresholds : kThresholds;
  std::vector<Setting> settings;
  for (const double s0 : thresholds) settings.push_back(setting_at(s0));
  const auto add = [&](const std::string& name, const SessionPair& session) {
    tell(context, name);
    const double radius = std::min(session.config.contact.object->radius,
                                   session.config.contact.scene.front().hierarchy->radius);
    const TouchedPair pair = touch(session, kPath);
    const std::vector<Choice> choices = measure(pair, settings, context.quick ? 8 : 32);
    add_rows(name, radius, settings, choices, outcome);
    add_claims(name, radius, thresholds, choices, outcome.claims);
  };
  for (const Scene& scene : kScenes)
    add(scene.name, session_pair(*context.assets, scene.name, context.quick ? 1.0 : scene.seconds,
                                 context.quick ? scene.quick_triangles : 0));
  if (const auto casts = casts_session(*context.assets, context.quick ? 1.0 : 3.0)) add("casts", *casts);
  else tell(context, "casts: left out, THIGMA_SHARED names no folder with meshes");
  return outcome;
}

}  // namespace thigma::experiments
