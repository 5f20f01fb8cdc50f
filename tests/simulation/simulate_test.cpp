#include "thigma/simulation/simulate.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/core/error.h"
#include "thigma/math/random.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"
#include "thigma/simulation/free_motion.h"

namespace thigma {
namespace {

/// A solid of density 1,000 over a floor whose top is z = 0.
struct Stage {
  ClodHierarchy object, floor;
  SimulationWorld world;
  SimulationState state;

  Stage(const TriangleMesh& mesh, const TriangleMesh& below, double scale = 1.0)
      : object(build_exact_hierarchy(mesh)), floor(build_exact_hierarchy(below)) {
    const MassProperties solid = mass_properties(mesh);
    world.body = make_body(1000.0 * solid.volume, 1000.0 * solid.inertia, Vec3(0, 0, -9.81));
    world.object = &object;
    world.body_from_mesh.position = -solid.center_of_mass;
    world.scene.push_back({&floor, Pose{}});
    world.tolerance = 1e-3 * 0.1 * scale;
  }
};

TriangleMesh slab(double scale = 1.0) {
  TriangleMesh box = make_box(scale * Vec3(4, 4, 0.2), {8, 8, 1});
  for (Vec3& p : box.positions) p.z() -= 0.1 * scale;
  return box;
}

/// What every run has to keep to.
struct Watch {
  SimulationPorts ports;
  double worst_gain = 0.0;   // of an impulse [J]
  double worst_drift = 0.0;  // growth of the energy between events [J]
  double energy = std::nan("");
  explicit Watch(const Stage& stage) {
    const RigidBody& body = stage.world.body;
    ports.event = [&](const CollisionEvent& e) {
      worst_gain = std::max(worst_gain, e.energy_change);
      energy = std::nan("");
    };
    ports.query = [&](const SimulationState& s, const ContactSet&) {
      const double now = mechanical_energy(body, s.body);
      if (!std::isnan(energy)) worst_drift = std::max(worst_drift, now - energy);
      energy = now;
    };
  }
};

TEST(Simulate, ABallBouncesAsAsked) {
  for (const double scale : {1e-3, 1.0, 100.0}) {
    TriangleMesh ball = make_ball(0.05 * scale, 8);
    Stage stage(ball, slab(scale), scale);
    stage.world.law = {0.6, 0.0};
    const double top = 0.35 * scale;
    stage.state.body.position = Vec3(0.01, 0.02, 0.35) * scale;
    SimulationScratch scratch = reserve_simulation(stage.world);
    Watch watch(stage);
    std::vector<CollisionEvent> events;
    const auto hear = watch.ports.event;
    watch.ports.event = [&](const CollisionEvent& e) {
      events.push_back(e);
      hear(e);
    };
    const double fall = std::sqrt(2.0 * 0.3 * scale / 9.81);
    // Through the first impact, to the top of the flight after it.
    double highest = 0.0;
    bool is_past = false;
    simulate(stage.world, 1.05 * fall, stage.state, scratch, watch.ports);
    ASSERT_EQ(events.size(), 1u) << scale;
    const double low = stage.state.body.position.z();
    const double up = stage.state.body.linear_momentum.z() / stage.world.body.mass;
    highest = low + up * up / (2.0 * 9.81);
    is_past = up > 0.0;
    EXPECT_TRUE(is_past);
    const double touch = events[0].approach * events[0].approach / (2.0 * 9.81);  // fallen to there
    const double rise = highest - (top - touch);
    EXPECT_NEAR(std::sqrt(rise / touch), 0.6, 1e-3) << scale;
    EXPECT_LE(events[0].gap, 0.25 * stage.world.tolerance);
    EXPECT_GE(events[0].gap, 0.0);
    EXPECT_LE(watch.worst_gain, 0.0);
  }
}

TEST(Simulate, ABlockStopsWhereCoulombSays) {
  Stage stage(make_box(Vec3(0.1, 0.1, 0.04)), slab());
  stage.world.law = {0.2, 0.3};
  stage.state.body.position = Vec3(-0.5, 0, 0.02 + 0.2 * stage.world.tolerance);
  const double speed = 1.2;
  stage.state.body.linear_momentum = stage.world.body.mass * Vec3(speed, 0, 0);
  SimulationScratch scratch = reserve_simulation(stage.world);
  Watch watch(stage);
  const SimulationCounts counts = simulate(stage.world, 0.6, stage.state, scratch, watch.ports);
  const double way = speed * speed / (2.0 * 0.3 * 9.81);
  EXPECT_NEAR(stage.state.body.position.x() + 0.5, way, 0.01 * way);
  EXPECT_LE(velocity(stage.world.body, stage.state.body).linear.norm(), 0.02);
  const double energy = 0.5 * stage.world.body.mass * speed * speed;
  EXPECT_LE(watch.worst_gain, 1e-12 * energy);
  EXPECT_LE(watch.worst_drift, 1e-6 * energy);
  EXPECT_LE(counts.deepest, stage.world.tolerance);
  EXPECT_EQ(counts.unresolved, 0);
}

TEST(Simulate, TheSameInputGivesTheSameBits) {
  BodyState ends[2];
  for (BodyState& end : ends) {
    Stage stage(make_l_shape(0.1, 0.03), slab());
    stage.state.body.position = Vec3(0, 0, 0.2);
    stage.state.body.angular_momentum = stage.world.body.inertia * Vec3(3, -2, 5);
    SimulationScratch scratch = reserve_simulation(stage.world);
    simulate(stage.world, 0.5, stage.state, scratch);
    end = stage.state.body;
  }
  EXPECT_EQ(to_vector(ends[0]), to_vector(ends[1]));
}

// Dropped at random, everything loses its energy and stays on top.
TEST(Simulate, RandomDropsComeToRest) {
  Random random(7);
  const TriangleMesh meshes[] = {make_box(Vec3(0.1, 0.06, 0.03)), make_l_shape(0.1, 0.03),
                                 make_ball(0.05, 3), make_torus(0.05, 0.015, 16, 8)};
  for (int trial = 0; trial < 8; ++trial) {
    Stage stage(meshes[trial % 4], slab());
    stage.world.law = {0.3, 0.4};
    stage.state.body.position = Vec3(0, 0, 0.15);
    stage.state.body.orientation = random.orientation();
    stage.state.body.angular_momentum = stage.world.body.inertia * (4.0 * random.direction());
    SimulationScratch scratch = reserve_simulation(stage.world);
    Watch watch(stage);
    const double energy = stage.world.body.mass * 9.81 * 0.15;
    SimulationCounts counts = simulate(stage.world, 1.5, stage.state, scratch, watch.ports);
    EXPECT_LE(watch.worst_gain, 1e-12 * energy) << trial;
    EXPECT_LE(watch.worst_drift, 1e-6 * energy) << trial;
    EXPECT_LE(counts.deepest, stage.world.tolerance) << trial;
    EXPECT_GT(stage.state.body.position.z(), 0.0) << trial;
    if (trial % 4 != 2) {  // balls roll
      EXPECT_TRUE(stage.state.is_resting) << trial;
    }
    EXPECT_EQ(stage.state.time, 1.5);
  }
}

// Coarse while fast, fine while slow: at an impact the levels change, to ones that lie elsewhere by
// ten tolerances. A search for the moment of contact of either would not end (Sec. 3.4.4).
TEST(Simulate, LevelsThatChangeAtAnImpactDoNotHoldTimeUp) {
  Stage stage(make_torus(0.06, 0.025, 40, 20), slab());
  stage.object = build_clod(make_torus(0.06, 0.025, 40, 20));
  stage.world.resolution.is_exact = false;
  stage.world.resolution.metric = {.haptic = 0.0, .velocity = 1.0};
  stage.world.resolution.deviation_cap = kNoCap;
  stage.world.law = {0.5, 0.3};
  stage.state.body.position = Vec3(0, 0, 0.2);
  stage.state.body.orientation = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 0).normalized()));
  SimulationScratch scratch = reserve_simulation(stage.world);
  Watch watch(stage);
  int coarsest = 0, finest = 100;
  const auto hear = watch.ports.event;
  watch.ports.event = [&](const CollisionEvent& e) {
    coarsest = std::max(coarsest, e.object_level);
    finest = std::min(finest, e.object_level);
    hear(e);
  };
  const SimulationCounts counts = simulate(stage.world, 1.0, stage.state, scratch, watch.ports);
  EXPECT_EQ(stage.state.time, 1.0);
  EXPECT_GT(counts.interpolated, 0);
  EXPECT_GT(coarsest, finest);
  EXPECT_LE(watch.worst_gain, 0.0);
  EXPECT_GT(stage.state.body.position.z(), 0.0);
}

/// A torus that falls on a floor, as coarse as its speed allows.
struct LevelFall {
  double rest_gap = 0.0;  // of the exact surfaces at the end, over the tolerance
  std::int64_t doubted = 0;
  bool is_resting = false;
};

/// alpha    of the velocity metric [s]
/// returns how deep the exact surfaces were in each other at any query, over the tolerance.
double fall_on_levels(bool allows_for_bounds, double alpha, LevelFall& fall) {
  Stage stage(make_torus(0.06, 0.025, 48, 24), slab());
  stage.object = build_clod(make_torus(0.06, 0.025, 48, 24));
  stage.world.resolution.is_exact = false;
  stage.world.resolution.metric = {.haptic = 0.0, .velocity = alpha};
  stage.world.allows_for_bounds = allows_for_bounds;
  stage.world.law = {0.3, 0.3};
  stage.state.body.position = Vec3(0, 0, 0.15);
  stage.state.body.orientation = Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 0).normalized()));
  SimulationScratch scratch = reserve_simulation(stage.world);
  std::vector<ContactFront> fronts(1);
  ContactSet exact;
  exact.contacts.reserve(20'000);
  Watch watch(stage);
  double deepest = 0.0, last = 0.0;
  const auto hear = watch.ports.query;
  watch.ports.query = [&](const SimulationState& s, const ContactSet& set) {
    hear(s, set);
    const Pose at = Pose{s.body.position, s.body.orientation} * stage.world.body_from_mesh;
    query_scene({stage.object, at}, stage.world.scene, {.tolerance = stage.world.tolerance}, fronts,
                exact);
    last = least_distance(exact) / stage.world.tolerance;
    deepest = std::max(deepest, -last);
  };
  const SimulationCounts counts = simulate(stage.world, 4.0, stage.state, scratch, watch.ports);
  EXPECT_LE(watch.worst_gain, 0.0);
  fall.doubted = counts.doubted;
  fall.is_resting = stage.state.is_resting;
  fall.rest_gap = last;
  return deepest;
}

TEST(Simulate, LevelsThatMayLieOffNeverLetTheSurfacesMeet) {
  LevelFall fall, trusting;
  EXPECT_LE(fall_on_levels(true, 0.02, fall), 0.25);
  EXPECT_GT(fall.doubted, 0);
  // Without the bounds the same fall ends deeper: what is tested is what keeps it clear.
  EXPECT_GT(fall_on_levels(false, 0.02, trusting), 1.0);
  EXPECT_EQ(trusting.doubted, 0);
}

TEST(Simulate, ABodyRestsOnTheSurfaceNotOnItsLevels) {
  for (const double alpha : {0.02, 0.2, 1.0}) {
    LevelFall fall;
    fall_on_levels(true, alpha, fall);
    EXPECT_TRUE(fall.is_resting) << alpha;
    EXPECT_LE(std::fabs(fall.rest_gap), 1.0) << alpha;
  }
}

TEST(Simulate, RefusesWhatCannotBeSimulated) {
  Stage stage(make_ball(0.05, 2), slab());
  stage.world.tolerance = 0.0;
  EXPECT_THROW(reserve_simulation(stage.world), InputError);
  stage.world.tolerance = 1e-4;
  stage.world.law.restitution = 1.5;
  EXPECT_THROW(reserve_simulation(stage.world), InputError);
  stage.world.law = {0.5, -1.0};
  EXPECT_THROW(reserve_simulation(stage.world), InputError);
  stage.world.law = {0.5, 0.3, -1.0};
  EXPECT_THROW(reserve_simulation(stage.world), InputError);
  stage.world.law = {};
  stage.world.object = nullptr;
  EXPECT_THROW(reserve_simulation(stage.world), InputError);
}

}  // namespace
}  // namespace thigma
