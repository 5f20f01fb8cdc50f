#include "thigma/clod/support_area.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/core/parallel.h"

namespace thigma {
namespace {

/// What every vertex looks at.
struct Faces {
  const TriangleMesh& mesh;
  const SurfaceTopology& topology;
  const SupportParams& params;
  std::vector<double> area = {};                       // of each face [m^2]
  std::vector<std::vector<std::int32_t>> around = {};  // each vertex
  std::vector<Vec3> normal = {};                       // of each vertex, of any length
};

/// One vertex after the other.
struct Flood {
  const Faces& all;
  std::vector<std::int32_t> seen_by;     // last vertex that looked at the face
  std::vector<std::int32_t> faces = {};  // reached
};

bool is_in_cone(const Flood& flood, std::int32_t face, const Vec3& normal) {
  return flood.all.topology.normal[idx(face)].dot(normal) >= flood.all.params.cone_cosine;
}

/// Share of a triangle with these heights that is not above a height, if its lowest corner is not.
double share_below(std::array<double, 3> height, double limit) {
  std::sort(height.begin(), height.end());
  const auto [low, middle, high] = height;
  if (high <= limit) return 1.0;
  if (low >= limit) return 0.0;
  // The part cut off at one corner is similar in both of its sides.
  if (limit <= middle) return (limit - low) / (middle - low) * ((limit - low) / (high - low));
  return 1.0 - (high - limit) / (high - middle) * ((high - limit) / (high - low));
}

/// Share of a face within the tolerance of the tangent plane.
double share_within(const Flood& flood, std::int32_t face, const Vec3& at_vertex,
                    const Vec3& normal) {
  std::array<double, 3> height, depth;
  for (std::size_t k = 0; k < 3; ++k) {
    height[k] = normal.dot(flood.all.mesh.positions[idx(flood.all.mesh.triangles[idx(face)][k])] -
                           at_vertex);
    depth[k] = -height[k];
  }
  return share_below(height, flood.all.params.tolerance) +
         share_below(depth, flood.all.params.tolerance) - 1.0;
}

bool counts(const Flood& flood, std::int32_t face, const Vec3& at_vertex, const Vec3& normal) {
  if (!is_in_cone(flood, face, normal)) return false;
  for (const std::int32_t v : flood.all.mesh.triangles[idx(face)])
    if (std::fabs(normal.dot(flood.all.mesh.positions[idx(v)] - at_vertex)) >
        flood.all.params.tolerance)
      return false;
  return true;
}

Faces list_faces(const TriangleMesh& mesh, const SurfaceTopology& topology,
                 const SupportParams& params) {
  Faces faces{mesh, topology, params};
  faces.around.resize(mesh.positions.size());
  faces.normal.assign(mesh.positions.size(), Vec3::Zero());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const Vec3& a = mesh.positions[idx(v[0])];
    const Vec3 cross = (mesh.positions[idx(v[1])] - a).cross(mesh.positions[idx(v[2])] - a);
    faces.area.push_back(0.5 * cross.norm());
    for (const std::int32_t corner : v) {
      faces.around[idx(corner)].push_back(static_cast<std::int32_t>(t));
      faces.normal[idx(corner)] += cross;
    }
  }
  return faces;
}

std::array<double, 2> areas_at(Flood& flood, std::size_t v) {
  const Faces& all = flood.all;
  if (!(all.normal[v].norm() > 0.0)) return {0.0, 0.0};
  const Vec3 n = all.normal[v].normalized();
  const auto id = static_cast<std::int32_t>(v);
  const auto projected = [&](std::int32_t face) {
    return all.area[idx(face)] * all.topology.normal[idx(face)].dot(n);
  };
  flood.faces.clear();
  const auto offer = [&](std::int32_t face) {
    if (flood.seen_by[idx(face)] == id) return;
    flood.seen_by[idx(face)] = id;
    if (counts(flood, face, all.mesh.positions[v], n)) flood.faces.push_back(face);
  };
  double in_part = 0.0;
  for (const std::int32_t face : all.around[v]) {
    const std::size_t whole = flood.faces.size();
    offer(face);
    if (flood.faces.size() == whole && is_in_cone(flood, face, n))
      in_part += share_within(flood, face, all.mesh.positions[v], n) * projected(face);
  }
  std::array<double, 2> areas = {in_part, in_part};
  for (const std::int32_t face : flood.faces) areas[0] += projected(face);
  for (std::size_t i = 0; i < flood.faces.size(); ++i) {
    areas[1] += projected(flood.faces[i]);
    if (static_cast<int>(flood.faces.size()) >= all.params.most_faces) continue;
    const auto& beside = all.topology.neighbor[idx(flood.faces[i])];
    for (const std::int32_t face : beside)
      if (face >= 0) offer(face);
  }
  return areas;
}

}  // namespace

std::vector<std::array<double, 2>> support_areas(const TriangleMesh& mesh,
                                                 const SurfaceTopology& topology,
                                                 const SupportParams& params, int threads) {
  const Faces faces = list_faces(mesh, topology, params);
  std::vector<std::array<double, 2>> areas(mesh.positions.size());
  for_each_range(areas.size(), threads, [&](std::size_t begin, std::size_t end) {
    Flood flood{faces, std::vector<std::int32_t>(mesh.triangles.size(), -1)};
    for (std::size_t v = begin; v < end; ++v) areas[v] = areas_at(flood, v);
  });
  return areas;
}

}  // namespace thigma
