#include "thigma/clod/detail/patch_features.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

struct LocalPatch {
  std::vector<Vec3> points;                         // by local vertex
  std::vector<std::array<std::uint8_t, 3>> corner;  // of each triangle
  std::vector<Vec3> cross;                          // twice the area times the normal
  // across corner i -> corner i + 1, -1 outside the patch
  std::vector<std::array<int, 3>> neighbor;
  std::vector<int> face;  // of each triangle
};

LocalPatch localize(const PatchOfMesh& of) {
  const std::span<const std::int32_t> vertices = of.vertices;
  LocalPatch patch;
  for (const std::int32_t v : vertices)
    patch.points.push_back(of.mesh.positions[static_cast<std::size_t>(v)]);
  for (const std::int32_t t : of.triangles) {
    std::array<std::uint8_t, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int32_t v = of.mesh.triangles[static_cast<std::size_t>(t)][k];
      corner[k] = static_cast<std::uint8_t>(std::lower_bound(vertices.begin(), vertices.end(), v) -
                                            vertices.begin());
    }
    const Vec3 &a = patch.points[corner[0]], &b = patch.points[corner[1]],
               &c = patch.points[corner[2]];
    patch.corner.push_back(corner);
    patch.cross.push_back((b - a).cross(c - a));
  }
  const std::size_t n = patch.corner.size();
  patch.neighbor.assign(n, {-1, -1, -1});
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < 3 && i != j; ++k)
        for (std::size_t l = 0; l < 3; ++l)
          if (patch.corner[i][k] == patch.corner[j][(l + 1) % 3] &&
              patch.corner[i][(k + 1) % 3] == patch.corner[j][l])
            patch.neighbor[i][k] = static_cast<int>(j);
  patch.face.assign(n, -1);
  return patch;
}

/// Unit normal of a triangle. That of a sliver is mostly rounding, and its own ends may lie over
/// the plane: then turned to be normal to its longest edge, so that they do not.
Vec3 seed_normal(const LocalPatch& patch, std::size_t t, double flat) {
  const auto corner = [&](std::size_t k) -> const Vec3& {
    return patch.points[patch.corner[t][k % 3]];
  };
  Vec3 normal = patch.cross[t].normalized(), longest = Vec3::Zero();
  bool is_off = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3 edge = corner(k + 1) - corner(k);
    is_off = is_off || std::fabs(normal.dot(edge)) > 0.5 * flat;
    if (edge.squaredNorm() > longest.squaredNorm()) longest = edge;
  }
  if (!is_off) return normal;
  const Vec3 along = longest.normalized();
  normal -= normal.dot(along) * along;
  if (!(normal.squaredNorm() > 0.01)) normal = along.unitOrthogonal();
  normal.normalize();
  return (normal - normal.dot(along) * along).normalized();
}

/// Gives the triangle's face to every triangle that can be reached in its plane.
void flood_face(LocalPatch& patch, std::size_t seed, int face, double flat) {
  const Vec3 normal = seed_normal(patch, seed, flat);
  const Vec3 on_plane = patch.points[patch.corner[seed][0]];
  std::vector<std::size_t> reached(1, seed);
  patch.face[seed] = face;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (const int other : patch.neighbor[reached[i]]) {
      if (other < 0 || patch.face[static_cast<std::size_t>(other)] >= 0) continue;
      const auto o = static_cast<std::size_t>(other);
      bool in_plane = patch.cross[o].dot(normal) > 0.0;  // a fold's other side is another face
      for (const std::uint8_t v : patch.corner[o])
        in_plane = in_plane && std::fabs(normal.dot(patch.points[v] - on_plane)) <= flat;
      if (!in_plane) continue;
      patch.face[o] = face;
      reached.push_back(o);
    }
}

/// Heights of the face's vertices along a normal, least and largest.
std::array<double, 2> height_range(const LocalPatch& patch, std::uint32_t vertices,
                                   const Vec3& normal) {
  std::array<double, 2> range{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  for (std::size_t v = 0; v < patch.points.size(); ++v) {
    if (!(vertices >> v & 1u)) continue;
    const double height = normal.dot(patch.points[v]);
    range = {std::min(range[0], height), std::max(range[1], height)};
  }
  return range;
}

/// The plane of the triangles that were given the face.
RealFace describe_face(const LocalPatch& patch, std::size_t seed, int index, double flat) {
  RealFace face;
  Vec3 sum = Vec3::Zero();
  for (std::size_t t = 0; t < patch.corner.size(); ++t) {
    if (patch.face[t] != index) continue;
    sum += patch.cross[t];
    for (const std::uint8_t v : patch.corner[t]) face.vertices |= 1u << v;
  }
  face.normal = sum.normalized();
  std::array<double, 2> range = height_range(patch, face.vertices, face.normal);
  // The mean of a face long and hardly wider than the tolerance may tilt by any angle. All of it is
  // within the tolerance of the plane it was gathered in.
  if (!(range[1] - range[0] <= 2.0 * flat)) {
    face.normal = seed_normal(patch, seed, flat);
    range = height_range(patch, face.vertices, face.normal);
  }
  face.offset = range[1];
  return face;
}

void find_faces(LocalPatch& patch, double flat, std::vector<RealFace>& faces) {
  // From the largest triangle down, so that slivers take the plane of what they lie in.
  std::vector<std::size_t> order(patch.corner.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return patch.cross[a].squaredNorm() > patch.cross[b].squaredNorm();
  });
  for (const std::size_t seed : order) {
    if (patch.face[seed] >= 0) continue;
    const auto index = static_cast<int>(faces.size());
    flood_face(patch, seed, index, flat);
    faces.push_back(describe_face(patch, seed, index, flat));
  }
}

/// Whether an edge where the patch ends is also where the hull's facet ends: nothing in the plane
/// lies beyond it.
bool ends_facet(const LocalPatch& patch, const RealFace& face, const Vec3& tail, const Vec3& head,
                double flat) {
  const Vec3 inward = face.normal.cross(head - tail).normalized();
  for (const Vec3& p : patch.points)
    if (face.normal.dot(p - tail) >= -flat && inward.dot(p - tail) < -flat) return false;
  return true;
}

/// Unit normal of the triangle across side k of a triangle of the patch; zero where there is none,
/// over a reflex edge, and of slivers, whose normals are mostly rounding.
Vec3 normal_beyond(const PatchOfMesh& patch, std::int32_t triangle, std::size_t k,
                   const Vec3& normal, double flat) {
  const TriangleMesh& mesh = patch.mesh;
  const std::int32_t other = patch.topology.neighbor[idx(triangle)][k];
  if (other < 0 || !(patch.topology.height[idx(other)] > flat)) return Vec3::Zero();
  const Vec3& tail = mesh.positions[idx(mesh.triangles[idx(triangle)][k])];
  for (const std::int32_t v : mesh.triangles[idx(other)])
    if (normal.dot(mesh.positions[idx(v)] - tail) > flat) return Vec3::Zero();
  return patch.topology.normal[idx(other)];
}

void find_edges(const PatchOfMesh& of, const LocalPatch& patch, double flat,
                PatchFeatures& features) {
  const std::vector<RealFace>& faces = features.faces;
  for (std::size_t t = 0; t < patch.corner.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int other = patch.neighbor[t][k];
      RealEdge edge;
      edge.tail = patch.corner[t][k];
      edge.head = patch.corner[t][(k + 1) % 3];
      edge.face_left = static_cast<std::int16_t>(patch.face[t]);
      if (other >= 0) {
        const auto o = static_cast<std::size_t>(other);
        if (o < t || patch.face[o] == patch.face[t]) continue;
        edge.face_right = static_cast<std::int16_t>(patch.face[o]);
      } else if (!ends_facet(patch, faces[static_cast<std::size_t>(patch.face[t])],
                             patch.points[edge.tail], patch.points[edge.head], flat)) {
        continue;
      } else {
        edge.beyond = normal_beyond(of, of.triangles[t], k, faces[idx(patch.face[t])].normal, flat);
      }
      features.edges.push_back(edge);
    }
}

}  // namespace

PatchFeatures find_features(const PatchOfMesh& of, double flat) {
  LocalPatch patch = localize(of);
  PatchFeatures features;
  find_faces(patch, flat, features.faces);
  find_edges(of, patch, flat, features);
  for (const auto& c : patch.corner)
    features.triangles.push_back({{c[0], c[1], c[2]}, 1u << c[0] | 1u << c[1] | 1u << c[2]});
  features.thickness = std::numeric_limits<double>::infinity();
  for (const RealFace& face : features.faces) {
    double width = 0.0;
    for (const Vec3& p : patch.points) width = std::max(width, face.offset - face.normal.dot(p));
    features.thickness = std::min(features.thickness, width);
  }
  return features;
}

}  // namespace thigma::detail
