// Protocol E14 (docs/sources.md): what is left of the forces when a query has to stop early, on two
// surfaces that fit each other.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "experiments/common/all_experiments.h"
#include "experiments/common/contact_profile.h"
#include "experiments/common/hands.h"
#include "experiments/common/statistics.h"
#include "experiments/e14-degradation/ways.h"

#include "thigma/math/elementary.h"
#include "thigma/math/quantile.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace e14_degradation {
namespace {

constexpr double kTestBudgets[] = {500, 1000, 2000, 4000, 8000, 16000};
constexpr double kTimeBudgets[] = {50e-6, 100e-6, 200e-6, 500e-6, 1000e-6, 2000e-6};  // [s]

/// Much to refine and little that cannot be left out: with the cap, which is off by default,
/// surfaces this near ask for thousands of tests.
Resolution capped() {
  Resolution resolution;
  resolution.is_exact = false;
  resolution.deviation_cap = 0.02;
  return resolution;
}

/// The upper disc hovers 0.1 mm above the lower one and slides, lifts and tilts by a little.
Path hover_path(double radius, int frames) {
  Path path;
  for (int i = 0; i < frames; ++i) {
    const double t = i * path.step;
    Pose pose;
    pose.position =
        radius * Vec3(1e-3 * sine(7.0 * t), 1e-3 * sine(5.0 * t), 5e-4 * (1.0 + sine(11.0 * t)));
    pose.orientation =
        rotation_from_vector(1e-4 * Vec3(sine(3.0 * t), sine(4.0 * t), 10.0 * sine(2.0 * t)));
    path.poses.push_back(pose);
  }
  return path;
}

/// One budget.
struct Result {
  Profile profile;
  // tests beyond the budget, or beyond the mandatory ones where those are more, most
  double excess = 0.0;
  double share_short = 0.0;  // of frames whose mandatory part alone is more than the budget
  double error = 0.0;        // of force and, over the radius, torque against the unlimited query
};

double error_of(const Profile& p, const Profile& unlimited, double radius) {
  std::vector<double> ours, theirs;
  for (std::size_t i = 0; i < p.force.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      ours.insert(ours.end(), {p.force[i][axis], p.torque[i][axis] / radius});
      theirs.insert(theirs.end(), {unlimited.force[i][axis], unlimited.torque[i][axis] / radius});
    }
  }
  return relative_error(ours, theirs);
}

Result run_tests(const Pair& pair, const Path& path, const PenaltyParams& gains,
                 const Profile& unlimited, double budget) {
  Resolution resolution = capped();
  resolution.budget_tests = static_cast<std::int64_t>(budget);
  Result r{.profile = replay(pair, path, resolution, gains, 1, ClusterStart::afresh)};
  for (std::size_t i = 0; i < r.profile.tests.size(); ++i) {
    r.excess = std::max(r.excess, r.profile.tests[i] - std::max(budget, r.profile.mandatory[i]));
    r.share_short +=
        (r.profile.mandatory[i] > budget ? 1.0 : 0.0) / static_cast<double>(r.profile.tests.size());
  }
  r.error = error_of(r.profile, unlimited, pair.radius);
  return r;
}

Result run_time(const Pair& pair, const Path& path, const PenaltyParams& gains,
                const Profile& unlimited, double budget) {
  Resolution resolution = capped();
  resolution.budget_cpu = budget;
  Result r{.profile = replay(pair, path, resolution, gains, 1, ClusterStart::afresh)};
  r.error = error_of(r.profile, unlimited, pair.radius);
  return r;
}

bool same_bits(const Profile& a, const Profile& b) {
  return a.tests == b.tests && a.force_size == b.force_size && a.bound == b.bound;
}

std::vector<Cell> row_of(const char* kind, double budget, const Result& r) {
  return {kind,
          budget,
          sample_quantile(r.profile.tests, 0.5),
          sample_quantile(r.profile.tests, 1.0),
          sample_quantile(r.profile.mandatory, 0.5),
          sample_quantile(r.profile.mandatory, 1.0),
          mean(r.profile.unrefined),
          1e6 * sample_quantile(r.profile.cpu, 0.5),
          1e6 * sample_quantile(r.profile.cpu, 0.99),
          1e6 * sample_quantile(r.profile.cpu, 0.999),
          r.error,
          r.share_short,
          sample_quantile(r.profile.bound, 0.5)};
}

/// Largest rise of the error from a budget to a larger one, over the error at the smallest.
double largest_rise(const std::vector<double>& errors) {
  double lowest = INFINITY, rise = 0.0;
  for (const double e : errors) {
    rise = std::max(rise, e - lowest);
    lowest = std::min(lowest, e);
  }
  return errors.front() > 0.0 ? rise / errors.front() : 0.0;
}

/// What the time budgets show.
struct TimeVerdict {
  double excess = 0.0;    // largest p99 over what is allowed, where the mandatory part fits
  double smallest = 0.0;  // budget that does [s]; 0: none
};

TimeVerdict judge(const std::vector<Result>& results, double one_test) {
  TimeVerdict verdict;
  // What cannot be left out, free levels and the front's validity: the smallest budget has time for
  // nothing else.
  const Profile& mandatory = results.front().profile;
  const double always = sample_quantile(mandatory.cpu, 0.99);
  const double price =
      sample_quantile(mandatory.cpu, 0.5) / sample_quantile(mandatory.mandatory, 0.5);
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Profile& p = results[i].profile;
    if (always > kTimeBudgets[i]) continue;
    if (verdict.smallest == 0.0) verdict.smallest = kTimeBudgets[i];
    // Frames that could keep the budget: the first ones of a front cannot.
    std::vector<double> cpu;
    for (std::size_t f = 0; f < p.cpu.size(); ++f) {
      if (p.mandatory[f] * price <= kTimeBudgets[i]) cpu.push_back(p.cpu[f]);
    }
    verdict.excess =
        std::max(verdict.excess, sample_quantile(cpu, 0.99) / (1.1 * kTimeBudgets[i] + one_test));
  }
  return verdict;
}

/// Times without a budget: the discs hover, jaws of as many triangles bite, led as they are at
/// their own count.
void add_ways(const Context& context, const WayStudy& discs, int triangles, Outcome& outcome) {
  Table table = way_table();
  std::vector<Claim> claims = study_ways(context, discs, table);
  const Pair led = scene_pair(*context.assets, "jaws");
  HandScript hand = jaws_hand(led.radius);
  hand.seconds = static_cast<double>(discs.path.poses.size()) * discs.path.step;
  const Path path = record_path(led, as_in_text(0.025), direct_gains(led, 0.01), hand);
  tell(context, "building two jaws of " + std::to_string(triangles) + " triangles");
  Assets own{.kept = context.assets->kept};
  const Pair jaws = scene_pair(own, "jaws", triangles);
  constexpr double kLimit = 1500.0;  // [us]
  constexpr int kStride = 20;
  const PenaltyParams gains = direct_gains(jaws, 0.01);
  for (const Claim& claim :
       study_ways(context, {"jaws", jaws, path, gains, kStride, kLimit}, table))
    claims.push_back(claim);
  outcome.tables.push_back(std::move(table));
  for (Claim& claim : claims) outcome.claims.push_back(std::move(claim));
}

}  // namespace
}  // namespace e14_degradation

Outcome run_e14_degradation(const Context& context) {
  using namespace e14_degradation;
  const int triangles = context.quick ? 100'000 : 1'000'000;
  Assets own{.kept = context.assets->kept};  // of these alone: the large ones do not stay
  const Pair pair = [&] {
    tell(context, "building two discs of " + std::to_string(triangles) + " triangles");
    Pair discs;
    discs.name = "conforming discs";
    discs.object = &levels_of(own, model_uri("conforming_upper", triangles));
    discs.scene = &levels_of(own, model_uri("conforming_lower", triangles));
    discs.radius = std::min(discs.object->radius, discs.scene->radius);
    return discs;
  }();
  const PenaltyParams gains = direct_gains(pair, 0.01);
  const Path path = hover_path(pair.radius, context.quick ? 600 : 10'000);
  tell(context, "unlimited");
  const Profile unlimited = replay(pair, path, capped(), gains, 1, ClusterStart::afresh);
  const double one_test = mean(unlimited.cpu) / mean(unlimited.tests);

  Outcome outcome;
  outcome.tables = {
      {.columns = {"budget in", "budget [tests, s]", "tests p50", "tests max", "mandatory p50",
                   "mandatory max", "unrefined mean", "CPU p50 [us]", "CPU p99 [us]",
                   "CPU p99.9 [us]", "error", "frames whose mandatory part exceeds it",
                   "largest bound p50 [m]"}}};
  add_row(outcome.tables[0], row_of("unlimited", 0.0, {.profile = unlimited}));
  plot::Series by_tests{.label = "budget in tests", .mark = plot::Mark::line_and_points};
  double excess = 0.0;
  bool is_reproducible = true;
  for (const double budget : kTestBudgets) {
    tell(context, std::to_string(static_cast<int>(budget)) + " tests");
    const Result r = run_tests(pair, path, gains, unlimited, budget);
    if (budget == 2000)
      is_reproducible =
          same_bits(r.profile, run_tests(pair, path, gains, unlimited, budget).profile);
    excess = std::max(excess, r.excess);
    add_row(outcome.tables[0], row_of("tests", budget, r));
    by_tests.x.push_back(budget);
    by_tests.y.push_back(r.error);
  }
  std::vector<Result> timed;
  plot::Series p99{.label = "p99 of CPU time", .mark = plot::Mark::line_and_points};
  plot::Series allowed{.label = "budget + 10 %", .is_dashed = true};
  plot::Series by_time{.label = "budget in time", .mark = plot::Mark::line_and_points};
  for (const double budget : kTimeBudgets) {
    tell(context, std::to_string(static_cast<int>(std::lround(1e6 * budget))) + " us");
    timed.push_back(run_time(pair, path, gains, unlimited, budget));
    add_row(outcome.tables[0], row_of("time", budget, timed.back()));
    for (plot::Series* s : {&p99, &allowed, &by_time}) s->x.push_back(1e6 * budget);
    p99.y.push_back(1e6 * sample_quantile(timed.back().profile.cpu, 0.99));
    allowed.y.push_back(1.1e6 * budget);
    by_time.y.push_back(timed.back().error);
  }
  const TimeVerdict verdict = judge(timed, one_test);
  outcome.claims = {
      at_most("tests",
              "tests beyond the budget, or beyond the mandatory part where that is more: most of "
              "any frame",
              excess, 0.0, "tests"),
      at_least("reproducible", "a budget of tests gives the same bits again (1: yes)",
               is_reproducible ? 1.0 : 0.0, 1.0),
      on_this_machine(at_most(
          "time",
          "p99 of CPU time over budget + 10 % + one test, of the frames whose mandatory part fits; "
          "largest of the budgets that hold the usual one",
          verdict.excess, 1.0)),
      stated("smallest",
             "smallest of the budgets 50, 100, 200, 500, 1000 and 2000 us that holds the mandatory "
             "part in 99 of "
             "100 frames",
             1e6 * verdict.smallest, "us"),
      at_most("falls",
              "error against the unlimited query falls as the budget of tests grows: largest rise "
              "over the first error",
              largest_rise(by_tests.y), 0.05),
      stated("p999", "p99.9 of CPU time without a budget",
             1e6 * sample_quantile(unlimited.cpu, 0.999), "us")};
  const std::string models = std::to_string(triangles) +
                             " triangles each, 0.1 mm apart at 10 cm radius, s0 = 2.5 %, cap 2 %";
  outcome.figure = {.title = "Queries that stop early (E14)",
                    .note = "conforming discs of " + models,
                    .panels = {{.title = "Error against the unlimited query",
                                .x = {.label = "budget [tests]", .is_log = true},
                                .y = {.label = "RMS error / RMS"},
                                .series = {by_tests}},
                               {.title = "The same",
                                .x = {.label = "budget [us]", .is_log = true},
                                .y = {.label = "RMS error / RMS"},
                                .series = {by_time}},
                               {.title = "Time kept",
                                .x = {.label = "budget [us]", .is_log = true},
                                .y = {.label = "CPU time [us]", .is_log = true},
                                .series = {p99, allowed}}},
                    .columns = 3,
                    .width = 1300,
                    .panel_height = 320};
  constexpr double kLimit = 800.0;  // [us]
  add_ways(context, {"discs", pair, path, gains, 0, kLimit}, triangles, outcome);
  return outcome;
}

}  // namespace thigma::experiments
