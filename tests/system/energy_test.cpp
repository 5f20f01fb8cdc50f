// Energy: a held object in free space never gives back what nobody put in.

#include "support/mesh_session.h"
#include "support/plane_session.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

/// Kinetic energy of the object plus what the coupling's springs hold [J].
double stored(const SessionConfig& config, const HapticSample& s, const Coupling& coupling) {
  const CouplingStretch stretch = coupling_stretch(coupling, s.handle.pose, s.body);
  return kinetic_energy(config.haptic.body, s.body) +
         0.5 * coupling.linear_stiffness * stretch.linear.squaredNorm() +
         0.5 * coupling.angular_stiffness * stretch.angular.squaredNorm();
}

TEST(Energy, NeverGrowsInFreeSpaceWhileTheHandIsStill) {
  for (const double rate : {200.0, 1000.0, 5000.0}) {
    SessionConfig config = test::plane_session(1.0);
    config.rate = rate;
    config.duration = 1.0;
    test::HeldDevice device;
    device.state.buttons = kClutchButton;
    std::vector<HapticSample> samples;
    run_lockstep(config, device,
                 {[&](const HapticSample& s) {
                    samples.push_back(s);
                    // One jerk, within the limits of a tick, then still.
                    if (s.frame == 20) {
                      device.state.motion.pose.position = {0.003, -0.002, 0.001};
                      device.state.motion.pose.orientation =
                          Quat(0.999, 0.0, 0.0447, 0.0).normalized();
                    }
                  },
                  {},
                  {}});
    Coupling coupling = config.haptic.coupling;
    grasp(coupling, samples[0].body, samples[0].handle.pose);
    double last = stored(config, samples[21], coupling);
    EXPECT_GT(last, 1e-6);
    for (std::size_t i = 22; i < samples.size(); ++i) {
      const double now = stored(config, samples[i], coupling);
      ASSERT_LE(now, last * (1.0 + 1e-9) + 1e-18) << "frame " << i << " at " << rate << " Hz";
      last = now;
    }
    EXPECT_LT(last, 1e-9);
  }
}

TEST(Energy, TheObserverSeesAPassiveWorldWhereTheHandMovesInTheAir) {
  test::MeshSession scene;
  scene.config.duration = 3.0;
  HandParams hand = scene.hand(HandPath::circle);
  // Each step of an encoder leaks about k q^2 / 2, which friction in the device has to make up for:
  // not what is asked here.
  hand.encoder = hand.angular_encoder = 0.0;
  HandDevice device(hand);
  const test::Kept kept(scene.config, device);
  ASSERT_EQ(kept.summary.end, SessionEnd::duration);
  EXPECT_GE(kept.summary.energy_min, -1e-6);
  EXPECT_GT(kept.samples.back().energy, kept.summary.energy_min);
}

}  // namespace
}  // namespace thigma
