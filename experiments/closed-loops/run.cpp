// Energy that slow closed loops hand out, with constraints, the penalty and the potential.

#include <algorithm>
#include <limits>
#include <string>

#include "experiments/closed-loops/loops.h"
#include "experiments/common/all_experiments.h"

namespace thigma::experiments {
namespace closed_loops_study {
namespace {

constexpr double kMicro = 1e-6;

/// Most that a cycle hands out; 0: none does; infinite where not all of them were made [J].
double handed_out(const LoopRun& run, int cycles) {
  double most = static_cast<int>(run.put_in.size()) == cycles - 1
                    ? 0.0
                    : std::numeric_limits<double>::infinity();
  for (const double e : run.put_in) most = std::max(most, -e);
  return most;
}

const char* name_of(const LedGains& gains) {
  return gains.is_potential ? "potential" : gains.is_constrained ? "constraint" : "penalty";
}

void add(const Loop& loop, const LedGains& gains, bool is_reversed, const LoopRun& run,
         Outcome& outcome) {
  for (std::size_t i = 0; i < run.put_in.size(); ++i) {
    add_row(outcome.tables[0], {loop.name, name_of(gains), 1000.0 / gains.every,
                                is_reversed ? "backwards" : "forwards", static_cast<double>(i + 2),
                                run.put_in[i] / kMicro, run.force, run.energy_min / kMicro,
                                static_cast<double>(run.held_back)});
  }
}

/// Most that a cycle hands out [uJ].
struct Most {
  double constraint = 0.0, penalty = 0.0, potential = 0.0;
};

Most run_responses(const Context& context, const Loop& loop, int cycles, Outcome& outcome) {
  Most most;
  double* const of[3] = {&most.constraint, &most.penalty, &most.potential};
  for (const int response : {0, 1, 2}) {
    for (const int every : {1, 10}) {
      // An area takes milliseconds.
      if (context.quick && every == (response == 1 ? 10 : response == 2 ? 1 : 0)) continue;
      LedGains gains;
      gains.is_constrained = response == 0;
      gains.is_potential = response == 2;
      gains.every = every;
      gains.contact_stiffness = loop.contact_stiffness;
      for (const bool is_reversed : {false, true}) {
        const LoopRun run = run_loop(loop, gains, is_reversed, cycles);
        add(loop, gains, is_reversed, run, outcome);
        *of[response] = std::max(handed_out(run, cycles) / kMicro, *of[response]);
      }
    }
  }
  return most;
}

/// The potential law without a session: what either direction hands out [uJ].
double run_alone(const Context& context, const Loop& loop, Outcome& outcome) {
  double most = 0.0;
  for (const bool is_reversed : {false, true}) {
    const LawLoop run = run_law(loop, is_reversed, context.quick ? 1000 : 4000);
    add_row(outcome.tables[1], {loop.name, is_reversed ? "backwards" : "forwards",
                                run.handed_out / kMicro, run.put_in / kMicro, run.force});
    most = std::max(most, run.handed_out / kMicro);
  }
  return most;
}

}  // namespace
}  // namespace closed_loops_study

Outcome run_closed_loops(const Context& context) {
  using namespace closed_loops_study;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"loop", "response", "contact rate [Hz]", "direction", "cycle",
                   "energy put in [uJ]", "largest force [N]", "least energy [uJ]",
                   "frames held back"}},
      {.name = "law",
       .columns = {"loop", "direction", "handed out [uJ]", "put in [uJ]", "largest force [N]"}}};
  outcome.figure = {.title = "Energy that a slow closed loop hands out",
                    .note = "the worst cycle, either direction; below 0.001 uJ drawn there",
                    .panels = {{.x = {.label = "loop"},
                                .y = {.label = "handed out a cycle [uJ]", .is_log = true}}},
                    .panel_height = 380};
  plot::Panel& panel = outcome.figure.panels[0];
  plot::Series constraint{.label = "constraint", .mark = plot::Mark::points};
  plot::Series penalty{.label = "penalty", .mark = plot::Mark::points};
  plot::Series potential{.label = "potential", .mark = plot::Mark::points};
  double penalty_most = 0.0;
  const int cycles = context.quick ? 3 : 5;
  for (const Loop& loop : closed_loops(context.quick ? 4000 : 40'000)) {
    tell(context, loop.name);
    const Most most = run_responses(context, loop, cycles, outcome);
    const double law = run_alone(context, loop, outcome);
    std::string id = loop.name;
    std::replace(id.begin(), id.end(), ' ', '-');
    outcome.claims.push_back(at_most(id, loop.name + ": most that a cycle hands out, constraint",
                                     most.constraint, 1.0, "uJ"));
    outcome.claims.push_back(at_most("potential-" + id, loop.name + ": the same with the potential",
                                     most.potential, 1.0, "uJ"));
    outcome.claims.push_back(at_most(
        "law-" + id, "the same of the potential law alone, no damper beside it", law, 1.0, "uJ"));
    outcome.claims.push_back(
        stated("penalty-" + id, "the same with the penalty", most.penalty, "uJ"));
    penalty_most = std::max(penalty_most, most.penalty);
    constraint.x.push_back(static_cast<double>(constraint.x.size()));
    constraint.y.push_back(std::max(most.constraint, 1e-3));
    penalty.x.push_back(constraint.x.back());
    penalty.y.push_back(std::max(most.penalty, 1e-3));
    potential.x.push_back(constraint.x.back());
    potential.y.push_back(std::max(most.potential, 1e-3));
    panel.x.categories.push_back(loop.name);
  }
  panel.series = {constraint, penalty, potential};
  panel.guides = {{"1 uJ", 1.0}};
  outcome.claims.push_back(at_least("penalty",
                                    "most that any of the loops hands out with the penalty",
                                    penalty_most, 10.0, "uJ"));
  return outcome;
}

}  // namespace thigma::experiments
