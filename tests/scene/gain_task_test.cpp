#include "thigma/scene/gain_task.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/core/error.h"
#include "thigma/device/hand.h"
#include "thigma/device/open_device.h"
#include "thigma/mesh/shapes.h"
#include "thigma/scene/scene_file.h"
#include "thigma/scene/start_placement.h"
#include "thigma/session/session_config.h"

namespace thigma {
namespace {

SceneDescription auto_ball_scene(const std::string& rest) {
  return parse_scene(
      "gains = \"auto\"\n[object]\nmesh = \"procedural:ball?triangles=2000\"\n" + rest, "S.toml",
      "");
}

GainProposal proposal_for(const SceneDescription& scene, const SessionConfig& config) {
  return propose_gains(gain_task(describe_device(scene.device.uri), config.haptic.body,
                                 config.haptic.workspace, scene.rate));
}

TEST(GainTask, KnowsAllOfAHandAndTheLimitsOfOthers) {
  const DevicePort hand = describe_device("hand:?device=sigma.7&mass=0.2&delay=0.003&jitter=0.001");
  EXPECT_EQ(hand.linear.max_stiffness, 4000.0);
  EXPECT_EQ(hand.angular.max_effort, 0.2);
  EXPECT_EQ(hand.linear.mass, 0.2);
  EXPECT_EQ(hand.linear.friction, 0.04);
  EXPECT_DOUBLE_EQ(hand.delay, 0.004);
  EXPECT_DOUBLE_EQ(describe_device("hand:?sampling=500").delay, 0.002);
  for (const char* uri : {"null:", "web:", "replay:x.mcap"}) {
    const DevicePort port = describe_device(uri);
    EXPECT_GT(port.linear.max_stiffness, 0.0) << uri;
    EXPECT_EQ(port.linear.mass, 0.0) << uri;
  }
  EXPECT_THROW(describe_device("hand:?mas=1"), DeviceAddressError);
  EXPECT_THROW(describe_device("dhd:"), DeviceUnavailable);
}

TEST(GainTask, AutoGainsAreThoseThatTuneProposes) {
  SceneDescription scene = auto_ball_scene("[device]\nuri = \"hand:?device=touch\"\n");
  ASSERT_TRUE(scene.has_auto_gains);
  const LoadedObject object = load_object(scene.object);
  const SessionConfig config = make_session_config(scene, object);
  const GainProposal p = proposal_for(scene, config);
  const Coupling& c = config.haptic.coupling;
  EXPECT_EQ(c.linear_stiffness, p.linear.stiffness);
  EXPECT_EQ(c.linear_damping, p.linear.damping);
  EXPECT_EQ(c.angular_stiffness, p.angular.stiffness);
  EXPECT_EQ(c.angular_damping, p.angular.damping);
  EXPECT_EQ(c.linear_saturation->max_force, p.max_force);
  EXPECT_EQ(config.contact.response.stiffness, p.contact.stiffness);
  EXPECT_EQ(config.contact.response.damping, p.contact.damping);
  EXPECT_TRUE(check_gains(gain_task(describe_device(scene.device.uri), config.haptic.body,
                                    config.haptic.workspace, scene.rate),
                          p, c, p.contact.stiffness, p.contact.damping)
                  .empty());
  // Another device, rate or mass, other gains.
  scene.device.uri = "hand:?device=sigma.7";
  EXPECT_GT(make_session_config(scene, object).haptic.coupling.linear_stiffness,
            c.linear_stiffness);
  scene.rate = 500.0;
  EXPECT_LT(make_session_config(scene, object).contact.response.stiffness, p.contact.stiffness);
}

/// A cube over a sheet under constraints, pressed by a simulated hand whose samples are late.
struct PressedCube {
  ClodHierarchy cube = build_exact_hierarchy(make_box(Vec3::Constant(0.03)));
  ClodHierarchy sheet = build_exact_hierarchy(make_sheet(0.2, 0.12, 6, 4));
  SceneDescription scene = parse_scene(
      "gains = \"auto\"\n[object]\nmesh = \"procedural:box\"\nmass = 0.01\n[contact]\n"
      "response = \"constraint\"\n[device]\nuri = \"" +
          std::string(kHand) + "\"\n",
      "S.toml", "");
  LoadedObject loaded;
  static constexpr const char* kHand = "hand:?path=press&force=1&delay=0.004&encoder=1e-6";

  PressedCube() {
    loaded.mesh = make_box(Vec3::Constant(0.03));
    loaded.measure = mass_properties(loaded.mesh);
    loaded.ball = enclosing_ball(loaded.mesh.positions);
    scene.object.world_from_mesh.position.z() = 0.018;
  }

  GainTask task(const SessionConfig& config) const {
    GainTask task =
        gain_task(describe_device(kHand), config.haptic.body, config.haptic.workspace, config.rate);
    task.is_constrained = true;
    return task;
  }

  /// How far the handle goes up and down in the last of three seconds at a coupling stiffness of
  /// this, critically damped [m].
  double sway(double stiffness) const {
    SessionConfig config = make_session_config(scene, loaded, cube, {{&sheet, Pose{}}});
    Coupling& c = config.haptic.coupling;
    c.linear_stiffness = stiffness;
    c.linear_damping = 2.0 * std::sqrt(stiffness * 0.01);
    c.linear_saturation.reset();
    use_constraints(config);
    const StartPlacement start = place_at_start({}, config);
    HandDevice hand(parse_hand(std::string(kHand).substr(6),
                               device_context(config, start, loaded.ball.radius)));
    config.haptic.device = hand.limits();
    config.duration = 3.0;
    double low = 1.0, high = -1.0;
    run_lockstep(config, hand,
                 {[&](const HapticSample& s) {
                    if (s.time < 2.0) return;
                    low = std::min(low, hand.true_motion().pose.position.z());
                    high = std::max(high, hand.true_motion().pose.position.z());
                  },
                  {},
                  {}});
    return high - low;
  }
};

TEST(GainTask, UnderConstraintsTheWholeLoopRestsBelowTheLimitAndSwingsFarBeyondIt) {
  const PressedCube pressed;
  const SessionConfig config =
      make_session_config(pressed.scene, pressed.loaded, pressed.cube, {{&pressed.sheet, Pose{}}});
  const GainProposal p = propose_gains(pressed.task(config));
  EXPECT_EQ(config.haptic.coupling.linear_stiffness, p.linear.stiffness);
  const double limit = p.linear.limits[static_cast<std::size_t>(GainLimit::loop)];
  ASSERT_TRUE(std::isfinite(limit));
  EXPECT_LT(pressed.sway(0.9 * limit), 2e-6);
  EXPECT_GT(pressed.sway(8.0 * limit), 1e-4);
}

TEST(GainTask, WhatTheSceneSaysStays) {
  const SceneDescription scene = auto_ball_scene(
      "[coupling]\nlinear_stiffness = 123\nmax_force = 2.5\n[contact]\ndamping_ratio = 0.5\n");
  const SessionConfig config = make_session_config(scene, load_object(scene.object));
  const GainProposal p = proposal_for(scene, config);
  EXPECT_EQ(config.haptic.coupling.linear_stiffness, 123.0);
  EXPECT_EQ(config.haptic.coupling.linear_saturation->max_force, 2.5);
  EXPECT_EQ(config.haptic.coupling.angular_stiffness, p.angular.stiffness);
  EXPECT_EQ(config.contact.response.stiffness, p.contact.stiffness);
  EXPECT_NEAR(config.contact.response.damping, 0.5 * p.contact.damping, 1e-12 * p.contact.damping);
}

TEST(GainTask, WithoutTheWordNothingChanges) {
  SceneDescription scene = auto_ball_scene("");
  scene.has_auto_gains = false;
  const LoadedObject object = load_object(scene.object);
  const DefaultGains gains = default_gains(object.ball.radius);
  EXPECT_EQ(make_session_config(scene, object).haptic.coupling.linear_stiffness,
            gains.linear_stiffness);
  EXPECT_THROW(parse_scene("gains = \"best\"\n[object]\nmesh = \"procedural:ball\"\n", "S", ""),
               InputError);
}

}  // namespace
}  // namespace thigma
