// Presses: over divisions of the surfaces, places and yaws, and from little to much travel.

#include "experiments/constraint-force/presses.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "experiments/common/assets.h"
#include "experiments/common/led_session.h"

#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"
#include "thigma/response/potential_contacts.h"

namespace thigma::experiments {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kHalf = 0.010;  // of the cube [m]
constexpr double kGap = 2e-4;    // at the start [m]

TriangleMesh plate(int nx, int ny, bool is_turned = false) {
  TriangleMesh mesh = make_box({0.08, 0.08, 0.01}, {nx, ny, 1});
  // Mirrored across x = y the diagonals of the tiles run the other way.
  if (is_turned) {
    for (Vec3& p : mesh.positions) std::swap(p.x(), p.y());
    mesh = flipped(std::move(mesh));
  }
  return transformed(std::move(mesh), {{0.0, 0.0, -0.005}, Quat::Identity()});
}

/// Where a pressed object stands: as the mesh is divided, placed and turned.
struct Stand {
  TriangleMesh object, scene;
  Vec3 place = Vec3::Zero();  // across the plate [m]
  Vec3 turn = Vec3::Zero();   // of the object
};

/// What the hand feels at rest, pressed so far beyond the touch.
struct Felt {
  Vec3 force = Vec3::Zero();  // [N]
  double stretch = 0.0;       // from the object's grasp point to the handle [m]
  double contacts = 0.0;      // of the last query, and its rows
  double rows = 0.0;
};

Felt press(LedPair pair, double depth, const std::optional<Saturation>& saturation, int every,
           bool is_potential = false) {
  LedGains gains;
  gains.every = every;
  gains.is_potential = is_potential;
  SessionConfig config = led_config(pair, gains, 0.6);
  config.haptic.coupling.linear_saturation = saturation;
  const HandPath hand = [&](double t) {
    const double in = std::clamp(t / 0.25, 0.0, 1.0);
    return Pose{pair.start.position - Vec3(0.0, 0.0, in * (pair.clearance + depth)),
                pair.start.orientation};
  };
  Felt felt;
  const LedRun run = run_led(config, hand, [&](const HapticSample& s, const LedStep& step) {
    felt.force = s.command.force;
    felt.stretch = (s.handle.pose.position - s.body.position).norm();
    felt.rows = step.rows;
  });
  felt.contacts = run.summary.contacts_mean;
  return felt;
}

LedPair pair_of(const Stand& stand) {
  Pose start{{0.0, 0.0, 0.0}, rotation_from_vector(stand.turn)};
  LedPair pair = make_led_pair("stand", stand.object, stand.scene, start);
  double low = 0.0;
  for (const Vec3& p : pair.object.positions) low = std::min(low, (pair.start.orientation * p).z());
  pair.start.position = stand.place + Vec3(0.0, 0.0, kGap - low);
  pair.clearance = kGap;
  return pair;
}

Felt press(const Stand& stand, double depth, bool is_potential) {
  // An area takes milliseconds, and nothing moves at rest.
  return press(pair_of(stand), depth, {}, is_potential ? 10 : 1, is_potential);
}

/// The potential law alone, no coupling beside it, so deep: upwards [N].
double law_force(const Stand& stand, double depth) {
  const LedPair pair = pair_of(stand);
  LedGains gains;
  gains.is_potential = true;
  const ContactWorld world = led_config(pair, gains, 1.0).contact;
  PotentialScratch scratch;
  reserve_potential(*world.potential, scratch);
  BodyState state;
  state.position = pair.start.position - Vec3(0.0, 0.0, kGap + depth);
  state.orientation = pair.start.orientation;
  const PotentialContact contact =
      measure_potential(*world.potential, state, world.potential_law, world.tolerance, scratch);
  return potential_force(contact.moments, world.response.stiffness, world.potential_law)
      .wrench.force.z();
}

/// A stand's force by either response, into a row.
void add_stand(const char* series, const std::string& what, const Stand& stand, Outcome& outcome) {
  constexpr double kDeep = 1e-3;
  add_row(outcome.tables[1], {series, what, press(stand, kDeep, false).force.z(),
                              press(stand, kDeep, true).force.z(), law_force(stand, 2e-4)});
}

/// Largest less least over the mean of what stands in a column of the rows of a series.
double spread(const std::string& series, std::size_t column, const Outcome& outcome) {
  double least = 1e300, most = 0.0, sum = 0.0;
  int count = 0;
  for (const auto& row : outcome.tables[1].rows) {
    if (std::get<std::string>(row[0]) != series) continue;
    const double force = std::get<double>(row[column]);
    least = std::min(least, force);
    most = std::max(most, force);
    sum += force;
    ++count;
  }
  return 100.0 * (most - least) / (sum / count);
}

void claim_spread(const char* id, const char* series, const std::string& what, Outcome& outcome) {
  outcome.claims.push_back(at_most(id, what, spread(series, 2, outcome), 1.0, "%"));
  outcome.claims.push_back(at_most(std::string("potential-") + id, "with the potential: " + what,
                                   spread(series, 3, outcome), 1.0, "%"));
  outcome.claims.push_back(at_most(std::string("law-") + id,
                                   "by the potential law alone, 0.2 mm deep: " + what,
                                   spread(series, 4, outcome), 1.0, "%"));
}

void run_divisions(bool is_quick, Outcome& outcome) {
  const Vec3 place(5e-4, 7e-4, 0.0);
  const std::vector<int> segments =
      is_quick ? std::vector<int>{1, 2, 4, 8, 16} : std::vector<int>{1, 4, 16, 64, 128};
  for (const int n : segments) {
    const TriangleMesh cube = make_box(Vec3::Constant(2.0 * kHalf), {n, n, n});
    for (const double tilt : {0.0, 1.0}) {
      add_stand(tilt == 0.0 ? "flat" : "tilted", std::to_string(12 * n * n) + " triangles",
                {cube, plate(4, 4), place, {0.0, tilt * kDegree, 0.0}}, outcome);
    }
  }
  const TriangleMesh ball = make_ball(kHalf, is_quick ? 8 : 24);
  const TriangleMesh plates[] = {plate(1, 1), plate(8, 8), plate(8, 8, true), plate(37, 11)};
  const char* names[] = {"2 triangles", "8 x 8", "8 x 8, diagonals turned", "37 x 11"};
  for (int i = 0; i < 4; ++i)
    add_stand("triangulations", names[i], {ball, plates[i], place, Vec3::Zero()}, outcome);
  const TriangleMesh cube = make_box(Vec3::Constant(2.0 * kHalf), {3, 3, 3});
  for (int i = 0; i < 40; ++i) {
    // Spread over a tile and a quarter turn.
    const double across = 0.01 * std::fmod(0.618 * i, 1.0), yaw = 1.5707963 * i / 40.0;
    add_stand("places", std::to_string(i),
              {cube, plates[1], {across, 0.01 * i / 40.0, 0.0}, {0.0, 0.0, yaw}}, outcome);
  }
  claim_spread("tessellation", "flat",
               "spread of the force over five divisions of a cube on a plate", outcome);
  claim_spread("tessellation-tilted", "tilted", "the same, tilted by a degree", outcome);
  claim_spread("triangulation", "triangulations",
               "spread of a ball's force over four triangulations of a plate", outcome);
  claim_spread("places", "places", "spread of a cube's force over 40 places and yaws", outcome);
}

/// Force over travel, against the spring's law: what is off, over the law.
void run_travel(Outcome& outcome) {
  const std::optional<Saturation> springs[] = {std::nullopt, make_saturation(1000.0, 0.002, 4.0)};
  const Stand stand{
      make_box(Vec3::Constant(2.0 * kHalf), {3, 3, 3}), plate(8, 8), {5e-4, 7e-4, 0.0}, {}};
  LedPair pair = make_led_pair("cube", stand.object, stand.scene,
                               {{5e-4, 7e-4, kHalf + kGap}, Quat::Identity()});
  pair.clearance = kGap;
  plot::Panel& panel = outcome.figure.panels[0];
  double worst = 0.0;
  for (const auto& spring : springs) {
    plot::Series felt{.label = spring ? "levels off at 4 N" : "linear", .mark = plot::Mark::points};
    plot::Series law{.label = "its law", .is_dashed = true};
    for (const double depth : {1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 3e-3, 5e-3, 7e-3, 9e-3}) {
      const double ideal = spring ? spring_force(*spring, depth).force : 1000.0 * depth;
      const double force = press(pair, depth, spring, 1).force.norm();
      const double off = std::fabs(force / ideal - 1.0);
      add_row(outcome.tables[2], {"travel", spring ? "levels off" : "linear", 1e3 * depth, force,
                                  ideal, 100.0 * off, 4.0});
      worst = std::max(worst, off);
      felt.x.push_back(1e3 * depth);
      felt.y.push_back(force);
      law.x.push_back(1e3 * depth);
      law.y.push_back(ideal);
    }
    panel.series.push_back(felt);
    panel.series.push_back(law);
  }
  outcome.claims.push_back(at_most("travel",
                                   "force from 0.1 to 9 mm of hand travel: off the coupling's law "
                                   "on the ideal proxy",
                                   100.0 * worst, 1.0, "%"));
}

/// From one contact to many: discs that follow each other, at several counts of triangles.
void run_contacts(bool is_quick, Outcome& outcome) {
  const std::vector<int> counts =
      is_quick ? std::vector<int>{1000, 4000} : std::vector<int>{1000, 10'000, 100'000};
  double worst = 0.0, most = 0.0;
  for (const int triangles : counts) {
    LedPair pair = make_led_pair("discs", make_mesh(model_uri("conforming_upper", triangles)),
                                 make_mesh(model_uri("conforming_lower", triangles)),
                                 {{0.0, 0.0, 5e-4}, Quat::Identity()});
    pair.clearance = 5e-4;
    const Felt felt = press(pair, 2e-3, {}, 1);
    const double ideal = 1000.0 * felt.stretch;
    const double off = std::fabs(felt.force.norm() / ideal - 1.0);
    add_row(outcome.tables[2], {"contacts", std::to_string(triangles) + " triangles", 2.0,
                                felt.force.norm(), ideal, 100.0 * off, felt.contacts});
    worst = std::max(worst, off);
    most = std::max(most, felt.contacts);
  }
  outcome.claims.push_back(at_most("contacts",
                                   "force between discs that follow each other: off the law at "
                                   "the stretch there is",
                                   100.0 * worst, 1.0, "%"));
  outcome.claims.push_back(stated("most-contacts", "contacts a query, mean, where most", most));
}

}  // namespace

void run_presses(const Context& context, Outcome& outcome) {
  tell(context, "divisions, places and yaws");
  run_divisions(context.quick, outcome);
  tell(context, "travel");
  run_travel(outcome);
  tell(context, "contacts");
  run_contacts(context.quick, outcome);
}

}  // namespace thigma::experiments
