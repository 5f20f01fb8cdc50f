#include "thigma/device/workspace.h"

#include "thigma/math/rotation.h"

namespace thigma {

WorkspaceAnchor base_anchor(const Workspace& workspace) THIGMA_RT {
  return {Pose{}, workspace.world_from_device, Vec3::Zero()};
}

WorkspaceAnchor anchor_at(const Pose& device, const Pose& world) THIGMA_RT {
  return {device, world, Vec3::Zero()};
}

Motion world_motion(const Workspace& workspace, const WorkspaceAnchor& anchor, const Motion& device,
                    bool senses_rotation) THIGMA_RT {
  const Quat& axes = workspace.world_from_device.orientation;
  const double s = workspace.motion_scale;
  Motion world;
  world.pose.position = anchor.world.position +
                        s * axes._transformVector(device.pose.position - anchor.device.position);
  world.twist.linear = s * axes._transformVector(device.twist.linear);
  if (!senses_rotation) {
    world.pose.orientation = anchor.world.orientation;
    world.twist.angular = anchor.turn_rate;
    return world;
  }
  const Quat turn = device.pose.orientation * anchor.device.orientation.conjugate();
  world.pose.orientation = unit(axes * turn * axes.conjugate() * anchor.world.orientation);
  world.twist.angular = axes._transformVector(device.twist.angular);
  return world;
}

Motion device_motion(const Workspace& workspace, const WorkspaceAnchor& anchor,
                     const Motion& world) THIGMA_RT {
  const Quat axes = workspace.world_from_device.orientation.conjugate();
  const double s = 1.0 / workspace.motion_scale;
  const Quat turn = world.pose.orientation * anchor.world.orientation.conjugate();
  Motion device;
  device.pose.position = anchor.device.position +
                         s * axes._transformVector(world.pose.position - anchor.world.position);
  device.pose.orientation = unit(axes * turn * axes.conjugate() * anchor.device.orientation);
  device.twist.linear = s * axes._transformVector(world.twist.linear);
  device.twist.angular = axes._transformVector(world.twist.angular);
  return device;
}

Wrench device_wrench(const Workspace& workspace, const Wrench& hand_wrench) THIGMA_RT {
  const Quat axes = workspace.world_from_device.orientation.conjugate();
  return {workspace.force_scale * axes._transformVector(hand_wrench.force),
          torque_scale(workspace) * axes._transformVector(hand_wrench.torque)};
}

void turn_by_buttons(const Workspace& workspace, std::uint32_t buttons, double rate, double dt,
                     WorkspaceAnchor& anchor) THIGMA_RT {
  Vec3 rate_device = Vec3::Zero();
  for (int i = 0; i < 6; ++i) {
    if (buttons & kTurnButtons[i]) rate_device[i / 2] += i % 2 == 0 ? rate : -rate;
  }
  anchor.turn_rate = workspace.world_from_device.orientation._transformVector(rate_device);
  const Quat turn = rotation_from_vector(dt * anchor.turn_rate);
  anchor.world.orientation = unit(turn * anchor.world.orientation);
}

}  // namespace thigma
