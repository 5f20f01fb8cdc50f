// Protocol E4 (docs/sources.md): energy at the device's port over the scenes, without delay, and 15
// ms late with and without the passivity controller.

#include <algorithm>
#include <cmath>
#include <limits>

#include "experiments/common/all_experiments.h"
#include "experiments/common/session_pair.h"

#include "thigma/device/hand.h"
#include "thigma/loop/passivity.h"
#include "thigma/scene/gain_task.h"
#include "thigma/scene/scene_file.h"
#include "thigma/session/session_config.h"

namespace thigma::experiments {
namespace e4_passivity {
namespace {

constexpr double kDelay = 0.015;  // [s]
// what energy_min is asked for: nearer zero is not told apart [J]
constexpr double kNothing = 1e-6;
constexpr double kAsked = 20.0;  // times nearer zero, of the controller
// The built-in scenes without relief; fig-5-12 and fig-4-14 have those with it.
constexpr const char* kScenes[] = {"jaws", "cup_spoon",  "simple_cup_spoon", "ellipsoid",
                                   "golf", "ball_joint", "conforming"};
constexpr int kQuickTriangles = 4000;

/// Gains as `tune` proposes them for this object and the simulated hand without delay.
void recommend(SessionConfig& config) {
  const GainProposal p = propose_gains(gain_task(describe_device("hand:"), config.haptic.body,
                                                 config.haptic.workspace, config.rate));
  Coupling& c = config.haptic.coupling;
  c.linear_stiffness = p.linear.stiffness;
  c.linear_damping = p.linear.damping;
  c.angular_stiffness = p.angular.stiffness;
  c.angular_damping = p.angular.damping;
  c.linear_saturation =
      make_saturation(c.linear_stiffness, 0.5 * p.max_force / c.linear_stiffness, p.max_force);
  c.angular_saturation =
      make_saturation(c.angular_stiffness, 0.5 * p.max_torque / c.angular_stiffness, p.max_torque);
  config.contact.response.stiffness = p.contact.stiffness;
  config.contact.response.damping = p.contact.damping;
}

struct Ran {
  SessionSummary summary;
  double sensed_min = 0.0;  // least energy from what the device senses of its handle [J]
  double energy_end = 0.0;
  std::vector<double> time, energy;
};

Ran run(const SessionPair& session, double delay, bool is_controlled) {
  HandParams params = parse_hand("path=demo", session.hand);
  params.delay = delay;
  HandDevice hand(params);
  SessionConfig config = session.config;
  if (is_controlled) enable_passivity(hand.limits(), config);
  EnergyObserver sensed;
  Ran ran;
  const auto look = [&](const HapticSample& sample) {
    observe_motion(sensed, sample.device.motion.pose);
    observe_wrench(sensed, sample.command);
    ran.energy_end = sample.energy;
    if (sample.frame % 10 != 0) return;
    ran.time.push_back(sample.time);
    ran.energy.push_back(1e3 * sample.energy);
  };
  ran.summary = run_lockstep(config, hand, {.haptic = look, .contact = {}, .event = {}});
  ran.sensed_min = sensed.energy_min;
  return ran;
}

/// The same session with constraints instead of springs.
SessionPair constrained(SessionPair session) {
  use_constraints(session.config);
  return session;
}

/// Discs that touch everywhere at once keep the penalty.
bool is_constrained_by_default(const std::string& scene) {
  return !parse_scene(builtin_scene(scene), scene, "").contact.response;
}

/// How a run was played.
struct Played {
  std::string scene;
  double delay = 0.0;  // [s]
  bool is_controlled = false, is_constrained = false;
};

void add(const Played& played, const Ran& ran, plot::Panel& panel, Outcome& outcome) {
  const auto& [scene, delay, is_controlled, is_constrained] = played;
  add_row(outcome.tables[0],
          {scene, is_constrained ? "constraint" : "penalty", delay, is_controlled ? 1.0 : 0.0,
           ran.summary.energy_min, ran.sensed_min, ran.energy_end,
           ran.summary.passivity.acted_share, ran.summary.passivity.sent_share,
           ran.summary.passivity.damping_max, ran.summary.force_max, ran.summary.force_rms,
           ran.summary.penetration_max, ran.summary.end == SessionEnd::fault ? 1.0 : 0.0});
  panel.series.push_back({.label = is_constrained  ? "constraints, no delay"
                                   : delay == 0.0  ? "no delay"
                                   : is_controlled ? "15 ms, controlled"
                                                   : "15 ms",
                          .x = ran.time,
                          .y = ran.energy});
}

}  // namespace
}  // namespace e4_passivity

Outcome run_e4_passivity(const Context& context) {
  using namespace e4_passivity;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"scene", "response", "delay [s]", "controlled", "least energy [J]",
                   "least energy as sensed [J]", "energy at the end [J]", "share of frames changed",
                   "share of the wrench sent", "largest damping [N s/m]", "largest force [N]",
                   "rms force [N]", "penetration [m]", "fault"}}};
  outcome.figure = {.title = "Energy put in at the device's port (protocol E4)",
                    .note = "true motion of the simulated handle; gains as `tune` proposes them"};
  double least = 0.0, least_own = 0.0, least_controlled = 0.0,
         least_gain = std::numeric_limits<double>::infinity();
  double cost = 0.0, damping = 0.0;
  double least_constrained = 0.0;
  int scenes_late = 0, faults = 0;
  for (const char* scene : kScenes) {
    tell(context, scene);
    SessionPair session = session_pair(*context.assets, scene, context.quick ? 3.0 : 10.0,
                                       context.quick ? kQuickTriangles : 0);
    const Ran own = run(session, 0.0, false);
    recommend(session.config);
    plot::Panel panel{.title = scene, .x = {.label = "time [s]"}, .y = {.label = "energy [mJ]"}};
    const Ran prompt = run(session, 0.0, false);
    const Ran late = run(session, kDelay, false);
    const Ran controlled = run(session, kDelay, true);
    add({std::string(scene) + " (its own gains)"}, own, panel, outcome);
    add({scene}, prompt, panel, outcome);
    add({scene, kDelay}, late, panel, outcome);
    add({scene, kDelay, true}, controlled, panel, outcome);
    if (is_constrained_by_default(scene)) {
      const Ran kept_out = run(constrained(session), 0.0, false);
      add({scene, 0.0, false, true}, kept_out, panel, outcome);
      least_constrained = std::min(least_constrained, kept_out.summary.energy_min);
      faults += kept_out.summary.end == SessionEnd::fault;
    }
    outcome.figure.panels.push_back(panel);
    least = std::min(least, prompt.summary.energy_min);
    least_own = std::min(least_own, own.summary.energy_min);
    least_controlled = std::min(least_controlled, controlled.summary.energy_min);
    // Where lateness gives less away than can be told from nothing, there is nothing to take back.
    if (late.summary.energy_min < -kAsked * kNothing) {
      const double left = std::min(controlled.summary.energy_min, -kNothing);
      least_gain = std::min(least_gain, late.summary.energy_min / left);
      ++scenes_late;
    }
    cost = std::max(cost, 1.0 - controlled.summary.passivity.sent_share);
    damping = std::max(damping, controlled.summary.passivity.damping_max);
  }
  outcome.claims = {
      at_least("energy-min", "least energy over the scenes at recommended gains, no added delay",
               least, -1e-6, "J"),
      at_least("energy-min-own", "the same at the gains the scenes themselves name", least_own,
               -1e-6, "J"),
      at_least("controlled", "least energy over the scenes 15 ms late with the controller",
               least_controlled, -1e-3, "J"),
      at_least("nearer",
               "how much nearer zero that is than without, in the worst scene; what is nearer than "
               "1e-6 J counts as that",
               least_gain, kAsked),
      at_least(
          "late",
          "scenes that give away more than 20 times 1e-6 J without the controller: those judged",
          scenes_late, 1.0),
      at_least("constraint",
               "least energy over the scenes that have constraints by default, with them, no added "
               "delay; recommended gains of "
               "the coupling",
               least_constrained, -1e-6, "J"),
      at_most("constraint-faults", "of these, sessions that a fault ended", faults, 0.0),
      stated("cost",
             "most that the controller leaves out of the wanted wrench, mean over a session", cost),
      stated("damping", "largest damping it adds to the handle", damping, "N s/m")};
  return outcome;
}

}  // namespace thigma::experiments
