// Proposed gains in the closed loop: five devices by their published limits, five objects, with and
// without rotation.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "experiments/common/all_experiments.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/device/device_limits.h"
#include "thigma/device/hand.h"
#include "thigma/device/open_device.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"
#include "thigma/scene/gain_task.h"
#include "thigma/scene/start_placement.h"

namespace thigma::experiments {
namespace gains {
namespace {

struct Held {
  const char* name;
  double mass;  // [kg]
  TriangleMesh mesh;
};

std::vector<Held> held_objects() {
  return {{"ball 20 mm", 0.005, make_ball(0.010, 4)},
          {"cube 30 mm", 0.010, make_box(Vec3::Constant(0.030), {4, 4, 4})},
          {"rod 160 mm", 0.010, make_box({0.160, 0.020, 0.006}, {16, 2, 1})},
          {"plate 80 mm", 0.040, make_box({0.080, 0.080, 0.010}, {6, 6, 1})},
          {"ball 80 mm", 0.200, make_ball(0.040, 6)}};
}

TriangleMesh rippled_sheet() {
  TriangleMesh mesh = make_sheet(0.20, 0.12, 40, 24);
  for (Vec3& p : mesh.positions) p.z() = 2e-4 * sine(400.0 * p.x()) * cosine(350.0 * p.y());
  return mesh;
}

/// One object of a device's, ready to run.
struct Bench {
  ClodHierarchy object, ground;
  SceneDescription scene;
  LoadedObject loaded;
};

constexpr double kGap = 0.003;  // above the sheet at the start [m]

Bench make_bench(const Held& held) {
  Bench bench;
  bench.object = build_exact_hierarchy(held.mesh);
  bench.ground = build_exact_hierarchy(rippled_sheet());
  bench.loaded.mesh = held.mesh;
  bench.loaded.measure = mass_properties(held.mesh);
  bench.loaded.ball = enclosing_ball(held.mesh.positions);
  bench.scene.file = held.name;
  bench.scene.mass = held.mass;
  bench.scene.has_auto_gains = true;
  bench.scene.contact.resolution.is_exact = true;
  double lowest = 0.0;
  for (const Vec3& p : held.mesh.positions) lowest = std::min(lowest, p.z());
  bench.scene.object.world_from_mesh.position.z() = kGap - lowest;
  return bench;
}

/// How the handle rests after being pressed on the sheet, in the device's own units.
struct Rest {
  double sway = 0.0, turn = 0.0;  // peak to peak over the last second of three [m, rad]
  bool has_fault = false;
  SessionSummary summary;
  bool is_stable(const HandParams& hand) const {
    // docs/sources.md, E3.
    return !has_fault && sway <= std::max(2.0 * hand.encoder, 1e-6) &&
           turn <= std::max(2.0 * hand.angular_encoder, 1e-6);
  }
};

struct Range {
  Vec3 low = Vec3::Constant(1e300), high = Vec3::Constant(-1e300);
  void add(const Vec3& v) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  double size() const { return (high - low).norm(); }
};

constexpr double kSeconds = 3.0, kJudged = 1.0;

Rest press(SessionConfig config, const HandParams& params) {
  HandDevice hand(params);
  config.haptic.device = hand.limits();
  config.duration = kSeconds;
  Range place, turn;
  const auto look = [&](const HapticSample& sample) {
    if (sample.time < kSeconds - kJudged) return;
    place.add(hand.true_motion().pose.position);
    turn.add(vector_from_rotation(hand.true_motion().pose.orientation));
  };
  Rest rest;
  rest.summary = run_lockstep(config, hand, {.haptic = look, .contact = {}, .event = {}});
  rest.has_fault = rest.summary.end == SessionEnd::fault;
  rest.sway = place.size();
  rest.turn = turn.size();
  return rest;
}

void scale_stiffness(double factor, SessionConfig& config) {
  Coupling& c = config.haptic.coupling;
  const auto stiffen = [factor](double& stiffness, double& damping,
                                std::optional<Saturation>& spring) {
    stiffness *= factor;
    damping *= std::sqrt(factor);
    if (spring)
      spring = make_saturation(stiffness, 0.5 * spring->max_force / stiffness, spring->max_force);
  };
  stiffen(c.linear_stiffness, c.linear_damping, c.linear_saturation);
  stiffen(c.angular_stiffness, c.angular_damping, c.angular_saturation);
  config.contact.response.stiffness *= factor;
  config.contact.response.damping *= std::sqrt(factor);
}

/// Names of the three stiffnesses that are outside.
int flagged(const GainTask& task, const SessionConfig& config) {
  const PenaltyParams& contact = config.contact.response;
  const auto warnings = check_gains(task, propose_gains(task), config.haptic.coupling,
                                    contact.stiffness, contact.damping);
  return static_cast<int>(std::count_if(warnings.begin(), warnings.end(), [](const auto& w) {
    return w.gain.find("stiffness") != std::string::npos;
  }));
}

/// Least of 2, 4, ... times the proposal at which the handle no longer rests; infinity when all do.
double first_unstable(const SessionConfig& config, const HandParams& hand) {
  for (double factor = 2.0; factor <= 64.0; factor *= 2.0) {
    SessionConfig stiffer = config;
    scale_stiffness(factor, stiffer);
    if (!press(stiffer, hand).is_stable(hand)) return factor;
  }
  return std::numeric_limits<double>::infinity();
}

struct Counts {
  int cases = 0, stable = 0, flagged = 0, quiet = 0, pressed = 0;
};

void run_case(const Bench& bench, const DeviceModel& model, int dof, bool is_quick,
              Outcome& outcome, Counts& counts) {
  SceneDescription scene = bench.scene;
  scene.device.uri = "hand:?device=" + std::string(model.name) + "&dof=" + std::to_string(dof) +
                     "&path=press&force=1";
  SessionConfig config =
      make_session_config(scene, bench.loaded, bench.object, {{&bench.ground, Pose{}}});
  const StartPlacement start = place_at_start({}, config);
  const double s = config.haptic.workspace.motion_scale;
  const DeviceContext context = device_context(config, start, bench.loaded.ball.radius);
  const HandParams hand = parse_hand(scene.device.uri.substr(6), context);
  const GainTask task = gain_task(describe_device(scene.device.uri), config.haptic.body,
                                  config.haptic.workspace, config.rate);
  const GainProposal p = propose_gains(task);
  const Rest rest = press(config, hand);
  SessionConfig doubled = config;
  scale_stiffness(2.0, doubled);
  ++counts.cases;
  counts.stable += rest.is_stable(hand) ? 1 : 0;
  counts.flagged += flagged(task, doubled) == 3 ? 1 : 0;
  counts.quiet += flagged(task, config) == 0 ? 1 : 0;
  counts.pressed += rest.summary.force_max > 0.5 ? 1 : 0;
  add_row(outcome.tables[0],
          {std::string(model.name), static_cast<double>(dof), bench.scene.file, *bench.scene.mass,
           s, p.linear.stiffness, p.linear.damping, limit_name(p.linear.binds), p.angular.stiffness,
           p.angular.damping, limit_name(p.angular.binds), p.contact.stiffness, p.contact.damping,
           limit_name(p.contact.binds), rest.sway, rest.turn, rest.summary.force_max,
           rest.summary.penetration_max,
           is_quick ? std::numeric_limits<double>::quiet_NaN() : first_unstable(config, hand)});
  if (dof == 6) {
    outcome.figure.panels[0].series[0].x.push_back(static_cast<double>(counts.cases));
    outcome.figure.panels[0].series[0].y.push_back(p.linear.stiffness);
    outcome.figure.panels[0].series[1].x.push_back(static_cast<double>(counts.cases));
    outcome.figure.panels[0].series[1].y.push_back(p.linear.limit);
  }
  outcome.figure.panels[1].series[0].x.push_back(static_cast<double>(counts.cases));
  outcome.figure.panels[1].series[0].y.push_back(rest.sway / hand.encoder);
}

}  // namespace
}  // namespace gains

Outcome run_gains(const Context& context) {
  using namespace gains;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"device", "dof", "object", "mass [kg]", "motion scale", "k_c [N/m]",
                   "b_c [N s/m]", "k_c bound by", "k_theta [N m/rad]", "b_theta [N m s/rad]",
                   "k_theta bound by", "k [N/m]", "b [N s/m]", "k bound by", "sway [m]",
                   "turn [rad]", "largest force [N]", "penetration [m]", "unstable from"}}};
  outcome.figure = {.title = "Proposed gains in the closed loop, 1 kHz, no added delay",
                    .note = "cases in the order of data.csv: device, object, rotation",
                    .panels = {{.title = "coupling",
                                .x = {.label = "case"},
                                .y = {.label = "k_c [N/m]", .is_log = true},
                                .series = {{.label = "proposed", .mark = plot::Mark::points},
                                           {.label = "limit", .mark = plot::Mark::points}}},
                               {.title = "rest while pressing with 1 N",
                                .x = {.label = "case"},
                                .y = {.label = "sway [encoder steps]"},
                                .series = {{.label = "", .mark = plot::Mark::points}},
                                .guides = {{.label = "bound", .value = 2.0}}}}};
  Counts counts;
  const std::vector<Held> objects = held_objects();
  for (const DeviceModel& model : device_models()) {
    if (!(model.max_stiffness > 0.0)) continue;
    tell(context, std::string(model.product));
    for (const Held& held : objects) {
      const Bench bench = make_bench(held);
      for (const int dof : {6, 3}) run_case(bench, model, dof, context.quick, outcome, counts);
    }
  }
  const double all = counts.cases;
  outcome.claims = {
      at_least("cases", "five devices with a published stiffness, five objects, dof 6 and 3", all,
               50.0),
      at_least("stable", "cases that rest within two encoder steps at the proposed gains",
               counts.stable, all),
      at_least("pressed", "cases in which more than 0.5 N was reached on the way", counts.pressed,
               all),
      at_least("quiet", "cases without a warning about the proposed stiffnesses", counts.quiet,
               all),
      at_least("flagged", "cases in which all three stiffnesses, doubled, are flagged",
               counts.flagged, all)};
  return outcome;
}

}  // namespace thigma::experiments
