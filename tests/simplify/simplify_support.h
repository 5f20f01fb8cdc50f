#pragma once
// Surfaces for the tests of simplification.

#include <cmath>

#include "thigma/convex/decomposition.h"
#include "thigma/mesh/shapes.h"
#include "thigma/simplify/simplify_surface.h"

namespace thigma::test {

/// A ball whose surface waves: reflex and convex everywhere, no symmetry.
inline TriangleMesh wavy_ball(int frequency, double radius = 1.0) {
  TriangleMesh mesh = make_ball(1.0, frequency);
  for (Vec3& p : mesh.positions) {
    const double x = p.x(), y = p.y(), z = p.z();
    const double wave = 5.0 * x * y * z + 3.0 * (x * x - y * y) * (z + 0.3) + 2.0 * y * z * z;
    p *= radius * (1.0 + 0.15 * wave);
  }
  return mesh;
}

/// Limits under which meshes of a few hundred triangles have levels.
inline SimplifyParams generous() {
  SimplifyParams params;
  params.longest_edge = 0.5;
  params.deviation_limit = 0.08;
  return params;
}

inline Simplification simplify(const TriangleMesh& mesh,
                               const SimplifyParams& params = generous()) {
  return simplify_surface(mesh, decompose_surface(mesh), params);
}

}  // namespace thigma::test
