// Haptic rates from 500 Hz to 10 kHz: the same scene, the same gains, the same hand.

#include "support/mesh_session.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

SessionSummary run_at(double rate) {
  test::MeshSession scene;
  scene.config.rate = rate;
  scene.config.duration = 3.0;
  // Contact frames stay a millisecond apart, as a contact thread gets no faster with the haptic
  // rate.
  scene.config.contact_every = std::max(1, static_cast<int>(rate / 1000.0 + 0.5));
  scene.config.contact_latency = scene.config.contact_every;
  HandDevice hand(scene.hand(HandPath::slide));
  return run_lockstep(scene.config, hand);
}

TEST(Rates, TheHandFeelsTheSameFrom500HzTo10kHz) {
  const SessionSummary usual = run_at(1000.0);
  ASSERT_EQ(usual.end, SessionEnd::duration);
  ASSERT_GT(usual.force_max, 0.8);
  for (const double rate : {500.0, 2000.0, 5000.0, 10000.0}) {
    const SessionSummary s = run_at(rate);
    EXPECT_EQ(s.end, SessionEnd::duration) << rate;
    EXPECT_EQ(s.frames, static_cast<std::uint64_t>(3.0 * rate));
    EXPECT_TRUE(s.safety_events.empty()) << rate;
    EXPECT_NEAR(s.force_rms, usual.force_rms, 0.1 * usual.force_rms) << rate;
    EXPECT_NEAR(s.force_max, usual.force_max, 0.25 * usual.force_max) << rate;
    EXPECT_GE(s.energy_min, -1e-6) << rate;
  }
}

}  // namespace
}  // namespace thigma
