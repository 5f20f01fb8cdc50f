#include "thigma/depth/triangle_ring.h"

#include <algorithm>

#include "thigma/core/index.h"

namespace thigma {

VertexTriangles vertex_triangles(const TriangleMesh& mesh) {
  VertexTriangles made;
  made.first.assign(mesh.positions.size() + 1, 0);
  for (const auto& corners : mesh.triangles)
    for (const std::int32_t v : corners) ++made.first[idx(v) + 1];
  for (std::size_t v = 1; v < made.first.size(); ++v) made.first[v] += made.first[v - 1];
  made.triangles.resize(3 * mesh.triangles.size());
  std::vector<std::int32_t> next(made.first.begin(), made.first.end() - 1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const std::int32_t v : mesh.triangles[t])
      made.triangles[idx(next[idx(v)]++)] = static_cast<std::int32_t>(t);
  return made;
}

void TriangleMarks::begin() noexcept {
  if (++round != 0) return;
  std::fill(of.begin(), of.end(), 0u);  // after 2^32 of them: no mark may look new
  round = 1;
}

bool TriangleMarks::add(std::int32_t triangle) noexcept {
  if (of[idx(triangle)] == round) return false;
  of[idx(triangle)] = round;
  return true;
}

void add_ring(const TriangleMesh& mesh, const VertexTriangles& at_vertex,
              std::span<const std::int32_t> triangles, TriangleMarks& marks,
              std::vector<std::int32_t>& ring) noexcept {
  if (at_vertex.first.empty()) return;
  for (const std::int32_t t : triangles)
    for (const std::int32_t v : mesh.triangles[idx(t)])
      for (std::int32_t i = at_vertex.first[idx(v)]; i < at_vertex.first[idx(v) + 1]; ++i)
        if (marks.add(at_vertex.triangles[idx(i)])) ring.push_back(at_vertex.triangles[idx(i)]);
}

}  // namespace thigma
