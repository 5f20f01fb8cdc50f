#pragma once
// What a coupling would give in the scenes of E2 if its object were stopped by the ideal surfaces.

#include <functional>
#include <string>
#include <vector>

#include "experiments/common/led_session.h"
#include "experiments/e2-force-quality/scenes.h"

namespace thigma::experiments {

/// Springs of these runs.
struct ProxySprings {
  double linear = 1000.0;  // [N/m]
  double angular = 0.5;    // [N m/rad]
};

/// A scene of E2 with the hand on its path.
struct ProxyScene {
  QualityScene scene;  // its path and meshes
  /// What the object does to the hand where the hand is at a pose of the path: force, or torque
  /// where the scene is one of torques [N, N m; world].
  std::function<Vec3(const Pose&)> ideal;
};

/// a to f of E2, meshes and paths as in e2-force-quality, but the spheres of b four times as fine.
std::vector<ProxyScene> proxy_scenes(int poses, const ProxySprings& springs);

/// The peg of the widest hole, turned as far beyond the touch as E2's path turns that of the
/// narrowest: a degree for all ends 0.7 mrad after the touch in the widest.
///
/// widest  that scene with E2's path
ProxyScene farther_peg(ProxyScene widest);

/// b alone, an eighth of its circle, with balls of other divisions, both `finer` times as fine as
/// there.
ProxyScene finer_balls(int poses, double finer, const ProxySprings& springs);

/// How the felt differs from the ideal.
struct ProxyQuality {
  double magnitude = 0.0;  // rms of the differences of sizes over rms of the ideal
  double mean_angle = 0.0, largest_angle = 0.0;  // [rad]
  double largest = 0.0;                          // of the ideal [N or N m]
  double stray = 0.0;                            // largest felt where nothing should be [N or N m]
  double held_back = 0.0;                        // share of the frames
};

/// How a path is played.
struct ProxyPace {
  double seconds = 20.0;  // of the path
  int every = 1;          // haptic frames from one contact frame to the next
  double slop = 1.0;      // of the engine's stand-off
  double damping = 2.0;   // of the coupling [N s/m]
};

/// Leads the hand along the path, after a tenth of a second as fast as it will be, and compares
/// every frame but those of its first twentieth from there on.
ProxyQuality judge_proxy(const ProxyScene& scene, const ProxySprings& springs,
                         const ProxyPace& pace);

}  // namespace thigma::experiments
