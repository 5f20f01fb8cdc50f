#include "experiments/e3-z-width/engine_width.h"

#include <algorithm>
#include <cmath>

#include "thigma/device/hand.h"
#include "thigma/dynamics/sampled_loop.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma::experiments {
namespace {

constexpr double kRadius = 0.015, kMass = 0.010;             // of the object [m, kg]
constexpr double kMoment = 0.4 * kMass * kRadius * kRadius;  // a ball's [kg m^2]
constexpr double kContactStiffness = 6000.0;                 // as `tune` proposes for 10 g [N/m]
constexpr double kWallTolerance = 5e-5;                      // [m]
constexpr double kCalmLinear = 300.0, kCalmAngular = 0.05;   // [N/m, N m/rad]
constexpr double kJudged = 0.25;  // of three seconds: creep of a settling hand is no swing [s]
// Of the grasp point where rotation is asked about, so that pressing turns the object; held in the
// middle otherwise, or the hand would feel nothing but how it tilts [m].
constexpr double kLever = 0.010;

void add(ContactSet& set, const Vec3& point, const Vec3& normal, double depth, double tolerance,
         int patch) {
  if (depth < -tolerance || set.contacts.size() == set.contacts.capacity()) return;
  Contact c;
  c.point = point;
  c.normal = normal;
  c.depth = depth;
  c.scene_point = point - depth * normal;
  c.object_patch = patch;
  c.scene_patch = patch;
  set.contacts.push_back(c);
}

/// A ball between walls through the origin's line y = 0; `slope` of each side to the horizontal
/// [rad].
ContactSource groove(double slope) {
  const SinCos s = sin_cos(slope);
  return [s, flat = slope == 0.0](const Pose& at, double tolerance, ContactSet& set) {
    for (const double side : {1.0, -1.0}) {
      const Vec3 out(0.0, side * s.sin, -s.cos);  // into the wall of that side
      const Vec3 point = at.position + kRadius * out;
      add(set, point, out, out.dot(point), tolerance, side > 0.0 ? 0 : 1);
      if (flat) return;
    }
  };
}

/// A peg along z in a square hole; its ends touch the four sides, its foot the ground.
void peg(const Pose& at, double tolerance, ContactSet& set) {
  constexpr double kHalf = 0.005, kClear = 1e-4, kLength = 0.030;
  int patch = 0;
  for (const double end : {-0.5, 0.5}) {
    const Vec3 middle = transform_point(at, Vec3(0.0, 0.0, end * kLength));
    for (const Vec3& side : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0)}) {
      const Vec3 point = transform_point(at, Vec3(0.0, 0.0, end * kLength) + kHalf * side);
      add(set, point, side, side.dot(point) - kHalf - kClear, tolerance, patch++);
    }
    if (end < 0.0) add(set, middle, -Vec3::UnitZ(), -middle.z(), tolerance, patch);
    ++patch;
  }
}

double critical(double stiffness, double mass) { return 2.0 * std::sqrt(stiffness * mass); }

SessionConfig session(const Place& place, double k_c, double k_t, double lever) {
  SessionConfig config;
  config.haptic.body = make_body(kMass, kMoment * Mat3::Identity());
  Coupling& c = config.haptic.coupling;
  c.linear_stiffness = k_c;
  c.linear_damping = critical(k_c, kMass);
  c.angular_stiffness = k_t;
  c.angular_damping = critical(k_t, kMoment);
  config.haptic.grasp_point = {lever, 0.0, 0.0};
  // What is looked for is where the loop swings, not what the limits make of it.
  config.haptic.safety.force_slew = config.haptic.safety.torque_slew = 1e9;
  config.haptic.safety.max_speed = 100.0;
  config.haptic.safety.pose_jump = 1.0;
  config.haptic.safety.max_turn_speed = 1e3;
  config.haptic.safety.orientation_jump = 10.0;
  config.contact.source = place.contacts;
  config.contact.tolerance = kWallTolerance;
  config.contact.response = {.stiffness = kContactStiffness,
                             .damping = critical(kContactStiffness, kMass)};
  config.contact.capacity = 64;
  config.world_from_body.position.z() = place.gap;
  config.duration = 3.0;
  return config;
}

}  // namespace

std::vector<Place> engine_places() {
  constexpr double kDegree = 3.14159265358979323846 / 180.0;
  std::vector<Place> places = {{"wall", groove(0.0), kRadius + 0.005}};
  for (const double angle : {60.0, 90.0, 120.0}) {
    const double slope = (90.0 - 0.5 * angle) * kDegree;
    places.push_back({"groove " + std::to_string(static_cast<int>(angle)), groove(slope),
                      kRadius / sin_cos(0.5 * angle * kDegree).sin + 0.005});
  }
  places.push_back({"peg", peg, 0.015 + 0.005});
  return places;
}

EngineRest press_in(const Place& place, double k_c, double k_t, double delay, bool turns) {
  HandParams params;
  params.program.path = HandPath::press;
  params.program.clearance = 0.005;
  params.program.reach = 0.020;
  params.max_force = 100.0;
  params.max_torque = 10.0;
  params.delay = delay;
  HandDevice hand(params);
  SessionConfig config = session(place, k_c, k_t, turns ? kLever : 0.0);
  config.haptic.device = hand.limits();
  Vec3 low[2] = {Vec3::Constant(1e300), Vec3::Constant(1e300)};
  Vec3 high[2] = {Vec3::Constant(-1e300), Vec3::Constant(-1e300)};
  const auto look = [&](const HapticSample& sample) {
    if (sample.time < config.duration - kJudged) return;
    const Pose& at = hand.true_motion().pose;
    const Vec3 now[2] = {at.position, vector_from_rotation(at.orientation)};
    for (int i = 0; i < 2; ++i) {
      low[i] = low[i].cwiseMin(now[i]);
      high[i] = high[i].cwiseMax(now[i]);
    }
  };
  const SessionSummary summary =
      run_lockstep(config, hand, {.haptic = look, .contact = {}, .event = {}});
  EngineRest rest;
  rest.sway = (high[0] - low[0]).norm();
  rest.turn = (high[1] - low[1]).norm();
  rest.force = summary.force_max;
  rest.is_unstable = summary.end == SessionEnd::fault || rest.sway > 2.0 * params.encoder ||
                     rest.turn > 2.0 * params.angular_encoder;
  return rest;
}

double loop_boundary(bool is_angular, double delay) {
  const HandParams hand;
  SampledLoop loop{.delay = delay,
                   .handle_mass = hand.mass,
                   .handle_damping = hand.damping,
                   .arm_mass = hand.arm_mass,
                   .arm_stiffness = hand.arm_stiffness,
                   .arm_damping = hand.arm_damping,
                   .body_mass = kMass,
                   .contact_stiffness = kContactStiffness,
                   .contact_damping = critical(kContactStiffness, kMass)};
  if (is_angular) {
    // The object turns about its point of contact at most; a wall does not hold its rotation.
    loop = {.delay = delay,
            .handle_mass = hand.inertia,
            .handle_damping = hand.angular_damping,
            .arm_mass = hand.arm_inertia,
            .arm_stiffness = hand.arm_angular_stiffness,
            .arm_damping = hand.arm_angular_damping,
            .body_mass = kMoment};
  }
  double low = is_angular ? 1e-4 : 1.0, high = is_angular ? 1e3 : 1e6;
  for (int i = 0; i < 24; ++i) {
    loop.coupling_stiffness = std::sqrt(low * high);
    loop.coupling_damping = critical(loop.coupling_stiffness, loop.body_mass);
    (loop_growth(loop) < 1.0 ? low : high) = loop.coupling_stiffness;
  }
  return low;
}

double engine_boundary(const Place& place, bool is_angular, double delay, double highest) {
  double low = is_angular ? 1e-3 : 10.0, high = highest;
  const auto is_unstable = [&](double k) {
    return press_in(place, is_angular ? kCalmLinear : k, is_angular ? k : kCalmAngular, delay,
                    is_angular)
        .is_unstable;
  };
  if (!is_unstable(high)) return high;
  while (high > 1.05 * low) {
    const double middle = std::sqrt(low * high);
    (is_unstable(middle) ? high : low) = middle;
  }
  return low;
}

}  // namespace thigma::experiments
