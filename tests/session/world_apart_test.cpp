// A world whose hands are stepped apart from it, in lockstep, however long its steps take.

#include "thigma/session/world_apart.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <vector>

#include "session/pushing_world.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using namespace test;

/// A hand that goes where a function of time says; remembers what it was sent, by its reads.
class MovingHand final : public HapticDevice {
 public:
  using Path = std::function<Vec3(double)>;
  explicit MovingHand(Path path) : path_(std::move(path)) {
    limits_.holds_person = false;
    limits_.max_force = 8.0;
    limits_.max_torque = 1.0;
  }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "moving"; }
  DeviceState read(double now) THIGMA_RT override {
    constexpr double kStep = 1e-6;
    DeviceState state;
    state.time = now;
    state.motion.pose.position = path_(now);
    state.motion.twist.linear = (path_(now + kStep) - path_(now - kStep)) / (2.0 * kStep);
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override { sent.push_back(wrench.force); }
  std::vector<Vec3> sent;

 private:
  Path path_;
  DeviceLimits limits_;
};

/// Without ramps, so that forces are those of the single loop.
void send_at_once(WorldSessionConfig& config) {
  for (WorldHand& hand : config.hands) {
    hand.limits.start_ramp = 0.0;
    hand.limits.clear_before_arming = 0.0;
    hand.limits.force_slew = hand.limits.torque_slew = 1e9;
  }
}

struct Scene {
  WorldBench bench;
  WorldSessionConfig config;
  MovingHand::Path path;
};

/// Pushes two blocks over a floor, comes back, pushes again.
void make_pushing(Scene& scene) {
  scene.config = pushing(scene.bench);
  scene.config.duration = 1.0;
  scene.path = [](double t) {
    const double reach = 0.02;
    return Vec3(reach * (1.0 - std::cos(2.0 * std::numbers::pi * t)), 0.0, 0.0);
  };
}

/// A tower of thirty blocks; the hand holds a block above it, comes down on it, presses and goes
/// aside a little.
void make_tower(Scene& scene) {
  WorldBench& bench = scene.bench;
  add_floor(bench, 1.0);
  const auto block = body_mesh(make_box(Vec3(0.05, 0.03, 0.02)));
  for (int i = 0; i < 30; ++i)
    bench.add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.010002 + 0.020002 * i), Quat::Identity(),
              600.0)
        .friction = {0.5, 0.5};
  bench.add(body_mesh(make_box(Vec3(0.02, 0.02, 0.02))), BodyKind::held,
            Vec3(0.0, 0.0, 0.020002 * 30 + 0.015));
  bench.make();
  scene.config = one_handed(bench);
  scene.config.hands[0].body = 31;
  scene.config.duration = 1.0;
  scene.path = [](double t) {
    const double down = 0.007 * (1.0 - std::cos(std::numbers::pi * std::min(2.0 * t, 1.0))) / 2.0;
    const double aside = t < 0.5 ? 0.0 : 1e-3 * std::sin(2.0 * std::numbers::pi * 2.0 * (t - 0.5));
    return Vec3(aside, 0.0, -down);
  };
}

/// Pegs and a ball among them in a tray: the ball rakes through.
void make_tray(Scene& scene) {
  WorldBench& bench = scene.bench;
  add_floor(bench, 0.4);
  const auto peg = body_mesh(make_box(Vec3(0.012, 0.012, 0.025)));
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k)
      bench.add(peg, BodyKind::moving, Vec3(0.02 * i, 0.02 * (k - 1), 0.0125 + 3e-6),
                Quat::Identity(), 2000.0);
  bench.add(body_mesh(make_box(Vec3(0.015, 0.015, 0.015))), BodyKind::held,
            Vec3(-0.02, 0.003, 0.012), Quat::Identity(), 2000.0);
  bench.make();
  scene.config = one_handed(bench);
  scene.config.hands[0].body = 10;
  scene.config.duration = 1.0;
  scene.path = [](double t) {
    return Vec3(0.03 * (1.0 - std::cos(2.0 * std::numbers::pi * t)), 0.0, 0.0);
  };
}

/// What a run was like at the hand.
struct Felt {
  WorldSummary summary;
  std::vector<Vec3> forces;   // by haptic frame
  std::vector<double> ages;   // of models
  double nearest = kInfinity;  // the body in the hand to what the world had then [m]
};

Felt feel(Scene& scene, int world_every, bool measures = false) {
  Felt felt;
  MovingHand hand(scene.path);
  HapticDevice* device = &hand;
  ApartLockstep how;
  how.world_every = world_every;
  // What the world makes while the haptic steps go, and has when they have gone.
  std::vector<BodyState> comes = scene.bench.state.bodies;
  how.world = [&](const WorldFrame& frame) {
    comes.assign(frame.bodies.begin(), frame.bodies.end());
  };
  const auto held = static_cast<std::size_t>(scene.config.hands[0].body);
  std::uint64_t count = 0;
  BodyState last;
  bool has_last = false;
  how.haptic = [&](std::size_t, const HapticSample& sample) {
    felt.forces.push_back(sample.command.force);
    felt.ages.push_back(sample.model_age);
    if (measures && has_last && ++count % 10 == 0) {
      WorldBench& bench = scene.bench;
      bench.state.bodies = comes;
      bench.state.bodies[held] = last;
      for (std::size_t i = 0; i < bench.bodies.size(); ++i)
        if (i != held && (bench.state.bodies[i].position - last.position).norm() < 0.1)
          felt.nearest = std::min(felt.nearest, bench.distance(i, held));
    }
    last = sample.body;
    has_last = sample.is_grasped;
  };
  felt.summary = run_world_apart(scene.config, {&device, 1}, how);
  return felt;
}

/// The same in the single loop.
Felt feel_in_one_loop(const Scene& scene) {
  Felt felt;
  MovingHand hand(scene.path);
  felt.summary = run_one(scene.config, &hand, [&](const WorldFrame& frame) {
    felt.forces.push_back(frame.commands[0].force);
  });
  return felt;
}

void tell(const char* name, int every, const Felt& felt) {
  const WorldHapticSummary& h = felt.summary.haptic[0];
  std::printf(
      "%s every %d: force %.4f N, energy %.3e least %.3e J, world's %.3e least %.3e made %.3e, "
      "rows %d bodies %d newton %d cut %llu back %llu corrections %llu by %.3e m, age %.3f s, "
      "nearest %.3e, fault %s\n",
      name, every, h.force_max, h.port_energy, h.port_energy_min, felt.summary.port_energy,
      felt.summary.port_energy_min, felt.summary.energy_made, h.rows_max, h.bodies_max,
      h.newton_max, static_cast<unsigned long long>(h.cut_short),
      static_cast<unsigned long long>(h.held_back), static_cast<unsigned long long>(h.corrections),
      h.correction_max, h.model_age_max, felt.nearest, fault_name(felt.summary.fault));
}

TEST(WorldApart, Explore) {
  for (int which = 0; which < 3; ++which) {
    const char* name = which == 0 ? "pushing" : which == 1 ? "tower" : "tray";
    const auto make = [&](Scene& scene) {
      (which == 0 ? make_pushing : which == 1 ? make_tower : make_tray)(scene);
      send_at_once(scene.config);
    };
    Scene scene;
    make(scene);
    const Felt one = feel_in_one_loop(scene);
    std::printf("%s alone: force %.4f N, energy %.3e least %.3e J made %.3e fault %s\n", name,
                one.summary.force_max, one.summary.port_energy, one.summary.port_energy_min,
                one.summary.energy_made, fault_name(one.summary.fault));
    for (const int every : {1, 4, 16, 50}) {
      const Felt felt = feel(scene, every, true);
      tell(name, every, felt);
      if (every > 1) continue;
      double sum = 0.0;
      std::vector<double> errors;
      for (std::size_t i = 1; i < std::min(one.forces.size(), felt.forces.size()); ++i) {
        errors.push_back((one.forces[i] - felt.forces[i]).norm());
        sum += errors.back();
      }
      std::printf("  error mean %.3e", sum / static_cast<double>(errors.size()));
      std::vector<double> sorted = errors;
      std::sort(sorted.begin(), sorted.end());
      for (const double q : {0.5, 0.9, 0.99, 0.999})
        std::printf(" p%g %.3e", 100 * q,
                    sorted[static_cast<std::size_t>(q * static_cast<double>(sorted.size() - 1))]);
      std::printf(" most %.3e at %zu\n", sorted.back(),
                  static_cast<std::size_t>(std::max_element(errors.begin(), errors.end()) -
                                           errors.begin()));
    }
  }
}

}  // namespace
}  // namespace thigma
