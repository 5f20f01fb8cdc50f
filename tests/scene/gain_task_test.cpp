#include "thigma/scene/gain_task.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/scene/scene_file.h"

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
