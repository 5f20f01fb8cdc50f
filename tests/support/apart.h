#pragma once
// Two surfaces brought near each other without touching, by distances of triangles alone.

#include "support/triangle_search.h"

#include "thigma/math/pose.h"

namespace thigma::test {

/// The pose moved along a direction until the surfaces are `gap` apart to 1 %; `far` is apart.
inline Pose brought_near(const TriangleMesh& object, Pose far, const Vec3& towards,
                         const TriangleTree& scene, double gap) {
  for (int turn = 0; turn < 200; ++turn) {
    const double distance = least_triangle_distance(build_triangle_tree(object, far), scene);
    if (distance <= 1.01 * gap) break;
    far.position += (distance - gap) * towards;  // never through: distances shrink by no more
  }
  return far;
}

inline bool meet(const TriangleMesh& object, const Pose& pose, const TriangleTree& scene) {
  return least_triangle_distance(build_triangle_tree(object, pose), scene) <= 0.0;
}

}  // namespace thigma::test
