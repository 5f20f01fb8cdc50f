#include "thigma/constraint/surface_features.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

SurfaceFeatures features_of(const TriangleMesh& mesh) {
  return find_features(build_exact_hierarchy(mesh));
}

std::ptrdiff_t corners(const SurfaceFeatures& features) {
  return std::count(features.is_corner.begin(), features.is_corner.end(), 1);
}

TEST(SurfaceFeatures, ABoxHasEightCornersAndTwelveEdgesHoweverItIsDivided) {
  for (const int n : {1, 2, 5, 8}) {
    const SurfaceFeatures box = features_of(make_box({0.02, 0.03, 0.04}, {n, n, n}));
    EXPECT_EQ(corners(box), 8) << n;
    EXPECT_EQ(box.edges.size(), 12u) << n;
  }
}

TEST(SurfaceFeatures, SizeDoesNotMatter) {
  for (const double scale : {1e-9, 1e-3, 1e3}) {
    const SurfaceFeatures ring = features_of(make_torus(scale, 0.3 * scale, 24, 12));
    const SurfaceFeatures one = features_of(make_torus(1.0, 0.3, 24, 12));
    EXPECT_EQ(corners(ring), corners(one)) << scale;
    EXPECT_EQ(ring.edges.size(), one.edges.size()) << scale;
  }
}

TEST(SurfaceFeatures, AScrewOnAMachineIsSeen) {
  // A box of 0.6 mm, its facets 0.3 mm, on one surface with a plate of 600 m.
  TriangleMesh both = make_box({600.0, 600.0, 1.0});
  const TriangleMesh screw = make_box({6e-4, 6e-4, 6e-4}, {2, 2, 2});
  const auto first = static_cast<std::int32_t>(both.positions.size());
  for (const Vec3& p : screw.positions) both.positions.push_back(p + Vec3(0.0, 0.0, 0.6));
  for (const auto& t : screw.triangles)
    both.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  const SurfaceFeatures features = features_of(both);
  EXPECT_EQ(features.triangles.size(), both.triangles.size());
  EXPECT_EQ(corners(features), 16);
  EXPECT_EQ(features.edges.size(), 24u);
}

TEST(SurfaceFeatures, InsideOfARingNothingIsACorner) {
  const SurfaceFeatures ring = features_of(make_torus(0.02, 0.005, 24, 12));
  for (std::size_t v = 0; v < ring.vertices.size(); ++v) {
    const Vec3& p = ring.vertices[v];
    const double from_axis = std::hypot(p.x(), p.y());
    if (from_axis > 0.018 && from_axis < 0.022) continue;
    EXPECT_EQ(ring.is_corner[v] != 0, from_axis > 0.022) << from_axis;
  }
}

TEST(SurfaceFeatures, AnOpenSheetEndsInEdges) {
  const SurfaceFeatures sheet = features_of(make_sheet(0.1, 0.1, 4, 4));
  EXPECT_EQ(corners(sheet), 4);
  EXPECT_EQ(sheet.edges.size(), 4u);
}

TEST(SurfaceFeatures, TrianglesKnowTheOnesBeyondTheirBorders) {
  for (const bool is_closed : {true, false}) {
    const SurfaceFeatures f = features_of(is_closed ? make_box({0.02, 0.03, 0.04}, {3, 2, 4})
                                                    : make_sheet(0.1, 0.1, 4, 4));
    int ends = 0;
    for (std::size_t t = 0; t < f.triangles.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t beyond = f.triangles[t].across[k];
        ends += beyond < 0;
        if (beyond < 0) continue;
        const SurfaceTriangle& other = f.triangles[static_cast<std::size_t>(beyond)];
        const std::int32_t tail = f.triangles[t].vertex[k],
                           head = f.triangles[t].vertex[(k + 1) % 3];
        bool has_it = false;
        for (std::size_t i = 0; i < 3; ++i)
          has_it |= other.vertex[i] == head && other.vertex[(i + 1) % 3] == tail &&
                    other.across[i] == static_cast<std::int32_t>(t);
        EXPECT_TRUE(has_it) << t << " across " << k;
      }
    }
    EXPECT_EQ(ends, is_closed ? 0 : 16);
  }
}

TEST(SurfaceFeatures, EveryPatchListsItsOwn) {
  const ClodHierarchy h = build_exact_hierarchy(make_l_shape(0.02, 0.01));
  const SurfaceFeatures f = find_features(h);
  ASSERT_EQ(f.first_triangle.size(), h.patches.size() + 1);
  EXPECT_EQ(f.patch_triangles.size(), f.triangles.size());
  std::vector<int> edge_seen(f.edges.size(), 0), vertex_seen(f.vertices.size(), 0);
  for (std::size_t p = 0; p < h.patches.size(); ++p) {
    const auto patch = static_cast<std::int32_t>(p);
    for (const std::int32_t e : part_of(f.patch_edges, f.first_edge, patch))
      ++edge_seen[static_cast<std::size_t>(e)];
    for (const std::int32_t v : part_of(f.patch_vertices, f.first_vertex, patch))
      ++vertex_seen[static_cast<std::size_t>(v)];
  }
  EXPECT_EQ(std::count(edge_seen.begin(), edge_seen.end(), 0), 0);
  EXPECT_EQ(std::count(vertex_seen.begin(), vertex_seen.end(), 0), 0);
}

TEST(SurfaceFeatures, ATriangleThatRoundingFoldedOverHidesNoEdge) {
  // A vertex in the middle of a box's edge, off it by a billionth to the wrong side: the triangle
  // between it and the edge faces inwards.
  for (const double off : {-1e-9, 0.0, 1e-9}) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},      {0, 0, 1},
                      {1, 0, 1}, {1, 1, 1}, {0, 1, 1}, {0.5, off, 1.0}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 8}, {0, 8, 4},
                      {4, 8, 5}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    const SurfaceFeatures features = find_features(build_exact_hierarchy(mesh));
    const Vec3 middle(0.3, 0.0, 1.0);  // of half of the edge
    const bool is_there =
        std::any_of(features.edges.begin(), features.edges.end(), [&](const ConvexEdge& edge) {
          const Vec3& tail = features.vertices[static_cast<std::size_t>(edge.tail)];
          const Vec3& head = features.vertices[static_cast<std::size_t>(edge.head)];
          const Vec3 along = (head - tail).normalized();
          const double at = (middle - tail).dot(along);
          return at > 0.0 && at < (head - tail).norm() &&
                 (middle - tail - at * along).norm() < 1e-6;
        });
    EXPECT_TRUE(is_there) << off;
  }
}

}  // namespace
}  // namespace thigma
