#include "experiments/never-enters/play.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "experiments/common/statistics.h"

namespace thigma::experiments::never_enters {
namespace {

constexpr double kPress = 0.009;  // of the hand beyond the first touch [m]

}  // namespace

Ran play(const Seen& seen, const PressedScene& scene, const Play& how) {
  LedGains gains;
  gains.is_constrained = how.is_constrained;
  gains.every = how.every;
  gains.threshold = how.threshold;
  gains.latency = how.latency;
  Ran ran;
  DepthMemory memory;
  int frame = 0;
  std::vector<double> forces[3];
  Vec3 first = Vec3::Zero(), last = Vec3::Zero();
  const auto look = [&](const HapticSample& sample, const LedStep&) {
    ran.force = sample.command.force.norm();
    if (sample.time >= kAtRest) {
      if (forces[0].empty()) first = sample.body.position;
      last = sample.body.position;
      for (int k = 0; k < 3; ++k) forces[k].push_back(sample.command.force[k]);
    }
    if (frame++ % how.look != 0) return;
    const double depth = outside_depth(seen.object, {sample.body.position, sample.body.orientation},
                                       seen.scene, memory);
    ran.ever = std::max(ran.ever, depth);
    if (sample.time >= kAtRest) ran.at_rest = std::max(ran.at_rest, depth);
  };
  ran.run = run_led(led_config(seen.pair, gains, kPressedSeconds),
                    pressed_hand(seen.pair, scene, kPress), look);
  for (const std::vector<double>& f : forces)
    ran.buzz = std::hypot(ran.buzz, band_level(f, 1e-3, 50.0, 500.0));
  ran.drift = (last - first).norm() / (kPressedSeconds - kAtRest);
  return ran;
}

double buzz_of_age(double full_age) {
  const PressedScene scene = built_in_scenes(2000).front();
  const LedPair pair = scene.make();
  LedGains gains;
  gains.every = 33;
  SessionConfig config = led_config(pair, gains, kPressedSeconds);
  SafetyLimits& safety = config.haptic.safety;
  safety.model_full_age = safety.rows_full_age = full_age;
  safety.rows_stale_age = safety.model_stale_age;
  std::vector<double> force;
  run_led(config, pressed_hand(pair, scene, kPress),
          [&](const HapticSample& sample, const LedStep&) {
            if (sample.time >= kAtRest) force.push_back(sample.command.force.z());
          });
  return band_level(force, 1e-3, 50.0, 500.0);
}

}  // namespace thigma::experiments::never_enters
