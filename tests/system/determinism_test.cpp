// Same inputs, same bits: lockstep runs, replays of both kinds of session.

#include <bit>

#include "support/mesh_session.h"
#include <gtest/gtest.h>

#include "thigma/recording/replay_session.h"

namespace thigma {
namespace {

using test::Kept;
using test::MeshSession;

HapticParams params_of(const SessionConfig& config, const HapticDevice& device) {
  HapticParams params = config.haptic;
  params.device = device.limits();
  return params;
}

TEST(Determinism, TwoSessionsGiveTheSameHashAndAnotherSeedAnother) {
  const auto hash = [](std::uint64_t seed) {
    MeshSession scene;
    scene.config.duration = 1.5;
    HandParams hand = scene.hand(HandPath::demo);
    hand.tremor = 1e-5;
    hand.seed = seed;
    HandDevice device(hand);
    return run_lockstep(scene.config, device).state_hash;
  };
  const std::uint64_t first = hash(1);
  EXPECT_EQ(hash(1), first);
  EXPECT_NE(hash(2), first);
}

TEST(Determinism, AReplayIsIdenticalAndAChangedBitIsFoundAtItsFrame) {
  MeshSession scene;
  scene.config.duration = 1.5;
  scene.config.contact_every = 7;
  scene.config.contact_latency = 3;
  HandDevice device(scene.hand(HandPath::press));
  Kept kept(scene.config, device);
  const HapticParams params = params_of(scene.config, device);
  const ReplayReport replay =
      replay_session(params, scene.config.world_from_body, kept.samples, kept.models);
  EXPECT_TRUE(replay.identical) << replay.reason;
  EXPECT_EQ(replay.state_hash, kept.summary.state_hash);

  double& x = kept.samples[1234].device.motion.pose.position.z();
  x = std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) ^ 1u);
  const ReplayReport changed =
      replay_session(params, scene.config.world_from_body, kept.samples, kept.models);
  EXPECT_FALSE(changed.identical);
  EXPECT_EQ(changed.first_difference, 1234);
}

TEST(Determinism, AThreadedSessionReplaysFromItsModels) {
  MeshSession scene;
  scene.config.duration = 1.0;
  // The machine's lateness must not decide the test.
  scene.config.haptic.safety.watchdog = 5.0;
  scene.config.haptic.safety.model_full_age = 5.0;
  scene.config.haptic.safety.model_stale_age = 10.0;
  scene.config.haptic.safety.pose_jump = 1.0;
  HandDevice device(scene.hand(HandPath::press));
  std::vector<HapticSample> samples;
  std::vector<ContactSample> models;
  Session session(scene.config, device,
                  {[&](const HapticSample& s) { samples.push_back(s); },
                   [&](const ContactSample& s) { models.push_back(s); },
                   {}});
  session.start();
  const SessionSummary summary = session.finish();
  ASSERT_EQ(summary.end, SessionEnd::duration);
  ASSERT_EQ(summary.dropped_samples, 0u);
  EXPECT_EQ(summary.frames, samples.size());
  const ReplayReport replay = replay_session(params_of(scene.config, device),
                                             scene.config.world_from_body, samples, models);
  EXPECT_TRUE(replay.identical) << replay.first_difference << ' ' << replay.reason;
  EXPECT_EQ(replay.state_hash, summary.state_hash);
}

}  // namespace
}  // namespace thigma
