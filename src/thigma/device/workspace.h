#pragma once
// From the device's workspace to the virtual one and back: scales, base pose, clutch.
//
// With motion scale s (virtual metres per device metre) and force scale f (device newtons per
// virtual newton)
//   v_virtual = s v_device,  w_virtual = w_device,  F_device = f F_virtual,  T_device = (f / s)
//   T_virtual.
// Then P_device = (f / s) P_virtual for force and torque alike, so a passive virtual port stays
// passive at the handle and the reflected 6 x 6 stiffness stays symmetric. f = 1/s keeps stiffness
// and gives the torque 1/s^2 of docs/sources.md (workspace scaling); f = s keeps power and gives
// torque scale 1, its alternative.

#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/device/haptic_device.h"
#include "thigma/math/pose.h"

namespace thigma {

/// Constant while a session runs.
struct Workspace {
  Pose world_from_device;  // axes of the device in the world; position: where the device's origin
                           // sits [m]
  double motion_scale = 1.0;  // s > 0 [virtual m / device m]
  double force_scale = 1.0;   // f > 0 [device N / virtual N]
};

/// Workspace of motion scale s that keeps the stiffness felt: force scale 1/s (Sec. 5.5.3: 0.4
/// and 2.5).
inline Workspace stiffness_keeping_workspace(const Pose& world_from_device,
                                             double motion_scale) THIGMA_RT {
  return {world_from_device, motion_scale, 1.0 / motion_scale};
}

/// Device newton metres per virtual newton metre: f / s, as power asks (top of this file).
inline double torque_scale(const Workspace& workspace) THIGMA_RT {
  return workspace.force_scale / workspace.motion_scale;
}

/// The clutch: this handle pose means that virtual pose. Changes at grasp, at re-grasp and by turn
/// buttons.
struct WorkspaceAnchor {
  Pose device;                    // handle pose when anchored [device frame]
  Pose world;                     // what it stood for then [world]
  Vec3 turn_rate = Vec3::Zero();  // by buttons, where rotation is not sensed [rad/s; world]
};

/// Anchor without a clutch offset: the device's origin at world_from_device.
/// Thread    [haptic].
WorkspaceAnchor base_anchor(const Workspace& workspace) THIGMA_RT;

/// Anchor that lets `device` mean `world` from now on: grasp, and re-grasp after the clutch was
/// open (world: the virtual handle pose at that moment, so that it does not jump).
/// Thread    [haptic].
WorkspaceAnchor anchor_at(const Pose& device, const Pose& world) THIGMA_RT;

/// Motion of the virtual handle.
///
/// device           handle pose and twist [m, rad/s; device frame]
/// senses_rotation  false: orientation stays the anchor's, turned by its turn_rate only
/// returns          pose and twist [world]
/// Thread           [haptic]; no failure.
Motion world_motion(const Workspace& workspace, const WorkspaceAnchor& anchor, const Motion& device,
                    bool senses_rotation) THIGMA_RT;

/// The inverse of world_motion for a device that senses rotation.
/// Thread    [haptic].
Motion device_motion(const Workspace& workspace, const WorkspaceAnchor& anchor,
                     const Motion& world) THIGMA_RT;

/// Wrench for the device from the wrench on the hand, about the handle [N, N m; world -> device
/// frame], scaled. The sign is kept: the caller passes the reaction.
/// Thread    [haptic].
/// Source    docs/sources.md, workspace scaling.
Wrench device_wrench(const Workspace& workspace, const Wrench& hand_wrench) THIGMA_RT;

/// Advances the anchor by turn buttons held during dt at `rate` about device axes [rad/s], and
/// keeps the rate in turn_rate so that the twist agrees with the motion. Call before world_motion,
/// once a tick.
/// Thread    [haptic].
void turn_by_buttons(const Workspace& workspace, std::uint32_t buttons, double rate, double dt,
                     WorkspaceAnchor& anchor) THIGMA_RT;

/// Turn rate used where the scene names none. The scripted hand holds the buttons as long as its
/// twist needs at it.
inline constexpr double kButtonTurnRate = 0.35;  // [rad/s], about 20 degrees a second

}  // namespace thigma
