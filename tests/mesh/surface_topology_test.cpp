#include "thigma/mesh/surface_topology.h"

#include <gtest/gtest.h>

#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

/// The triangle that uses the edge the other way round, by looking at all of them.
std::int32_t neighbor_of(const TriangleMesh& mesh, std::size_t t, std::size_t corner) {
  const auto from = mesh.triangles[t][corner], to = mesh.triangles[t][(corner + 1) % 3];
  for (std::size_t other = 0; other < mesh.triangles.size(); ++other) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (mesh.triangles[other][c] == to && mesh.triangles[other][(c + 1) % 3] == from)
        return static_cast<std::int32_t>(other);
    }
  }
  return -1;
}

TEST(SurfaceTopology, FindsTheNeighborAcrossEveryEdge) {
  TriangleMesh mesh = make_ball(1.0, 3);
  mesh.triangles.erase(mesh.triangles.begin() + 5);  // a boundary
  const SurfaceTopology surface = compute_topology(mesh);
  ASSERT_EQ(surface.neighbor.size(), mesh.triangles.size());
  int boundary = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      EXPECT_EQ(surface.neighbor[t][corner], neighbor_of(mesh, t, corner));
      boundary += surface.neighbor[t][corner] < 0;
    }
    EXPECT_NEAR(surface.normal[t].norm(), 1.0, 1e-12);
    EXPECT_EQ(surface.shell[t], surface.shell[0]);
  }
  EXPECT_EQ(boundary, 3);
}

TEST(SurfaceTopology, SeparatesShellsAndMarksTrianglesWithoutArea) {
  TriangleMesh mesh = make_ball(1.0, 1);
  const std::size_t first = mesh.triangles.size(), vertices = mesh.positions.size();
  const TriangleMesh other = make_ball(1.0, 1);
  for (const Vec3& p : other.positions) mesh.positions.push_back(p + Vec3(3.0, 0.0, 0.0));
  for (auto triangle : other.triangles) {
    for (auto& v : triangle) v += static_cast<std::int32_t>(vertices);
    mesh.triangles.push_back(triangle);
  }
  mesh.triangles.push_back({0, 0, 1});
  const SurfaceTopology surface = compute_topology(mesh);
  EXPECT_NE(surface.shell[0], surface.shell[first]);
  EXPECT_EQ(surface.normal.back(), Vec3(0.0, 0.0, 0.0));
}

}  // namespace
}  // namespace thigma
