#include "experiments/closed-loops/loops.h"

#include <algorithm>
#include <cmath>

#include "experiments/common/assets.h"

#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"
#include "thigma/response/potential_contacts.h"

namespace thigma::experiments {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kIn = 0.3;  // from the start to phase 0 [s]

TriangleMesh plate(std::array<int, 3> segments) {
  return transformed(make_box({0.1, 0.06, 0.01}, segments), {{0.0, 0.0, -0.005}, Quat::Identity()});
}

/// A plate whose left half is of few triangles and whose right half is of many.
TriangleMesh half_fine_plate() {
  std::vector<double> xs = {-0.05}, ys, zs = {-0.01, 0.0};
  for (int i = 0; i <= 24; ++i) xs.push_back(0.05 * i / 24.0);
  for (int i = 0; i <= 4; ++i) ys.push_back(-0.03 + 0.06 * i / 4.0);
  return make_blocks(xs, ys, zs, [](int, int, int) { return true; });
}

/// A bridge on two feet of 4 mm, 20 mm apart.
TriangleMesh two_feet() {
  const double xs[] = {-0.012, -0.008, 0.008, 0.012}, ys[] = {-0.005, 0.005};
  const double zs[] = {0.0, 0.006, 0.014};
  return make_blocks(xs, ys, zs, [](int i, int, int k) { return k == 1 || i != 1; });
}

Loop rocked_feet() {
  Loop loop{.name = "two feet rocked"};
  loop.pair =
      make_led_pair(loop.name, two_feet(), plate({4, 4, 1}), {{0.0, 0.0, 1e-3}, Quat::Identity()});
  const Pose start = loop.pair.start;
  loop.pressed = [start](double phase) {
    const SinCos a = sin_cos(kTwoPi * phase);
    // Tilt and load out of step, so that the loop encloses an area.
    return Pose{start.position - Vec3(0.0, 0.0, 0.003 + 0.0005 * a.cos),
                rotation_from_vector({0.0, 0.06 * a.sin, 0.0})};
  };
  return loop;
}

Loop wobbled_cube() {
  Loop loop{.name = "cube wobbled"};
  loop.pair = make_led_pair(loop.name, make_box(Vec3::Constant(0.02), {3, 3, 3}), plate({4, 4, 1}),
                            {{0.0005, 0.0007, 0.011}, Quat::Identity()});
  const Pose start = loop.pair.start;
  loop.pressed = [start](double phase) {
    const SinCos a = sin_cos(kTwoPi * phase);
    return Pose{start.position - Vec3(0.0, 0.0, 0.0027),
                rotation_from_vector({0.05 * a.cos, 0.05 * a.sin, 0.0})};
  };
  return loop;
}

Loop coarse_and_fine() {
  Loop loop{.name = "coarse and fine"};
  loop.pair = make_led_pair(loop.name, make_ball(0.008, 6), half_fine_plate(),
                            {{-0.02, 0.003, 0.009}, Quat::Identity()});
  const Pose start = loop.pair.start;
  loop.pressed = [start](double phase) {
    const SinCos a = sin_cos(kTwoPi * phase);
    // Down on the coarse half, over to the fine one, up there, back in the air.
    return Pose{start.position + Vec3(0.02 - 0.02 * a.sin, 0.0, 0.0002 - 0.0022 * (1.0 - a.cos)),
                Quat::Identity()};
  };
  return loop;
}

Loop circled_jaws(int triangles) {
  Loop loop{.name = "jaws circled", .contact_stiffness = 5000.0};
  loop.pair = placed_apart(make_led_pair(loop.name, make_mesh(model_uri("jaw_upper", triangles)),
                                         make_mesh(model_uri("jaw_lower", triangles)),
                                         {{0.0, 0.0, 0.001}, Quat::Identity()}),
                           -Vec3::UnitZ(), 1e-3);
  const Pose start = loop.pair.start;
  loop.pressed = [start](double phase) {
    const SinCos a = sin_cos(kTwoPi * phase);
    return Pose{start.position + Vec3(0.0005 * a.cos, 0.0005 * a.sin, -0.003), start.orientation};
  };
  return loop;
}

}  // namespace

std::vector<Loop> closed_loops(int triangles) {
  std::vector<Loop> loops;
  loops.push_back(rocked_feet());
  loops.push_back(wobbled_cube());
  loops.push_back(coarse_and_fine());
  loops.push_back(circled_jaws(triangles));
  return loops;
}

LoopRun run_loop(const Loop& loop, const LedGains& gains, bool is_reversed, int cycles) {
  const Pose start = loop.pair.start;
  const HandPath hand = [&](double t) {
    const double turns = (t - kIn) / loop.cycle;
    const double phase =
        t < kIn ? 0.0 : (is_reversed ? -turns : turns) - std::floor(is_reversed ? -turns : turns);
    Pose pose = loop.pressed(phase);
    if (t >= kIn) return pose;
    const double in = t / kIn;
    pose.position = start.position + in * (pose.position - start.position);
    const Vec3 turn = vector_from_rotation(pose.orientation * start.orientation.conjugate());
    pose.orientation = rotation_from_vector(in * turn) * start.orientation;
    return pose;
  };
  LoopRun result;
  const int in = static_cast<int>(std::lround(1e3 * kIn));
  const int cycle = static_cast<int>(std::lround(1e3 * loop.cycle));
  int frame = 0;
  double begun = 0.0;
  const auto look = [&](const HapticSample& sample, const LedStep&) {
    result.force = std::max(result.force, sample.command.force.norm());
    const int after = frame++ - in;
    if (after <= 0 || after % cycle != 0) return;
    if (after > cycle) result.put_in.push_back(sample.energy - begun);
    begun = sample.energy;
  };
  const LedRun run =
      run_led(led_config(loop.pair, gains, kIn + cycles * loop.cycle + 0.01), hand, look);
  result.energy_min = run.energy_min;
  result.held_back = run.held_back;
  result.frames = run.frames;
  return result;
}

LawLoop run_law(const Loop& loop, bool is_reversed, int steps) {
  constexpr double kForce = 2.0, kMostLift = 4e-3;
  constexpr int kHalvings = 14;
  const LedPair& pair = loop.pair;
  const std::vector<SceneBody> bodies = {{pair.scene_levels.get(), Pose{}}};
  const PotentialWorld world = make_potential_world(*pair.object_levels, Pose{}, bodies);
  const PotentialLaw law{.exponent = 4, .area = 0.0625 * pair.reach * pair.reach};
  PotentialScratch scratch;
  reserve_potential(world, scratch);
  const auto push = [&](const Pose& pose) {
    BodyState state;
    state.position = pose.position;
    state.orientation = pose.orientation;
    return potential_force(measure_potential(world, state, law, pair.tolerance, scratch).moments,
                           loop.contact_stiffness, law)
        .wrench;
  };
  const auto lifted = [&](double phase, double lift) {
    Pose pose = loop.pressed(phase - std::floor(phase));
    pose.position.z() += lift;
    return pose;
  };
  double low = 0.0, high = kMostLift;
  for (int i = 0; i < kHalvings; ++i) {
    const double lift = 0.5 * (low + high);
    double most = 0.0;
    for (const double phase : {0.0, 0.25, 0.5, 0.75})
      most = std::max(most, push(lifted(phase, lift)).force.norm());
    (most > kForce ? low : high) = lift;
  }
  LawLoop result;
  Pose before;
  Wrench pushed;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const Pose pose = lifted(is_reversed ? -share : share, low);
    const Wrench wrench = push(pose);
    result.force = std::max(result.force, wrench.force.norm());
    if (i > 0) {
      const Vec3 turn = vector_from_rotation(pose.orientation * before.orientation.conjugate());
      const double out = 0.5 * ((wrench.force + pushed.force).dot(pose.position - before.position) +
                                (wrench.torque + pushed.torque).dot(turn));
      result.handed_out += out;
      result.put_in += std::max(-out, 0.0);
    }
    before = pose;
    pushed = wrench;
  }
  return result;
}

}  // namespace thigma::experiments
