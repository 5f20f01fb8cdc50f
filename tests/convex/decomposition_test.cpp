#include "thigma/convex/decomposition.h"

#include <algorithm>
#include <set>

#include "support/shared.h"
#include <gtest/gtest.h>

#include "thigma/convex/clip.h"
#include "thigma/convex/count_patches.h"
#include "thigma/convex/quickhull.h"
#include "thigma/core/error.h"
#include "thigma/import/read_mesh.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/shapes.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

std::array<Vec3, 3> corners(const TriangleMesh& mesh, std::size_t t) {
  const auto& v = mesh.triangles[t];
  return {mesh.positions[static_cast<std::size_t>(v[0])],
          mesh.positions[static_cast<std::size_t>(v[1])],
          mesh.positions[static_cast<std::size_t>(v[2])]};
}

/// The invariants by brute force over a mesh of one shell: no tree, no neighbours, no shortcuts.
void expect_valid(const TriangleMesh& mesh, const ConvexDecomposition& d) {
  const double radius = enclosing_ball(mesh.positions).radius;
  const double flat = d.params.convexity_tolerance * radius * (1 + 1e-9);
  std::vector<int> uses(mesh.triangles.size(), 0);
  for (std::size_t p = 0; p < d.patches.size(); ++p) {
    std::set<std::int32_t> used;
    for (const std::int32_t t : d.patches[p]) {
      ++uses[static_cast<std::size_t>(t)];
      EXPECT_EQ(d.patch_of_triangle[static_cast<std::size_t>(t)], static_cast<std::int32_t>(p));
      for (const std::int32_t v : mesh.triangles[static_cast<std::size_t>(t)]) used.insert(v);
    }
    EXPECT_TRUE(std::is_sorted(d.patches[p].begin(), d.patches[p].end()));
    EXPECT_EQ(d.vertices[p], std::vector<std::int32_t>(used.begin(), used.end()));
    EXPECT_LE(static_cast<int>(used.size()), d.params.max_vertices);
    std::vector<Vec3> points;
    for (const std::int32_t v : used) points.push_back(mesh.positions[static_cast<std::size_t>(v)]);
    for (const std::int32_t t : d.patches[p]) {
      const auto c = corners(mesh, static_cast<std::size_t>(t));
      const Vec3 normal = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
      for (const Vec3& q : points) EXPECT_LE(normal.dot(q - c[0]), flat) << "patch " << p;
    }
    Quickhull hull;
    start_hull(hull, points, 1e-10);
    if (hull.dimension < 3) continue;
    complete_hull(hull);
    std::vector<HalfSpace> half_spaces;
    list_half_spaces(hull, d.params.protrusion_tolerance * radius, half_spaces);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      if (d.patch_of_triangle[t] == static_cast<std::int32_t>(p)) continue;
      auto c = corners(mesh, t);
      for (Vec3& q : c) q = (q - hull.origin) * hull.scale;
      EXPECT_FALSE(reaches_into(c, half_spaces)) << "patch " << p << " triangle " << t;
    }
  }
  for (const int n : uses) EXPECT_EQ(n, 1);
}

void transform(TriangleMesh& mesh, double scale, const Vec3& offset) {
  for (Vec3& p : mesh.positions) p = scale * p + offset;
}

TEST(DecomposeSurface, ConvexSolidsAreOnePatch) {
  for (const TriangleMesh& mesh : {make_box({1, 2, 3}), make_tetrahedron(1.0), make_ball(1.0, 1)}) {
    const ConvexDecomposition d = decompose_surface(mesh);
    EXPECT_EQ(d.patches.size(), 1u);
    expect_valid(mesh, d);
  }
}

// Hulls of 32 vertices at most cut a wheel of 400; it is convex all the same.
TEST(CountConvexPatches, ConvexShapesHaveOneHoweverManyVertices) {
  const TriangleMesh wheel = make_cylinder(1.0, 0.5, 80, 4, 2);
  EXPECT_GT(decompose_surface(wheel).patches.size(), 10u);
  EXPECT_EQ(count_convex_patches(wheel), 1);
  EXPECT_EQ(count_convex_patches(make_ball(1.0, 4)), 1);
  EXPECT_GE(count_convex_patches(make_l_shape(1.0, 0.3)), 2);
  const TriangleMesh torus = make_torus(1.0, 0.3, 24, 16);
  EXPECT_GE(count_convex_patches(torus), 24);
  EXPECT_LE(count_convex_patches(torus),
            static_cast<std::int32_t>(decompose_surface(torus).patches.size()));
}

TEST(DecomposeSurface, HoldsItsInvariantsOnShapes) {
  const TriangleMesh shapes[] = {make_box({1, 2, 3}, {4, 4, 4}), make_ball(1.0, 6),
                                 make_l_shape(1.0, 0.3),         make_torus(1.0, 0.3, 24, 16),
                                 make_dome(1.0, 16, 6),          make_sheet(1, 1, 8, 8),
                                 make_cylinder(0.5, 2, 24, 3, 2)};
  for (const TriangleMesh& mesh : shapes) {
    const ConvexDecomposition d = decompose_surface(mesh);
    expect_valid(mesh, d);
    EXPECT_LT(d.patches.size(), mesh.triangles.size() / 2);
  }
}

TEST(DecomposeSurface, SolidsWithAReflexEdgeAreNotOnePatch) {
  EXPECT_GE(decompose_surface(make_l_shape(1.0, 0.3)).patches.size(), 2u);
  EXPECT_GE(decompose_surface(make_torus(1.0, 0.3, 24, 16)).patches.size(), 24u);
}

// A bowl thinner than its patches are deep: every patch of the outer side is convex and its hull
// would come out through the inner side.
TEST(DecomposeSurface, HullsDoNotComeOutThroughThinWalls) {
  std::vector<Vec2> profile;
  for (int i = 0; i <= 12; ++i) {
    const double angle = -0.5 * kPi + 0.5 * kPi * i / 12;
    profile.emplace_back(i == 0 ? 0.0 : cosine(angle), sine(angle));
  }
  for (int i = 12; i >= 0; --i) {
    const double angle = -0.5 * kPi + 0.5 * kPi * i / 12;
    profile.emplace_back(i == 0 ? 0.0 : 0.995 * cosine(angle), 0.995 * sine(angle));
  }
  const TriangleMesh bowl = make_revolution(profile, 24);
  const ConvexDecomposition d = decompose_surface(bowl);
  EXPECT_GT(d.cut_by_protrusion, 10);
  expect_valid(bowl, d);
  ConvexDecomposition careless = decompose_surface(bowl, {.protrusion_tolerance = 10.0});
  EXPECT_EQ(careless.cut_by_protrusion, 0);
  EXPECT_LT(careless.patches.size(), d.patches.size());
}

TEST(DecomposeSurface, DoesNotDependOnScaleAndHardlyOnOffset) {
  const TriangleMesh torus = make_torus(1.0, 0.3, 24, 16);
  const ConvexDecomposition expected = decompose_surface(torus);
  for (const double scale : {0x1p-30, 0x1p30}) {
    TriangleMesh other = torus;
    transform(other, scale, Vec3::Zero());
    EXPECT_EQ(decompose_surface(other).patch_of_triangle, expected.patch_of_triangle);
  }
  TriangleMesh far_away = torus;
  transform(far_away, 1.0, Vec3(1e7, 1e7, -1e7));
  expect_valid(far_away, decompose_surface(far_away, {.convexity_tolerance = 1e-7,
                                                      .protrusion_tolerance = 1e-6}));
}

TEST(DecomposeSurface, SinglePrecisionFacesDoNotShatter) {
  TriangleMesh mesh = make_box({1, 1, 1}, {12, 12, 12});
  const Eigen::Matrix3d turn =
      Eigen::Quaterniond(0.8, 0.3, -0.4, 0.33).normalized().toRotationMatrix();
  for (Vec3& p : mesh.positions) p = (turn * p).cast<float>().cast<double>() * 0.00024;
  const DecompositionParams chosen = resolve_tolerances(mesh, compute_topology(mesh), {});
  EXPECT_GT(chosen.convexity_tolerance, 5e-8);
  const ConvexDecomposition d = decompose_surface(mesh);
  EXPECT_LT(d.patches.size(), mesh.triangles.size() / 12);
  EXPECT_GT(decompose_surface(mesh, {.convexity_tolerance = 1e-12}).patches.size(),
            3 * d.patches.size());
}

TEST(DecomposeSurface, LeavesZeroAreaTrianglesOut) {
  TriangleMesh mesh = make_box({1, 1, 1});
  mesh.positions.emplace_back(0.5 * (mesh.positions[0] + mesh.positions[1]));
  const auto middle = static_cast<std::int32_t>(mesh.positions.size()) - 1;
  mesh.triangles.push_back({0, middle, 1});
  const ConvexDecomposition d = decompose_surface(mesh);
  EXPECT_EQ(d.patch_of_triangle.back(), -1);
  TriangleMesh flat;
  flat.positions = {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}};
  flat.triangles = {{0, 1, 2}};
  EXPECT_THROW(decompose_surface(flat), InputError);
}

TEST(DecomposeSurface, ReportsPatchesCutWhereTheSurfaceCrossesItself) {
  EXPECT_EQ(decompose_surface(make_torus(1.0, 0.3, 24, 16)).cut_by_self_intersection, 0);
  // A ring thicker than its hole passes through itself about the axis.
  EXPECT_GT(decompose_surface(make_torus(1.0, 1.6, 24, 16)).cut_by_self_intersection, 0);
}

TEST(DecomposeSurface, KeepsToItsNumberOfVertices) {
  const TriangleMesh ball = make_ball(1.0, 6);
  for (const int limit : {3, 8, 32}) {
    const ConvexDecomposition d = decompose_surface(ball, {.max_vertices = limit});
    for (const auto& v : d.vertices) EXPECT_LE(static_cast<int>(v.size()), limit);
    EXPECT_GT(d.cut_by_size, 0);
  }
}

TEST(DecomposeSurface, RealMeshesHaveTheExpectedTrianglesAPatch) {
  THIGMA_NEEDS_SHARED(folder);
  for (const char* name :
       {"a01_dental_cast_upper", "a03_femur_right", "a07_bolt_m16_loose", "a16_mountain_open"}) {
    const TriangleMesh mesh =
        read_mesh((folder / "meshes" / (std::string(name) + ".obj")).string()).mesh;
    const ConvexDecomposition d = decompose_surface(mesh);
    const double ratio =
        static_cast<double>(mesh.triangles.size()) / static_cast<double>(d.patches.size());
    EXPECT_GT(ratio, 2.1) << name;
    EXPECT_LT(ratio, 7.0) << name;
    EXPECT_GT(d.cut_by_protrusion, 50) << name;
  }
}

}  // namespace
}  // namespace thigma
