// Largest step of the contact force from one haptic frame to the next: slow rotation over a corner,
// clusters that come and go, contacts that change their level of detail; each beside the largest
// where nothing switches.

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "experiments/common/all_experiments.h"
#include "experiments/common/coupled_run.h"
#include "experiments/common/session_pair.h"

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma::experiments {
namespace force_steps {
namespace {

constexpr double kSide = 0.02;      // of the cube [m]
constexpr double kPressed = 0.002;  // handle below the floor [m]
constexpr double kPi = 3.14159265358979323846;

/// Largest steps where something switched, and elsewhere [N].
struct Steps {
  double switching = 0.0, other = 0.0;
  double torque_switching = 0.0, torque_other = 0.0;  // [N m]
  double force_max = 0.0;
  std::uint64_t switches = 0;
};

void note(bool is_switch, const Wrench& now, const Wrench& before, Steps& steps) {
  const double force = (now.force - before.force).norm();
  const double torque = (now.torque - before.torque).norm();
  (is_switch ? steps.switching : steps.other) =
      std::max(is_switch ? steps.switching : steps.other, force);
  (is_switch ? steps.torque_switching : steps.torque_other) =
      std::max(is_switch ? steps.torque_switching : steps.torque_other, torque);
  steps.switches += is_switch ? 1 : 0;
  steps.force_max = std::max(steps.force_max, now.force.norm());
}

/// Corner of the cube that lies lowest in this orientation.
int lowest_corner(const Quat& turn) {
  int lowest = 0;
  double least = 1.0;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 local((corner & 1) ? 1.0 : -1.0, (corner & 2) ? 1.0 : -1.0,
                     (corner & 4) ? 1.0 : -1.0);
    const double z = (turn * (0.5 * kSide * local)).z();
    if (z < least) {
      least = z;
      lowest = corner;
    }
  }
  return lowest;
}

/// The cube on a floor, its handle pressed down while it turns about a horizontal axis at `speed`,
/// over flat faces and corners. A switch: another corner has become the lowest within the last
/// kRecent frames, as models are a frame late.
Steps turn_cube(double from, double to, double speed, bool distributes_wide_contacts) {
  const ClodHierarchy cube = build_exact_hierarchy(make_box(kSide * Vec3::Ones()));
  const ClodHierarchy floor = build_exact_hierarchy(make_sheet(0.2, 0.2, 2, 2));
  CoupledSetup setup;
  setup.body = make_body(0.010, 1e-6 * Mat3::Identity());
  setup.coupling.linear_stiffness = 500.0;
  setup.coupling.linear_damping = 2.0 * std::sqrt(500.0 * 0.010);
  setup.coupling.angular_stiffness = 0.6;
  setup.coupling.angular_damping = 2.0 * std::sqrt(0.6 * 1e-6);
  setup.coupling.is_grasped = true;
  setup.contact.object = &cube;
  setup.contact.scene = {{&floor, Pose{}}};
  setup.contact.tolerance = 2e-4;
  setup.contact.distributes_wide_contacts = distributes_wide_contacts;
  setup.contact.response = {.stiffness = 5000.0, .damping = 2.0 * std::sqrt(5000.0 * 0.010)};
  const Vec3 axis = Vec3(0.1, 1.0, 0.0).normalized();  // not along an edge: one end comes first
  std::vector<Pose> poses;
  const auto frames = static_cast<int>(std::abs(to - from) / speed * 1000.0);
  for (int i = 0; i <= frames; ++i) {
    const double angle = from + (to - from) * i / frames;
    // Above the floor as the turned cube stands on it, less what it is pressed down by.
    const Quat turn = rotation_from_vector(angle * axis);
    double lowest = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const Vec3 local((corner & 1) ? 1.0 : -1.0, (corner & 2) ? 1.0 : -1.0,
                       (corner & 4) ? 1.0 : -1.0);
      lowest = std::min(lowest, (turn * (0.5 * kSide * local)).z());
    }
    poses.push_back({Vec3(0.001, 0.002, -lowest - kPressed), turn});
  }
  setup.start.position = poses.front().position + Vec3(0.0, 0.0, kPressed);
  setup.start.orientation = poses.front().orientation;
  const std::vector<CoupledFrame> ran = run_coupled(setup, motion_along(poses, setup.period));
  Steps steps;
  constexpr std::size_t kSettled = 200, kRecent = 20;
  for (std::size_t i = kSettled; i < ran.size(); ++i) {
    const bool is_switch =
        lowest_corner(ran[i].body.orientation) != lowest_corner(ran[i - kRecent].body.orientation);
    note(is_switch, ran[i].contact, ran[i - 1].contact, steps);
  }
  return steps;
}

struct SceneSteps {
  Steps clusters;
  ForceSteps levels;
};

/// A scene as `thigma run` has it. A switch: a cluster of another id, or one fewer, in the model.
SceneSteps run_scene(const SessionPair& session) {
  const std::unique_ptr<HapticDevice> hand = open_device("hand:?path=slide", session.hand);
  SceneSteps result;
  std::map<std::uint64_t, std::set<std::int32_t>> known;
  std::uint64_t last_sequence = 0;
  HapticSample last;
  bool has_last = false;
  const auto look = [&](const HapticSample& s) {
    const bool counts = s.is_grasped && s.is_armed && s.fault == Fault::none && s.touching > 0;
    if (counts && has_last) {
      const bool is_switch = known[s.model_sequence] != known[last_sequence];
      note(is_switch, s.contact, last.contact, result.clusters);
    }
    known.erase(known.begin(), known.lower_bound(std::min(s.model_sequence, last_sequence)));
    last = s;
    last_sequence = s.model_sequence;
    has_last = counts;
  };
  const auto learn = [&](const ContactSample& c) {
    std::set<std::int32_t>& ids = known[c.model.sequence];
    for (const PlaneTerm& term : c.model.planes) ids.insert(term.id);
  };
  const SessionSummary summary =
      run_lockstep(session.config, *hand, {.haptic = look, .contact = learn, .event = {}});
  result.levels = summary.force_steps;
  return result;
}

void add(const std::string& what, const Steps& s, Outcome& outcome) {
  add_row(outcome.tables[0], {what, s.switching, s.other, s.torque_switching, s.torque_other,
                              static_cast<double>(s.switches), s.force_max});
}

}  // namespace
}  // namespace force_steps

Outcome run_force_steps(const Context& context) {
  using namespace force_steps;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"what", "step where something switches [N]", "step elsewhere [N]",
                   "torque step where something switches [N m]", "torque step elsewhere [N m]",
                   "frames with a switch", "largest force [N]"}}};
  outcome.figure = {.title = "Steps of the contact force where something switches",
                    .note = "largest from one haptic frame to the next; a row of data.csv each"};
  plot::Panel panel{.title = "steps",
                    .x = {.label = "row of data.csv"},
                    .y = {.label = "largest step [N]"},
                    .series = {{.label = "where something switches", .mark = plot::Mark::points},
                               {.label = "elsewhere", .mark = plot::Mark::points}}};
  tell(context, "cube over flat");
  const Steps flat = turn_cube(-0.1, 0.1, 0.1, true);
  const Steps alone = turn_cube(-0.1, 0.1, 0.1, false);
  tell(context, "cube over a corner");
  const Steps corner = turn_cube(0.25 * kPi - 0.1, 0.25 * kPi + 0.1, 0.1, true);
  add("cube rolling over its face, 0.1 rad/s", flat, outcome);
  add("cube rolling over its face, one contact for the pair of patches", alone, outcome);
  add("cube rolling over an edge, 0.1 rad/s", corner, outcome);
  SessionPair jaws =
      session_pair(*context.assets, "jaws", context.quick ? 3.0 : 8.0, context.quick ? 4000 : 0);
  tell(context, "jaws");
  const SceneSteps with = run_scene(jaws);
  add("jaws sliding, clusters that come and go", with.clusters, outcome);
  Steps levels;
  levels.switching = with.levels.contact.level_change;
  levels.other = with.levels.contact.other;
  levels.switches = with.levels.level_change_frames;
  levels.force_max = with.clusters.force_max;
  add("jaws sliding, contacts that change level", levels, outcome);
  for (std::size_t i = 0; i < outcome.tables[0].rows.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      panel.series[k].x.push_back(static_cast<double>(i));
      panel.series[k].y.push_back(std::get<double>(outcome.tables[0].rows[i][k + 1]));
    }
  }
  outcome.figure.panels = {panel};
  const auto claim = [&](const char* id, const std::string& what, const Steps& s) {
    outcome.claims.push_back(stated(
        std::string(id) + "-switch",
        what + ": largest step of the contact force where something switches", s.switching, "N"));
    outcome.claims.push_back(
        stated(std::string(id) + "-other", what + ": largest elsewhere", s.other, "N"));
  };
  claim("flat", "cube rolling over its face", flat);
  claim("alone", "cube rolling over its face, one contact for the pair of patches", alone);
  claim("corner", "cube rolling over an edge", corner);
  outcome.claims.push_back(at_most(
      "spread", "cube rolling over its face: largest step, over that with one contact for the pair",
      std::max(flat.switching, flat.other) / std::max(alone.switching, alone.other), 0.1));
  claim("clusters", "jaws sliding, clusters", with.clusters);
  claim("levels", "jaws sliding, levels", levels);
  return outcome;
}

}  // namespace thigma::experiments
