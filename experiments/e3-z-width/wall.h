#pragma once
// A sampled wall and the simulated device against it (docs/sources.md, E3), without the engine.

#include <vector>

#include "thigma/device/hand.h"

namespace thigma::experiments {

/// Wall F = K x + B (x_k - x_{k-1}) / T.
struct Wall {
  double stiffness = 0.0, damping = 0.0;  // [N/m, N s/m]
  bool is_two_sided = false;              // false: it never pulls, x > 0 is inside
};

/// One axis of the simulated device against a wall.
struct WallCase {
  HandParams hand;
  Wall wall;
  double period = 1e-3;  // [s]
  double push = 0.0;     // constant force into the wall [N]
  double seconds = 3.0;
};

/// Position of the handle at every tick [m]; stops early where it has left for good. A two-sided
/// wall starts with a blow of 10 mN for a tick.
std::vector<double> swing(const WallCase& wall_case);

/// Growth of |x| from the second eighth of a swing to the last; above 1 it is unstable. What left
/// for good: infinity.
double growth(const std::vector<double>& x, double seconds, double period);

/// docs/sources.md, E3: over the last third peak-to-peak > max(2 D, 1 um), or it grows.
bool is_unstable(const WallCase& wall_case);

/// Device of docs/sources.md, E3: 'A' analytic, 'B' like a Phantom, 'C' like a robot; no arm.
HandParams e3_device(char letter);

/// Largest root of z^{D+1} (z - 1)^2 + (z + 1) ((alpha + beta) z - beta) / 2: the two-sided wall on
/// a mass m without damping, alpha = K T^2 / m, beta = B T / m, D whole samples late.
double largest_root(double alpha, double beta, int late);
/// Largest alpha with every root within the unit circle; 0 where there is none.
double exact_boundary(double beta, int late);

/// Whether no motion from rest to rest draws energy from a wall on a device of damping b, sampled
/// at T: every pivot of the quadratic form of energy over the samples is positive.
bool is_passive(const Wall& wall, double device_damping, double period);

}  // namespace thigma::experiments
