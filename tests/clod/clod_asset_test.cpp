#include "thigma/clod/clod_asset.h"

#include <algorithm>
#include <cmath>

#include "clod/asset_samples.h"
#include <gtest/gtest.h>

#include "thigma/clod/clod_file.h"

namespace thigma {
namespace {

using test::sample_asset;

TriangleMesh scaled_mesh(double factor) {
  TriangleMesh mesh = test::sample_mesh();
  for (Vec3& p : mesh.positions) p *= factor;
  return mesh;
}

/// Largest difference of two numbers relative to their unit; infinities are equal.
struct Worst {
  double value = 0.0;
  void compare(double a, double b, double unit) {
    if (a != b) value = std::max(value, std::fabs(a - b) / unit);
  }
  void compare(const Vec3& a, const Vec3& b, double unit) { compare((a - b).norm(), 0.0, unit); }
};

double difference(const ClodHierarchy& a, const ClodHierarchy& b) {
  const double size = a.radius;
  Worst worst;
  worst.compare(a.radius, b.radius, size);
  worst.compare(a.center, b.center, size);
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    worst.compare(a.nodes[i].radius, b.nodes[i].radius, size);
    worst.compare(a.nodes[i].hausdorff, b.nodes[i].hausdorff, size);
    worst.compare(a.nodes[i].center, b.nodes[i].center, size);
  }
  for (std::size_t i = 0; i < a.level_patches.size(); ++i) {
    const LevelPatch &c = a.level_patches[i], &d = b.level_patches[i];
    worst.compare(c.deviation, d.deviation, size);
    worst.compare(c.hausdorff, d.hausdorff, size);
    worst.compare(c.from_below, d.from_below, size);
    worst.compare(c.to_below, d.to_below, size);
    worst.compare(c.patch.thickness, d.patch.thickness, size);
  }
  for (std::size_t i = 0; i < a.vertices.size(); ++i)
    worst.compare(a.vertices[i], b.vertices[i], size);
  for (std::size_t i = 0; i < a.support.size(); ++i)
    for (const std::size_t reading : {0, 1})
      worst.compare(a.support[i][reading], b.support[i][reading], size * size);
  for (std::size_t i = 0; i < a.faces.size(); ++i) {
    worst.compare(a.faces[i].normal, b.faces[i].normal, 1.0);
    worst.compare(a.faces[i].offset, b.faces[i].offset, size);
  }
  for (std::size_t i = 0; i < a.lanes.size(); ++i)
    worst.compare(a.lanes[i], b.lanes[i], 1e7 * size);
  for (std::size_t k = 0; k < a.levels.size(); ++k) {
    worst.compare(a.levels[k].resolution, b.levels[k].resolution, 1.0 / size);
    worst.compare(a.levels[k].hausdorff_max, b.levels[k].hausdorff_max, size);
    worst.compare(a.levels[k].deviation_max, b.levels[k].deviation_max, size);
    worst.compare(a.levels[k].contact_hausdorff_max, b.levels[k].contact_hausdorff_max, size);
  }
  return worst.value;
}

// Where scaling does not round, every decision of the build is the same one, and so is every bit.
TEST(ClodAsset, ScalingByAPowerOfTwoIsBuildingTheScaledMesh) {
  for (const double factor : {0x1p-10, 4.0}) {
    ClodAsset built = build_clod_asset(scaled_mesh(factor), test::generous());
    ClodAsset scaled = sample_asset();
    scale_asset(scaled, factor);
    EXPECT_EQ(scaled.origin.unit_scale, factor);
    built.origin.unit_scale = factor;
    EXPECT_EQ(format_clod(built), format_clod(scaled)) << factor;
  }
}

// Where it rounds, ties may fall the other way; patches do not depend on them here.
TEST(ClodAsset, ScalingIsBuildingTheScaledMeshToRounding) {
  const double factor = 0.37;
  const ClodHierarchy built = build_exact_hierarchy(scaled_mesh(factor));
  ClodHierarchy scaled = build_exact_hierarchy(test::sample_mesh());
  scale_hierarchy(scaled, factor);
  EXPECT_EQ(find_flaw(scaled), "");
  ASSERT_EQ(built.patches.size(), scaled.patches.size());
  Worst worst;
  for (std::size_t i = 0; i < built.patches.size(); ++i) {
    const HullView a = hull_view(built, built.patches[i].node);
    const HullView b = hull_view(scaled, scaled.patches[i].node);
    ASSERT_EQ(a.vertex_count, b.vertex_count);
    ASSERT_EQ(a.face_count, b.face_count);
    worst.compare(a.radius, b.radius, built.radius);
    worst.compare(a.center, b.center, built.radius);
    worst.compare(a.thickness, b.thickness, built.radius);
    for (int k = 0; k < a.vertex_count; ++k)
      worst.compare(a.vertices[k], b.vertices[k], built.radius);
    for (int k = 0; k < a.face_count; ++k)
      worst.compare(a.faces[k].offset, b.faces[k].offset, built.radius);
    for (int k = 0; k < 3 * a.lane_count; ++k)
      worst.compare(a.lanes[k], b.lanes[k], 1e6 * built.radius);
  }
  EXPECT_LT(worst.value, 1e-12);
}

TEST(ClodAsset, ScalesThereAndBack) {
  ClodAsset asset = sample_asset();
  scale_asset(asset, 0.37);
  EXPECT_EQ(find_flaw(asset.hierarchy), "");
  EXPECT_GT(difference(asset.hierarchy, sample_asset().hierarchy), 0.1);
  scale_asset(asset, 1.0 / 0.37);
  EXPECT_LT(difference(asset.hierarchy, sample_asset().hierarchy), 1e-12);
  const MassProperties &m = asset.mass.measure, &n = sample_asset().mass.measure;
  EXPECT_NEAR(m.area, n.area, 1e-12 * n.area);
  EXPECT_NEAR(m.volume, n.volume, 1e-12 * n.volume);
  EXPECT_LT((m.inertia - n.inertia).norm(), 1e-12 * n.inertia.norm());
  EXPECT_LT((m.center_of_mass - n.center_of_mass).norm(), 1e-12);
}

TEST(ClodAsset, EveryTriangleOfEveryLevelHasItsPatch) {
  const ClodAsset& asset = sample_asset();
  const ClodHierarchy& h = asset.hierarchy;
  ASSERT_GT(asset.meshes.size(), 3u);
  for (std::size_t k = 0; k < asset.meshes.size(); ++k) {
    const auto patch = patches_of_triangles(asset, static_cast<std::int32_t>(k));
    ASSERT_EQ(patch.size(), asset.meshes[k].triangles.size());
    if (k > 0) {
      EXPECT_EQ(static_cast<std::size_t>(h.levels[k].triangle_count), patch.size());
    }
    for (std::size_t t = 0; t < patch.size(); ++t) {
      ASSERT_GE(patch[t], 0);
      // A corner of the triangle is a hull vertex of its patch.
      const Vec3& p =
          asset.meshes[k].positions[static_cast<std::size_t>(asset.meshes[k].triangles[t][0])];
      std::int32_t first = 0, count = 0;
      if (k > 0) {
        const LevelPatch& c = h.level_patches[static_cast<std::size_t>(patch[t])];
        EXPECT_EQ(static_cast<std::size_t>(c.level), k);
        first = c.first_vertex, count = c.vertex_count;
      } else {
        const auto node = h.patches[static_cast<std::size_t>(patch[t])].node;
        const ClodNode& n = h.nodes[static_cast<std::size_t>(node)];
        first = n.first_vertex, count = n.vertex_count;
      }
      const Vec3* begin = h.vertices.data() + first;
      EXPECT_NE(std::find(begin, begin + count, p), begin + count);
    }
  }
}

TEST(ClodAsset, KnowsMassAndOrigin) {
  const ClodAsset& asset = sample_asset();
  EXPECT_TRUE(asset.mass.is_closed);
  EXPECT_GT(asset.mass.measure.volume, 3.0);
  EXPECT_EQ(asset.origin.deviation_limit, 0.08);
  EXPECT_GT(asset.origin.convexity_tolerance, 0.0);
  EXPECT_FALSE(build_clod_asset(make_dome(1.0, 12, 5)).mass.is_closed);
}

}  // namespace
}  // namespace thigma
