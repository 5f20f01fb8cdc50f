#include "viewer/server/feed.h"

#include <memory>

#include "support/plane_session.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"
#include "thigma/session/session_config.h"

namespace thigma::live {
namespace {

using test::plane_hand;
using test::plane_session;

std::unique_ptr<LiveFeed> fed(const SessionConfig& config, HapticDevice& device) {
  auto feed = std::make_unique<LiveFeed>(config.haptic.workspace);
  feed->begin_session(config.haptic.workspace);
  run_lockstep(config, device,
               {[&](const HapticSample& s) { feed->observe(s); },
                [&](const ContactSample& s) { feed->observe(s); },
                [&](const SessionEvent& e) { feed->observe(e); }});
  return feed;
}

TEST(Feed, EveryFrameIsARowUntilThereIsNoRoom) {
  SessionConfig config = plane_session();
  config.duration = 0.5;
  HandDevice hand(plane_hand(HandPath::press));
  const auto feed = fed(config, hand);
  std::vector<ChannelRow> rows;
  feed->take_rows(rows);
  ASSERT_EQ(rows.size(), 500u);
  for (std::size_t i = 0; i < rows.size(); ++i)
    ASSERT_DOUBLE_EQ(rows[i].time, 1e-3 * static_cast<double>(i));
  EXPECT_EQ(feed->dropped_rows(), 0u);
  std::vector<SessionEvent> events;
  feed->take_events(events);
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events[0].kind, EventKind::grasped);
  events.clear();
  feed->take_events(events);
  EXPECT_TRUE(events.empty());

  HapticSample sample;
  for (int i = 0; i < 20000; ++i) feed->observe(sample);  // nobody takes them: nothing waits
  EXPECT_EQ(feed->dropped_rows(), 20000u - 8192u);
}

TEST(Feed, NothingIsShownBeforeTheFirstFrame) {
  LiveFeed feed{Workspace{}};
  EXPECT_EQ(feed.haptic(), nullptr);
  EXPECT_EQ(feed.contact(), nullptr);
}

/// A held cube, pulled below the plane by 5 mm, in a scaled workspace whose y points up.
SessionConfig pulled() {
  SessionConfig config = plane_session(0.005);
  config.haptic.workspace.world_from_device.orientation =
      rotation_from_vector({1.5707963267948966, 0.0, 0.0});
  config.haptic.workspace.motion_scale = 0.5;
  config.haptic.workspace.force_scale = 2.0;
  config.haptic.grasp_point = {0.001, 0.002, 0.003};
  config.haptic.safety.start_ramp = 0.0;
  return config;
}

/// Moves along a straight way of the device, from 0.1 s on.
class Puller final : public HapticDevice {
 public:
  const DeviceLimits& limits() const override { return limits_; }
  std::string name() const override { return "puller"; }
  DeviceState read(double now) THIGMA_RT override {
    DeviceState s;
    s.time = now;
    s.buttons = kClutchButton;
    const double way = now > 0.1 ? std::min(0.1 * (now - 0.1), 0.02) : 0.0;
    s.motion.pose.position = {0.1 * way, -way, 0.0};
    return s;
  }
  void write(const Wrench&) THIGMA_RT override {}

 private:
  DeviceLimits limits_{.holds_person = false};
};

TEST(Feed, GhostIsWhereTheHandWouldHaveTheObject) {
  const SessionConfig config = pulled();
  Puller device;
  const auto feed = fed(config, device);
  const HapticNow* now = feed->haptic();
  ASSERT_NE(now, nullptr);
  ASSERT_TRUE(now->sample.is_grasped);
  // 20 mm down the device's y and 2 mm along its x, at half the scale.
  const Vec3 wanted = config.world_from_body.position + Vec3(0.001, 0.0, -0.010);
  EXPECT_NEAR((now->ghost.position - wanted).norm(), 0.0, 1e-9);
  EXPECT_GT(now->sample.body.position.z(), now->ghost.position.z() + 0.003);  // the plane holds it
}

TEST(Feed, SnapshotTellsForcesInTheWorldAtTheHand) {
  const SessionConfig config = pulled();
  Puller device;
  const auto feed = fed(config, device);
  const HapticNow* now = feed->haptic();
  ASSERT_NE(now, nullptr);
  std::vector<ViewedCluster> clusters;
  const Pose body_from_mesh{{0.0, 0.0, -0.001}, Quat::Identity()};
  const Snapshot s =
      make_snapshot(*now, feed->contact(), config.haptic.body, config.haptic.workspace,
                    body_from_mesh, config.haptic.grasp_point, clusters);
  EXPECT_EQ(s.frame, 999u);
  EXPECT_EQ(s.bits, kGrasped | kArmed);
  HapticNow late = *now;
  late.sample.device.weight = 0.9;
  const Snapshot fading =
      make_snapshot(late, feed->contact(), config.haptic.body, config.haptic.workspace,
                    body_from_mesh, config.haptic.grasp_point, clusters);
  EXPECT_EQ(fading.bits, kGrasped | kArmed | kFading);
  EXPECT_NEAR(s.object.position.z(), now->sample.body.position.z() - 0.001, 1e-5);  // hardly tilted
  EXPECT_NEAR((s.grasp_point - s.center - Vec3(0.001, 0.002, 0.003)).norm(), 0.0, 1e-4);
  // What the plane gives the object, the coupling takes to the hand: twice, by the force scale.
  EXPECT_GT(s.contact.force.z(), 0.5);
  EXPECT_NEAR(s.on_hand.force.z(), 2.0 * s.contact.force.z(), 0.05 * s.on_hand.force.z());
  EXPECT_NEAR(s.on_hand.force.y(), 0.0, 0.05 * s.on_hand.force.z());
  EXPECT_NEAR(now->sample.command.force.y(), s.on_hand.force.z(), 1e-9);  // as the device has it
  ASSERT_FALSE(s.clusters.empty());
  Vec3 sum = Vec3::Zero();
  for (const ViewedCluster& c : s.clusters) sum += c.force;
  EXPECT_NEAR((sum - s.contact.force).norm(), 0.0, 1e-9 * sum.norm());
  EXPECT_NEAR(s.stretch, 0.0055, 0.001);
}

/// A cube of 40 mm over a sheet, with friction, pulled 5 mm into it and on along x.
struct RestingCube {
  ClodHierarchy cube = build_exact_hierarchy(make_box(Vec3::Constant(2.0 * test::kCubeHalf)));
  ClodHierarchy sheet = build_exact_hierarchy(make_sheet(0.2, 0.2, 8, 8));
  SessionConfig config = pulled();

  RestingCube() {
    config.contact.source = nullptr;
    config.contact.object = &cube;
    config.contact.scene = {{&sheet, Pose{}}};
    config.contact.friction.assign(config.contact.scene.size(), {0.2, 0.2});
    use_constraints(config);
  }
};

TEST(Feed, RowsStandWhereTheObjectIsAndTheirForcesAddUp) {
  const RestingCube scene;
  Puller device;
  const auto feed = fed(scene.config, device);
  const HapticSample& h = feed->haptic()->sample;
  ASSERT_TRUE(h.is_grasped);
  std::vector<ViewedRow> rows;
  view_rows(h, feed->contact(), rows);
  ASSERT_GE(rows.size(), 4u);
  Vec3 sum = Vec3::Zero();
  std::size_t pressing = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ViewedRow& r = rows[i];
    EXPECT_EQ(r.friction, 0.2);
    EXPECT_NEAR(r.normal.norm(), 1.0, 1e-12);
    // The cube's corners over the sheet z = 0: where the row says both features are, they are.
    if (r.kind == RowKind::scene_plane) {
      EXPECT_NEAR((r.point + r.gap * r.normal).z(), 0.0, 1e-9);
    }
    EXPECT_GT(r.gap, -1e-6);
    if (r.presses) {
      ++pressing;
      EXPECT_EQ(pressing, i + 1);  // these first
      EXPECT_LT(r.gap, 1e-5);
      EXPECT_GT(r.force.z(), 0.0);
      const double across = r.force.head<2>().norm();
      EXPECT_LE(across, 0.2 * r.force.z() * (1.0 + 1e-6));
      sum += r.force;
    } else {
      EXPECT_EQ(r.force, Vec3(Vec3::Zero()));
    }
    if (i > pressing) {
      EXPECT_GE(r.gap, rows[i - 1].gap);
    }
  }
  EXPECT_GE(pressing, 1u);
  EXPECT_NEAR((sum - h.contact.force).norm(), 0.0, 1e-3 * sum.norm());
  view_rows(h, nullptr, rows);
  EXPECT_TRUE(rows.empty());
}

TEST(Feed, NoMoreRowsAreShownThanTheProtocolHolds) {
  const RestingCube scene;
  ContactSample contact;
  for (int i = 0; i < 200; ++i) {
    ContactRow row = make_row(RowKind::scene_plane);
    row.id = static_cast<std::uint64_t>(i);
    row.object_point = {0.0, 0.0, 1e-4 * i};
    row.scene_direction = -Vec3::UnitZ();
    contact.model.constraints.rows.push_back(row);
  }
  ContactRow parallel = make_row(RowKind::edges);  // has no normal
  parallel.object_direction = parallel.scene_direction = Vec3::UnitX();
  contact.model.constraints.rows.push_back(parallel);
  HapticSample h;
  h.body.position.z() = 0.01;
  h.pressing.push_back({150, {0.0, 0.0, 2.0}});
  std::vector<ViewedRow> rows;
  view_rows(h, &contact, rows);
  ASSERT_EQ(rows.size(), kViewedRows);
  EXPECT_TRUE(rows[0].presses);
  EXPECT_NEAR(rows[0].gap, 0.01 + 0.015, 1e-12);
  EXPECT_NEAR(rows[1].gap, 0.01, 1e-12);
  EXPECT_FALSE(rows[1].presses);
}

TEST(Feed, RowsOfAFrameTellOfWaitingInTheStateChannel) {
  LiveFeed feed{Workspace{}};
  HapticSample s;
  s.is_grasped = s.is_held_back = true;
  feed.observe(s);
  s.is_held_back = false;
  s.is_squeezed = true;
  feed.observe(s);
  std::vector<ChannelRow> rows;
  feed.take_rows(rows);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].values.back(), static_cast<float>(kGrasped | kHeldBack));
  EXPECT_EQ(rows[1].values.back(), static_cast<float>(kGrasped | kSqueezed));
}

TEST(Feed, ReleasedObjectsHaveNoGhostOfTheirOwn) {
  SessionConfig config = plane_session();
  config.duration = 0.1;
  test::HeldDevice device;  // nobody holds it
  const auto feed = fed(config, device);
  const HapticNow* now = feed->haptic();
  ASSERT_NE(now, nullptr);
  EXPECT_EQ(now->ghost.position, now->sample.body.position);
  std::vector<ChannelRow> rows;
  feed->take_rows(rows);
  EXPECT_EQ(rows.back().values[7], 0.0f);  // no stretch
}

TEST(Feed, AGhostThatIsFirstSeenInTheMiddleStandsAtTheObject) {
  // As after a seek in a recording: the first frame that comes is held, and the one before it is
  // not known.
  LiveFeed feed{Workspace{}};
  feed.begin_session(Workspace{});
  HapticSample sample;
  sample.frame = 700;
  sample.is_grasped = true;
  sample.body.position = {0.1, -0.2, 0.3};
  sample.handle.pose.position = {0.1, -0.2, 0.32};
  feed.observe(sample);
  ASSERT_NE(feed.haptic(), nullptr);
  EXPECT_LT((feed.haptic()->ghost.position - sample.body.position).norm(), 1e-12);

  // And from a body of a time that has nothing to do with it.
  feed.begin_session(Workspace{});
  sample.frame = 30;
  sample.body.position = {-0.4, 0.0, 0.0};
  sample.handle.pose.position = {-0.4, 0.0, 0.02};
  feed.observe(sample);
  EXPECT_LT((feed.haptic()->ghost.position - sample.body.position).norm(), 1e-12);
}

TEST(Feed, WhatIsForgottenIsNotShown) {
  LiveFeed feed{Workspace{}};
  feed.observe(HapticSample{});
  feed.observe(ContactSample{});
  ASSERT_NE(feed.haptic(), nullptr);
  feed.observe(HapticSample{});  // not fetched yet
  feed.forget();
  EXPECT_EQ(feed.haptic(), nullptr);
  EXPECT_EQ(feed.contact(), nullptr);
  feed.observe(HapticSample{});
  EXPECT_NE(feed.haptic(), nullptr);
}

}  // namespace
}  // namespace thigma::live
