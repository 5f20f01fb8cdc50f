#include "thigma/session/live_ports.h"

#include <algorithm>
#include <atomic>
#include <memory>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

using test::HeldDevice;
using test::plane_hand;
using test::plane_session;

ContactWorld bare_world() {
  ContactWorld world;
  world.source = test::plane_contacts;
  world.tolerance = 2e-4;
  return world;
}

TEST(Live, ViewShowsEveryContactWhereTheyAreFew) {
  const ContactWorld world = bare_world();
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  StampedBody at;
  at.state.position.z() = test::kCubeHalf - 1e-4;
  ContactSample sample;
  contact_step(world, at, scratch, sample);
  ContactView view;
  view_contacts(world, scratch, 0.5, view);
  EXPECT_EQ(view.found, 4);
  ASSERT_EQ(view.contacts.size(), 4u);
  EXPECT_EQ(view.sequence, sample.model.sequence);
  EXPECT_EQ(view.time, 0.5);
  EXPECT_NEAR(view.contacts[0].depth, 1e-4, 1e-15);
  EXPECT_EQ(view.contacts[0].normal, Vec3(0.0, 0.0, -1.0));
  EXPECT_EQ(view.contacts[0].object_node, -1);  // of no hierarchy
}

TEST(Live, ViewOfManyContactsHoldsTheDeepestOfEachCluster) {
  const ContactWorld world = bare_world();
  ContactScratch scratch;
  reserve_contact_scratch(world, scratch);
  Random random(3);
  for (int i = 0; i < 5000; ++i) {
    Contact c;
    c.point = random.in_cube(0.02);
    c.depth = 1e-5 * static_cast<double>(i % 97);
    scratch.contacts.contacts.push_back(c);
  }
  scratch.contacts.contacts[1234].depth = 0.01;
  cluster_contacts(scratch.contacts.contacts, {}, {.tolerance = 1e-3}, scratch.clustering,
                   scratch.clusters);
  ContactView view;
  view_contacts(world, scratch, 0.0, view);
  EXPECT_EQ(view.found, 5000);
  EXPECT_LE(view.contacts.size(), kViewedContacts);
  EXPECT_GE(view.contacts.size(), kViewedContacts / 2);
  double deepest = 0.0;
  for (const ViewedContact& c : view.contacts) deepest = std::max(deepest, c.depth);
  EXPECT_EQ(deepest, 0.01);
}

TEST(Live, ViewNamesNodesOfEveryLevel) {
  ClodHierarchy h;
  h.patches.resize(2);
  h.patches[0].node = 7;
  h.patches[1].node = 8;
  h.level_patches.resize(1);
  h.level_patches[0].patch.node = 3;
  ContactWorld world = bare_world();
  world.object = &h;
  world.scene = {{&h, Pose{}}};
  ContactScratch scratch;
  Contact c;
  c.object_patch = 1;
  c.scene_patch = 2;  // the first of the simplified levels
  c.scene_level = 1;
  scratch.contacts.contacts = {c};
  ContactView view;
  view_contacts(world, scratch, 0.0, view);
  ASSERT_EQ(view.contacts.size(), 1u);
  EXPECT_EQ(view.contacts[0].object_node, 8);
  EXPECT_EQ(view.contacts[0].scene_node, 3);
  EXPECT_EQ(view.contacts[0].scene_level, 1);
}

TEST(Live, TuningKeepsVelocityAndTheGrasp) {
  SessionConfig config = plane_session();
  HapticState state = initial_state(config.haptic, config.world_from_body);
  grasp(state.coupling, state.body, {{0.01, 0.0, 0.05}, Quat::Identity()});
  state.body.linear_momentum = {1e-3, 2e-3, 0.0};
  state.body.angular_momentum = {1e-6, 0.0, 3e-6};
  const Twist before = velocity(config.haptic.body, state.body);
  HapticTuning tuning{make_body(0.03, 2e-5 * Mat3::Identity()), config.haptic.coupling};
  tuning.coupling.linear_stiffness = 123.0;
  const Pose held = state.coupling.body_from_grasp;
  apply_tuning(tuning, config.haptic, state);
  const Twist after = velocity(config.haptic.body, state.body);
  EXPECT_NEAR((after.linear - before.linear).norm(), 0.0, 1e-15);
  EXPECT_NEAR((after.angular - before.angular).norm(), 0.0, 1e-12);
  EXPECT_EQ(state.coupling.linear_stiffness, 123.0);
  EXPECT_EQ(config.haptic.coupling.linear_stiffness, 123.0);
  EXPECT_TRUE(state.coupling.is_grasped);
  EXPECT_EQ(state.coupling.body_from_grasp.position, held.position);
}

TEST(Live, WatchingALockstepSessionChangesNothing) {
  SessionConfig config = plane_session();
  HandDevice first(plane_hand(HandPath::press)), second(plane_hand(HandPath::press));
  const std::uint64_t alone = run_lockstep(config, first).state_hash;
  const auto live = std::make_unique<LivePorts>();
  live->is_paused = true;  // of threads only
  config.live = live.get();
  EXPECT_EQ(run_lockstep(config, second).state_hash, alone);
  EXPECT_TRUE(live->contacts.fetch());
  EXPECT_GT(live->contacts.value().sequence, 0u);
}

/// A session on threads that no late frame of this machine may end.
SessionConfig patient_session(LivePorts* live) {
  SessionConfig config = plane_session();
  config.duration = 0.0;
  config.haptic.safety.watchdog = 5.0;
  config.haptic.safety.model_full_age = 5.0;
  config.haptic.safety.model_stale_age = 10.0;
  config.live = live;
  return config;
}

TEST(Live, PausedSessionTimeStandsStillAndStepsOneByOne) {
  const auto live = std::make_unique<LivePorts>();
  live->is_paused = true;
  SessionConfig config = patient_session(live.get());
  config.haptic.safety.watchdog = 0.02;  // a pause is no fault
  HeldDevice device;
  std::atomic<std::uint64_t> frames{0};
  Session session(config, device, {[&](const HapticSample& s) { frames = s.frame + 1; }, {}, {}});
  session.start();
  sleep_ns(80'000'000);
  EXPECT_EQ(frames, 0u);
  live->steps = 3;
  for (int i = 0; i < 2000 && frames < 3; ++i) sleep_ns(1'000'000);
  sleep_ns(30'000'000);
  EXPECT_EQ(frames, 3u);
  session.request_stop();
  const SessionSummary s = session.finish();
  EXPECT_EQ(s.frames, 3u);
  EXPECT_EQ(s.end, SessionEnd::stopped);
}

TEST(Live, ASessionThatHoldsAPersonIsNotPaused) {
  const auto live = std::make_unique<LivePorts>();
  live->is_paused = true;
  SessionConfig config = patient_session(live.get());
  HeldDevice device;
  device.device_limits.holds_person = true;
  std::atomic<std::uint64_t> frames{0};
  Session session(config, device, {[&](const HapticSample& s) { frames = s.frame + 1; }, {}, {}});
  session.start();
  for (int i = 0; i < 5000 && frames < 20; ++i) sleep_ns(1'000'000);
  session.request_stop();
  session.finish();
  EXPECT_GE(frames, 20u);
}

TEST(Live, TuningReachesTheRunningThreads) {
  const auto live = std::make_unique<LivePorts>();
  SessionConfig config = patient_session(live.get());
  config.world_from_body.position.z() = test::kCubeHalf + 1e-4;  // within the tolerance
  HeldDevice device;
  device.state.buttons = kClutchButton;
  live->contact_tuning.publish({.response = {.stiffness = 777.0}, .resolution = {}});
  HapticTuning tuning{config.haptic.body, config.haptic.coupling};
  tuning.body.gravity = {-9.81, 0.0, 0.0};
  live->haptic_tuning.publish(tuning);
  std::atomic<double> pull{0.0}, stiffness{0.0};
  Session session(config, device,
                  {[&](const HapticSample& s) { pull = s.coupling.force.x(); },
                   [&](const ContactSample& s) {
                     double sum = 0.0;
                     for (const PlaneTerm& t : s.model.planes) sum += t.stiffness;
                     stiffness = sum;
                   },
                   {}});
  session.start();
  for (int i = 0; i < 5000 && !(pull > 0.09 && stiffness > 776.0); ++i) sleep_ns(1'000'000);
  session.request_stop();
  session.finish();
  EXPECT_GT(pull, 0.09);  // the object has got a weight of 0.098 N
  EXPECT_NEAR(stiffness, 777.0, 1e-9);
}

}  // namespace
}  // namespace thigma
