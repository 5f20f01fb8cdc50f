#pragma once
// The whole engine in the loop: how stiff the coupling may be on a wall, in a groove, with a peg in
// its hole.

#include <string>
#include <vector>

#include "thigma/session/session.h"

namespace thigma::experiments {

/// A place to press into, in closed form.
struct Place {
  std::string name;
  ContactSource contacts;  // of an object of radius 15 mm whose mesh frame is its centre
  double gap = 0.005;      // below the start, along -z, to the first touch [m]
};

/// Half space, V-grooves of 60, 90 and 120 degrees, a peg of 10 mm in a hole of 0.1 mm clearance.
std::vector<Place> engine_places();

/// How far the handle still moves over the last 0.25 s of three seconds, pressed in with 1 N at
/// these gains: position and rotation [m, rad], peak to peak. `turns`: held off its centre, so that
/// pressing turns it.
struct EngineRest {
  double sway = 0.0, turn = 0.0;
  double force = 0.0;        // largest sent [N]
  bool is_unstable = false;  // more than two encoder steps, or a fault
};
EngineRest press_in(const Place& place, double linear_stiffness, double angular_stiffness,
                    double delay, bool turns);

/// What the linear loop of sampled_loop.h expects: largest stiffness that settles in contact with
/// the simulated arm, translation or rotation.
double loop_boundary(bool is_angular, double delay);

/// Largest stiffness that comes to rest, by bisection to 5 %; the other half at a calm value.
double engine_boundary(const Place& place, bool is_angular, double delay, double highest);

}  // namespace thigma::experiments
