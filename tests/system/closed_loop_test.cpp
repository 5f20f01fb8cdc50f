// The loop closed through the simulated hand: stable while resting, pressing, sliding and tapping.

#include <algorithm>
#include <cmath>

#include "support/mesh_session.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::Kept;
using test::MeshSession;

struct Case {
  double coupling;
  int dof;
};

class ClosedLoop : public testing::TestWithParam<Case> {
 protected:
  /// Peak to peak of the handle's height over frames [from, to) [m; device].
  static double sway(const Kept& kept, std::size_t from, std::size_t to) {
    double low = 1e300, high = -1e300;
    for (std::size_t i = from; i < to; ++i) {
      const double z = kept.samples[i].device.motion.pose.position.z();
      low = std::min(low, z);
      high = std::max(high, z);
    }
    return high - low;
  }
  /// Root mean square of the force's change from frame to frame [N].
  static double force_change(const Kept& kept, std::size_t from, std::size_t to) {
    double sum = 0.0;
    for (std::size_t i = from + 1; i < to; ++i) {
      sum += (kept.samples[i].command.force - kept.samples[i - 1].command.force).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(to - from - 1));
  }
};

TEST_P(ClosedLoop, RestingInTheAirNothingMoves) {
  MeshSession scene(GetParam().coupling);
  scene.config.duration = 1.0;
  const HandParams hand = scene.hand(HandPath::rest, GetParam().dof);
  HandDevice device(hand);
  const Kept kept(scene.config, device);
  EXPECT_EQ(kept.summary.end, SessionEnd::duration);
  EXPECT_LE(sway(kept, 500, 1000), hand.encoder * 1.001);
  EXPECT_LT(kept.summary.force_max, 1e-3);
}

TEST_P(ClosedLoop, PressingHoldsTheForceAndRestsWithinAnEncoderStep) {
  MeshSession scene(GetParam().coupling);
  scene.config.duration = 4.0;
  const HandParams hand = scene.hand(HandPath::press, GetParam().dof);
  HandDevice device(hand);
  const Kept kept(scene.config, device);
  ASSERT_EQ(kept.summary.end, SessionEnd::duration);
  const HapticSample& last = kept.samples.back();
  EXPECT_NEAR(last.command.force.norm(), hand.program.force, 0.15);
  EXPECT_GT(last.touching, 0);
  // At rest: no oscillation beyond one encoder step, and none that grows.
  EXPECT_LE(sway(kept, 3500, 4000), hand.encoder * 1.001);
  EXPECT_LE(sway(kept, 3500, 4000), sway(kept, 3000, 3500) + hand.encoder * 1.001);
  EXPECT_GT(kept.summary.force_max, 0.5);
  EXPECT_LT(kept.summary.force_max, 2.0 * hand.program.force);
  // Penetration stays what the contact spring says, far below the size of things.
  EXPECT_LT(kept.summary.penetration_max, 2e-3);
  RecordProperty("force_max_mN", static_cast<int>(1e3 * kept.summary.force_max));
  RecordProperty("penetration_max_um", static_cast<int>(1e6 * kept.summary.penetration_max));
}

TEST_P(ClosedLoop, SlidingStaysBounded) {
  MeshSession scene(GetParam().coupling);
  scene.config.duration = 6.0;
  HandDevice device(scene.hand(HandPath::slide, GetParam().dof));
  const Kept kept(scene.config, device);
  ASSERT_EQ(kept.summary.end, SessionEnd::duration);
  EXPECT_LT(kept.summary.force_max, 3.0);
  EXPECT_LE(force_change(kept, 4000, 6000), force_change(kept, 2000, 4000) * 1.5 + 1e-3);
  EXPECT_LT(force_change(kept, 2000, 6000), 0.05);
  EXPECT_GT(kept.samples.back().touching, 0);
}

TEST_P(ClosedLoop, TapsComeAndGo) {
  MeshSession scene(GetParam().coupling);
  scene.config.duration = 4.0;
  HandDevice device(scene.hand(HandPath::tap, GetParam().dof));
  const Kept kept(scene.config, device);
  ASSERT_EQ(kept.summary.end, SessionEnd::duration);
  int touches = 0;
  double early = 0.0, late = 0.0;
  for (std::size_t i = 1; i < kept.samples.size(); ++i) {
    if (kept.samples[i].touching > 0 && kept.samples[i - 1].touching == 0) ++touches;
    double& peak = i < kept.samples.size() / 2 ? early : late;
    peak = std::max(peak, kept.samples[i].command.force.norm());
  }
  EXPECT_GE(touches, 3);
  EXPECT_GT(early, 0.2);
  EXPECT_LT(late, 1.5 * early);  // no tap is harder for those before it
  EXPECT_LT(kept.summary.force_max, 5.0);
}

INSTANTIATE_TEST_SUITE_P(Gains, ClosedLoop,
                         testing::Values(Case{200.0, 6}, Case{500.0, 6}, Case{200.0, 3},
                                         Case{500.0, 3}),
                         [](const testing::TestParamInfo<Case>& each) {
                           return "coupling" +
                                  std::to_string(static_cast<int>(each.param.coupling)) + "dof" +
                                  std::to_string(each.param.dof);
                         });

TEST(ClosedLoop, WithoutActuatedRotationTorqueIsComputedButNotSent) {
  MeshSession scene(300.0);
  scene.config.haptic.grasp_point = {0.01, 0.0, 0.0};
  scene.config.duration = 2.0;
  HandDevice device(scene.hand(HandPath::press, 3));
  const Kept kept(scene.config, device);
  EXPECT_GT(kept.summary.torque_max, 1e-5);
  for (const HapticSample& s : kept.samples) ASSERT_EQ(s.command.torque, Vec3::Zero());
}

}  // namespace
}  // namespace thigma
