// Presses: over divisions of the surfaces, places and yaws, and from little to much travel.

#include "experiments/constraint-force/presses.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "experiments/common/assets.h"
#include "experiments/common/led_session.h"

#include "thigma/contact/query_contacts.h"
#include "thigma/math/elementary.h"
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

/// What the hand feels at rest, pressed so far beyond the touch, and where the object is.
struct Felt {
  Vec3 force = Vec3::Zero();  // [N]
  Pose object;
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
  run_led(config, hand, [&](const HapticSample& s, const LedStep&) {
    felt.force = s.command.force;
    felt.object = {s.body.position, s.body.orientation};
  });
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

/// Pairs of patches that are as near as that.
double pairs_within(double distance, const LedPair& pair, const Pose& object) {
  constexpr std::size_t kRoom = 1'000'000;
  ContactFront front;
  reserve_front(front, *pair.object_levels, *pair.scene_levels, kRoom);
  ContactSet contacts;
  contacts.contacts.reserve(kRoom);
  query_contacts({*pair.object_levels, object}, {*pair.scene_levels}, {.tolerance = distance},
                 front, contacts);
  return static_cast<double>(contacts.contacts.size()) + static_cast<double>(contacts.dropped);
}

/// A block of n x n x 2 triangles on one side, wavy along both axes: that of the object below, that
/// of the scene above, so that they fit.
TriangleMesh wavy_block(int n, bool is_object) {
  constexpr double kSize = 0.04, kThick = 0.01, kWave = 5e-4;
  std::vector<double> steps;
  for (int i = 0; i <= n; ++i) steps.push_back(kSize * (static_cast<double>(i) / n - 0.5));
  const double other = is_object ? kThick : -kThick;
  const double zs[] = {std::min(0.0, other), std::max(0.0, other)};
  TriangleMesh mesh = make_blocks(steps, steps, zs, [](int, int, int) { return true; });
  if (n == 1) return mesh;
  for (Vec3& p : mesh.positions) {
    if (p.z() != 0.0) continue;
    // Another height at every corner: no two triangles lie in one plane.
    p.z() = kWave * sin_cos(700.0 * p.x() + 0.3).sin * sin_cos(900.0 * p.y() + 0.7).cos;
  }
  return mesh;
}

/// From one contact to many: blocks that fit each other, whose touch is known.
void run_contacts(bool is_quick, Outcome& outcome) {
  constexpr double kNear = 5e-6, kDeep = 2e-3;  // [m]
  const std::vector<int> divisions =
      is_quick ? std::vector<int>{1, 4, 16} : std::vector<int>{1, 4, 16, 50, 150};
  double worst = 0.0, most = 0.0;
  for (const int n : divisions) {
    const TriangleMesh object = wavy_block(n, true);
    LedPair pair =
        make_led_pair("blocks", object, wavy_block(n, false), {{0.0, 0.0, kGap}, Quat::Identity()});
    pair.clearance = kGap;
    // Many take a second.
    const Felt felt = press(pair, kDeep, {}, n > 16 ? 5 : 1);
    const double ideal = 1000.0 * kDeep;
    const double off = std::fabs(felt.force.norm() / ideal - 1.0);
    const double contacts = pairs_within(kNear, pair, felt.object);
    add_row(outcome.tables[2], {"contacts", std::to_string(2 * n * n) + " triangles", 1e3 * kDeep,
                                felt.force.norm(), ideal, 100.0 * off, contacts});
    worst = std::max(worst, off);
    most = std::max(most, contacts);
  }
  outcome.claims.push_back(
      at_most("contacts",
              "force between blocks that fit each other: off the coupling's law on the ideal proxy",
              100.0 * worst, 1.0, "%"));
  outcome.claims.push_back(
      stated("most-contacts", "pairs of patches that touch, to 5 um, most", most));
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
