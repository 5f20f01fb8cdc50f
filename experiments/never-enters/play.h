#pragma once
// One run of a pressed pair, looked at from outside.

#include "experiments/common/outside_depth.h"
#include "experiments/never-enters/scenes.h"

namespace thigma::experiments::never_enters {

/// How one scene is played.
struct Play {
  bool is_constrained;
  int every;
  int look;                // frames from one look of the outside to the next
  double threshold = 0.0;  // s0 of levels far away; 0: exact
  int latency = 1;         // haptic frames until a model is used
};

struct Ran {
  LedRun run;
  double ever = 0.0, at_rest = 0.0;  // [m]
  double force = 0.0;                // at the end [N]
  double buzz = 0.0;                 // of the force above 50 Hz at rest, rms [N]
  double drift = 0.0;                // of the object at rest [m/s]
};

/// A pair with its surfaces as the outside sees them.
struct Seen {
  LedPair pair;
  DepthSurface object, scene;
};

Ran play(const Seen& seen, const PressedScene& scene, const Play& how);

/// Force above 50 Hz of a cube at rest with contacts at 30 Hz, if models of rows faded by their age
/// as those of springs do, from this age on, rms [N].
double buzz_of_age(double full_age);

}  // namespace thigma::experiments::never_enters
