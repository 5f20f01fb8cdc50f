#pragma once
// What a hand feels of ridges: how often, and how high.

namespace thigma::experiments::relief {

/// The force under a hand that is led over the ridges of the plate at one height.
struct Felt {
  double rate = 0.0;     // of its peaks over that of the ridges passed
  double decibel = 0.0;  // its swing over k_c times that of the probe's rest, place by place [dB]
  double largest_step = 0.0;  // of the force from frame to frame [N]
  bool is_stable = false;     // no fault, no limit of force
};

/// Scene `plate`, the probe led across its ridges by a script.
///
/// every  haptic frames from one contact frame to the next
/// speed  of the hand [m/s]
/// Thread [offline]; deterministic.
Felt feel_ridges(int every, double speed);

}  // namespace thigma::experiments::relief
