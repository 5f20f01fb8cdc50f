#pragma once
// Every number of the haptic step, constant while a session runs.

#include <cstdint>
#include <vector>

#include "thigma/core/rt.h"
#include "thigma/device/haptic_device.h"
#include "thigma/device/workspace.h"
#include "thigma/dynamics/body.h"
#include "thigma/dynamics/constraint_model.h"
#include "thigma/dynamics/coupling.h"
#include "thigma/loop/passivity_control.h"
#include "thigma/loop/safety.h"

namespace thigma {

/// Where the hand takes hold when the clutch closes.
enum class GraspPlace : std::uint8_t {
  grasp_point,  // at HapticParams::grasp_point: the handle is moved there (clutching), wherever the
                // device is
  handle,       // where the virtual handle is at that moment, at whatever distance from the object
};

/// How the contact forces reach the hand.
enum class ResponseKind : std::uint8_t {
  coupled,  // simulated body and virtual coupling (Chapter 5)
  // the object is where the handle has it; contact forces go straight to the hand (Sec. 3.5.3)
  direct,
  // simulated body and virtual coupling; contacts are inequalities: the object never enters
  constrained,
  // as coupled, but the contacts' force is the gradient of one energy (PotentialLaw)
  potential,
};

/// Constant while a session runs.
struct HapticParams {
  RigidBody body;
  Coupling coupling;  // gains and saturations; grasp frame and is_grasped are set by the step
  Workspace workspace;
  SafetyLimits safety;
  DeviceLimits device;  // of the device in use; sessions fill it in
  GraspPlace grasp_place = GraspPlace::grasp_point;
  Vec3 grasp_point = Vec3::Zero();  // from the centre of mass [m; body frame]
  // of the turn buttons, for devices without sensed rotation [rad/s]
  double turn_rate = kButtonTurnRate;
  ResponseKind response = ResponseKind::coupled;
  ConstraintParams constraint;  // of the constrained response
  // what the object does where it meets the static objects, by their number; none beyond the end
  std::vector<ImpactPair> impacts;
  PassivityParams passivity;  // off by default
  // a device that was lost and answers again may be taken up by a new press of the clutch; else the
  // fault stays until cleared
  bool resumes_lost_device = false;
};

/// Sets params.device, and takes rides_out_gaps away where the device holds a person.
/// Thread    [offline].
void use_device_limits(const DeviceLimits& limits, HapticParams& params);

/// Whether a session goes on, with zero force, while this fault is latched: a press of the clutch
/// may clear it.
/// Thread    [haptic].
inline bool is_resumable(const HapticParams& params, Fault fault) THIGMA_RT {
  return params.resumes_lost_device && fault == Fault::device_lost;
}

}  // namespace thigma
