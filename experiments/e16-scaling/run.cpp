// Protocol E16 (docs/sources.md): how query time, front, memory and build time grow with the number
// of triangles.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "experiments/common/all_experiments.h"
#include "experiments/common/contact_profile.h"
#include "experiments/common/hands.h"
#include "experiments/common/hierarchy_bytes.h"
#include "experiments/common/statistics.h"

#include "thigma/math/quantile.h"

namespace thigma::experiments {
namespace e16_scaling {
namespace {

/// One count of triangles.
struct Size {
  double triangles = 0.0;                          // of both objects
  double build = 0.0;                              // CPU [s]
  double bytes = 0.0;                              // of both hierarchies
  double exact = 0.0, coarse = 0.0, capped = 0.0;  // query CPU, median along the path [s]
  double exact_front = 0.0, coarse_front = 0.0;
};

double median(const Profile& profile, const Span& span) {
  return sample_quantile(cut(profile.cpu, span), 0.5);
}

/// The path of the jaws at their own count, played at this one.
Size measure(const Context& context, const Path& path, int triangles) {
  Assets assets;  // of this count alone: the large ones do not stay
  const Pair pair = scene_pair(assets, "jaws", triangles, true);
  const PenaltyParams gains = direct_gains(pair, 0.01);
  Size size;
  size.triangles = pair.object->triangle_count + pair.scene->triangle_count;
  for (const auto& [uri, seconds] : assets.seconds) size.build += seconds;
  size.bytes = hierarchy_bytes(*pair.object) + hierarchy_bytes(*pair.scene);
  tell(context, "jaws of " + std::to_string(triangles) + " triangles");
  Resolution capped = as_in_text(0.025);
  capped.deviation_cap = 0.02;
  const Profile exact = replay(pair, path, as_in_text(0.0), gains);
  const Profile coarse = replay(pair, path, as_in_text(0.025), gains, 3);
  const Span span = in_contact(exact);
  size.exact = median(exact, span);
  size.coarse = median(coarse, span);
  size.capped = median(replay(pair, path, capped, gains, 3), span);
  size.exact_front = sample_quantile(cut(exact.front, span), 0.5);
  size.coarse_front = sample_quantile(cut(coarse.front, span), 0.5);
  return size;
}

/// A quantity of the sizes as a column, with its exponent.
struct Growth {
  const char* id;
  const char* text;
  double Size::*value;
};

constexpr Growth kGrowths[] = {{"exact", "exact query time", &Size::exact},
                               {"capped", "query time at 2.5 % with the 2 % cap", &Size::capped},
                               {"exact-front", "exact front", &Size::exact_front},
                               {"front", "front at 2.5 %", &Size::coarse_front},
                               {"build", "build time", &Size::build},
                               {"memory", "memory of the levels", &Size::bytes}};

std::vector<double> column(const std::vector<Size>& sizes, double Size::*value) {
  std::vector<double> v;
  for (const Size& s : sizes) v.push_back(s.*value);
  return v;
}

std::string interval(const LineFit& fit) {
  char text[64];
  std::snprintf(text, sizeof text, " (95 %%: %.2f to %.2f)", fit.slope_low, fit.slope_high);
  return text;
}

plot::Series curve(const char* label, const std::vector<Size>& sizes, double Size::*value,
                   double scale) {
  plot::Series s{.label = label,
                 .x = column(sizes, &Size::triangles),
                 .y = column(sizes, value),
                 .mark = plot::Mark::line_and_points};
  for (double& y : s.y) y *= scale;
  return s;
}

}  // namespace
}  // namespace e16_scaling

Outcome run_e16_scaling(const Context& context) {
  using namespace e16_scaling;
  std::vector<int> counts = {1000, 3000, 10'000, 30'000, 100'000};
  if (!context.quick) counts.insert(counts.end(), {300'000, 1'000'000});
  const Pair jaws = scene_pair(*context.assets, "jaws");
  HandScript hand = jaws_hand(jaws.radius);
  if (context.quick) hand.seconds = 0.6;
  const Path path = record_path(jaws, as_in_text(0.025), direct_gains(jaws, 0.01), hand);
  std::vector<Size> sizes;
  for (const int count : counts) sizes.push_back(measure(context, path, count));

  Outcome outcome;
  outcome.tables = {
      {.columns = {"triangles of both", "build CPU [s]", "memory [B]", "exact query CPU p50 [s]",
                   "query CPU p50 at 2.5 % [s]", "the same with the 2 % cap [s]", "exact front p50",
                   "front p50 at 2.5 %"}}};
  for (const Size& s : sizes) {
    add_row(outcome.tables[0], {s.triangles, s.build, s.bytes, s.exact, s.coarse, s.capped,
                                s.exact_front, s.coarse_front});
  }
  const std::vector<double> triangles = column(sizes, &Size::triangles);
  const LineFit main = fit_power(triangles, column(sizes, &Size::coarse));
  const Claim sublinear = on_this_machine(
      below("sublinear",
            "exponent of query time at s0 = 2.5 % in the number of triangles" + interval(main),
            main.slope, 0.5));
  const std::size_t last = sizes.size() - 1;
  const double end_slope = std::log(sizes[last].coarse / sizes[last - 1].coarse) /
                           std::log(sizes[last].triangles / sizes[last - 1].triangles);
  char why[200];
  std::snprintf(why, sizeof why,
                "the query grows with the small models and levels off: over the last step, to %.0f "
                "triangles, the "
                "exponent is %.2f; a whole run goes on to two million",
                sizes[last].triangles, end_slope);
  outcome.claims = {context.quick ? known_not_to(sublinear, {why, "data.csv", 0.8}) : sublinear};
  for (const Growth& g : kGrowths) {
    const LineFit fit = fit_power(triangles, column(sizes, g.value));
    outcome.claims.push_back(
        stated(g.id, std::string("exponent of ") + g.text + interval(fit), fit.slope));
  }
  const auto panel = [](const char* title, const char* label) {
    return plot::Panel{.title = title,
                       .x = {.label = "triangles of both jaws", .is_log = true},
                       .y = {.label = label, .is_log = true}};
  };
  outcome.figure = {
      .title = "Growth with the number of triangles (E16)",
      .note = "jaws, one path, medians in contact",
      .panels = {panel("Contact query", "CPU time [us]"), panel("Front", "node pairs"),
                 panel("Build, both jaws", "CPU time [s]"), panel("Memory, both jaws", "[MB]")},
      .columns = 2,
      .width = 1100,
      .panel_height = 300};
  outcome.figure.panels[0].series = {curve("exact", sizes, &Size::exact, 1e6),
                                     curve("s0 = 2.5 %", sizes, &Size::coarse, 1e6),
                                     curve("s0 = 2.5 %, cap 2 %", sizes, &Size::capped, 1e6)};
  outcome.figure.panels[1].series = {curve("exact", sizes, &Size::exact_front, 1.0),
                                     curve("s0 = 2.5 %", sizes, &Size::coarse_front, 1.0)};
  outcome.figure.panels[2].series = {curve("", sizes, &Size::build, 1.0)};
  outcome.figure.panels[3].series = {curve("", sizes, &Size::bytes, 1e-6)};
  return outcome;
}

}  // namespace thigma::experiments
