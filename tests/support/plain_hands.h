#pragma once
// Hands whose response is known in closed form.

#include "thigma/device/hand.h"

namespace thigma::test {

inline HandParams resting() {
  HandParams p;
  p.program.path = HandPath::rest;
  return p;
}

/// A point mass without friction, encoder or arm: the reference device of the stability tests,
/// without damping.
inline HandParams bare_mass(double mass) {
  HandParams p = resting();
  p.mass = mass;
  p.damping = p.friction = p.encoder = 0.0;
  p.angular_damping = p.angular_friction = p.angular_encoder = 0.0;
  p.arm_mass = p.arm_stiffness = p.arm_damping = 0.0;
  p.arm_inertia = p.arm_angular_stiffness = p.arm_angular_damping = 0.0;
  p.max_force = 1000.0;
  p.max_torque = 100.0;
  return p;
}

}  // namespace thigma::test
