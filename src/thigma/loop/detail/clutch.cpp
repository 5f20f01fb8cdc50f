#include "thigma/loop/detail/clutch.h"

namespace thigma::detail {
namespace {

void hold_still(BodyState& y) THIGMA_RT {
  y.linear_momentum.setZero();
  y.angular_momentum.setZero();
}

/// The clutch has closed: the handle stands for the grasp point, or stays where it is, and both
/// springs are at rest.
void take_hold(const HapticParams& params, const Pose& handle, HapticState& state) THIGMA_RT {
  if (params.grasp_place == GraspPlace::grasp_point) {
    const Pose world_from_body{state.body.position, state.body.orientation};
    const Pose place{transform_point(world_from_body, params.grasp_point),
                     params.workspace.world_from_device.orientation * handle.orientation};
    state.anchor = anchor_at(handle, place);
  }
  const Motion still{handle, Twist{}};
  const Motion world =
      world_motion(params.workspace, state.anchor, still, params.device.senses_rotation);
  grasp(state.coupling, state.body, world.pose);
  state.is_grasped = true;
}

/// A device that was lost and answers again: a new press of the clutch clears the fault, the next
/// frame takes hold.
void resume_by_clutch(const DeviceState& device, HapticState& state) THIGMA_RT {
  if (device.status != DeviceStatus::ok) return;
  const bool is_pressed = (device.buttons & kClutchButton) != 0;
  if (is_pressed && !state.was_pressed) {
    clear_fault(state.safety);
  } else {
    state.was_pressed = is_pressed;
  }
}

}  // namespace

void let_go(HapticState& state) THIGMA_RT {
  release(state.coupling);
  hold_still(state.body);
  state.is_grasped = false;
  state.bristles = {};
  state.rows.bounces.clear();
  state.taps = {};
}

void follow_clutch(const HapticParams& params, const DeviceState& device, bool is_usable,
                   HapticState& state) THIGMA_RT {
  if (state.safety.fault != Fault::none) {
    if (state.is_grasped) let_go(state);
    if (is_resumable(params, state.safety.fault)) resume_by_clutch(device, state);
    return;
  }
  if (!is_usable) return;
  const bool is_pressed = (state.last_device.buttons & kClutchButton) != 0;
  if (is_pressed && !state.was_pressed) take_hold(params, state.last_device.motion.pose, state);
  if (!is_pressed && state.is_grasped) let_go(state);
  state.was_pressed = is_pressed;
}

}  // namespace thigma::detail
