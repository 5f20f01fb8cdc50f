#include "thigma/mesh/shapes.h"

#include "support/closed_surface.h"
#include <gtest/gtest.h>

#include "thigma/math/elementary.h"

namespace thigma {
namespace {

struct ClosedCase {
  const char* name;
  TriangleMesh mesh;
  std::size_t triangles;
  long long euler;
  double volume;    // of the smooth shape [m^3]
  double may_lose;  // share of the volume the facets may cut off
};

std::vector<ClosedCase> closed_cases() {
  const double cone = kPi * 0.01 * 0.3 / 3.0;
  return {
      {"tetrahedron", make_tetrahedron(0.1), 4, 2, 0.001 / (6.0 * std::sqrt(2.0)), 1e-12},
      {"box", make_box({1, 2, 3}, {2, 3, 4}), 2 * 2 * (6 + 12 + 8), 2, 6.0, 1e-12},
      {"ball", make_ball(0.5, 10), 2000, 2, kPi / 6.0, 0.02},
      {"ellipsoid", make_ellipsoid({0.1, 0.2, 0.3}, 10), 2000, 2, kPi * 0.008, 0.02},
      {"polar", make_polar_ellipsoid({0.1, 0.2, 0.3}, 40, 20), 2 * 40 * 19, 2, kPi * 0.008, 0.02},
      {"cylinder", make_cylinder(0.1, 0.3, 64, 5, 3), 64 * (10 + 10), 2, kPi * 0.003, 0.003},
      {"cone", make_cone(0.1, 0.3, 64, 4, 3), 64 * (5 + 7), 2, cone, 0.003},
      {"capsule", make_capsule(0.1, 0.3, 64, 5), 64 * 2 * (15 + 5 + 15) + 64 * 2, 2,
       kPi * (0.003 + 0.004 / 3.0), 0.01},
      {"torus", make_torus(0.3, 0.1, 64, 32), 2 * 64 * 32, 0, 2.0 * kPi * kPi * 0.003, 0.02},
      {"l shape", make_l_shape(0.3, 0.1), 28, 2, 0.1 * (0.09 - 0.04), 1e-12},
      {"hollow ball", make_hollow_ball(0.5, 0.25, 16), 2 * 20 * 256, 4, kPi / 6.0 * 0.875, 0.01},
  };
}

TEST(Shapes, ClosedOnesAreWatertightOutwardAndOfTheirVolume) {
  for (const ClosedCase& c : closed_cases()) {
    SCOPED_TRACE(c.name);
    const test::SurfaceCount count = test::count_surface(c.mesh);
    EXPECT_EQ(c.mesh.triangles.size(), c.triangles);
    EXPECT_EQ(count.boundary, 0);
    EXPECT_EQ(count.repeated, 0);
    EXPECT_EQ(count.unused, 0);
    EXPECT_EQ(count.euler, c.euler);
    EXPECT_LE(count.volume, c.volume * (1.0 + 1e-12));
    EXPECT_GE(count.volume, c.volume * (1.0 - c.may_lose));
  }
}

TEST(Shapes, BallAndEllipsoidAreConvex) {
  const TriangleMesh mesh = make_ellipsoid({0.02, 0.03, 0.05}, 10);
  for (const auto& t : mesh.triangles) {
    const Vec3& p = mesh.positions[t[0]];
    const Vec3 n = (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p).normalized();
    for (const Vec3& q : mesh.positions) ASSERT_LE(n.dot(q - p), 1e-12 * 0.05);
  }
}

TEST(Shapes, SizesAreThoseAskedFor) {
  for (const Vec3& p : make_ball(0.25, 7).positions) EXPECT_NEAR(p.norm(), 0.25, 1e-15);
  Vec3 low = Vec3::Constant(1e9), high = -low;
  for (const Vec3& p : make_box({1, 2, 3}, {3, 2, 1}).positions) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  EXPECT_EQ(low, Vec3(-0.5, -1.0, -1.5));
  EXPECT_EQ(high, Vec3(0.5, 1.0, 1.5));
}

TEST(Shapes, OpenOnesHaveTheirBoundary) {
  const test::SurfaceCount sheet = test::count_surface(make_sheet(0.2, 0.1, 6, 4));
  EXPECT_EQ(sheet.boundary, 2 * (6 + 4));
  EXPECT_EQ(sheet.repeated, 0);
  EXPECT_EQ(sheet.euler, 1);
  const test::SurfaceCount dome = test::count_surface(make_dome(0.1, 32, 8));
  EXPECT_EQ(dome.boundary, 32);
  EXPECT_EQ(dome.repeated, 0);
  EXPECT_EQ(dome.euler, 1);
  for (const auto& t : make_sheet(0.2, 0.1, 6, 4).triangles) {
    const TriangleMesh m = make_sheet(0.2, 0.1, 6, 4);
    EXPECT_GT(
        (m.positions[t[1]] - m.positions[t[0]]).cross(m.positions[t[2]] - m.positions[t[0]]).z(),
        0.0);
  }
}

TEST(Shapes, MoebiusBandHasNoConsistentOrientation) {
  // One seam where the directed edges clash, and a single boundary loop of 2 around edges.
  const TriangleMesh band = make_moebius(0.1, 0.04, 24, 3);
  EXPECT_EQ(band.triangles.size(), 2u * 24u * 3u);
  const test::SurfaceCount count = test::count_surface(band);
  EXPECT_EQ(count.repeated, 3);
  EXPECT_EQ(count.unused, 0);
}

TEST(Shapes, BlocksMakeHolesAndCavities) {
  const std::array<double, 4> planes = {0.0, 1.0, 2.0, 3.0};
  const std::array<double, 2> slab = {0.0, 1.0};
  const TriangleMesh ring =
      make_blocks(planes, planes, slab, [](int i, int j, int) { return i != 1 || j != 1; });
  EXPECT_EQ(test::count_surface(ring).euler, 0);
  EXPECT_NEAR(test::count_surface(ring).volume, 8.0, 1e-12);
  const TriangleMesh shell = make_blocks(
      planes, planes, planes, [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; });
  EXPECT_EQ(test::count_surface(shell).euler, 4);
  EXPECT_NEAR(test::count_surface(shell).volume, 26.0, 1e-12);
}

TEST(Shapes, JoinTransformFlipUnweld) {
  const TriangleMesh ball = make_ball(1.0, 3);
  Pose pose;
  pose.position = {5, 0, 0};
  pose.orientation = Quat(Eigen::AngleAxisd(0.7, Vec3::UnitZ()));
  const TriangleMesh two = joined(ball, transformed(ball, pose, 2.0));
  const double volume = test::count_surface(ball).volume;
  EXPECT_NEAR(test::count_surface(two).volume, 9.0 * volume, 1e-12 * volume * 100);
  EXPECT_EQ(test::count_surface(two).euler, 4);
  EXPECT_NEAR(test::count_surface(flipped(ball)).volume, -volume, 1e-15);
  EXPECT_EQ(unwelded(ball).positions.size(), 3 * ball.triangles.size());
  EXPECT_EQ(test::count_surface(unwelded(ball)).boundary,
            static_cast<int>(3 * ball.triangles.size()));
}

}  // namespace
}  // namespace thigma
