#pragma once
// What a surface is, counted in the plainest way; independent of the mesh room's own report.

#include <map>
#include <set>
#include <utility>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::test {

struct SurfaceCount {
  int boundary = 0;     // edges of one triangle
  int repeated = 0;     // directed edges that two triangles share: more than two faces, or turned
                        // against each other
  int unused = 0;       // vertices of no triangle
  long long euler = 0;  // V - E + F: 2 (components) - 2 (handles) when closed
  double volume = 0.0;  // [m^3], positive when it faces outwards
};

inline SurfaceCount count_surface(const TriangleMesh& mesh) {
  SurfaceCount count;
  std::set<std::pair<std::int32_t, std::int32_t>> directed;
  std::set<std::int32_t> used;
  for (const auto& t : mesh.triangles) {
    for (int e = 0; e < 3; ++e) {
      used.insert(t[e]);
      if (!directed.insert({t[e], t[(e + 1) % 3]}).second) ++count.repeated;
    }
    count.volume +=
        mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6.0;
  }
  long long edges = 0;
  for (const auto& [a, b] : directed) {
    const bool has_twin = directed.count({b, a}) > 0;
    if (!has_twin) ++count.boundary;
    if (!has_twin || a < b) ++edges;
  }
  count.unused = static_cast<int>(mesh.positions.size() - used.size());
  count.euler = static_cast<long long>(mesh.positions.size()) - edges +
                static_cast<long long>(mesh.triangles.size());
  return count;
}

}  // namespace thigma::test
