#pragma once
// One axis of the whole loop, linear: arm, handle, samples that come late, coupling, body, contact.
// What gains are judged by before anybody holds a device.

namespace thigma {

/// One axis, translation or rotation: lengths are [m] or [rad], forces [N] or [N m], masses [kg] or
/// [kg m^2]. All on one side of the workspace scales.
struct SampledLoop {
  double period = 1e-3;         // of the haptic frames, > 0 [s]
  double delay = 0.0;           // of a sample, beyond the frame it is read in, >= 0 [s]
  double handle_mass = 0.075;   // > 0
  double handle_damping = 0.0;  // of the device
  double arm_mass = 0.0;        // moves with the handle
  double arm_stiffness = 0.0;   // from a point at rest to the handle
  double arm_damping = 0.0;
  double body_mass = 0.010;         // of the grasped object, > 0; infinite: it stays where it is
  double coupling_stiffness = 0.0;  // k_c
  double coupling_damping = 0.0;    // b_c
  double contact_stiffness = 0.0;   // k of a plane that also pulls; 0: free space
  double contact_damping = 0.0;     // b
};

/// By what factor swings grow from frame to frame; below 1 they die out. The handle moves in
/// continuous time under a force held over each frame; the body takes a backward Euler step at
/// every one of them, as implicit_step does; the handle's velocity is the difference of two
/// samples.
///
/// loop     see there
/// returns  spectral radius of the loop, from the size of its swings over `frames`; estimates err
///          by about 2 / frames, and what grows by more than 1e200 in an eighth of the frames
///          counts as 2
/// Thread   [offline]; programmer errors (a period or mass that is not positive) are asserts.
double loop_growth(const SampledLoop& loop, int frames = 4096);

}  // namespace thigma
