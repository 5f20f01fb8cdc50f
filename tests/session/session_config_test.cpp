#include "thigma/session/session_config.h"

#include "support/mesh_session.h"
#include <gtest/gtest.h>

#include "thigma/recording/replay_session.h"

namespace thigma {
namespace {

constexpr double kDelay = 0.015;

HandParams late_hand(const test::MeshSession& scene, double delay) {
  HandParams hand = scene.hand(HandPath::demo);
  hand.delay = delay;
  return hand;
}

TEST(PassiveSession, TakesStiffnessAsTheHandFeelsItAndTheDelayTheDeviceTells) {
  test::MeshSession scene(300.0);
  scene.config.haptic.workspace.motion_scale = 0.4;
  scene.config.haptic.workspace.force_scale = 2.0;
  HandDevice hand(late_hand(scene, kDelay));
  enable_passivity(hand.limits(), scene.config);
  const PassivityParams& p = scene.config.haptic.passivity;
  EXPECT_TRUE(p.is_on);
  EXPECT_DOUBLE_EQ(p.delay, kDelay);
  EXPECT_DOUBLE_EQ(p.stiffness, 300.0 * 0.8);
  EXPECT_DOUBLE_EQ(p.angular_stiffness, scene.config.haptic.coupling.angular_stiffness * 5.0);
  EXPECT_DOUBLE_EQ(p.max_damping, 240.0 * (kDelay + 1e-3));
  scene.config.haptic.coupling.linear_stiffness = 150.0;
  retune_passivity(scene.config.haptic);
  EXPECT_DOUBLE_EQ(scene.config.haptic.passivity.stiffness, 120.0);
  EXPECT_DOUBLE_EQ(scene.config.haptic.passivity.delay, kDelay);
}

TEST(PassiveSession, TheEnergyIsThatOfTheTrueHandleWhereItIsKnown) {
  test::MeshSession scene;
  scene.config.duration = 1.5;
  HandDevice hand(late_hand(scene, 0.005));
  EnergyObserver port;
  std::uint64_t pushed = 0;
  run_lockstep(scene.config, hand,
               {[&](const HapticSample& s) {
                  observe_motion(port, hand.true_motion().pose);
                  observe_wrench(port, hand.applied_wrench());
                  ASSERT_EQ(s.energy, port.energy) << s.frame;
                  pushed += s.command.force.norm() > 0.1 ? 1 : 0;
                },
                {},
                {}});
  EXPECT_GT(pushed, 100u);
}

TEST(PassiveSession, KeepsTheWholeLoopPassiveWithLateSamplesAndReplays) {
  test::MeshSession scene(480.0);
  scene.config.duration = 4.0;
  HandDevice free_hand(late_hand(scene, kDelay)), hand(late_hand(scene, kDelay));
  const SessionSummary free = run_lockstep(scene.config, free_hand);
  EXPECT_FALSE(free.passivity.is_on);
  EXPECT_LT(free.energy_min, -1e-4);

  enable_passivity(hand.limits(), scene.config);
  const test::Kept kept(scene.config, hand);
  EXPECT_GE(kept.summary.energy_min, free.energy_min / 20.0);
  EXPECT_GT(kept.summary.force_max, 0.5);
  EXPECT_TRUE(kept.summary.passivity.is_on);
  EXPECT_GT(kept.summary.passivity.acted_share, 0.0);
  EXPECT_GT(kept.summary.passivity.damping_max, 0.0);

  HapticParams params = scene.config.haptic;
  params.device = hand.limits();
  const ReplayReport replay =
      replay_session(params, scene.config.world_from_body, kept.samples, kept.models);
  EXPECT_TRUE(replay.identical) << replay.reason;
  params.passivity.is_on = false;
  EXPECT_FALSE(
      replay_session(params, scene.config.world_from_body, kept.samples, kept.models).identical);
}

}  // namespace
}  // namespace thigma
