#include "viewer/server/world_feed.h"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

namespace thigma::live {
namespace {

template <class T>
T at(const std::string& message, std::size_t offset) {
  T value;
  std::memcpy(&value, message.data() + offset, sizeof value);
  return value;
}

/// Three bodies; a hand of the scene and a page's.
struct Bench {
  WorldView view;
  std::vector<BodyState> bodies{3};
  std::vector<std::uint8_t> is_asleep{1, 0, 0};
  std::vector<Motion> handles{2};
  std::vector<Wrench> commands{2};
  std::vector<WorldGrip> grips{2};
  WorldHapticNow haptic;
  WorldFeed feed;

  Bench() {
    view.body_from_mesh.resize(3);
    view.body_from_mesh[2].position = Vec3(0.0, 0.0, -0.1);
    view.workspaces.resize(2);
    view.page_hand = 1;
    for (std::size_t i = 0; i < 3; ++i) bodies[i].position = Vec3(static_cast<double>(i), 0.0, 0.0);
    handles[0].pose.position = Vec3(1.0, 0.5, 0.0);
    handles[1].pose.position = Vec3(2.0, 0.0, 0.3);
    commands[0].force = Vec3(1.0, 0.0, 0.0);
    commands[1].force = Vec3(0.0, 0.0, -2.0);
    feed.begin_session(view);
  }
  HapticSample observe(std::uint64_t frame) {
    WorldFrame f;
    f.frame = frame;
    f.time = 1e-3 * static_cast<double>(frame + 1);
    f.bodies = bodies;
    f.is_asleep = is_asleep;
    f.handles = handles;
    f.commands = commands;
    f.grips = grips;
    f.haptic = haptic;
    return feed.observe(f);
  }
};

TEST(WorldFeed, RowsAreShownUntilThereAreNewerOnesOrAnotherSession) {
  Bench b;
  std::vector<WorldRow> rows(2);
  rows[0].force = Vec3(0.0, 0.0, 1.0);
  b.feed.observe(rows, 7);
  b.observe(1);
  b.observe(2);
  ASSERT_NE(b.feed.newest(), nullptr);
  ASSERT_EQ(b.feed.newest()->rows.size(), 2u);
  EXPECT_TRUE(b.feed.newest()->rows[0].presses());
  EXPECT_EQ(b.feed.newest()->rows_near, 7u);
  b.feed.begin_session(b.view);
  b.observe(1);
  ASSERT_NE(b.feed.newest(), nullptr);
  EXPECT_TRUE(b.feed.newest()->rows.empty());
}

TEST(WorldFeed, NothingIsShownBeforeTheFirstFrameNorOfTheSessionBefore) {
  Bench b;
  EXPECT_EQ(b.feed.newest(), nullptr);
  b.observe(5);
  b.feed.begin_session(b.view);
  EXPECT_EQ(b.feed.newest(), nullptr);
  b.observe(0);
  ASSERT_NE(b.feed.newest(), nullptr);
  EXPECT_EQ(b.feed.newest()->frame, 0u);
}

TEST(WorldFeed, BodiesThatComeAndGoAreSeenBeforeTheNextFrame) {
  Bench b;
  const std::vector<std::int32_t> was = {0, 2, -1};
  b.feed.carry(std::vector<Pose>(3), was);
  EXPECT_EQ(b.feed.newest(), nullptr);  // there was no frame yet
  b.grips[0].body = 1;                  // it goes
  b.grips[1].body = 2;
  b.observe(5);
  std::vector<Pose> poses(3);
  poses[2].position = Vec3(0.0, 7.0, 0.0);
  b.feed.carry(poses, was);
  b.feed.begin_session(b.view);
  const WorldNow* now = b.feed.newest();
  ASSERT_NE(now, nullptr);
  EXPECT_EQ(now->frame, 5u);
  EXPECT_EQ(now->bodies[2].position, poses[2].position);
  EXPECT_EQ(now->is_asleep, (std::vector<std::uint8_t>{0, 0, 0}));
  EXPECT_EQ(now->hands[0].body, -1);
  EXPECT_EQ(now->hands[1].body, 1);
  EXPECT_EQ(now->shown_body, 1);
}

TEST(WorldFeed, ThePagesHandIsShownWhileItHoldsElseTheOneThatDoes) {
  Bench b;
  HapticSample s = b.observe(0);
  EXPECT_FALSE(s.is_grasped);
  EXPECT_EQ(b.feed.newest()->shown_hand, 1);
  EXPECT_EQ(b.feed.newest()->shown_body, -1);

  b.grips[0].body = 1;  // the scene's
  s = b.observe(1);
  EXPECT_TRUE(s.is_grasped);
  EXPECT_EQ(s.command.force, b.commands[0].force);
  EXPECT_EQ(s.body.position, b.bodies[1].position);
  EXPECT_EQ(b.feed.newest()->shown_hand, 0);

  b.grips[1].body = 2;
  b.grips[1].body_from_grasp.position = Vec3(0.0, 0.0, 0.1);
  s = b.observe(2);
  EXPECT_EQ(s.command.force, b.commands[1].force);
  EXPECT_EQ(s.body.position, b.bodies[2].position);
  EXPECT_NEAR(s.stretch, 0.2, 1e-12);  // from 0.1 above the body's centre to 0.3
  const WorldNow& now = *b.feed.newest();
  EXPECT_EQ(now.shown_body, 2);
  // The ghost: where the hand would have its mesh.
  EXPECT_NEAR((now.hands[1].ghost.position - Vec3(2.0, 0.0, 0.1)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((now.bodies[2].position - Vec3(2.0, 0.0, -0.1)).norm(), 0.0, 1e-12);

  b.grips[0].body = b.grips[1].body = -1;
  s = b.observe(3);
  EXPECT_FALSE(s.is_grasped);
  EXPECT_EQ(b.feed.newest()->shown_body, 2);  // the one that was shown last stays
}

TEST(WorldFeed, WhereHandsAreApartTheirForcesAndTimesAreShown) {
  Bench b;
  b.grips[1].body = 2;
  std::vector<Wrench> sent(2);
  sent[1].force = Vec3(0.5, 0.0, 0.0);
  b.haptic.sent = sent;
  EXPECT_EQ(b.observe(0).command.force, b.commands[1].force);  // no tick of theirs: they are not
  b.haptic.ticks = 90;
  b.haptic.missed = 3;
  b.haptic.step_cpu = 0.25;
  const HapticSample s = b.observe(1);
  EXPECT_EQ(s.command.force, sent[1].force);
  EXPECT_EQ(s.step_cpu, 0.25f);
  const WorldNow& now = *b.feed.newest();
  EXPECT_EQ(now.hands[1].force, sent[1].force);
  EXPECT_EQ(now.haptic_ticks, 90u);
  EXPECT_EQ(now.haptic_missed, 3u);
}

TEST(WorldFeed, BodiesLieAsTheTableSays) {
  Bench b;
  b.grips[1].body = 2;
  b.observe(9);
  const std::string m = encode_bodies(*b.feed.newest());
  ASSERT_EQ(m.size(), 32u + 32u * 3u + 64u * 2u);
  EXPECT_EQ(at<std::uint8_t>(m, 0), 6);
  EXPECT_EQ(at<std::uint8_t>(m, 1), 1);
  EXPECT_EQ(at<std::uint32_t>(m, 4), 3u);
  EXPECT_DOUBLE_EQ(at<double>(m, 8), 0.010);
  EXPECT_EQ(at<double>(m, 16), 9.0);
  EXPECT_EQ(at<std::uint32_t>(m, 24), 2u);
  EXPECT_EQ(at<float>(m, 32 + 32), 1.0f);           // x of the second body
  EXPECT_EQ(at<float>(m, 32 + 2 * 32 + 24), 1.0f);  // w of the third
  EXPECT_EQ(at<std::uint32_t>(m, 32 + 28), 1u);     // the first is asleep
  EXPECT_EQ(at<std::uint32_t>(m, 32 + 32 + 28), 0u);
  const std::size_t hand = 32 + 3 * 32 + 64;  // the page's
  EXPECT_EQ(at<float>(m, hand + 8), 0.3f);
  EXPECT_EQ(at<float>(m, hand + 28), 2.0f);  // grasp point
  EXPECT_EQ(at<float>(m, hand + 48), -2.0f);
  EXPECT_EQ(at<std::int32_t>(m, hand + 52), 2);
  EXPECT_EQ(at<std::uint32_t>(m, hand + 56), 1u);
  EXPECT_EQ(at<std::int32_t>(m, hand - 64 + 52), -1);
}

}  // namespace
}  // namespace thigma::live
