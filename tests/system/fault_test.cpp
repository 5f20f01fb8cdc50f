// Every fault ends in zero force, in time, and stays there.

#include "support/mesh_session.h"
#include <gtest/gtest.h>

#include "thigma/session/session_config.h"

namespace thigma {
namespace {

using test::Kept;
using test::MeshSession;

struct Expected {
  const char* text;
  const char* fault;
  double within;  // from the event to zero force [s]
};

class Faults : public testing::TestWithParam<Expected> {};

TEST_P(Faults, ZeroForceWithinItsTimeWhilePressing) {
  MeshSession scene;
  scene.config.duration = 4.0;
  scene.config.faults = parse_faults(GetParam().text);
  const double begin = scene.config.faults[0].time;
  HandDevice device(scene.hand(HandPath::press));
  const Kept kept(scene.config, device);
  ASSERT_EQ(kept.summary.end, SessionEnd::fault);
  ASSERT_EQ(kept.summary.safety_events.size(), 1u);
  EXPECT_EQ(kept.summary.safety_events[0].detail, GetParam().fault);
  EXPECT_GE(kept.summary.safety_events[0].time, begin);
  double before = 0.0, last_force_time = 0.0;
  for (const HapticSample& s : kept.samples) {
    if (s.time < begin - 1e-9) before = s.command.force.norm();
    if (s.command.force.norm() > 0.0 || s.command.torque.norm() > 0.0) last_force_time = s.time;
  }
  EXPECT_GT(before, 0.5);  // it was pressing
  EXPECT_LT(last_force_time, begin + GetParam().within);
  EXPECT_EQ(device.applied_wrench().force, Vec3::Zero());
  EXPECT_EQ(device.applied_wrench().torque, Vec3::Zero());
  EXPECT_LT(kept.summary.seconds, begin + 0.2);  // and the session ended
}

INSTANTIATE_TEST_SUITE_P(All, Faults,
                         testing::Values(Expected{"unplug@2", "device_lost", 1e-3},
                                         Expected{"nan@2", "not_finite", 1e-3},
                                         Expected{"stall=0.06@2", "contact_stale", 0.051},
                                         Expected{"hang=0.05@2", "watchdog", 0.021}),
                         [](const auto& each) { return std::string(each.param.fault); });

TEST(StaleModel, NeverPullsAndFadesWithTheDeviceWrench) {
  MeshSession scene;
  scene.config.duration = 4.0;
  scene.config.faults = parse_faults("stall=0.1@2");
  HandDevice device(scene.hand(HandPath::press));
  const Kept kept(scene.config, device);
  double last = 1e300;
  int faded = 0;
  for (const HapticSample& s : kept.samples) {
    EXPECT_GE(s.contact.force.dot(-scene.start.approach), 0.0);
    if (s.model_age <= scene.config.haptic.safety.model_full_age) continue;
    EXPECT_LE(s.command.force.norm(), last + 1e-12);
    last = s.command.force.norm();
    ++faded;
  }
  EXPECT_GE(faded, 20);
  EXPECT_EQ(last, 0.0);
}

TEST(StaleModel, AShortStallIsNoFault) {
  MeshSession scene;
  scene.config.duration = 3.0;
  scene.config.faults = parse_faults("stall=0.035@2");
  HandDevice device(scene.hand(HandPath::press));
  const Kept kept(scene.config, device);
  EXPECT_EQ(kept.summary.end, SessionEnd::duration);
  double weakest = 1.0;
  for (const HapticSample& s : kept.samples) weakest = std::min(weakest, s.model_weight);
  EXPECT_LT(weakest, 0.7);
  EXPECT_GT(weakest, 0.3);
  EXPECT_GT(kept.samples.back().command.force.norm(), 0.5);  // it came back
}

TEST(StaleModel, TheForceComesBackNoFasterThanTheSlewLimit) {
  MeshSession scene;
  scene.config.duration = 3.0;
  scene.config.faults = parse_faults("stall=0.048@2");  // the weight falls to almost nothing
  HandDevice device(scene.hand(HandPath::press));
  const Kept kept(scene.config, device);
  EXPECT_EQ(kept.summary.end, SessionEnd::duration);
  const SafetyLimits& limits = scene.config.haptic.safety;
  double weakest = 1.0, last = 1e300, weight = 1.0;
  for (const HapticSample& s : kept.samples) {
    if (s.time < 2.0) continue;
    const double fade = s.elapsed / (limits.model_stale_age - limits.model_full_age);
    EXPECT_LE(s.model_weight, weight + fade + 1e-12) << s.time;
    EXPECT_LE(s.command.force.norm(), last + limits.force_slew * s.elapsed + 1e-9) << s.time;
    weakest = std::min(weakest, s.model_weight);
    weight = s.model_weight;
    last = s.command.force.norm();
  }
  EXPECT_LT(weakest, 0.1);
  EXPECT_EQ(weight, 1.0);
  EXPECT_GT(last, 0.5);  // it came back
}

// A contact query as slow as two gears in mesh: every model is used from 20 to 40 ms after its
// state.
TEST(SlowQuery, OldModelsMakeNoFaultAndNoPull) {
  for (const ResponseKind response : {ResponseKind::coupled, ResponseKind::direct}) {
    SCOPED_TRACE(response == ResponseKind::direct ? "direct" : "coupled");
    MeshSession scene;
    if (response == ResponseKind::direct) {
      use_direct_response(HandDevice(scene.hand(HandPath::press)).limits(), scene.config);
      scene.start = find_start(scene.config.contact, scene.config.world_from_body);
      scene.config.world_from_body = scene.start.world_from_body;
    }
    scene.config.duration = 5.0;
    scene.config.contact_every = 20;
    scene.config.contact_latency = 20;
    HandDevice device(scene.hand(HandPath::press));
    const Kept kept(scene.config, device);
    EXPECT_EQ(kept.summary.end, SessionEnd::duration);
    EXPECT_TRUE(kept.summary.safety_events.empty());
    double weakest = 1.0;
    for (const HapticSample& s : kept.samples) {
      if (s.model_sequence > 1) weakest = std::min(weakest, s.model_weight);
      EXPECT_GE(s.contact.force.dot(-scene.start.approach), 0.0);
    }
    EXPECT_LT(weakest, 0.6);
    EXPECT_GT(kept.summary.force_max, 0.2);
    EXPECT_LE(kept.summary.force_max, device.limits().max_force * (1.0 + 1e-12));
  }
}

}  // namespace
}  // namespace thigma
