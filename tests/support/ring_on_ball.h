#pragma once
// A ring that comes down round a ball, both with levels of detail.

#include "support/query_path.h"

#include "thigma/clod/build_clod.h"
#include "thigma/mesh/shapes.h"

namespace thigma::test {

struct RingOnBall {
  ClodHierarchy object = build_clod(make_torus(1.0, 0.4, 48, 20));
  ClodHierarchy scene = build_clod(make_ball(1.3, 14));
};

/// They meet at 0.9; the ring turns a little.
inline Pose ring_at(double s) {
  Pose pose;
  pose.position = Vec3(0.02 * sine(5.0 * s), 0.0, 1.45 - 0.12 * s);
  pose.orientation = turn(Vec3::UnitX(), 4.0 * sine(3.0 * s));
  return pose;
}

}  // namespace thigma::test
