// Whether the division of a flat plate can be felt: sliding over 1, 64 and 4,096 tiles; the gap of
// the first force; steps of the force where the rows that press change.

#include <algorithm>
#include <cmath>
#include <string>

#include "experiments/common/all_experiments.h"
#include "experiments/common/assets.h"
#include "experiments/common/led_session.h"

#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma::experiments {
namespace tiles {
namespace {

constexpr int kDivisions[] = {1, 8, 64};  // of a side: 1, 64 and 4,096 tiles
constexpr int kEvery[] = {1, 10};
constexpr double kDampings[] = {2.0, 1.0, 0.5,
                                0.1};             // of the coupling, the first is judged [N s/m]
constexpr double kPress = 0.004, kSlide = 0.040;  // [m]
constexpr double kIn = 0.2, kSettle = 0.3, kTime = 1.2;
constexpr double kHalf = 0.010;  // of the cube, and the ball's radius [m]

/// Cube (0) or ball (1) over a plate whose top is z = 0.
LedPair over_plate(int shape, int divisions, double gap) {
  const TriangleMesh plate = transformed(make_box({0.1, 0.06, 0.01}, {divisions, divisions, 1}),
                                         {{0.0, 0.0, -0.005}, Quat::Identity()});
  const TriangleMesh object =
      shape == 0 ? make_box(Vec3::Constant(2.0 * kHalf), {3, 3, 3}) : make_ball(kHalf, 12);
  // So that neither lies on the borders of the tiles.
  LedPair pair = make_led_pair(shape == 0 ? "cube" : "ball", object, plate,
                               {{-0.5 * kSlide + 3e-4, 7e-4, 0.02}, Quat::Identity()});
  double low = 0.0;
  for (const Vec3& p : pair.object.positions) low = std::min(low, p.z());
  pair.start.position.z() = gap - low;
  pair.clearance = gap;
  return pair;
}

struct Slid {
  double tangential = 0.0;  // largest over the mean normal force
  double mean_tangential = 0.0;
  double normal = 0.0;  // mean [N]
  double work = 0.0;    // of the hand from rest to rest [J]
  int held_back = 0;
};

Slid slide(const LedPair& pair, int every) {
  LedGains gains;
  gains.every = every;
  const Pose start = pair.start;
  const HandPath hand = [&](double t) {
    const double in = std::clamp(t / kIn, 0.0, 1.0);
    const double x = std::clamp((t - kSettle) / kTime, 0.0, 1.0);
    const double by = x * x * (3.0 - 2.0 * x);
    return Pose{start.position + Vec3(kSlide * by, 0.0, -in * (kPress + pair.clearance)),
                start.orientation};
  };
  Slid slid;
  double begun = 0.0, ended = 0.0;
  int frames = 0;
  const auto look = [&](const HapticSample& s, const LedStep&) {
    if (s.time < kSettle) begun = s.energy;
    ended = s.energy;
    if (s.time < kSettle || s.time > kSettle + kTime) return;
    const Vec3 f = s.contact.force;
    const double across = std::hypot(f.x(), f.y());
    slid.tangential = std::max(slid.tangential, across);
    slid.mean_tangential += across;
    slid.normal += f.z();
    ++frames;
  };
  const LedRun run = run_led(led_config(pair, gains, kSettle + kTime + 0.3), hand, look);
  slid.normal /= frames;
  slid.tangential /= slid.normal;
  slid.mean_tangential /= frames * slid.normal;
  slid.work = ended - begun;
  slid.held_back = run.held_back;
  return slid;
}

/// The surfaces' distance in the last frame before the hand feels more than a millinewton [m].
double first_gap(const LedPair& pair, int every) {
  LedGains gains;
  gains.every = every;
  const Pose start = pair.start;
  const HandPath hand = [&](double t) {
    return Pose{start.position - Vec3(0.0, 0.0, 0.005 * std::max(0.0, t - 0.1)), start.orientation};
  };
  double gap = 0.0, height = pair.clearance;
  bool is_felt = false;
  const auto look = [&](const HapticSample& s, const LedStep&) {
    // At constant speed the coupling is slack: what it pulls with is the contact's.
    if (!is_felt && s.time > 0.15 && s.contact.force.norm() > 1e-3) {
      is_felt = true;
      gap = height;
    }
    height = pair.clearance + s.body.position.z() - start.position.z();
  };
  run_led(led_config(pair, gains, 0.1 + 1.5 * pair.clearance / 0.005), hand, look);
  return is_felt ? gap : 1.0;
}

/// Largest change of the force from frame to frame where the rows that press change, and elsewhere.
struct Steps {
  double at_change = 0.0, elsewhere = 0.0;  // [N]
  int changes = 0;
};

Steps force_steps(const LedPair& pair, int every, double damping) {
  const Vec3 slide(0.003, 0.001, 0.0), twist(0.02, 0.03, 0.05);
  LedGains gains;
  gains.every = every;
  gains.damping = damping;
  const Pose start = pair.start;
  const HandPath hand = [&](double t) {
    const double in = std::clamp(t / kIn, 0.0, 1.0);
    const double by = std::sin(6.283185307179586 * std::max(0.0, t - kSettle) / kTime);
    Pose pose = start;
    pose.position += Vec3(0.0, 0.0, -in * (0.002 + pair.clearance)) + by * slide;
    pose.orientation = rotation_from_vector(by * twist) * start.orientation;
    return pose;
  };
  Steps steps;
  Vec3 last = Vec3::Zero();
  std::uint64_t set = 0;
  const auto look = [&](const HapticSample& s, const LedStep& step) {
    if (s.time > kSettle + 0.05) {
      const double change = (s.command.force - last).norm();
      const bool is_other = step.active_set != set;
      double& most = is_other ? steps.at_change : steps.elsewhere;
      most = std::max(most, change);
      steps.changes += is_other;
    }
    last = s.command.force;
    set = step.active_set;
  };
  run_led(led_config(pair, gains, kSettle + kTime), hand, look);
  return steps;
}

void run_slides(Outcome& outcome) {
  plot::Panel& panel = outcome.figure.panels[0];
  double tangential = 0.0, spread = 0.0, gap = 0.0;
  int held_back = 0;
  for (const int shape : {0, 1}) {
    double least = 1e300, most = 0.0;
    for (const int every : kEvery) {
      plot::Series series{.label = std::string(shape == 0 ? "cube, " : "ball, ") +
                                   std::to_string(1000 / every) + " Hz",
                          .mark = plot::Mark::line_and_points};
      for (const int divisions : kDivisions) {
        const LedPair pair = over_plate(shape, divisions, 5e-4);
        const Slid slid = slide(pair, every);
        const double first = first_gap(pair, every);
        const double count = divisions * divisions;
        add_row(outcome.tables[0],
                {pair.name, count, 1000.0 / every, slid.tangential, slid.mean_tangential,
                 slid.normal, 1e6 * slid.work, static_cast<double>(slid.held_back), 1e6 * first});
        series.x.push_back(count);
        series.y.push_back(std::max(slid.tangential, 1e-9));
        tangential = std::max(tangential, slid.tangential);
        least = std::min(least, slid.work);
        most = std::max(most, slid.work);
        gap = std::max(gap, first);
        held_back += slid.held_back;
      }
      panel.series.push_back(series);
    }
    spread = std::max(spread, (most - least) / std::fabs(most));
  }
  outcome.claims = {
      at_most("tangential", "largest tangential force over the mean normal one", tangential, 0.01),
      at_most("work", "spread of the work of a slide over the tiles and rates, over the work",
              spread, 0.02),
      at_most("first-gap", "the surfaces' distance at the first force", 1e6 * gap, 2.0, "um"),
      stated("held-back", "frames held back", held_back)};
}

void run_steps(bool is_quick, Outcome& outcome) {
  std::vector<LedPair> pairs;
  pairs.push_back(over_plate(0, 8, 5e-4));
  pairs.push_back(over_plate(1, 64, 5e-4));
  pairs.push_back(
      placed_apart(make_led_pair("jaws", make_mesh(model_uri("jaw_upper", is_quick ? 4000 : 0)),
                                 make_mesh(model_uri("jaw_lower", is_quick ? 4000 : 0)),
                                 {{0.0, 0.0, 0.001}, Quat::Identity()}),
                   -Vec3::UnitZ(), 1e-3));
  double worst = 0.0;
  for (const LedPair& pair : pairs) {
    for (const double damping : kDampings) {
      for (const int every : kEvery) {
        const Steps steps = force_steps(pair, every, damping);
        const double ratio = steps.at_change / std::max(steps.elsewhere, 1e-12);
        add_row(outcome.tables[1],
                {pair.name, damping, 1000.0 / every, static_cast<double>(steps.changes),
                 1e3 * steps.at_change, 1e3 * steps.elsewhere, ratio});
        if (steps.changes > 0 && damping == kDampings[0]) worst = std::max(worst, ratio);
      }
    }
  }
  outcome.claims.push_back(at_most(
      "steps", "largest force step where the rows that press change, over the largest elsewhere",
      worst, 1.2));
}

}  // namespace
}  // namespace tiles

Outcome run_tiles(const Context& context) {
  using namespace tiles;
  Outcome outcome;
  outcome.tables = {
      {.columns = {"object", "tiles", "contact rate [Hz]", "tangential over normal, largest",
                   "mean", "normal force [N]", "work [uJ]", "frames held back",
                   "gap of the first force [um]"}},
      {.name = "steps",
       .columns = {"pair", "damping [N s/m]", "contact rate [Hz]", "changes",
                   "largest step at one [mN]", "largest step elsewhere [mN]", "ratio"}}};
  outcome.figure = {.title = "Sliding 40 mm over a flat plate, pressed with 4 N",
                    .note = "without friction; what is below 1e-9 is drawn there",
                    .panels = {{.x = {.label = "tiles", .is_log = true},
                                .y = {.label = "tangential over normal force", .is_log = true},
                                .guides = {{"1 %", 0.01}}}},
                    .panel_height = 380};
  tell(context, "sliding");
  run_slides(outcome);
  tell(context, "steps");
  run_steps(context.quick, outcome);
  return outcome;
}

}  // namespace thigma::experiments
