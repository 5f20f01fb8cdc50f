#pragma once
// A ball whose surface waves: reflex and convex everywhere, no symmetry.

#include "thigma/mesh/shapes.h"

namespace thigma::test {

/// waves  their height over the radius, about
inline TriangleMesh wavy_ball_of(int frequency, double radius, double waves) {
  TriangleMesh mesh = make_ball(radius, frequency);
  for (Vec3& p : mesh.positions) {
    const double x = p.x() / radius, y = p.y() / radius, z = p.z() / radius;
    p *= 1.0 + waves * (5.0 * x * y * z + 3.0 * (x * x - y * y) * (z + 0.3));
  }
  return mesh;
}

}  // namespace thigma::test
