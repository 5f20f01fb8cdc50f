#pragma once
// One haptic frame: from the device's pose to the force in the hand (Sec. 5.1.2).

#include <cstdint>

#include "thigma/core/latest.h"
#include "thigma/core/rt.h"
#include "thigma/core/spsc_ring.h"
#include "thigma/device/haptic_device.h"
#include "thigma/device/workspace.h"
#include "thigma/dynamics/coupling.h"
#include "thigma/dynamics/linear_contact_model.h"
#include "thigma/loop/haptic_params.h"
#include "thigma/loop/passivity.h"
#include "thigma/loop/passivity_control.h"
#include "thigma/loop/safety.h"
#include "thigma/loop/samples.h"

namespace thigma {

/// One impact that still rings. Every member is set where one is made.
struct TapVoice {
  Wrench unit;        // of a newton of it on the hand about the handle when it began [-, m; world]
  double size;        // force it would have now at the top of its sine [N]
  double age;         // [s]
  double frequency;   // [Hz]
  double decay_rate;  // [1/s]
};
inline constexpr int kMaxVoices = 4;  // at once; a stronger one takes the place of the weakest

/// Taps between two steps. Empty is silence.
struct TapState {
  StaticVector<TapVoice, kMaxVoices> voices;
  Wrench asked;  // by the last step, about the handle [world]
  Wrench held;   // as far as that was sent
  // What taps may still hand out: the energy that impacts have taken from the body and what the
  // hand has put in against the taps since [J]
  double store = 0.0;
};

/// What changes from frame to frame. Copyable: a step is a function of it and of its inputs.
struct HapticState {
  std::uint64_t frame = 0;
  double time = 0.0;  // of the last step [s; session clock]
  BodyState body;
  bool is_grasped = false;
  bool was_pressed = false;  // clutch, last frame
  Coupling coupling;         // params.coupling with the present grasp
  WorkspaceAnchor anchor;
  DeviceState last_device;  // last usable sample
  SafetyState safety;
  EnergyObserver energy;
  PassivityControl passivity;
  RowMemory rows;             // of the constrained response
  BristleMemory bristles;     // friction of the others
  TapState taps;              // of the constrained response
  Pose handle;                // of the last step [world]
  double wanted_speed = 0.0;  // of the last step, were nothing to hold it back [m/s]
  double wanted_gain = 0.0;   // and how fast that grows [m/s^2]
  float step_cpu = 0.0f,
        wake_late = 0.0f;  // of the frame before, filled in by the shell for telemetry [s]
};

/// What the haptic thread tells the contact thread.
struct StampedBody {
  BodyState state;
  double time = 0.0;  // session clock [s]
  std::uint64_t frame = 0;
  // of any point of the object, were the travel of the last model not to end; 0 but with the
  // constrained response [m/s]
  double wanted_speed = 0.0;
  double wanted_gain = 0.0;  // how fast that grows [m/s^2]
};

struct ConstrainedStep;
struct StepForces;

/// Moves the body in the place of constrained_step, where it is not the only one that moves.
struct BodyStepper {
  void* self = nullptr;
  // as constrained_step, dt > 0 [s]; null: nothing takes its place
  ConstrainedStep (*step)(void* self, const BodyAtState& at, const StepForces& forces,
                          double dt) THIGMA_RT = nullptr;
};

/// The shared things a step touches; all lives longer than the session's threads.
struct HapticPorts {
  HapticDevice* device = nullptr;
  Latest<LinearContactModel>* models = nullptr;  // read
  Latest<StampedBody>* bodies = nullptr;         // written
  SpscRing<HapticSample>* telemetry = nullptr;   // written; null: none
  // that row solves are timed by, without a call of the system [ns]; null: not timed
  std::int64_t (*clock)() noexcept = nullptr;
  BodyStepper stepper{};  // of the constrained response
};

/// What a tick is told from outside.
struct HapticTick {
  double now = 0.0;       // [s; session clock, or that of a device that owns the clock]
  double elapsed = 1e-3;  // since the last step, the length of this one [s], > 0; a step without a
                          // finite time or a length above zero is fault not_finite
  Fault external_fault = Fault::none;
};

/// State before the first frame: the body at rest at `world_from_body` (centre of mass), nothing
/// grasped.
HapticState initial_state(const HapticParams& params, const Pose& world_from_body) THIGMA_RT;

/// One frame: device, coupling, newest contact model, implicit step, coupling again, limits,
/// passivity controller where it is on, device, telemetry.
///
/// With the direct response the object follows the handle exactly, through anything, and the
/// contact wrench alone is sent, under the same limits. Damping of the contact terms acts on the
/// handle's velocity.
///
/// With the constrained response the body is simulated as with the penalty, but contacts are
/// inequalities (dynamics/constrained_step.h): it stays outside, and the hand feels the coupling.
/// A model that is old keeps its rows; the body waits at the end of their travel, and the wrench on
/// the hand fades.
///
/// Contacts with friction: rows by Coulomb's cones, terms by a bristle each (dynamics/bristle.h),
/// with either of the other responses; what is let go of forgets its bristles.
///
/// A device sample that counts by less than 1 (DeviceState::weight) holds the object by weaker
/// springs, and the wrench on the hand is weaker by the same factor: at 0 the object comes to rest
/// where it is.
///
/// The clutch button takes hold of the object and lets it go. An object nobody holds stays where it
/// is, at rest. Grasped inside a contact it follows the hand, but nothing is sent until it has left
/// the contact once: arming never happens inside a contact. After a fault nothing is held and zero
/// is sent until clear_fault, or, where params.resumes_lost_device, until a lost device answers
/// again and its clutch is pressed anew.
///
/// With safety.rides_out_gaps a frame that is told of the watchdog, or finds the model too old,
/// sends zero and goes on instead: what is held stays held, the force comes back over the ramp.
///
/// params, ports   constant; ports.device is read once and written once
/// tick            time and step length; nothing assumes 1 ms
/// state           read and written
/// returns         the frame's sample, as pushed to telemetry
/// Thread          [haptic]: the session's thread, or a device's own. Bounded, no failure; what is
///                 wrong latches a fault and sends zero force.
/// Source          Sec. 5.1.2 steps 1-6; the hand gets the reaction about the handle
///                 (docs/deviations.md).
HapticSample haptic_step(const HapticParams& params, const HapticPorts& ports,
                         const HapticTick& tick, HapticState& state) THIGMA_RT;

}  // namespace thigma
