#include "experiments/throws/in_the_air.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "experiments/common/assets.h"
#include "experiments/common/led_session.h"
#include "experiments/common/outside_depth.h"

#include "thigma/constraint/build_constraints.h"
#include "thigma/mesh/shapes.h"
#include "thigma/models/conforming.h"

namespace thigma::experiments {
namespace {

constexpr double kAway = 0.060, kDeep = 0.002, kNear = 0.005;  // [m]
constexpr double kRest = 0.02, kFrame = 1e-3;  // before it sets out; a haptic frame [s]

LedPair air_pair(int index) {
  const Pose above{{0.0005, 0.0007, 0.05}, Quat::Identity()};
  if (index == 0) {
    const Pose down{{0.0, 0.0, -0.005}, Quat::Identity()};
    return placed_apart(
        make_led_pair("cube over plate", make_box(Vec3::Constant(0.02), {4, 4, 4}),
                      transformed(make_box({0.1, 0.1, 0.01}, {4, 4, 1}), down), above),
        -Vec3::UnitZ(), 1e-3);
  }
  if (index == 1) {
    return placed_apart(
        make_led_pair("ball over ball", make_ball(0.01, 24), make_ball(0.02, 30), above),
        -Vec3::UnitZ(), 1e-3);
  }
  if (index == 3) {
    constexpr int kTriangles = 12'000;
    return placed_apart(
        make_led_pair("conforming discs", models::make_conforming_upper(kTriangles, 1),
                      models::make_conforming_lower(kTriangles, 1), above),
        -Vec3::UnitZ(), 1e-3);
  }
  const Pose apart{{0.0, 0.0, 0.003}, Quat::Identity()};
  return placed_apart(make_led_pair("jaws", make_mesh(model_uri("jaw_upper", 4000)),
                                    make_mesh(model_uri("jaw_lower", 4000)), apart),
                      -Vec3::UnitZ(), 1e-3);
}

/// Down and up between `kAway` over the touch and `kDeep` under it, at one speed; until `begin` [s]
/// it rests.
HandPath to_and_fro(const Pose& touching, double speed, double begin) {
  return [=](double t) {
    const double way = kAway + kDeep;
    const double gone = std::fmod(speed * std::max(t - begin, 0.0), 2.0 * way);
    const double height = kAway - (gone < way ? gone : 2.0 * way - gone);
    return Pose{touching.position + height * Vec3::UnitZ(), touching.orientation};
  };
}

/// What is led, and how.
struct AirSetup {
  double speed;
  int every;
  double ahead;
};

std::vector<HapticSample> samples_of(const LedPair& pair, const HandPath& hand,
                                     const AirSetup& setup, std::vector<LedStep>& steps) {
  LedGains gains;
  gains.every = setup.every;
  const double seconds = kRest + 2.0 * 2.0 * (kAway + kDeep) / setup.speed;
  std::vector<HapticSample> samples;
  SessionConfig config = led_config(pair, gains, seconds);
  ConstraintWorld world = *config.contact.constraints;
  world.most_look_ahead *= setup.ahead;
  config.contact.constraints = std::make_shared<const ConstraintWorld>(std::move(world));
  run_led(config, hand, [&](const HapticSample& s, const LedStep& step) {
    samples.push_back(s);
    steps.push_back(step);
  });
  return samples;
}

}  // namespace

AirRun run_in_the_air(int index, double speed, int every, double ahead, double late) {
  LedPair pair = air_pair(index);
  Pose touching = pair.start;
  touching.position.z() -= pair.clearance;
  const HandPath hand = to_and_fro(touching, speed, kRest + late * every * kFrame);
  pair.start = hand(0.0);
  const AirSetup setup{speed, every, ahead};
  std::vector<LedStep> steps, free_steps;
  const std::vector<HapticSample> with = samples_of(pair, hand, setup, steps);
  // The same without a scene: the hand a hundred metres up.
  const Vec3 up(0.0, 0.0, 100.0);
  LedPair alone = pair;
  alone.start.position += up;
  const HandPath high = [&](double t) {
    Pose pose = hand(t);
    pose.position += up;
    return pose;
  };
  const std::vector<HapticSample> without = samples_of(alone, high, setup, free_steps);
  AirRun run;
  bool has_touched = false;
  for (std::size_t i = 0; i < with.size(); ++i) {
    const double height = with[i].body.position.z() - touching.position.z();
    const bool is_air = height > kNear;
    has_touched = has_touched || with[i].touching > 0;
    if (is_air) {
      ++run.air_frames;
      run.air_held += steps[i].is_held_back;
    } else if (with[i].touching == 0) {
      ++run.near_frames;
      run.near_held += steps[i].is_held_back;
    }
    // After a touch the two differ by what the touch did; they are compared up to it.
    if (!is_air || has_touched) continue;
    run.lag =
        std::max(run.lag, (with[i].body.position + up - without[i].body.position).norm() / speed);
    run.phantom = std::max(run.phantom, (with[i].command.force - without[i].command.force).norm());
  }
  return run;
}

void add_air_run(const AirRun& run, AirRun& sum) {
  sum.air_frames += run.air_frames;
  sum.air_held += run.air_held;
  sum.near_frames += run.near_frames;
  sum.near_held += run.near_held;
  sum.lag = std::max(sum.lag, run.lag);
  sum.phantom = std::max(sum.phantom, run.phantom);
}

}  // namespace thigma::experiments
