#include "benchmarks/baselines/nearest_point.h"

#include <algorithm>
#include <utility>

#include "thigma/math/elementary.h"

namespace thigma::bench {
namespace {

const Vec3& corner_of(const TriangleMesh& mesh, std::int32_t triangle, std::size_t corner) {
  const auto& t = mesh.triangles[static_cast<std::size_t>(triangle)];
  return mesh.positions[static_cast<std::size_t>(t[corner])];
}

NearestPoint on_edge(const Vec3& p, const Vec3& a, const Vec3& b, std::size_t edge) {
  const Vec3 along = b - a;
  const double length2 = along.squaredNorm();
  const double t = length2 > 0.0 ? (p - a).dot(along) / length2 : 0.0;
  NearestPoint q;
  if (t <= 0.0) {
    q.point = a;
    q.part = static_cast<TrianglePart>(edge);
  } else if (t >= 1.0) {
    q.point = b;
    q.part = static_cast<TrianglePart>((edge + 1) % 3);
  } else {
    q.point = a + t * along;
    q.part = static_cast<TrianglePart>(3 + edge);
  }
  q.distance2 = (p - q.point).squaredNorm();
  return q;
}

}  // namespace

NearestPoint nearest_point(const TriangleMesh& mesh, std::int32_t triangle, const Vec3& p) {
  const Vec3& a = corner_of(mesh, triangle, 0);
  const Vec3& b = corner_of(mesh, triangle, 1);
  const Vec3& c = corner_of(mesh, triangle, 2);
  const Vec3 n = (b - a).cross(c - a);
  const double n2 = n.squaredNorm();
  // Beyond an edge where the triangle of p and that edge is turned against the face.
  const double over01 = n.dot((b - a).cross(p - a)), over12 = n.dot((c - b).cross(p - b)),
               over20 = n.dot((a - c).cross(p - c));
  if (n2 > 0.0 && over01 >= 0.0 && over12 >= 0.0 && over20 >= 0.0) {
    const double height = (p - a).dot(n);
    return {p - (height / n2) * n, height * height / n2, TrianglePart::inside};
  }
  NearestPoint best;
  bool has = false;
  auto offer = [&](double over, const Vec3& from, const Vec3& to, std::size_t edge) {
    if (over >= 0.0 && n2 > 0.0) return;
    const NearestPoint q = on_edge(p, from, to, edge);
    if (!has || q.distance2 < best.distance2) best = q;
    has = true;
  };
  offer(over01, a, b, 0);
  offer(over12, b, c, 1);
  offer(over20, c, a, 2);
  return best;
}

SurfaceNormals surface_normals(const TriangleMesh& mesh) {
  SurfaceNormals normals;
  const std::size_t count = mesh.triangles.size();
  normals.face.resize(count);
  normals.edge.resize(count);
  normals.vertex.assign(mesh.positions.size(), Vec3::Zero());
  struct Side {
    std::int32_t low, high, triangle, edge;
  };
  std::vector<Side> sides;
  for (std::size_t t = 0; t < count; ++t) {
    const auto triangle = static_cast<std::int32_t>(t);
    const Vec3 n = (corner_of(mesh, triangle, 1) - corner_of(mesh, triangle, 0))
                       .cross(corner_of(mesh, triangle, 2) - corner_of(mesh, triangle, 0));
    const double length = n.norm();
    normals.face[t] = length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t v = mesh.triangles[t][i], w = mesh.triangles[t][(i + 1) % 3];
      const Vec3 u1 = corner_of(mesh, triangle, (i + 1) % 3) - corner_of(mesh, triangle, i);
      const Vec3 u2 = corner_of(mesh, triangle, (i + 2) % 3) - corner_of(mesh, triangle, i);
      normals.vertex[static_cast<std::size_t>(v)] +=
          arc_tangent2(u1.cross(u2).norm(), u1.dot(u2)) * normals.face[t];
      sides.push_back({std::min(v, w), std::max(v, w), triangle, static_cast<std::int32_t>(i)});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.triangle, x.edge) <
           std::tie(y.low, y.high, y.triangle, y.edge);
  });
  for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
    Vec3 sum = Vec3::Zero();
    for (last = first; last < sides.size() && sides[last].low == sides[first].low &&
                       sides[last].high == sides[first].high;
         ++last) {
      sum += normals.face[static_cast<std::size_t>(sides[last].triangle)];
    }
    for (std::size_t i = first; i < last; ++i) {
      normals.edge[static_cast<std::size_t>(sides[i].triangle)]
                  [static_cast<std::size_t>(sides[i].edge)] = sum;
    }
  }
  return normals;
}

bool is_outside(const SurfaceNormals& normals, const TriangleMesh& mesh, std::int32_t triangle,
                const NearestPoint& q, const Vec3& p) {
  const auto t = static_cast<std::size_t>(triangle);
  const auto part = static_cast<std::size_t>(q.part);
  const Vec3& n =
      q.part == TrianglePart::inside
          ? normals.face[t]
          : (part >= 3 ? normals.edge[t][part - 3]
                       : normals.vertex[static_cast<std::size_t>(mesh.triangles[t][part])]);
  return (p - q.point).dot(n) >= 0.0;
}

}  // namespace thigma::bench
