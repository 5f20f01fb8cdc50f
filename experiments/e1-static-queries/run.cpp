// Protocol E1 (docs/sources.md): single queries without coherence at predefined distances,
// same-object pairs (Trenkel, Weller, Zachmann 2007), negative distances too (Diktas, Sahiner).

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "benchmarks/probe.h"
#include "experiments/common/all_experiments.h"
#include "experiments/common/distance.h"
#include "experiments/common/replay.h"
#include "experiments/common/statistics.h"

#include "thigma/math/quantile.h"
#include "thigma/math/random.h"

namespace thigma::experiments {
namespace e1_static_queries {
namespace {

constexpr double kDistances[] = {-0.02, -0.01, -0.005, -0.001, 0.0, 0.001, 0.002,
                                 0.005, 0.01,  0.02,   0.05,   0.1, 0.2,   0.3};
constexpr const char* kModels[] = {"jaw_lower", "golf_ball"};

/// Poses at each distance. Where two golf balls of a million triangles are 2 % of their size deep
/// an exact query takes most of a second, so a tenth of the poses is drawn there.
int pose_count(const Context& context, int triangles) {
  if (context.quick) return 16;
  return triangles < 1'000'000 ? 1000 : 100;
}

struct Way {
  const char* name;
  Resolution resolution;
};

std::array<Way, 3> ways() {
  Resolution capped = as_in_text(0.025);
  capped.deviation_cap = 0.02;
  return {{{"exact", as_in_text(0.0)},
           {"s0 = 2.5 %", as_in_text(0.025)},
           {"s0 = 2.5 %, cap 2 %", capped}}};
}

/// Times and errors of one distance, for each way.
struct AtDistance {
  std::array<std::vector<double>, 3> seconds;
  std::array<std::vector<double>, 3> errors;  // of the smallest separation, over the size
  std::array<std::vector<double>, 3> contacts;
};

double size_of(const ClodHierarchy& h) {
  Vec3 low = h.vertices.front(), high = low;
  for (const Vec3& v : h.vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  return (high - low).maxCoeff();
}

/// Pose at a distance; a negative one is so far beyond the first touch.
Placed place(const ClodHierarchy& h, Random& random, double distance, double size) {
  Pose start;
  start.orientation = random.orientation();
  const Vec3 direction = random.direction();
  start.position = h.center - start.orientation._transformVector(h.center) -
                   (2.2 * h.radius + 0.4 * size) * direction;
  Placed placed = place_at_distance(h, start, direction, h, std::max(distance, 0.0), 1e-6 * size);
  if (distance < 0.0) placed.pose.position -= distance * direction;
  return placed;
}

void ask(const ClodHierarchy& h, const Pose& pose, double tolerance, double size,
         std::array<ContactFront, 3>& fronts, ContactSet& set, AtDistance& out) {
  double exact = 0.0;
  const auto all = ways();
  for (std::size_t w = 0; w < all.size(); ++w) {
    clear(set);
    clear_front(fronts[w]);
    const double start = bench::thread_cpu();
    query_contacts({h, pose}, {h}, {.tolerance = tolerance, .resolution = all[w].resolution},
                   fronts[w], set);
    out.seconds[w].push_back(bench::thread_cpu() - start);
    out.contacts[w].push_back(static_cast<double>(set.contacts.size()));
    const double least = least_distance(set);
    if (w == 0) exact = least;
    if (std::isfinite(least) && std::isfinite(exact))
      out.errors[w].push_back(std::fabs(least - exact) / size);
  }
}

/// One model at one count, all distances.
std::vector<AtDistance> measure(const Context& context, const ClodHierarchy& h, int poses) {
  std::vector<AtDistance> result;
  const double size = size_of(h), tolerance = 0.01 * h.radius;
  std::array<ContactFront, 3> fronts;
  for (ContactFront& f : fronts) reserve_front(f, h, h);
  ContactSet set;
  set.contacts.reserve(400'000);
  for (const double d : kDistances) {
    Random random(context.seed);  // the same orientations and directions at every distance
    AtDistance at;
    for (int i = 0; i < poses; ++i) {
      const Placed placed = place(h, random, d * size, size);
      if (placed.is_met) ask(h, placed.pose, tolerance, size, fronts, set, at);
    }
    result.push_back(std::move(at));
  }
  return result;
}

/// Mean times over the distances up to touch, where the query has something to find.
struct Curves {
  std::array<std::vector<double>, 3> near_means;
  std::vector<double> triangles;
};

void add_rows(const char* model, const ClodHierarchy& h, const std::vector<AtDistance>& all,
              Outcome& outcome, Curves& curves) {
  const auto names = ways();
  for (std::size_t w = 0; w < names.size(); ++w) {
    std::vector<double> near;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::vector<double>& s = all[i].seconds[w];
      add_row(outcome.tables[0],
              {model, static_cast<double>(h.triangle_count), names[w].name, kDistances[i],
               static_cast<double>(s.size()), mean(s), sample_quantile(s, 0.99),
               sample_quantile(s, 1.0), mean(all[i].contacts[w]), mean(all[i].errors[w]),
               sample_quantile(all[i].errors[w], 1.0)});
      if (std::fabs(kDistances[i]) <= 0.002) near.insert(near.end(), s.begin(), s.end());
    }
    curves.near_means[w].push_back(mean(near));
  }
  curves.triangles.push_back(h.triangle_count);
}

plot::Series over_distance(const char* label, const std::vector<AtDistance>& all, std::size_t way) {
  plot::Series s{.label = label, .mark = plot::Mark::line_and_points};
  for (std::size_t i = 0; i < all.size(); ++i) {
    s.x.push_back(100.0 * kDistances[i]);
    s.y.push_back(1e6 * mean(all[i].seconds[way]));
  }
  return s;
}

std::string interval(const LineFit& fit) {
  char text[64];
  std::snprintf(text, sizeof text, " (95 %%: %.2f to %.2f)", fit.slope_low, fit.slope_high);
  return text;
}

}  // namespace
}  // namespace e1_static_queries

Outcome run_e1_static_queries(const Context& context) {
  using namespace e1_static_queries;
  std::vector<int> counts = {1000, 3000, 10'000, 30'000, 100'000};
  if (!context.quick) counts.push_back(1'000'000);
  Outcome outcome;
  outcome.tables = {{.columns = {"model", "triangles", "query", "distance / size", "poses",
                                 "CPU mean [s]", "CPU p99 [s]", "CPU max [s]", "contacts mean",
                                 "error mean / size", "error max / size"}}};
  outcome.figure = {.title = "Static queries at predefined distances (E1)",
                    .note =
                        "same-object pairs, random orientations and directions, no coherence; "
                        "tolerance 1 % of the radius",
                    .columns = 2,
                    .width = 1100,
                    .panel_height = 330};
  for (const char* model : kModels) {
    Curves curves;
    for (const int count : counts) {
      tell(context, std::string(model) + " of " + std::to_string(count) + " triangles");
      Assets own{.kept = context.assets->kept};
      const ClodHierarchy& h = levels_of(own, model_uri(model, count));
      const std::vector<AtDistance> all = measure(context, h, pose_count(context, count));
      add_rows(model, h, all, outcome, curves);
      if (count != counts.back()) continue;
      outcome.figure.panels.push_back(
          {.title = std::string(model) + ", " + std::to_string(count) + " triangles",
           .x = {.label = "distance [% of the size]"},
           .y = {.label = "mean CPU time [us]", .is_log = true},
           .series = {over_distance("exact", all, 0), over_distance("s0 = 2.5 %", all, 1),
                      over_distance("s0 = 2.5 %, cap 2 %", all, 2)}});
    }
    plot::Panel growth{.title = std::string(model) + ", within 0.2 % of touch",
                       .x = {.label = "triangles", .is_log = true},
                       .y = {.label = "mean CPU time [us]", .is_log = true}};
    const auto names = ways();
    for (std::size_t w = 0; w < names.size(); ++w) {
      plot::Series s{.label = names[w].name,
                     .x = curves.triangles,
                     .y = curves.near_means[w],
                     .mark = plot::Mark::line_and_points};
      for (double& y : s.y) y *= 1e6;
      growth.series.push_back(s);
      const LineFit fit = fit_power(curves.triangles, curves.near_means[w]);
      const std::string text = std::string("exponent of a fresh query near touch, ") + model +
                               ", " + names[w].name + interval(fit);
      const std::string id = std::string(w == 0   ? "exact-"
                                         : w == 1 ? "sublinear-"
                                                  : "capped-") +
                             model;
      outcome.claims.push_back(w == 1 ? on_this_machine(below(id, text, fit.slope, 0.5))
                                      : stated(id, text, fit.slope));
    }
    outcome.figure.panels.push_back(growth);
  }
  double worst = 0.0;
  for (const Claim& c : outcome.claims) {
    if (c.bound && c.value) worst = std::max(worst, *c.value);
  }
  outcome.claims.insert(
      outcome.claims.begin(),
      on_this_machine(below("sublinear",
                            "query time at s0 = 2.5 % grows slower than triangles^0.5: largest "
                            "exponent of the models",
                            worst, 0.5)));
  return outcome;
}

}  // namespace thigma::experiments
