#include "thigma/depth/detail/fine_sheets.h"

#include <algorithm>

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

#include "thigma/depth/depth_gradient.h"
#include "thigma/math/plane_cross.h"

namespace thigma {
namespace {

/// Height of the outermost front of a plate over a point of its own plane, every facet cut into
/// small triangles; the texels of plates of one cell lie square on it.
double slow_sheet(const HapticTexture& texture, const Vec2& at) {
  constexpr int kParts = 6;
  const double side = texture.coarse.positions.back().x() - texture.coarse.positions.front().x();
  const double texel = side / (texture.width - 1.0);
  const auto point = [&](double column, double row) -> Vec3 {
    return Vec3(texel * column - 0.5 * side, texel * row - 0.5 * side, 0.0) +
           test::lookup(texture, Vec2(column, row));
  };
  double best = kNoSurface;
  const auto meet = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
    if (!(cross(Vec2((b - a).head<2>()), Vec2((c - a).head<2>())) > 0.0)) return;
    const Vec3 w = test::barycentric(a.head<2>(), b.head<2>(), c.head<2>(), at);
    if (w.minCoeff() >= -1e-9) best = std::max(best, w[0] * a.z() + w[1] * b.z() + w[2] * c.z());
  };
  for (int j = 0; j < kParts * (texture.height - 1); ++j) {
    for (int i = 0; i < kParts * (texture.width - 1); ++i) {
      const double x = i / static_cast<double>(kParts), y = j / static_cast<double>(kParts),
                   step = 1.0 / kParts;
      const Vec3 a = point(x, y), b = point(x + step, y), c = point(x, y + step),
                 d = point(x + step, y + step);
      meet(a, b, d);
      meet(a, d, c);
    }
  }
  return best;
}

/// A flat plate of one cell whose texels lie anywhere about it, so that it folds.
HapticTexture folded_plate(Random& random, double size) {
  test::PlateShape shape{.size = size, .cells = 1, .texels = 24, .bend = 0.0, .waves = 2.0};
  shape.amplitude = 0.01 * size;
  shape.noise = 1.2 * size / (shape.texels - 1.0);  // of a texel
  return make_texture(test::plate_source(random, shape), "folded");
}

// A nanometre part and a kilometre one.
TEST(FineSheets, HeightIsThatOfTheOutermostFrontWhereverItFolds) {
  for (const double size : {1e-9, 0.02, 1e3}) {
    Random random(5);
    int folds = 0, missed = 0;
    for (int n = 0; n < 4; ++n) {
      const HapticTexture texture = folded_plate(random, size);
      const std::vector<std::int32_t> all = test::all_triangles(texture);
      const ContactFrame frame = contact_frame(Vec3::Zero(), Vec3::UnitZ());
      ProjectedPatch patch;
      project_patch({&texture, all, Pose{}}, frame, Facing::along, patch);
      for (int k = 0; k < 25; ++k) {
        const Vec2 world(0.45 * size * random.uniform(-1.0, 1.0),
                         0.45 * size * random.uniform(-1.0, 1.0));
        const Vec2 at =
            (frame.world_from_contact.transpose() * Vec3(world.x(), world.y(), 0.0)).head<2>();
        const double want = slow_sheet(texture, world), got = detail::sheet_height(patch, at);
        ASSERT_EQ(want == kNoSurface, got == kNoSurface);
        if (want == kNoSurface) continue;
        // A facet that is bent is not quite its small triangles.
        EXPECT_NEAR(got, want, 2e-3 * size);
        std::int32_t near = -1;
        folds += !surface_jet(patch, at).is_height_field;
        missed += !(std::fabs(height_at(patch, at, near) - want) < 2e-3 * size);
      }
    }
    EXPECT_GT(folds, 10);
    EXPECT_GT(missed, 10) << "or the height field is as good";
  }
}

TEST(FineSheets, SeesTrianglesThatAreEdgeOn) {
  // A wall beside a floor; its texels lean over the floor.
  TextureSource source;
  source.coarse.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}};
  source.coarse.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4}};
  source.width = 5, source.height = 10;
  source.corners = {{Vec2(0, 0), Vec2(4, 0), Vec2(4, 4)},
                    {Vec2(0, 0), Vec2(4, 4), Vec2(0, 4)},
                    {Vec2(0, 5), Vec2(4, 5), Vec2(4, 9)},
                    {Vec2(0, 5), Vec2(4, 9), Vec2(0, 9)}};
  // The wall at height z goes out by 0.4 (1 - z): a slope from the floor up to its top.
  for (int j = 0; j < 10; ++j)
    for (int i = 0; i < 5; ++i)
      source.texels.push_back({j < 5 ? 0.0f : 0.4f * (1.0f - 0.25f * (j - 5)), 0.0f, 0.0f});
  const HapticTexture texture = make_texture(source, "wall");
  const std::vector<std::int32_t> all = test::all_triangles(texture);
  const ContactFrame frame = contact_frame(Vec3::Zero(), Vec3::UnitZ());
  ProjectedPatch patch;
  project_patch({&texture, all, Pose{}}, frame, Facing::along, patch);
  ASSERT_EQ(patch.hidden.size(), 2u);
  for (const double x : {0.1, 0.2, 0.35, 0.7}) {
    const Vec2 at = (frame.world_from_contact.transpose() * Vec3(x, 0.37, 0.0)).head<2>();
    EXPECT_NEAR(detail::sheet_height(patch, at), x < 0.4 ? 1.0 - x / 0.4 : 0.0, 1e-6) << x;
  }
}

// The depth of a folded plate under a flat one is the highest of its front, whichever sheet.
TEST(FineSheets, DepthOfAFoldedPlateIsThatOfItsHighestFront) {
  Random random(8);
  const double size = 0.02;
  test::PlateShape flat{.size = size, .cells = 1, .texels = 2, .amplitude = 0.0, .bend = 0.0};
  flat.is_reversed = true;
  const HapticTexture over = make_texture(test::plate_source(random, flat), "flat");
  const auto grid = make_grid_depth({}), branch = make_branch_depth({});
  int of_sheets = 0;
  for (int n = 0; n < 30; ++n) {
    const HapticTexture texture = folded_plate(random, size);
    const std::vector<std::int32_t> all = test::all_triangles(texture),
                                    both = test::all_triangles(over);
    DepthContact contact;
    contact.object = {&texture, all, Pose{}};
    contact.scene = {&over, both, Pose{}};
    for (const auto& backend : {grid.get(), branch.get()}) {
      const DepthSamples got = test::depth_of(*backend, contact);
      ASSERT_TRUE(got.is_found);
      EXPECT_FALSE(got.is_height_field && got.is_of_sheets);
      if (!got.is_of_sheets) continue;
      const Vec3 world = got.frame.world_from_contact * Vec3(got.at.x(), got.at.y(), 0.0);
      const double want = slow_sheet(texture, world.head<2>());
      if (want == kNoSurface) continue;  // beside the end of the fine surface its edge stands in
      ++of_sheets;
      EXPECT_NEAR(got.depth[0], want, 2e-3 * size);
      GradientScratch scratch;
      EXPECT_TRUE(depth_gradient(contact, got, GradientKind::envelope, scratch).is_valid);
      // Nothing that the search should have seen beside it is higher.
      constexpr int kSide = 10;
      const double spacing = size / 50.0;
      double highest = kNoDepth;
      for (int k = 0; k < kSide * kSide; ++k) {
        const Vec2 off = spacing * (Vec2(k % kSide, k / kSide) / (kSide - 1) - Vec2(0.5, 0.5));
        highest = std::max(highest, slow_sheet(texture, world.head<2>() + off));
      }
      EXPECT_GE(got.depth[0], highest - 5e-3 * size) << "a lip ends where it is highest";
    }
  }
  EXPECT_GT(of_sheets, 6);
}

}  // namespace
}  // namespace thigma
