// A world whose hands are stepped apart from it, in lockstep, however long its steps take.

#include "thigma/session/world_apart.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "session/pushing_world.h"
#include <gtest/gtest.h>

#include "thigma/device/script.h"
#include "thigma/scene/world_scene.h"

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
    if (has_last_) energy -= last_.dot(state.motion.pose.position - at_);
    least = std::min(least, energy);
    has_last_ = true;
    at_ = state.motion.pose.position;
    state.motion.twist.linear = (path_(now + kStep) - path_(now - kStep)) / (2.0 * kStep);
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override { last_ = wrench.force; }
  double energy = 0.0, least = 0.0;  // that it has put in, its force held from read to read [J]

 private:
  Path path_;
  bool has_last_ = false;
  Vec3 last_ = Vec3::Zero(), at_ = Vec3::Zero();
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
    bench
        .add(block, BodyKind::moving, Vec3(0.0, 0.0, 0.010002 + 0.020002 * i), Quat::Identity(),
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

/// A drawer on a slider, with the handle of another hand's block against its front.
void make_drawer(Scene& scene) {
  WorldBench& bench = scene.bench;
  bench.add(body_mesh(make_box(Vec3(0.1, 0.06, 0.03))), BodyKind::held, Vec3::Zero());
  WorldJoint slider;
  slider.name = "rail";
  slider.kind = JointKind::slider;
  slider.a = 0;
  slider.lower = -0.015;
  slider.upper = 0.015;
  slider.damping = 2.0;
  const BodyState start[] = {bench.bodies[0].start};
  place_joint(slider, joint_frame(Vec3::Zero(), Vec3::UnitX()), start);
  bench.world = make_world(bench.bodies, Vec3(0.0, 0.0, -9.81), {slider});
  bench.state = start_state(bench.world);
  scene.config = one_handed(bench);
  scene.config.hands[0].body = 0;
  scene.config.duration = 1.0;
  scene.path = [](double t) {
    const double turn = 2.0 * std::numbers::pi * t;
    return Vec3(0.0085 * (1.0 - std::cos(turn)), 0.002 * (1.0 - std::cos(turn)), 0.0);
  };
}

using Make = void (*)(Scene&);

/// What a run was like at the hand.
struct Felt {
  WorldSummary summary;
  std::vector<Vec3> forces;  // by haptic frame
  std::vector<double> ages;  // of models
  double least = 0.0;        // of the energy that the hand had put in at its device [J]
  // most that bodies had beyond their start and the most that the hand had put in until then, its
  // own where the haptic step has it; the hand's work at the ends of steps, as that of a world [J]
  double made = 0.0;
};

Felt feel(const Scene& scene, ApartLockstep how) {
  Felt felt;
  MovingHand hand(scene.path);
  HapticDevice* device = &hand;
  const auto held = static_cast<std::size_t>(scene.config.hands[0].body);
  const double begins = mechanical_energy(scene.config.world, scene.config.start);
  WorldState has = scene.config.start;
  double most = 0.0, work = 0.0;
  Vec3 last = scene.path(0.0);
  how.world = [&](const WorldFrame& frame) {
    has.bodies.assign(frame.bodies.begin(), frame.bodies.end());
  };
  how.haptic = [&](std::size_t, const HapticSample& sample) {
    felt.forces.push_back(sample.command.force);
    felt.ages.push_back(sample.model_age);
    if (!sample.is_grasped) return;
    WorldState now = has;
    now.bodies[held] = sample.body;
    const double gained = mechanical_energy(scene.config.world, now) - begins;
    const Vec3& at = sample.device.motion.pose.position;
    work -= sample.command.force.dot(at - last);
    last = at;
    most = std::max(most, work);
    felt.made = std::max(felt.made, gained - most);
  };
  felt.summary = run_world_apart(scene.config, {&device, 1}, how);
  felt.least = hand.least;
  return felt;
}

Felt feel(const Scene& scene, int world_every) {
  ApartLockstep how;
  how.world_every = world_every;
  return feel(scene, how);
}

/// The same in the single loop.
Felt feel_in_one_loop(const Scene& scene) {
  Felt felt;
  MovingHand hand(scene.path);
  felt.summary = run_one(scene.config, &hand, [&](const WorldFrame& frame) {
    felt.forces.push_back(frame.commands[0].force);
  });
  felt.least = hand.least;
  return felt;
}

/// Sorted distances of the forces of two runs, but for the first frame, in which the world has not
/// taken hold yet.
std::vector<double> errors_of(const Felt& a, const Felt& b) {
  std::vector<double> errors;
  for (std::size_t i = 1; i < std::min(a.forces.size(), b.forces.size()); ++i)
    errors.push_back((a.forces[i] - b.forces[i]).norm());
  std::sort(errors.begin(), errors.end());
  return errors;
}

double share(const std::vector<double>& sorted, double of) {
  return sorted[static_cast<std::size_t>(of * static_cast<double>(sorted.size() - 1))];
}

constexpr double kBound = 1e-6;  // of energy that may be handed out beyond the single loop's [J]

TEST(WorldApart, WhereTheWorldKeepsUpTheHandFeelsWhatItFeelsInOneLoop) {
  // The tower's seventh block is where the world begins that the haptic steps do not know.
  const struct {
    Make make;
    double usual, most;  // of 99 % and of all frames [N]
  } cases[] = {{make_pushing, 2e-3, 0.8},
               {make_tower, 0.04, 0.05},
               {make_tray, 1e-3, 0.9},
               {make_drawer, 1e-3, 0.5}};
  for (const auto& c : cases) {
    Scene scene;
    c.make(scene);
    send_at_once(scene.config);
    const Felt one = feel_in_one_loop(scene), apart = feel(scene, 1);
    ASSERT_FALSE(apart.summary.has_fault());
    ASSERT_EQ(apart.forces.size(), 1000u);
    const std::vector<double> errors = errors_of(one, apart);
    EXPECT_LE(share(errors, 0.5), 1e-4);
    EXPECT_LE(share(errors, 0.99), c.usual);
    EXPECT_LE(errors.back(), c.most);
    EXPECT_GE(apart.least, one.least - kBound);
    EXPECT_LE(apart.made, kBound);
    // What the world made of the hand's samples is what it makes in one loop.
    EXPECT_EQ(apart.summary.state_hash, one.summary.state_hash);
  }
}

/// All bodies spring back by this.
void make_springy(double restitution, Scene& scene) {
  WorldBench& bench = scene.bench;
  for (WorldBody& body : bench.bodies) body.restitution = restitution;
  bench.make();
  scene.config.world = bench.world;
  scene.config.start = bench.state;
}

/// A block in the hand is knocked against the floor.
void make_knocking(Scene& scene) {
  WorldBench& bench = scene.bench;
  add_floor(bench, 1.0);
  bench.add(body_mesh(make_box(Vec3(0.04, 0.04, 0.04))), BodyKind::held, Vec3(0.0, 0.0, 0.03));
  bench.make();
  scene.config = one_handed(bench);
  scene.config.hands[0].body = 1;
  scene.config.duration = 1.0;
  scene.path = [](double t) {
    return Vec3(0.0, 0.0, -0.0065 * (1.0 - std::cos(2.0 * std::numbers::pi * 4.0 * t)));
  };
}

TEST(WorldApart, WhatSpringsBackInTheWorldDoesInHapticSteps) {
  // Stopped alone the knocked block was off by 1.3 N and 2.6 N, one in a hundred pushes by 0.06 N
  // and 0.3 N.
  const struct {
    Make make;
    double usual, most;  // of 99 % and of all frames [N]
  } cases[] = {{make_knocking, 1e-9, 1e-9}, {make_pushing, 0.03, 0.6}};
  for (const auto& c : cases) {
    for (const double restitution : {0.5, 1.0}) {
      Scene scene;
      c.make(scene);
      make_springy(restitution, scene);
      send_at_once(scene.config);
      const Felt one = feel_in_one_loop(scene), apart = feel(scene, 1);
      const std::vector<double> errors = errors_of(one, apart);
      EXPECT_GT(one.summary.impacts, 10);
      EXPECT_LE(share(errors, 0.99), c.usual) << restitution;
      EXPECT_LE(errors.back(), c.most) << restitution;
      for (const int every : {1, 4, 16, 50}) {
        const Felt felt = feel(scene, every);
        EXPECT_GE(felt.least, one.least - kBound) << restitution << " " << every;
        EXPECT_LE(felt.made, kBorderCredit + kBound) << restitution << " " << every;
      }
    }
  }
}

TEST(WorldApart, WhatWaitsForTheWorldIsNoWallThatSpringsBack) {
  Scene scene;
  make_tower(scene);
  make_springy(1.0, scene);
  send_at_once(scene.config);
  const std::vector<double> errors = errors_of(feel_in_one_loop(scene), feel(scene, 16));
  EXPECT_LE(errors.back(), 0.6);  // 2.9 N off such a wall
}

TEST(WorldApart, HandsOutNoEnergyHoweverLongAStepOfTheWorldTakes) {
  for (const Make make : {make_pushing, make_tower, make_tray, make_drawer}) {
    Scene scene;
    make(scene);
    send_at_once(scene.config);
    const Felt one = feel_in_one_loop(scene);
    for (const int every : {4, 16, 50}) {
      const Felt felt = feel(scene, every);
      const WorldHapticSummary& h = felt.summary.haptic[0];
      EXPECT_FALSE(felt.summary.has_fault());
      EXPECT_EQ(h.steps, 1000u);  // whatever the world does
      EXPECT_EQ(felt.summary.frames,
                (1000u + static_cast<unsigned>(every) - 1) / static_cast<unsigned>(every));
      EXPECT_LE(h.force_max, 8.0 * (1.0 + 1e-12));
      EXPECT_GE(felt.least, one.least - kBound);
      EXPECT_LE(felt.made, kBorderCredit + kBound);
      EXPECT_LE(h.newton_max, kHandNewton);
      EXPECT_LE(h.rows_max, kHandRows);
      EXPECT_LE(h.bodies_max, kHandBodies);
    }
  }
}

TEST(WorldApart, StepsAmongJointsHaveFactorsEnough) {
  // A peg in the hand in a ring that is fixed to a drawer on rails that rub.
  LoadedWorld world =
      load_world(read_world_scene(std::string(THIGMA_SOURCE_DIR) + "/scenes/drawer.toml"));
  world.config.duration = 3.0;
  for (const int every : {1, 5}) {
    const WorldDevices devices = open_world_devices(world, {}, 1);
    ApartLockstep how;
    how.world_every = every;
    const WorldSummary run = run_world_apart(world.config, devices.list, how);
    EXPECT_FALSE(run.has_fault());
    EXPECT_GT(run.haptic[0].force_max, 0.5);
    EXPECT_EQ(run.haptic[0].cut_short, 0u) << every;
  }
}

TEST(WorldApart, GoesTheSameWayTwice) {
  Scene scene;
  make_tower(scene);
  scene.config.duration = 0.6;
  const Felt first = feel(scene, 7), second = feel(scene, 7);
  EXPECT_EQ(first.summary.state_hash, second.summary.state_hash);
  EXPECT_EQ(first.summary.haptic[0].state_hash, second.summary.haptic[0].state_hash);
  scene.config.start.bodies[31].position.x() += 1e-9;
  EXPECT_NE(feel(scene, 7).summary.haptic[0].state_hash, first.summary.haptic[0].state_hash);
}

TEST(WorldApart, AWorldThatNeverAnswersFadesAndNeverPulls) {
  Scene scene;
  make_pushing(scene);
  send_at_once(scene.config);
  // In contact with both blocks from 0.27 s on.
  constexpr std::uint64_t kLast = 350;
  ApartLockstep how;
  how.lasts = [&](std::uint64_t frame) { return frame < kLast ? 1 : 1'000'000; };
  const Felt felt = feel(scene, how);
  EXPECT_FALSE(felt.summary.has_fault());
  const SafetyLimits limits;
  double pressed = 0.0;
  for (std::size_t i = kLast; i < felt.forces.size(); ++i) {
    const double force = felt.forces[i].norm();
    if (felt.ages[i] <= limits.model_full_age) pressed = std::max(pressed, force);
    if (felt.ages[i] >= limits.model_stale_age) {
      EXPECT_EQ(force, 0.0) << i;
    }
    // The hand goes on in +x until 0.5 s: it is stopped, then nothing is felt.
    if (i < 500) {
      EXPECT_LE(felt.forces[i].x(), 1e-9) << i;
    }
  }
  EXPECT_GT(pressed, 0.5);
  EXPECT_EQ(felt.summary.haptic[0].steps, 1000u);
}

TEST(WorldApart, AStepOfTheWorldThatTakesLongIsOver) {
  Scene scene;
  make_pushing(scene);
  send_at_once(scene.config);
  ApartLockstep how;
  how.lasts = [](std::uint64_t frame) { return frame == 350 ? 138 : 1; };
  const Felt felt = feel(scene, how), usual = feel(scene, 1);
  EXPECT_FALSE(felt.summary.has_fault());
  EXPECT_EQ(felt.summary.frames, 1000u - 137u);
  EXPECT_GE(felt.least, usual.least - kBound);
  EXPECT_LE(felt.made, kBorderCredit + kBound);
  for (std::size_t i = 900; i < 1000; ++i)
    EXPECT_NEAR((felt.forces[i] - usual.forces[i]).norm(), 0.0, 0.05) << i;
}

/// A page's hand: its clutch is closed between two times, and it lifts meanwhile.
class LiftingHand final : public HapticDevice {
 public:
  LiftingHand() {
    limits_.holds_person = false;
    sent.reserve(1000);
  }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "lifting"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    const bool is_closed = (now >= 0.1 && now < 0.4) || now >= 0.42;
    state.buttons = is_closed ? kClutchButton : 0;
    const double lifted = std::clamp(now, 0.1, 0.4) - 0.1;
    state.motion.pose.position.z() = 0.05 * lifted;
    if (now >= 0.1 && now < 0.4) state.motion.twist.linear.z() = 0.05;
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override { sent.push_back(wrench.force.norm()); }
  std::vector<double> sent;

 private:
  DeviceLimits limits_;
};

/// What a hand holds in the frames of its world, which takes a step every so many haptic ones.
std::vector<std::int32_t> held_by(HapticDevice& hand, const WorldSessionConfig& config, int every) {
  HapticDevice* device = &hand;
  ApartLockstep how;
  how.world_every = every;
  std::vector<std::int32_t> held;
  how.world = [&](const WorldFrame& frame) { held.push_back(frame.grips[0].body); };
  EXPECT_FALSE(run_world_apart(config, {&device, 1}, how).has_fault());
  return held;
}

TEST(WorldApart, WithoutADurationItRunsUntilADeviceHasFinished) {
  Scene scene;
  make_pushing(scene);
  scene.config.duration = 0.0;
  const auto plays = [&](const auto& run) {
    const auto script = make_script_device({{.time = 0.0}, {.time = 0.05}});
    HapticDevice* device = script.get();
    return run(std::span<HapticDevice* const>(&device, 1)).frames;
  };
  const std::uint64_t alone = plays([&](auto devices) { return run_world(scene.config, devices); });
  const std::uint64_t apart =
      plays([&](auto devices) { return run_world_apart(scene.config, devices, {}); });
  EXPECT_GT(alone, 40u);
  EXPECT_LT(alone, 60u);
  EXPECT_NEAR(static_cast<double>(apart), static_cast<double>(alone), 2.0);
}

TEST(WorldApart, AFreeHandLetsGoAtOnceHoweverLongAStepOfTheWorldTakes) {
  for (const int every : {1, 8, 40}) {
    WorldBench bench;
    add_floor(bench, 1.0);
    bench.add(body_mesh(make_box(Vec3(0.04, 0.04, 0.04))), BodyKind::moving,
              Vec3(0.0, 0.0, 0.02 + 3e-6));
    bench.make();
    WorldSessionConfig config = free_handed(bench);
    config.hands[0].body = 1;
    config.duration = 0.8;
    send_at_once(config);
    LiftingHand hand;
    const std::vector<std::int32_t> held = held_by(hand, config, every);
    const double weight = bench.bodies[1].mass * 9.81;
    EXPECT_GT(hand.sent[398], 0.5 * weight) << every;
    // Closed again without an aim it holds nothing, though the world has not seen it open.
    for (std::size_t i = 400; i < hand.sent.size() && i < 800; ++i)
      EXPECT_EQ(hand.sent[i], 0.0) << every << " " << i;
    EXPECT_EQ(held.back(), -1) << every;
    EXPECT_EQ(hand.sent.back(), 0.0);
  }
}

/// A page's hand that closes its clutch, is lost at a time with it closed, and comes back.
class LosableHand final : public HapticDevice {
 public:
  LosableHand(double lost, double back) : lost_(lost), back_(back) { limits_.holds_person = false; }
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "losable"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState state;
    state.time = now;
    state.buttons = now >= 0.01 ? kClutchButton : 0;
    state.motion.pose.position.z() = 0.005 * std::min(now, 0.2);
    if (now >= lost_ && now < back_) state.status = DeviceStatus::lost;
    return state;
  }
  void write(const Wrench& wrench) THIGMA_RT override { sent.push_back(wrench.force.norm()); }
  std::vector<double> sent;

 private:
  const double lost_, back_;
  DeviceLimits limits_;
};

/// Three blocks, 1 to 3, and a free hand that is aimed at the second.
WorldSessionConfig aimed_at_the_second(WorldBench& bench) {
  WorldSessionConfig config = test::three_blocks(bench);
  config.hands[0].body = 2;
  config.duration = 0.4;
  send_at_once(config);
  return config;
}

TEST(WorldApart, APageThatIsLostLetsGoThoughTheWorldNeverSeesIt) {
  for (const int every : {1, 40}) {
    WorldBench bench;
    const WorldSessionConfig config = aimed_at_the_second(bench);
    LosableHand hand(0.21, 0.225);  // within one step of the world, of 40 frames
    const std::vector<std::int32_t> held = held_by(hand, config, every);
    EXPECT_GT(hand.sent[209], 0.1) << every;
    for (std::size_t i = 210; i < hand.sent.size(); ++i) EXPECT_EQ(hand.sent[i], 0.0) << every;
    EXPECT_NE(std::count(held.begin(), held.end(), 2), 0) << every;
    EXPECT_EQ(held.back(), -1) << every;
  }
}

TEST(WorldApart, BodiesComeAndGoUnderAHandWhateverAStepOfTheWorldTakes) {
  for (const int every : {1, 8}) {
    WorldBench bench;
    const WorldSessionConfig config = aimed_at_the_second(bench);
    // Without the first block, then without the second as well: the one in the hand.
    std::vector<WorldSessionConfig> next(2, config);
    for (WorldSessionConfig& one : next) {
      bench.bodies.erase(bench.bodies.begin() + 1);
      bench.make();
      one.world = bench.world;
      one.start = bench.state;
      one.hands[0].couplings.resize(bench.bodies.size());
    }
    LosableHand hand(1e9, 1e9);
    HapticDevice* device = &hand;
    ApartLockstep how;
    how.world_every = every;
    std::uint64_t frame = 0;
    const auto change = [&](WorldRun& run, std::size_t number) {
      WorldState state = next[number].start;
      const std::vector<BodyState>& before = run.state().bodies;
      state.bodies = {before[0]};
      state.bodies.insert(state.bodies.end(), before.begin() + 2, before.end());
      std::vector<std::int32_t> was = {0, 2, 3};
      was.resize(state.bodies.size());
      run.go_on(next[number], state, was);
    };
    const auto at = [&](std::uint64_t tick) { return tick / static_cast<std::uint64_t>(every); };
    how.between = [&](WorldRun& run) {
      if (frame == at(160)) change(run, 0);
      if (frame == at(240)) change(run, 1);
      ++frame;
    };
    std::vector<std::int32_t> held;
    how.world = [&](const WorldFrame& made) { held.push_back(made.grips[0].body); };
    const WorldSummary run = run_world_apart(config, {&device, 1}, how);
    EXPECT_FALSE(run.has_fault());
    EXPECT_EQ(held[at(160) - 1], 2);
    EXPECT_EQ(held[at(160)], 1);  // the same one
    EXPECT_EQ(held.back(), -1);
    const double before = hand.sent[150];
    EXPECT_GT(before, 0.1);
    for (std::size_t i = 150; i < 240; ++i) EXPECT_NEAR(hand.sent[i], before, 0.5 * before) << i;
    for (std::size_t i = 250; i < hand.sent.size(); ++i) EXPECT_EQ(hand.sent[i], 0.0) << i;
    EXPECT_EQ(run.haptic[0].steps, 400u);
  }
}

TEST(WorldApart, AFaultOfOneHandLeavesBothAtZeroForce) {
  for (const bool is_left : {true, false}) {
    WorldBench bench;
    WorldSessionConfig config = with_two_hands(bench, false);
    send_at_once(config);
    BadDevice bad(0.05, BadDevice::Trouble::lost, 0.3), good(0.05, BadDevice::Trouble::none, 0.0);
    HapticDevice* devices[] = {is_left ? &bad : &good, is_left ? &good : &bad};
    ApartLockstep how;
    how.world_every = 10;
    const WorldSummary run = run_world_apart(config, devices, how);
    EXPECT_EQ(run.fault, Fault::device_lost);
    EXPECT_EQ(run.hands[is_left ? 0 : 1].fault, Fault::device_lost);
    EXPECT_EQ(run.haptic[0].steps, 301u);  // not when the world comes to it
    for (const BadDevice* device : {&bad, &good}) {
      EXPECT_GT(device->most, 0.05);
      expect_let_go(*device);
    }
  }
}

}  // namespace
}  // namespace thigma
