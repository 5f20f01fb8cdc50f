#include "thigma/session/simulated_session.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"
#include "thigma/session/live_ports.h"

namespace thigma {
namespace {

/// A brick over a floor at z = 0.
struct Drop {
  ClodHierarchy brick, floor;
  SessionConfig config;
  SimulationWorld world;
  SimulationState start;

  Drop() {
    const TriangleMesh mesh = make_box(Vec3(0.1, 0.06, 0.03));
    TriangleMesh slab = make_box(Vec3(1, 1, 0.1));
    for (Vec3& p : slab.positions) p.z() -= 0.05;
    brick = build_exact_hierarchy(mesh);
    floor = build_exact_hierarchy(slab);
    const MassProperties solid = mass_properties(mesh);
    world.body = make_body(1000.0 * solid.volume, 1000.0 * solid.inertia, Vec3(0, 0, -9.81));
    world.object = &brick;
    world.scene.push_back({&floor, Pose{}});
    world.tolerance = 1e-4;
    world.law = {0.3, 0.4};
    start.body.position = Vec3(0, 0, 0.1);
    start.body.orientation = Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 0).normalized()));
    config.haptic.body = world.body;
    config.contact.object = &brick;
    config.contact.scene = world.scene;
    config.contact.tolerance = world.tolerance;
    config.contact.resolution.is_exact = true;
    config.contact.capacity = 200;
  }
};

TEST(SimulatedSession, EndsWhenTheBodyRestsAndTellsOfIt) {
  Drop drop;
  std::uint64_t frames = 0, models = 0, last_model = 0;
  int impacts = 0, rests = 0;
  double heaviest = 0.0, z = 1.0, deepest = -1.0;
  Wrench at_rest;
  SessionSinks sinks;
  sinks.haptic = [&](const HapticSample& s) {
    EXPECT_EQ(s.frame, frames++);
    EXPECT_EQ(s.model_sequence, last_model);
    heaviest = std::max(heaviest, s.contact.force.norm());
    z = s.body.position.z();
    deepest = std::max(deepest, s.penetration);
    at_rest = s.contact;
  };
  sinks.contact = [&](const ContactSample& s) {
    ++models;
    last_model = s.model.sequence;
  };
  sinks.event = [&](const SessionEvent& e) {
    impacts += e.kind == EventKind::impact;
    rests += e.kind == EventKind::at_rest;
  };
  const SimulatedSummary summary =
      run_simulated(drop.config, {drop.world, drop.start}, false, sinks);
  EXPECT_EQ(summary.session.end, SessionEnd::device_finished);
  EXPECT_TRUE(summary.is_resting);
  EXPECT_EQ(frames, summary.session.frames);
  EXPECT_EQ(models, frames);
  EXPECT_GT(impacts, 0);
  EXPECT_EQ(rests, 1);
  const double weight = drop.world.body.mass * 9.81;
  EXPECT_GT(heaviest, 10.0 * weight);  // an impact within a frame
  EXPECT_NEAR(at_rest.force.z(), weight, 1e-9 * weight);
  EXPECT_GT(z, 0.0);
  EXPECT_LE(deepest, drop.world.tolerance);
  EXPECT_LT(summary.energy_end, summary.energy_start);
  EXPECT_LE(summary.growth_max, 1e-6 * summary.energy_start);
}

TEST(SimulatedSession, TheClockChangesNothingButTheTime) {
  Drop drop;
  drop.config.duration = 0.15;
  const SimulatedSummary fast = run_simulated(drop.config, {drop.world, drop.start}, false);
  const SimulatedSummary again = run_simulated(drop.config, {drop.world, drop.start}, false);
  const SimulatedSummary paced = run_simulated(drop.config, {drop.world, drop.start}, true);
  EXPECT_EQ(fast.session.frames, 150u);
  EXPECT_EQ(fast.session.state_hash, again.session.state_hash);
  EXPECT_EQ(fast.session.state_hash, paced.session.state_hash);
  drop.start.body.position.x() += 1e-9;
  EXPECT_NE(run_simulated(drop.config, {drop.world, drop.start}, false).session.state_hash,
            fast.session.state_hash);
}

TEST(SimulatedSession, StopsWhenTold) {
  Drop drop;
  std::atomic<bool> stop{false};
  SessionSinks sinks;
  sinks.haptic = [&](const HapticSample& s) { stop = s.frame == 20; };
  const SimulatedSummary summary =
      run_simulated(drop.config, {drop.world, drop.start}, false, sinks, &stop);
  EXPECT_EQ(summary.session.end, SessionEnd::stopped);
  EXPECT_EQ(summary.session.frames, 21u);
}

// Paused it stands; single frames asked for are done.
TEST(SimulatedSession, StandsStillWhilePaused) {
  Drop drop;
  const auto live = std::make_unique<LivePorts>();
  drop.config.live = live.get();
  live->is_paused = true;
  live->steps = 3;
  std::atomic<bool> stop{false};
  std::atomic<std::uint64_t> frames{0};
  SessionSinks sinks;
  sinks.haptic = [&](const HapticSample&) { ++frames; };
  SimulatedSummary summary;
  std::thread session([&] {
    summary = run_simulated(drop.config, {drop.world, drop.start}, true, sinks, &stop);
  });
  while (frames < 3) std::this_thread::yield();
  stop = true;
  session.join();
  EXPECT_EQ(summary.session.frames, 3u);
}

}  // namespace
}  // namespace thigma
