#include "thigma/response/solid_surface.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"
#include "thigma/mesh/topology.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma {
namespace {

/// Depth in a box about the origin.
double depth_in_box(const Vec3& half, const Vec3& p) {
  const Vec3 over = p.cwiseAbs() - half;
  const double inside = std::min(over.maxCoeff(), 0.0);
  return -(over.cwiseMax(0.0).norm() + inside);
}

TEST(SolidSurface, DepthInABoxIsExact) {
  const Vec3 size(0.02, 0.03, 0.05);
  const SolidSurface box = make_solid_surface(build_exact_hierarchy(make_box(size, {3, 1, 4})));
  Random random(11);
  std::int32_t guess = -1;
  for (int i = 0; i < 4000; ++i) {
    const Vec3 p = random.in_cube(0.04);
    const PointDepth found = depth_inside(box, p, guess);
    EXPECT_NEAR(found.depth, depth_in_box(0.5 * size, p), 1e-15);
    EXPECT_NEAR(found.outward.norm(), 1.0, 1e-12);
    guess = found.triangle;
    // The gradient, away from where two sides are equally near.
    constexpr double kStep = 1e-7;
    Vec3 gradient;
    for (int k = 0; k < 3; ++k)
      gradient[k] = (depth_in_box(0.5 * size, p - kStep * Vec3::Unit(k)) -
                     depth_in_box(0.5 * size, p + kStep * Vec3::Unit(k))) /
                    (2.0 * kStep);
    if (std::fabs(gradient.norm() - 1.0) > 1e-6) continue;
    EXPECT_LT((gradient - found.outward).norm(), 1e-5);
  }
}

TEST(SolidSurface, OnItsFacesEdgesAndCornersItsNormalsPointOutward) {
  const SolidSurface box = make_solid_surface(build_exact_hierarchy(make_box(Vec3::Ones())));
  EXPECT_NEAR(depth_inside(box, {0.1, 0.2, 0.5}, -1).outward.z(), 1.0, 1e-12);
  const Vec3 at_edge = depth_inside(box, {0.1, 0.5, 0.5}, -1).outward;
  EXPECT_NEAR(at_edge.y(), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(at_edge.z(), std::sqrt(0.5), 1e-12);
  // By angles: a corner's normal does not depend on how its faces are divided.
  EXPECT_NEAR(depth_inside(box, {0.5, 0.5, 0.5}, -1).outward.dot(Vec3::Ones()), std::sqrt(3.0),
              1e-12);
}

TEST(SolidSurface, TellsInsideFromOutsideWhereASurfaceIsNotConvex) {
  const TriangleMesh mesh = make_torus(0.03, 0.01, 24, 12);
  const SolidSurface torus = make_solid_surface(build_exact_hierarchy(mesh));
  const EdgeTable table = build_edge_table(mesh);
  const Components components = connect_over_edges(mesh, table);
  const InsideTest inside(mesh, components);
  Random random(12);
  int within = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 p = random.in_cube(0.04);
    const auto around = inside.components_around(p);
    if (!around) continue;
    within += !around->empty();
    EXPECT_EQ(depth_inside(torus, p, -1).depth > 0.0, !around->empty()) << p.transpose();
  }
  EXPECT_GT(within, 200);
}

TEST(SolidSurface, BesideTheBorderOfASheetNothingIsInside) {
  TriangleMesh mesh = make_sheet(0.1, 0.1, 4, 4);
  SolidSurface sheet = make_solid_surface(build_exact_hierarchy(mesh));
  const double up = sheet.vertex[static_cast<std::size_t>(12)].z() > 0.0 ? 1.0 : -1.0;
  EXPECT_NEAR(depth_inside(sheet, {0.01, 0.02, -up * 1e-3}, -1).depth, 1e-3, 1e-15);
  EXPECT_LT(depth_inside(sheet, {0.06, 0.02, -up * 1e-3}, -1).depth, 0.0);
}

/// A sheet of two triangles with ridges along y of this height, a texture of n x n texels.
HapticTexture ridged(double side, double height, int n) {
  TextureSource source;
  source.coarse = make_sheet(side, side, 1, 1);
  for (const auto& t : source.coarse.triangles) {
    std::array<Vec2, 3> uv;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = source.coarse.positions[static_cast<std::size_t>(t[k])];
      uv[k] = Vec2((p.x() / side + 0.5) * (n - 1), (p.y() / side + 0.5) * (n - 1));
    }
    source.corners.push_back(uv);
  }
  source.width = source.height = n;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      Texel texel;
      texel.z = static_cast<float>(i % 2 == 0 ? height : -height);
      source.texels.push_back(texel);
    }
  }
  return make_texture(std::move(source), "ridges");
}

TEST(SolidSurface, OfATextureIsItsFineSurface) {
  constexpr double kSide = 0.02, kHeight = 2e-4;
  constexpr int kTexels = 21;
  const SolidSurface fine = make_solid_surface(ridged(kSide, kHeight, kTexels));
  EXPECT_GE(fine.mesh.triangles.size(), 2u * 20u * 20u);
  const double up = fine.vertex[fine.vertex.size() / 2].z() > 0.0 ? 1.0 : -1.0;
  const double pitch = kSide / (kTexels - 1);
  // Above a summit and a valley; the flanks lean by 2 height a pitch.
  for (int i = 1; i < kTexels - 1; ++i) {
    const double x = -0.5 * kSide + i * pitch, h = i % 2 == 0 ? kHeight : -kHeight;
    const Vec3 p(x, 1e-3, h + up * 1e-4);
    const double lean = 1e-4 * pitch / std::hypot(pitch, 2.0 * kHeight);
    const bool is_summit = h * up > 0.0;
    EXPECT_NEAR(depth_inside(fine, p, -1).depth, is_summit ? -1e-4 : -lean, 2e-9) << i;
    const Vec3 below(x, 1e-3, h - up * 1e-4);
    EXPECT_NEAR(depth_inside(fine, below, -1).depth, is_summit ? lean : 1e-4, 2e-9) << i;
  }
  // Nothing gapes along the diagonal that the two triangles share, and the rim is one.
  Random random(31);
  for (int i = 0; i < 500; ++i) {
    const double x = random.uniform(-0.009, 0.009);
    EXPECT_GT(depth_inside(fine, {x, x, -up * 1e-3}, -1).depth, 0.0);
    EXPECT_GT(depth_inside(fine, {x, -x, -up * 1e-3}, -1).depth, 0.0);
  }
  EXPECT_LT(depth_inside(fine, {0.012, 0.0, -up * 1e-3}, -1).depth, 0.0);
}

}  // namespace
}  // namespace thigma
