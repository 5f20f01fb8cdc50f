// A ball let down on a sheet at 0.2 m/s: with a contact frame every millisecond it is stopped,
// every ten it is deep before anybody knows.

#include <algorithm>
#include <string>
#include <vector>

#include "support/mesh_session.h"
#include "support/plane_session.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

struct Dropped {
  std::vector<SessionEvent> told;  // of deep contacts
  double deepest = 0.0;            // of what the models know [m]
};

Dropped let_down(int every) {
  test::MeshSession scene;
  SessionConfig& config = scene.config;
  config.duration = 0.6;
  config.contact_every = config.contact_latency = every;
  test::HeldDevice device;
  device.state.buttons = kClutchButton;
  const double way = scene.start.clearance + 0.005;
  Dropped dropped;
  SessionSinks sinks;
  sinks.haptic = [&](const HapticSample& s) {
    dropped.deepest = std::max(dropped.deepest, s.penetration);
    const double done = std::clamp(0.2 * (s.time - 0.2), 0.0, way);
    device.state.motion.pose.position = done * scene.start.approach;
  };
  sinks.event = [&](const SessionEvent& e) {
    if (e.kind == EventKind::deep_contact) dropped.told.push_back(e);
  };
  run_lockstep(config, device, sinks);
  return dropped;
}

TEST(DeepContact, IsToldWhereContactFramesAreRare) {
  const Dropped rare = let_down(10);
  ASSERT_FALSE(rare.told.empty());
  EXPECT_FALSE(rare.told[0].text.empty());
  EXPECT_GT(rare.deepest, kDeepShare * 0.015);
}

TEST(DeepContact, IsNotToldWhereTheyKeepUp) {
  const Dropped usual = let_down(1);
  EXPECT_TRUE(usual.told.empty());
  EXPECT_GT(usual.deepest, 1e-4);  // it did touch
}

}  // namespace
}  // namespace thigma
