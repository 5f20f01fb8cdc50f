#pragma once
// A simulated person holding a simulated device, so that the haptic loop is closed without
// hardware.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "thigma/device/hand_program.h"
#include "thigma/device/haptic_device.h"
#include "thigma/device/script.h"

namespace thigma {

/// Everything about the simulated device and arm. The handle is a rigid body; the arm's mass moves
/// with it and a spring and damper pull both toward a moving target. Linear and angular halves have
/// the same law.
struct HandParams {
  // the device: like a Phantom (docs/sources.md, E3, device B); angular numbers are of that class,
  // not of one data sheet
  double mass = 0.075;             // of the handle, felt [kg]
  double damping = 0.005;          // [N s/m]
  double friction = 0.04;          // Coulomb [N]
  double encoder = 3e-5;           // step of the sensed position [m]; 0 = exact
  double inertia = 2e-5;           // of the handle [kg m^2]
  double angular_damping = 1e-5;   // [N m s/rad]
  double angular_friction = 5e-4;  // Coulomb [N m]
  double angular_encoder = 4e-5;   // step of the sensed orientation [rad]; 0 = exact
  double sampling = 0.0;           // encoders are read this often [Hz]; 0 = at every read
  double delay = 0.0;              // age of what a read returns, beyond sampling [s], <= 0.1
  double jitter = 0.0;             // added to the delay, uniform in [0, jitter] [s], <= 0.1
  // longest window of the velocity estimate [s]; angular: twice that
  double velocity_window = 0.015;
  double max_force = 8.5;              // the actuators saturate here [N], norm
  double max_torque = 0.188;           // [N m], norm
  double max_stiffness = 800.0;        // told by limits() [N/m]
  double max_angular_stiffness = 0.3;  // told by limits() [N m/rad]
  double workspace_radius = 0.1;       // told by limits() [m]
  bool senses_rotation = true;         // without it the sensed orientation stays the identity
  bool actuates_rotation = true;       // without it torque is never applied
  std::string device = "phantom";      // name told by name()

  // the arm: docs/sources.md, E3 has 100-1500 N/m and 1-15 N s/m
  double arm_mass = 0.15;              // [kg]
  double arm_stiffness = 400.0;        // [N/m]
  double arm_damping = 8.0;            // relative to the target's velocity [N s/m]
  double arm_inertia = 2e-4;           // [kg m^2]
  double arm_angular_stiffness = 0.5;  // [N m/rad]
  double arm_angular_damping = 0.01;   // [N m s/rad]
  double tremor = 0.0;                 // of the target, 8-12 Hz [m], root mean square per axis
  double angular_tremor = 0.0;         // [rad]

  HandProgramParams program;      // what the hand does
  std::vector<TimedPose> script;  // when not empty, the target follows this instead of the program
  std::uint64_t seed = 1;         // of tremor and jitter
};

/// The simulated hand and device.
/// Time starts at the first read and advances in read(now): sub-steps of at most 62.5 us, at most
/// 1600 of them (longer ones after a stall of more than 0.1 s), trapezoidal for mass, spring and
/// damper, implicit for friction: stable for any gains. A `now` that does not advance changes
/// nothing. Invariant: handle orientation is unit; same parameters, times and wrenches give the
/// same bits.
class HandDevice final : public HapticDevice {
 public:
  /// errors  std::invalid_argument naming the parameter that is out of range (what_is_wrong).
  /// Thread  [offline].
  explicit HandDevice(const HandParams& params);
  ~HandDevice() override;

  const DeviceLimits& limits() const override;
  std::string name() const override;
  DeviceState read(double now) THIGMA_RT override;
  void write(const Wrench& wrench) THIGMA_RT override;

  /// Where the handle really is and how it moves, without encoders, delay and filters: what energy
  /// is measured with.
  const Motion& true_motion() const THIGMA_RT;
  /// Where the arm pulls the handle.
  const Motion& target_motion() const THIGMA_RT;
  /// Wrench the actuators really apply, after saturation and without what is not actuated [device
  /// frame].
  const Wrench& applied_wrench() const THIGMA_RT;
  /// Kinetic energy of handle and arm plus energy in the arm's springs [J].
  double stored_energy() const THIGMA_RT;
  /// What the program is doing; `script` with a script.
  HandPhase phase() const THIGMA_RT;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Empty, or one line "PARAMETER = VALUE, what is allowed".
/// Thread    [offline].
std::string what_is_wrong(const HandParams& params);

/// As the constructor.
/// Thread    [offline].
std::unique_ptr<HandDevice> make_hand(const HandParams& params = {});

}  // namespace thigma
