#include "thigma/device/hand_program.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "device/tick.h"
#include <gtest/gtest.h>

#include "thigma/device/hand.h"
#include "thigma/device/workspace.h"
#include "thigma/math/elementary.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using test::kTick;
constexpr double kDepth = 0.02;  // of the wall along the approach

struct Played {
  std::vector<HandPhase> phases;  // each change
  double force_max = 0.0, across_max = 0.0, across_min = 0.0, angle_max = 0.0, depth_max = 0.0;
  double buttons_turned = 0.0;  // by turn buttons along the approach [rad]
  double final_depth = 0.0, final_force = 0.0, final_angle = 0.0;
};

// The default hand against a plane across its approach; stiffness 0: nothing there.
Played play(HandParams p, double stiffness, double seconds) {
  const auto hand = make_hand(p);
  Played played;
  const Vec3 n = p.program.approach;
  WorkspaceAnchor anchor;
  for (int i = 0; i * kTick < seconds; ++i) {
    const DeviceState state = hand->read(i * kTick);
    const Vec3 moved = state.motion.pose.position - p.program.start.position;
    const double force = stiffness * std::max(0.0, moved.dot(n) - kDepth);
    hand->write({-force * n, Vec3::Zero()});
    const Quat turn = state.motion.pose.orientation * p.program.start.orientation.conjugate();
    turn_by_buttons({}, state.buttons, kButtonTurnRate, kTick, anchor);
    EXPECT_TRUE(state.buttons & kClutchButton);
    if (played.phases.empty() || played.phases.back() != hand->phase()) {
      played.phases.push_back(hand->phase());
    }
    const double across = moved.dot(p.program.slide);
    played.final_angle = vector_from_rotation(turn).dot(n);
    played.final_depth = moved.dot(n);
    played.final_force = force;
    played.force_max = std::max(played.force_max, force);
    played.across_max = std::max(played.across_max, across);
    played.across_min = std::min(played.across_min, across);
    played.angle_max = std::max(played.angle_max, played.final_angle);
    played.depth_max = std::max(played.depth_max, played.final_depth);
    const double turned = vector_from_rotation(anchor.world.orientation).dot(n);
    played.buttons_turned = std::max(played.buttons_turned, turned);
  }
  return played;
}

using enum HandPhase;

TEST(HandProgram, DemoDoesEverythingInOrderAndRepeats) {
  const Played played = play({}, 500.0, 9.0);
  const std::vector<HandPhase> once = {rest, approach, press, slide, twist,  untwist,
                                       lift, tap,      lift,  tap,   retract};
  ASSERT_GE(played.phases.size(), once.size() + 3);
  for (std::size_t i = 0; i < played.phases.size(); ++i) {
    EXPECT_EQ(played.phases[i], once[i % once.size()]) << i;
  }
  EXPECT_NEAR(played.across_max, 0.010, 2e-4);
  EXPECT_NEAR(played.angle_max, 0.0873, 1e-3);
  EXPECT_GT(played.force_max, 0.95);
  EXPECT_LT(played.force_max, 2.5);  // taps included
}

TEST(HandProgram, DemoFitsIntoFiveSecondsUpToTheTaps) {
  const Played played = play({}, 500.0, 5.0);
  EXPECT_EQ(std::count(played.phases.begin(), played.phases.end(), tap), 2);
}

TEST(HandProgram, WorksAlongAnyApproachFromAnyStart) {
  HandParams p;
  p.program.approach = Vec3(1.0, 2.0, -2.0) / 3.0;
  p.program.slide = Vec3(2.0, 1.0, 2.0) / 3.0;
  p.program.start.position = {0.01, -0.02, 0.03};
  p.program.start.orientation = unit(Quat(0.5, 0.1, -0.7, 0.2));
  const Played played = play(p, 500.0, 5.0);
  EXPECT_NEAR(played.across_max, 0.010, 2e-4);
  EXPECT_NEAR(played.angle_max, 0.0873, 1e-3);
  EXPECT_GT(played.force_max, 0.95);
}

TEST(HandProgram, NothingThereIsNotChased) {
  HandParams p;
  const Played played = play(p, 0.0, 4.0);
  const std::vector<HandPhase> expected = {rest, approach, retract, rest, approach};
  ASSERT_GE(played.phases.size(), 4u);
  for (std::size_t i = 0; i < std::min(played.phases.size(), expected.size()); ++i) {
    EXPECT_EQ(played.phases[i], expected[i]);
  }
  EXPECT_LT(played.depth_max, p.program.reach + 2e-3);  // the arm may swing on by a little
}

TEST(HandProgram, WeightInTheHandIsNotContact) {
  // 0.6 N hang on the handle from the start: more than the share of 1 N that counts as contact.
  const auto hand = make_hand();
  for (int i = 0; i < 900; ++i) {
    hand->read(i * kTick);
    hand->write({{0.0, 0.0, -0.6}, Vec3::Zero()});
  }
  EXPECT_EQ(hand->phase(), approach);
}

TEST(HandProgram, SlideGoesThereAndBack) {
  HandParams p;
  p.program.path = HandPath::slide;
  const Played played = play(p, 500.0, 6.0);
  EXPECT_EQ(played.phases.back(), slide);
  EXPECT_NEAR(played.across_max, 0.010, 2e-4);
  EXPECT_GT(played.across_min, -2e-4);
  EXPECT_NEAR(played.final_force, 1.0, 0.06);
}

TEST(HandProgram, TapComesAndGoes) {
  HandParams p;
  p.program.path = HandPath::tap;
  const Played played = play(p, 500.0, 6.0);
  EXPECT_GE(std::count(played.phases.begin(), played.phases.end(), tap), 8);
  EXPECT_LT(played.force_max, 3.0);
}

TEST(HandProgram, CircleStaysOnItsCircle) {
  HandParams p;
  p.program.path = HandPath::circle;
  const auto hand = make_hand(p);
  double farthest = 0.0;
  for (int i = 0; i < 5000; ++i) {
    hand->read(i * kTick);
    const Vec3 x = hand->target_motion().pose.position;
    const Vec3 from_centre = x + p.program.slide_length * p.program.slide;
    EXPECT_NEAR(from_centre.norm(), p.program.slide_length, 1e-12);
    EXPECT_NEAR(x.z(), 0.0, 1e-15);
    farthest = std::max(farthest, x.norm());
  }
  EXPECT_NEAR(farthest, 2.0 * p.program.slide_length, 1e-5);
}

TEST(HandProgram, TurnGoesThereAndBackAboutTheApproach) {
  HandParams p;
  p.program.path = HandPath::turn;
  p.program.twist_angle = 1.0;
  p.program.twist_time = 2.0;
  const auto hand = make_hand(p);
  double most = 0.0, last = 0.0, fastest = 0.0;
  int turned_back = 0;
  for (int i = 0; i < 9000; ++i) {
    hand->read(i * kTick);
    const Pose pose = hand->target_motion().pose;
    EXPECT_EQ(pose.position.norm(), 0.0);
    const Vec3 axis = vector_from_rotation(pose.orientation);
    EXPECT_NEAR(axis.cross(p.program.approach).norm(), 0.0, 1e-12);
    const double angle = axis.dot(p.program.approach);
    turned_back += most > 0.999 && last > 1e-4 && angle <= 1e-4 ? 1 : 0;
    fastest = std::max(fastest, std::fabs(angle - last));
    most = std::max(most, angle);
    last = angle;
  }
  EXPECT_NEAR(most, 1.0, 1e-6);
  EXPECT_EQ(turned_back, 2);  // after 4 and 8 s
  EXPECT_NEAR(fastest, 0.25 * kPi * kTick, 1e-6);
}

TEST(HandProgram, RestStaysAtTheStart) {
  HandParams p;
  p.program.path = HandPath::rest;
  const Played played = play(p, 500.0, 2.0);
  EXPECT_EQ(played.phases, std::vector<HandPhase>{rest});
  EXPECT_EQ(played.depth_max, 0.0);
}

TEST(HandProgram, WithoutSensedRotationButtonsTwist) {
  HandParams p;
  p.senses_rotation = p.actuates_rotation = false;
  const Played played = play(p, 500.0, 5.0);
  EXPECT_EQ(played.angle_max, 0.0);
  EXPECT_NEAR(played.buttons_turned, 0.0873, 2.0 * kButtonTurnRate * kTick);
  EXPECT_EQ(std::count(played.phases.begin(), played.phases.end(), tap), 2);
}

TEST(HandProgram, ScalesToSmallObjects) {
  HandProgramParams near;
  near.clearance = 0.004;
  const HandProgramParams small = scale_to_object(near, 0.01);
  EXPECT_DOUBLE_EQ(small.slide_length, 0.002);
  EXPECT_DOUBLE_EQ(small.lift_height, 0.002);
  EXPECT_DOUBLE_EQ(small.reach, 0.016);
  const HandProgramParams large = scale_to_object({}, 1.0);
  EXPECT_DOUBLE_EQ(large.slide_length, HandProgramParams{}.slide_length);
}

TEST(HandProgram, TargetIsContinuous) {
  HandParams p;
  const auto hand = make_hand(p);
  double fastest = 0.0;
  for (int i = 0; i < 9000; ++i) {
    const double z = hand->read(i * kTick).motion.pose.position.z();
    hand->write({{0.0, 0.0, 500.0 * std::max(0.0, -z - kDepth)}, Vec3::Zero()});
    fastest = std::max(fastest, hand->target_motion().twist.linear.norm());
  }
  EXPECT_LE(fastest, p.program.tap_speed + 1e-9);
  EXPECT_GT(fastest, 0.09);
}

}  // namespace
}  // namespace thigma
