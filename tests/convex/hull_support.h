#pragma once
// Hulls and patches for the pair tests, with everything a view points to.

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <vector>

#include "thigma/convex/gjk.h"
#include "thigma/convex/hull_view.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma::test {

/// A hull of points (all of them kept as vertices), without surface.
struct PointHull {
  struct alignas(32) Lanes {
    float values[3 * kMaxHullVertices] = {};
  };
  std::vector<Vec3> points;
  Lanes lanes;
  Vec3 center = Vec3::Zero();
  double radius = 0.0;

  explicit PointHull(std::vector<Vec3> p) : points(std::move(p)) {
    for (const Vec3& q : points) center += q / static_cast<double>(points.size());
    for (const Vec3& q : points) radius = std::max(radius, (q - center).norm());
    const int n = lane_count(), last = static_cast<int>(points.size()) - 1;
    for (int k = 0; k < n; ++k) {
      for (int c = 0; c < 3; ++c) {
        lanes.values[c * n + k] =
            static_cast<float>(points[static_cast<std::size_t>(std::min(k, last))][c] - center[c]);
      }
    }
  }
  int lane_count() const { return (static_cast<int>(points.size()) + 7) / 8 * 8; }
  HullView view() const {
    HullView v;
    v.vertices = points.data();
    v.vertex_count = static_cast<int>(points.size());
    v.lanes = lanes.values;
    v.lane_count = lane_count();
    v.center = center;
    v.radius = radius;
    return v;
  }
};

/// n points of a kind: 0 a ball, 1 flat, 2 on a line, 3 a thousand-to-one sliver, 4 all on a
/// shallow cap.
inline PointHull random_hull(int kind, int n, const Vec3& center, double scale, Random& random) {
  const Mat3 attitude = random.orientation().toRotationMatrix();
  std::vector<Vec3> points;
  for (int i = 0; i < n; ++i) {
    Vec3 p = random.direction();
    if (kind == 1) p.z() = 0.0;
    if (kind == 2) p.y() = p.z() = 0.0;
    if (kind == 3) p = Vec3(p.x(), 1e-3 * p.y(), 1e-3 * p.z());
    if (kind == 4) p.z() = -0.2 * (p.x() * p.x() + p.y() * p.y());
    points.push_back(scale * (attitude * p + center));
  }
  return PointHull(std::move(points));
}

inline RelativePose random_pose(double reach, Random& random) {
  return {random.orientation().toRotationMatrix(), random.in_cube(reach)};
}

/// A patch of a triangle mesh as the hierarchy would store it.
struct MeshPatch {
  std::vector<Vec3> points;
  std::vector<RealFace> faces;
  std::vector<RealEdge> edges;
  std::vector<HullTriangle> triangles;
  Vec3 center = Vec3::Zero();
  double radius = 0.0, thickness = 0.0;

  HullView view() const {
    HullView v;
    v.vertices = points.data();
    v.vertex_count = static_cast<int>(points.size());
    v.center = center;
    v.radius = radius;
    v.faces = faces.data();
    v.face_count = static_cast<int>(faces.size());
    v.edges = edges.data();
    v.edge_count = static_cast<int>(edges.size());
    v.triangles = triangles.data();
    v.triangle_count = static_cast<int>(triangles.size());
    v.thickness = thickness;
    return v;
  }
};

using Triangles = std::vector<std::array<std::int32_t, 3>>;

/// Patch of the listed triangles; the caller knows that they are one convex patch. Every triangle
/// is a face.
inline MeshPatch make_patch(const std::vector<Vec3>& positions, const Triangles& mesh,
                            const std::vector<int>& members) {
  MeshPatch patch;
  std::map<std::int32_t, int> index;
  std::map<std::pair<int, int>, int> half_edges;
  for (int t : members) {
    HullTriangle triangle;
    RealFace face;
    Vec3 p[3];
    for (int k = 0; k < 3; ++k) {
      const std::int32_t v = mesh[static_cast<std::size_t>(t)][static_cast<std::size_t>(k)];
      p[k] = positions[static_cast<std::size_t>(v)];
      const auto [it, is_new] = index.try_emplace(v, static_cast<int>(index.size()));
      if (is_new) patch.points.push_back(p[k]);
      triangle.corner[k] = static_cast<std::uint8_t>(it->second);
      triangle.mask |= 1u << it->second;
    }
    for (int k = 0; k < 3; ++k)
      half_edges[{triangle.corner[k], triangle.corner[(k + 1) % 3]}] =
          static_cast<int>(patch.faces.size());
    face.normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    face.offset = face.normal.dot(p[0]);
    face.vertices = triangle.mask;
    patch.faces.push_back(face);
    patch.triangles.push_back(triangle);
  }
  for (const auto& [ends, face] : half_edges) {
    const auto twin = half_edges.find({ends.second, ends.first});
    if (twin != half_edges.end() && ends.first > ends.second) continue;
    RealEdge edge;
    edge.tail = static_cast<std::uint8_t>(ends.first);
    edge.head = static_cast<std::uint8_t>(ends.second);
    edge.face_left = static_cast<std::int16_t>(face);
    if (twin != half_edges.end()) edge.face_right = static_cast<std::int16_t>(twin->second);
    patch.edges.push_back(edge);
  }
  for (const Vec3& q : patch.points) patch.center += q / static_cast<double>(patch.points.size());
  for (const Vec3& q : patch.points)
    patch.radius = std::max(patch.radius, (q - patch.center).norm());
  patch.thickness = std::numeric_limits<double>::infinity();
  for (const RealFace& f : patch.faces) {
    for (const Vec3& q : patch.points)
      patch.radius = std::max(patch.radius, (q - patch.center).norm());
    double low = f.offset;
    for (const Vec3& q : patch.points) low = std::min(low, f.normal.dot(q));
    patch.thickness = std::min(patch.thickness, f.offset - low);
  }
  return patch;
}

/// The triangles of a unit ball whose centres lie higher than `from` along z: one patch, open
/// below; all of it for -2.
inline MeshPatch ball_cap(int frequency, double from) {
  const TriangleMesh ball = make_ball(1.0, frequency);
  std::vector<int> members;
  for (std::size_t t = 0; t < ball.triangles.size(); ++t) {
    double height = 0.0;
    for (const std::int32_t v : ball.triangles[t])
      height += ball.positions[static_cast<std::size_t>(v)].z() / 3.0;
    if (height > from) members.push_back(static_cast<int>(t));
  }
  return make_patch(ball.positions, ball.triangles, members);
}

}  // namespace thigma::test
