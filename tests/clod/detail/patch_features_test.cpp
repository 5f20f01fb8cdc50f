#include "thigma/clod/detail/patch_features.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "thigma/convex/decomposition.h"
#include "thigma/mesh/shapes.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma::detail {
namespace {

/// Normal of the other triangle at an edge of the mesh, by looking at all; zero where there is none
/// or the edge is reflex.
Vec3 beyond_by_loop(const TriangleMesh& mesh, const std::vector<std::int32_t>& patch,
                    std::int32_t tail, std::int32_t head, const Vec3& normal, double flat) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const auto has = [&](std::int32_t vertex) {
      return std::find(v.begin(), v.end(), vertex) != v.end();
    };
    if (!has(tail) || !has(head) ||
        std::find(patch.begin(), patch.end(), static_cast<std::int32_t>(t)) != patch.end())
      continue;
    const Vec3 &p = mesh.positions[v[0]], &q = mesh.positions[v[1]], &r = mesh.positions[v[2]];
    for (const Vec3& corner : {p, q, r})
      if (normal.dot(corner - mesh.positions[tail]) > flat) return Vec3::Zero();
    return (q - p).cross(r - p).normalized();
  }
  return Vec3::Zero();
}

struct Borders {
  int convex = 0, none = 0;
};

Borders expect_borders(const TriangleMesh& mesh) {
  const SurfaceTopology surface = compute_topology(mesh);
  const ConvexDecomposition parts = decompose_surface(mesh);
  const double flat = 1e-9;
  Borders seen;
  for (std::size_t i = 0; i < parts.patches.size(); ++i) {
    const PatchFeatures features =
        find_features({mesh, surface, parts.patches[i], parts.vertices[i]}, flat);
    for (const RealEdge& e : features.edges) {
      if (e.face_right >= 0) {
        EXPECT_EQ(e.beyond, Vec3(Vec3::Zero()));  // the patch goes on
        continue;
      }
      const Vec3 want =
          beyond_by_loop(mesh, parts.patches[i], parts.vertices[i][e.tail],
                         parts.vertices[i][e.head], features.faces[e.face_left].normal, flat);
      EXPECT_LE((e.beyond - want).norm(), 1e-12) << "patch " << i;
      ++(want.isZero(0.0) ? seen.none : seen.convex);
    }
  }
  return seen;
}

TEST(PatchFeatures, border_edges_know_the_face_beyond) {
  const Borders box = expect_borders(make_box(Vec3(1.4, 1.0, 0.8), {13, 13, 13}));
  EXPECT_GT(box.convex, 100);
  EXPECT_EQ(box.none, 0);
  EXPECT_GT(expect_borders(make_ball(1.0, 6)).convex, 100);
  // Reflex where the legs meet; nothing at all where a sheet ends.
  const double xs[] = {0.0, 0.5, 1.0}, ys[] = {0.0, 1.0};
  const Borders step =
      expect_borders(make_blocks(xs, ys, xs, [](int i, int, int k) { return i == 0 || k == 0; }));
  EXPECT_GT(step.none, 0);
  const Borders sheet = expect_borders(make_sheet(1.0, 1.0, 1, 1));
  EXPECT_EQ(sheet.convex, 0);
  EXPECT_EQ(sheet.none, 4);
}

}  // namespace
}  // namespace thigma::detail
