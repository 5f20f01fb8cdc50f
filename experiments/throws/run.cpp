// Objects thrown at a plate of 0.1 mm: none may pass; and what holding them back costs in the air.

#include <algorithm>
#include <string>

#include "experiments/common/all_experiments.h"
#include "experiments/throws/in_the_air.h"
#include "experiments/throws/thrown.h"

namespace thigma::experiments {
namespace throws {
namespace {

constexpr std::int64_t kQuick = 200, kWhole = 10'000;
// Where between two contact frames the hand sets out is chance: whether one comes just before a
// touch, or just after.
constexpr int kStarts = 8;
constexpr int kDiscs = 3;  // of kAirPairs

ThrowCount throw_all(const ThrowWorld& world, std::uint64_t seed, std::int64_t throws,
                     bool is_constrained) {
  ThrowCount count;
  for (std::int64_t i = 0; i < throws; ++i) {
    const Throw one = make_throw(seed, static_cast<std::uint64_t>(i));
    add_throw(one, run_throw(world, one, is_constrained), count);
  }
  return count;
}

double as_double(std::int64_t n) { return static_cast<double>(n); }

double share(std::int64_t part, std::int64_t all) {
  return as_double(part) / std::max(1.0, as_double(all));
}

void add(const char* response, const ThrowCount& count, Outcome& outcome) {
  for (std::size_t i = 0; i < kThrowEvery.size(); ++i) {
    add_row(outcome.tables[0],
            {response, 1000.0 / kThrowEvery[i], as_double(count.thrown[i]),
             as_double(count.passed[i]), as_double(count.entered[i]), as_double(count.faults[i])});
  }
}

plot::Series shares(const char* label, const ThrowCount& count) {
  plot::Series series{.label = label, .mark = plot::Mark::line_and_points};
  for (std::size_t i = 0; i < kThrowEvery.size(); ++i) {
    series.x.push_back(1000.0 / kThrowEvery[i]);
    series.y.push_back(100.0 * as_double(count.passed[i]) /
                       std::max(1.0, as_double(count.thrown[i])));
  }
  return series;
}

void claim_throws(const ThrowCount& constraint, const ThrowCount& penalty, Outcome& outcome) {
  const double thrown = as_double(total(constraint.thrown));
  outcome.claims = {
      at_most("passed", "throws that pass the plate, constraint",
              as_double(total(constraint.passed)), 0.0),
      at_most("entered", "throws with a vertex below the plate's top in any frame, constraint",
              as_double(total(constraint.entered)), 0.0),
      at_most("faults", "share of the throws that a fault ended, constraint",
              as_double(total(constraint.faults)) / thrown, 0.01),
      at_least("touched", "share of the throws in which the plate was pressed",
               as_double(constraint.touched) / thrown, 0.5),
      at_least("penalty", "share of the same throws that pass with the penalty",
               as_double(total(penalty.passed)) / thrown, 0.05),
      stated("held-back", "share of all frames in which a throw was held back, constraint",
             as_double(constraint.held_back) / as_double(constraint.frames))};
}

/// At one speed and rate; from as many starts between two contact frames.
AirRun run_pair(int pair, double speed, int every, int starts, Outcome& outcome) {
  AirRun run;
  for (int k = 0; k < starts; ++k)
    add_air_run(run_in_the_air(pair, speed, every, 1.0, k / as_double(starts)), run);
  add_row(outcome.tables[1], {kAirPairs[pair], speed, 1000.0 / every, as_double(run.air_frames),
                              as_double(run.air_held), as_double(run.near_frames),
                              as_double(run.near_held), 1e3 * run.lag, run.phantom});
  return run;
}

/// Of all pairs but the discs.
AirRun run_pairs(double speed, int every, int starts, Outcome& outcome) {
  AirRun all;
  for (int pair = 0; pair < kDiscs; ++pair)
    add_air_run(run_pair(pair, speed, every, starts, outcome), all);
  return all;
}

void run_air(Outcome& outcome) {
  AirRun fast;
  for (const int every : {1, 3}) add_air_run(run_pairs(0.5, every, kStarts, outcome), fast);
  for (const double ahead : {0.25, 0.5, 1.0, 2.0}) {
    const AirRun run = run_in_the_air(1, 0.5, 3, ahead);
    add_row(outcome.tables[2],
            {ahead, as_double(run.air_held), as_double(run.near_held), 1e3 * run.lag, run.phantom});
  }
  std::vector<Claim> claims = {
      at_most("air-held", "frames held back in the air, 0.5 m/s, contacts at 1000 and 333 Hz",
              fast.air_held, 0.0),
      at_most("near-held", "share of the frames held back within 5 mm of contact, the same",
              share(fast.near_held, fast.near_frames), 0.01),
      at_most("lag", "how far behind in the air the object is for the scene's sake, over the speed",
              1e3 * fast.lag, 3.0, "ms"),
      at_most("phantom", "force in the air that is there for the scene's sake", fast.phantom, 0.02,
              "N")};
  for (const auto& [speed, every, name] :
       {std::tuple{0.5, 10, "0.5 m/s, 100 Hz"}, std::tuple{0.5, 33, "0.5 m/s, 30 Hz"},
        std::tuple{5.0, 1, "5 m/s, 1000 Hz"}, std::tuple{5.0, 33, "5 m/s, 30 Hz"}}) {
    const AirRun run = run_pairs(speed, every, 1, outcome);
    const std::string id =
        std::to_string(static_cast<int>(10.0 * speed)) + "-" + std::to_string(every);
    claims.push_back(
        stated("lag-" + id, std::string("lag in the air at ") + name, 1e3 * run.lag, "ms"));
    claims.push_back(
        stated("phantom-" + id, std::string("force in the air at ") + name, run.phantom, "N"));
  }
  AirRun discs;
  for (const int every : {1, 3}) add_air_run(run_pair(kDiscs, 0.5, every, kStarts, outcome), discs);
  claims.push_back(at_most("discs-held",
                           "share of the frames in the air in which conforming discs, which have "
                           "thousands of pairs near when they touch, are held back, 0.5 m/s, "
                           "contacts at 1000 and 333 Hz",
                           share(discs.air_held, discs.air_frames), 0.02));
  claims.push_back(stated("discs-near", "the same within 5 mm of contact",
                          share(discs.near_held, discs.near_frames)));
  for (Claim& claim : claims) outcome.claims.push_back(std::move(claim));
}

}  // namespace
}  // namespace throws

Outcome run_throws(const Context& context) {
  using namespace throws;
  Outcome outcome;
  outcome.tables = {{.columns = {"response", "contact rate [Hz]", "thrown", "passed", "entered",
                                 "ended by a fault"}},
                    {.name = "air",
                     .columns = {"pair", "speed [m/s]", "contact rate [Hz]", "frames in the air",
                                 "of these held back", "frames within 5 mm", "of these held back ",
                                 "lag [ms]", "force in the air [N]"}},
                    {.name = "ahead",
                     .columns = {"looks ahead, over the most of the engine",
                                 "ball over ball, 333 Hz: frames held back in the air",
                                 "within 5 mm", "lag [ms]", "force in the air [N]"}}};
  const ThrowWorld world = make_throw_world();
  const std::int64_t throws = context.quick ? kQuick : kWhole;
  tell(context, std::to_string(throws) + " throws with constraints");
  const ThrowCount constraint = throw_all(world, context.seed, throws, true);
  tell(context, "the same with the penalty");
  const ThrowCount penalty = throw_all(world, context.seed, throws, false);
  add("constraint", constraint, outcome);
  add("penalty", penalty, outcome);
  outcome.figure = {
      .title = "Objects thrown at a plate of 0.1 mm",
      .note = "0.05 to 5 m/s, to 50 rad/s, 5 to 200 g, couplings to 1 kN/m",
      .panels = {{.x = {.label = "contact rate [Hz]", .is_log = true},
                  .y = {.label = "passed [%]", .low = 0.0},
                  .series = {shares("constraint", constraint), shares("penalty", penalty)}}}};
  claim_throws(constraint, penalty, outcome);
  tell(context, "in the air");
  run_air(outcome);
  return outcome;
}

}  // namespace thigma::experiments
