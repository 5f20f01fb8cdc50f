#include "thigma/device/workspace.h"

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

Pose random_pose(Random& random) {
  Pose pose;
  pose.position = random.in_cube(0.3);
  pose.orientation = random.orientation();
  return pose;
}

Motion random_motion(Random& random) {
  return {random_pose(random), {random.in_cube(1.0), random.in_cube(5.0)}};
}

double angle_between(const Quat& a, const Quat& b) {
  return vector_from_rotation(a * b.conjugate()).norm();
}

TEST(Workspace, PowerAtTheHandleIsTheVirtualPowerTimesOneFactor) {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const Workspace workspace{random_pose(random), random.uniform(0.1, 10.0),
                              random.uniform(0.1, 10.0)};
    const WorkspaceAnchor anchor = anchor_at(random_pose(random), random_pose(random));
    const Motion device = random_motion(random);
    const Motion world = world_motion(workspace, anchor, device, true);
    const Wrench virtual_wrench{random.in_cube(3.0), random.in_cube(0.3)};
    const Wrench sent = device_wrench(workspace, virtual_wrench);
    const double factor = workspace.force_scale / workspace.motion_scale;
    // Force and torque separately: one factor for both is what keeps a 6-DoF port passive.
    EXPECT_NEAR(sent.force.dot(device.twist.linear),
                factor * virtual_wrench.force.dot(world.twist.linear), 1e-10 * factor);
    EXPECT_NEAR(sent.torque.dot(device.twist.angular),
                factor * virtual_wrench.torque.dot(world.twist.angular), 1e-10 * factor);
  }
}

TEST(Workspace, StiffnessKeepingScaleHasTheTorqueScaleOfErrata) {
  const Workspace workspace = stiffness_keeping_workspace({}, 0.4);
  EXPECT_DOUBLE_EQ(workspace.force_scale, 2.5);
  EXPECT_DOUBLE_EQ(torque_scale(workspace), 1.0 / (0.4 * 0.4));
  Motion device;
  device.pose.position = {0.01, 0.0, 0.0};
  const Motion world = world_motion(workspace, base_anchor(workspace), device, true);
  const Wrench sent = device_wrench(workspace, {-500.0 * world.pose.position, Vec3::Zero()});
  EXPECT_NEAR(sent.force.x(), -500.0 * 0.01, 1e-12);
}

TEST(Workspace, ReflectedStiffnessIsSymmetric) {
  // A virtual spring at a point off the handle couples force and rotation; seen at the handle its 6
  // x 6 stiffness must have equal off-diagonal blocks, or a closed path would yield energy.
  Random random(3);
  const Workspace workspace = stiffness_keeping_workspace(random_pose(random), 0.25);
  const WorkspaceAnchor anchor = base_anchor(workspace);
  const Vec3 arm = {0.03, -0.02, 0.05};
  const Vec3 stiffness = {300.0, 800.0, 50.0};
  const Motion rest = world_motion(workspace, anchor, {}, true);
  const auto wrench_at = [&](const Motion& device) {
    const Motion m = world_motion(workspace, anchor, device, true);
    const Vec3 lever = m.pose.orientation * (rest.pose.orientation.conjugate() * arm);
    const Vec3 stretch = m.pose.position + lever - rest.pose.position - arm;
    const Vec3 force = -stiffness.cwiseProduct(stretch);
    return device_wrench(workspace, {force, lever.cross(force)});
  };
  Mat6 k;
  const double h = 1e-6;
  for (int c = 0; c < 6; ++c) {
    const auto moved = [&](double step) {
      Motion device;
      if (c < 3) {
        device.pose.position[c] = step;
      } else {
        device.pose.orientation = rotation_from_vector(step * Vec3::Unit(c - 3));
      }
      return wrench_at(device);
    };
    const Wrench up = moved(h);
    const Wrench down = moved(-h);
    k.col(c) << (up.force - down.force) / (2 * h), (up.torque - down.torque) / (2 * h);
  }
  EXPECT_GT(k.topRightCorner(3, 3).norm(), 1.0);
  EXPECT_LT((k - k.transpose()).norm(), 1e-6 * k.norm());
}

TEST(Workspace, DeviceMotionUndoesWorldMotion) {
  Random random(11);
  for (int i = 0; i < 100; ++i) {
    const Workspace workspace{random_pose(random), random.uniform(0.1, 10.0), 1.0};
    const WorkspaceAnchor anchor = anchor_at(random_pose(random), random_pose(random));
    const Motion device = random_motion(random);
    const Motion back =
        device_motion(workspace, anchor, world_motion(workspace, anchor, device, true));
    EXPECT_LT((back.pose.position - device.pose.position).norm(), 1e-14);
    EXPECT_LT(angle_between(back.pose.orientation, device.pose.orientation), 1e-14);
    EXPECT_LT((back.twist.linear - device.twist.linear).norm(), 1e-14);
    EXPECT_LT((back.twist.angular - device.twist.angular).norm(), 1e-13);
  }
}

TEST(Workspace, TwistIsTheRateOfThePose) {
  Random random(5);
  const Workspace workspace{random_pose(random), 3.0, 1.0};
  const WorkspaceAnchor anchor = anchor_at(random_pose(random), random_pose(random));
  const Motion device = random_motion(random);
  const double h = 1e-6;
  Motion later = device;
  later.pose.position += h * device.twist.linear;
  later.pose.orientation = rotation_from_vector(h * device.twist.angular) * device.pose.orientation;
  const Motion a = world_motion(workspace, anchor, device, true);
  const Motion b = world_motion(workspace, anchor, later, true);
  EXPECT_LT(((b.pose.position - a.pose.position) / h - a.twist.linear).norm(), 1e-8);
  const Vec3 turn = vector_from_rotation(b.pose.orientation * a.pose.orientation.conjugate());
  EXPECT_LT((turn / h - a.twist.angular).norm(), 1e-8);
}

TEST(Workspace, RegraspDoesNotMoveTheVirtualHandle) {
  Random random(13);
  const Workspace workspace{random_pose(random), 2.0, 0.5};
  WorkspaceAnchor anchor = base_anchor(workspace);
  const Motion at_release = random_motion(random);
  const Pose held = world_motion(workspace, anchor, at_release, true).pose;
  const Motion at_grasp = random_motion(random);  // the clutch was open in between
  anchor = anchor_at(at_grasp.pose, held);
  const Motion after = world_motion(workspace, anchor, at_grasp, true);
  EXPECT_LT((after.pose.position - held.position).norm(), 1e-15);
  EXPECT_LT(angle_between(after.pose.orientation, held.orientation), 1e-15);
}

TEST(Workspace, WithoutSensedRotationTheObjectKeepsItsOrientation) {
  Random random(17);
  const Workspace workspace{random_pose(random), 2.0, 0.5};
  const WorkspaceAnchor anchor = anchor_at({}, random_pose(random));
  const Motion world = world_motion(workspace, anchor, random_motion(random), false);
  EXPECT_EQ(world.pose.orientation.coeffs(), anchor.world.orientation.coeffs());
  EXPECT_EQ(world.twist.angular, Vec3::Zero());
  EXPECT_GT(world.twist.linear.norm(), 0.0);
}

TEST(Workspace, ButtonsTurnAboutDeviceAxesAtTheirRate) {
  Random random(19);
  const Workspace workspace{random_pose(random), 2.0, 0.5};
  WorkspaceAnchor anchor = anchor_at({}, random_pose(random));
  const Quat before = anchor.world.orientation;
  const std::uint32_t minus_y = kTurnButtons[3];
  for (int i = 0; i < 1000; ++i) turn_by_buttons(workspace, minus_y, 0.35, 1e-3, anchor);
  const Vec3 turned = vector_from_rotation(anchor.world.orientation * before.conjugate());
  const Vec3 axis = workspace.world_from_device.orientation * Vec3(0.0, -1.0, 0.0);
  EXPECT_LT((turned - 0.35 * axis).norm(), 1e-12);
  EXPECT_LT((anchor.turn_rate - 0.35 * axis).norm(), 1e-15);
  turn_by_buttons(workspace, kTurnButtons[0] | kTurnButtons[1], 0.35, 1e-3, anchor);
  EXPECT_EQ(anchor.turn_rate, Vec3::Zero());
}

}  // namespace
}  // namespace thigma
