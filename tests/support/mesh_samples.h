#pragma once
// Short ways to place a sample mesh.

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::test {

inline TriangleMesh moved(TriangleMesh mesh, const Vec3& by, double scale = 1.0) {
  for (Vec3& p : mesh.positions) p = scale * p + by;
  return mesh;
}

inline TriangleMesh stretched(TriangleMesh mesh, const Vec3& by) {
  for (Vec3& p : mesh.positions) p = p.cwiseProduct(by);
  return mesh;
}

}  // namespace thigma::test
