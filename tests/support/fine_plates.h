#pragma once
// Fine surfaces whose places are known without the engine: plates with relief on top and convex
// shapes, and how deep one is inside the other by its points alone.

#include <algorithm>
#include <cmath>
#include <vector>

#include "thigma/math/pose.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::test {

/// The top of a plate: heights over a square grid about the middle, between them bilinear.
struct FinePlate {
  double side = 0.0, top = 0.0;  // [m]
  int count = 0;                 // points each way
  std::vector<double> heights;   // over `top`, row by row

  double place(int i) const { return side * (static_cast<double>(i) / (count - 1) - 0.5); }
  double at(int i, int j) const { return heights[static_cast<std::size_t>(j * count + i)]; }
  /// Height of the surface, far below beside the plate.
  double height(double x, double y) const {
    const double u = (x / side + 0.5) * (count - 1), v = (y / side + 0.5) * (count - 1);
    if (!(u >= 0.0 && v >= 0.0 && u <= count - 1 && v <= count - 1)) return -1.0;
    const int i = std::min(static_cast<int>(u), count - 2),
              j = std::min(static_cast<int>(v), count - 2);
    const double s = u - i, t = v - j;
    return top + (1.0 - t) * ((1.0 - s) * at(i, j) + s * at(i + 1, j)) +
           t * ((1.0 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
  }
  Vec3 point(int i, int j) const { return {place(i), place(j), top + at(i, j)}; }
};

template <class Height>
FinePlate fine_plate(double side, double thickness, int count, const Height& height) {
  FinePlate plate{side, 0.5 * thickness, count, {}};
  for (int j = 0; j < count; ++j)
    for (int i = 0; i < count; ++i)
      plate.heights.push_back(
          static_cast<double>(static_cast<float>(height(plate.place(i), plate.place(j)))));
  return plate;
}

/// Deepest of some points below the top of a plate, along its own z; negative: all above it [m].
inline double depth_of_points(const std::vector<Vec3>& points, const Pose& plate_from_points,
                              const FinePlate& plate) {
  double deepest = -1.0;
  for (const Vec3& p : points) {
    const Vec3 q = transform_point(plate_from_points, p);
    deepest = std::max(deepest, plate.height(q.x(), q.y()) - q.z());
  }
  return deepest;
}

/// Deepest point of a plate's top inside a convex mesh.
inline double depth_in_convex(const FinePlate& plate, const Pose& mesh_from_plate,
                              const TriangleMesh& mesh) {
  struct Face {
    Vec3 normal;
    double offset;
  };
  std::vector<Face> faces;
  double reach = 0.0;
  for (const Vec3& p : mesh.positions) reach = std::max(reach, p.norm());
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto at = [&](std::int32_t i) { return mesh.positions[static_cast<std::size_t>(i)]; };
    const Vec3 n = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
    faces.push_back({n, n.dot(at(a))});
  }
  double deepest = -1.0;
  for (int j = 0; j < plate.count; ++j) {
    for (int i = 0; i < plate.count; ++i) {
      const Vec3 p = transform_point(mesh_from_plate, plate.point(i, j));
      if (p.norm() > reach) continue;
      double inside = 1.0;
      for (const Face& face : faces) {
        inside = std::min(inside, face.offset - face.normal.dot(p));
        if (inside < deepest) break;
      }
      deepest = std::max(deepest, inside);
    }
  }
  return deepest;
}

}  // namespace thigma::test
