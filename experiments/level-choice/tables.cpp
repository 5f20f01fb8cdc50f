#include "experiments/level-choice/tables.h"

#include <algorithm>
#include <cmath>

namespace thigma::experiments::level_choice {
namespace {

constexpr double kAsked[] = {0.01, 0.025, 0.05, kNoMetric};  // between them levels have to change
constexpr double kMebi = 1024.0 * 1024.0;
// Where the figure has what is of no threshold [%].
constexpr double kExactPlace = 0.025, kShellPlace = 40.0;

plot::Panel panel_of(const char* title, const char* label) {
  return {.title = title,
          .x = {.label = "s0 [% of the radius]", .is_log = true, .low = 0.018, .high = 60.0},
          .y = {.label = label, .is_log = true},
          .guides = {{"exact", kExactPlace, true},
                     {"2.5 %", 100.0 * kShipped, true},
                     {"shell", kShellPlace, true}}};
}

void add_row_of(const Studied& pair, const std::string& setting, const Choice& c, double build,
                Table& table) {
  add_row(table, {pair.name,
                  setting,
                  c.triangles,
                  c.contacts,
                  c.front,
                  c.query,
                  c.force_error,
                  c.shared_error,
                  c.recall,
                  c.separation_error / pair.radius,
                  c.bounds / pair.radius,
                  c.interval / pair.radius,
                  c.interval_ratio,
                  c.outside,
                  c.divided,
                  c.narrowing,
                  c.area_rank,
                  c.levels_at_once,
                  c.bytes / kMebi,
                  build});
}

/// A curve over the thresholds, and dots of the same colour where there is none.
template <class Get>
void add_curve(const Studied& pair, int color, plot::Panel& panel, Get get) {
  std::string label = pair.name;
  std::replace(label.begin(), label.end(), '_', ' ');
  plot::Series curve{.label = label, .mark = plot::Mark::line_and_points, .color = color};
  plot::Series dots{.mark = plot::Mark::points, .color = color};
  for (std::size_t k = 0; k < pair.settings.size(); ++k) {
    const double s0 = pair.settings[k].threshold;
    if (!std::isfinite(s0)) continue;
    plot::Series& to = s0 > 0.0 ? curve : dots;
    to.x.push_back(s0 > 0.0 ? 100.0 * s0 : kExactPlace);
    to.y.push_back(get(pair.study.choices[k]));
  }
  dots.x.push_back(kShellPlace);
  dots.y.push_back(get(pair.study.shell));
  panel.series.push_back(curve);
  panel.series.push_back(dots);
}

}  // namespace

const Choice& choice_at(const Studied& pair, double s0) {
  std::size_t i = 0;
  while (pair.settings[i].threshold != s0) ++i;
  return pair.study.choices[i];
}

Outcome empty_outcome() {
  Outcome outcome;
  outcome.tables = {
      {.columns = {"scene",
                   "s0",
                   "triangles below a contact",
                   "contacts",
                   "front",
                   "query CPU p50 [s]",
                   "force error",
                   "force error, shared stiffness",
                   "recall",
                   "least separation error / radius",
                   "bounds / radius",
                   "interval / radius",
                   "interval / error",
                   "poses outside",
                   "pairs divided",
                   "narrowing CPU p50 [s]",
                   "rank of level and area",
                   "levels at once",
                   "memory [MiB]",
                   "shell build CPU [s]"}},
      {.name = "growth",
       .columns = {"scene", "quantity", "from", "to", "growth", "95 % low", "95 % high"}},
      {.name = "area",
       .columns = {"scene", "what", "rank correlation", "contacts", "commonest level",
                   "region p90 / p10", "95 % low", "95 % high"}}};
  outcome.figure = {
      .title = "What s0 buys",
      .note =
          "five scenes led at 2.5 %, asked again at the same poses; dots: the exact query (left), "
          "a "
          "point shell (right)",
      .panels = {panel_of("Error of the force, stiffness shared", "RMS error / RMS exact"),
                 panel_of("Query", "CPU time p50 [us]"),
                 panel_of("Level", "original triangles below a contact"),
                 panel_of("Contacts", "mean number")},
      .columns = 2,
      .width = 1100,
      .panel_height = 330};
  return outcome;
}

std::vector<Step> steps_of(const Studied& pair) {
  constexpr std::uint64_t kSeed = 1;
  std::vector<Step> steps;
  for (std::size_t i = 1; i < std::size(kAsked); ++i) {
    const Choice &from = choice_at(pair, kAsked[i - 1]), &to = choice_at(pair, kAsked[i]);
    steps.push_back({setting_at(kAsked[i - 1]).name, setting_at(kAsked[i]).name,
                     growth_between(from.below, to.below, false, kSeed),
                     growth_between(from.error, to.error, true, kSeed),
                     growth_between(from.shared, to.shared, true, kSeed)});
  }
  return steps;
}

void add_rows(const Studied& pair, Outcome& outcome) {
  const PairStudy& study = pair.study;
  for (std::size_t k = 0; k < pair.settings.size(); ++k)
    add_row_of(pair, pair.settings[k].name, study.choices[k], std::nan(""), outcome.tables[0]);
  add_row_of(pair, "point shell", study.shell, pair.shell_build, outcome.tables[0]);
  for (const Step& s : steps_of(pair)) {
    const auto add = [&](const char* what, const Growth& g) {
      add_row(outcome.tables[1], {pair.name, what, s.from, s.to, g.value, g.low, g.high});
    };
    add("triangles below a contact", s.below);
    add("force error", s.error);
    add("force error, shared stiffness", s.shared);
  }
  for (const AreaRank& r : study.ranks)
    add_row(outcome.tables[2],
            {pair.name, r.what, r.rank, r.count, study.commonest_level, study.region_spread.value,
             study.region_spread.low, study.region_spread.high});
  const int color = static_cast<int>(outcome.figure.panels[0].series.size() / 2);
  add_curve(pair, color, outcome.figure.panels[0], [](const Choice& c) { return c.shared_error; });
  add_curve(pair, color, outcome.figure.panels[1], [](const Choice& c) { return 1e6 * c.query; });
  add_curve(pair, color, outcome.figure.panels[2], [](const Choice& c) { return c.triangles; });
  add_curve(pair, color, outcome.figure.panels[3], [](const Choice& c) { return c.contacts; });
}

}  // namespace thigma::experiments::level_choice
