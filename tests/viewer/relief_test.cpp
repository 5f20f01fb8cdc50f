#include "viewer/server/relief.h"

#include <cstring>

#include <gtest/gtest.h>

#include "thigma/texture/texel_lookup.h"

namespace thigma::live {
namespace {

/// A square of two triangles over 9 x 9 texels that rise by `height` in a cosine.
HapticTexture wavy_square(double height) {
  TextureSource source;
  source.coarse.positions = {{0, 0, 0}, {0.08, 0, 0}, {0.08, 0.08, 0}, {0, 0.08, 0}};
  source.coarse.triangles = {{0, 1, 2}, {0, 2, 3}};
  source.corners = {{Vec2(0, 0), Vec2(8, 0), Vec2(8, 8)}, {Vec2(0, 0), Vec2(8, 8), Vec2(0, 8)}};
  source.width = source.height = 9;
  for (int j = 0; j < 9; ++j) {
    for (int i = 0; i < 9; ++i) {
      const bool is_up = (i + j) % 2 == 0;
      source.texels.push_back({0.0f, 0.0f, static_cast<float>(is_up ? height : 0.0), 0.0f});
    }
  }
  return make_texture(std::move(source), "square");
}

double area_of(const TriangleMesh& mesh) {
  double area = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](int k) {
      return mesh.positions[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
    };
    area += 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).z();  // all face up
  }
  return area;
}

TEST(Relief, EveryPointLiesOnTheFineSurface) {
  const HapticTexture texture = wavy_square(0.001);
  const ReliefSurface relief = make_relief_surface(texture, 100000);
  EXPECT_EQ(relief.divisions, 12);  // the diagonal of 11.3 texels
  ASSERT_EQ(relief.mesh.triangles.size(), 2u * 144u);
  double highest = 0.0;
  for (const Vec3& p : relief.mesh.positions) {
    const Vec2 where(100.0 * p.x(), 100.0 * p.y());
    EXPECT_NEAR(p.z(), displacement_at(texture, where).z(), 1e-9);
    highest = std::max(highest, p.z());
  }
  EXPECT_NEAR(highest, 0.001, 1e-9);
}

TEST(Relief, TheDividedTrianglesCoverTheCoarseOnesAndFaceTheSameWay) {
  const ReliefSurface relief = make_relief_surface(wavy_square(0.0005), 1000);
  EXPECT_NEAR(area_of(relief.mesh), 0.08 * 0.08, 1e-12);
  for (const auto& t : relief.mesh.triangles)
    for (const std::int32_t corner : t)
      EXPECT_LT(static_cast<std::size_t>(corner), relief.mesh.positions.size());
}

TEST(Relief, IsDividedNoFurtherThanAllowed) {
  const HapticTexture texture = wavy_square(0.001);
  for (const std::size_t most : {0u, 2u, 7u, 8u, 50u}) {
    const ReliefSurface relief = make_relief_surface(texture, most);
    EXPECT_LE(relief.mesh.triangles.size(), std::max<std::size_t>(most, 2));
    EXPECT_EQ(relief.mesh.triangles.size(),
              2u * static_cast<std::size_t>(relief.divisions * relief.divisions));
  }
}

}  // namespace
}  // namespace thigma::live
