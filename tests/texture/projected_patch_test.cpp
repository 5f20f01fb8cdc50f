#include "texture/textured_plates.h"
#include <gtest/gtest.h>

#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

TEST(ContactFrame, is_right_handed_whatever_the_normal) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Vec3 n = i < 3 ? Vec3(Vec3::Unit(i)) : random.direction();
    const Mat3 m = contact_frame(Vec3::Zero(), n).world_from_contact;
    EXPECT_LE((m.transpose() * m - Mat3::Identity()).norm(), 1e-14);
    EXPECT_LE((m.col(0).cross(m.col(1)) - n).norm(), 1e-14);
    EXPECT_EQ(m.col(2), n);
  }
}

// Both sides of a random contact against a slow search in world coordinates.
TEST(ProjectedPatch, height_is_that_of_the_fine_surface_over_the_point) {
  Random random(2);
  int covered = 0, open = 0;
  for (int i = 0; i < 20; ++i) {
    const test::PlateContact p(random, {.cells = 1 + i % 4, .bend = 3.0, .noise = 1e-4});
    const ContactFrame frame = contact_frame(p.contact.point, p.contact.normal);
    const Vec3 u = frame.world_from_contact.col(0), v = frame.world_from_contact.col(1);
    for (const Facing facing : {Facing::along, Facing::against}) {
      const TexturedPatch& side = facing == Facing::along ? p.contact.object : p.contact.scene;
      const Vec3 direction = facing == Facing::along ? p.contact.normal : Vec3(-p.contact.normal);
      ProjectedPatch patch;
      project_patch(*side.texture, side.triangles, side.world_from_body, frame, facing, patch);
      std::int32_t near = -1;
      for (int k = 0; k < 50; ++k) {
        const Vec2 at(random.uniform(-0.015, 0.015), random.uniform(-0.015, 0.015));
        const Vec3 world = p.contact.point + at.x() * u + at.y() * v;
        const double want = test::slow_height(side, world, u, v, direction);
        const double got = height_at(patch, at, near);
        if (want == kNoDepth) {
          EXPECT_EQ(got, kNoSurface);
          ++open;
        } else {
          EXPECT_NEAR(got, want, 1e-14);
          EXPECT_NEAR(surface_jet(patch, at).height, want, 1e-14);
          ++covered;
        }
      }
    }
  }
  EXPECT_GT(covered, 500);
  EXPECT_GT(open, 100);
}

TEST(ProjectedPatch, facet_slope_is_the_derivative_of_the_height) {
  Random random(3);
  const test::PlateContact p(random, {.texels = 16, .bend = 3.0, .noise = 1e-4});
  const ContactFrame frame = contact_frame(p.contact.point, p.contact.normal);
  ProjectedPatch patch;
  project_patch(p.object, p.object_triangles, p.contact.object.world_from_body, frame,
                Facing::along, patch);
  int good = 0, covered = 0;
  for (int k = 0; k < 300; ++k) {
    const Vec2 at(random.uniform(-0.006, 0.006), random.uniform(-0.006, 0.006));
    const double step = 1e-8;
    std::int32_t near = -1;
    Vec2 slope;
    for (int i = 0; i < 2; ++i) {
      const Vec2 by = step * Vec2::Unit(i);
      slope[i] = (height_at(patch, at + by, near) - height_at(patch, at - by, near)) / (2 * step);
    }
    const SurfaceJet jet = surface_jet(patch, at);
    covered += jet.is_covered;
    good += jet.is_covered && (jet.facet_slope - slope).norm() < 1e-6;
  }
  EXPECT_GT(covered, 250);
  EXPECT_GE(good, covered - 1);  // one may lie on the seam of two facets
}

TEST(ProjectedPatch, says_where_it_is_no_height_field) {
  const HapticTexture box = make_plain_texture(make_box({0.02, 0.02, 0.02}), "box");
  const std::vector<std::int32_t> all = test::all_triangles(box);
  std::vector<std::int32_t> top;
  for (const std::int32_t t : all) {
    const auto& [a, b, c] = box.coarse.triangles[static_cast<std::size_t>(t)];
    const auto z = [&](std::int32_t i) {
      return box.coarse.positions[static_cast<std::size_t>(i)].z();
    };
    if (z(a) > 0.0 && z(b) > 0.0 && z(c) > 0.0) top.push_back(t);
  }
  ASSERT_EQ(top.size(), 2u);
  const ContactFrame frame = contact_frame(Vec3::Zero(), Vec3::UnitZ());
  const auto around = [&](const Vec3& world) -> PlaneBox {
    const Vec2 at = (frame.world_from_contact.transpose() * world).head<2>();
    return {at - Vec2::Constant(1e-3), at + Vec2::Constant(1e-3)};
  };
  const PlaneBox middle = around(Vec3::Zero()), edge = around(Vec3(0.01, 0.0, 0.0));
  ProjectedPatch patch;
  project_patch(box, top, Pose{}, frame, Facing::along, patch);
  EXPECT_TRUE(is_height_field(patch, middle));
  project_patch(box, all, Pose{}, frame, Facing::along, patch);
  EXPECT_EQ(patch.triangles.size(), 2u);
  EXPECT_FALSE(is_height_field(patch, middle));  // the bottom faces away
  project_patch(box, top, Pose{}, frame, Facing::against, patch);
  EXPECT_TRUE(patch.triangles.empty());
  EXPECT_FALSE(is_height_field(patch, middle));
  // One wall beside the top: edge-on at its own place, no matter elsewhere.
  std::vector<std::int32_t> with_wall = top;
  for (const std::int32_t t : all) {
    const auto& corners = box.coarse.triangles[static_cast<std::size_t>(t)];
    const bool is_wall = std::all_of(corners.begin(), corners.end(), [&](std::int32_t i) {
      return box.coarse.positions[static_cast<std::size_t>(i)].x() > 0.0;
    });
    if (is_wall) with_wall.push_back(t);
  }
  project_patch(box, with_wall, Pose{}, frame, Facing::along, patch);
  EXPECT_TRUE(is_height_field(patch, middle));
  EXPECT_FALSE(is_height_field(patch, edge));
}

// A relief steep enough, and displaced sideways, that it hangs over.
TEST(ProjectedPatch, fine_surface_that_turns_over_is_no_height_field) {
  TextureSource source;
  source.coarse.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  source.coarse.triangles = {{0, 1, 2}, {0, 2, 3}};
  source.width = source.height = 32;
  source.corners = {{Vec2(0, 0), Vec2(31, 0), Vec2(31, 31)},
                    {Vec2(0, 0), Vec2(31, 31), Vec2(0, 31)}};
  for (int j = 0; j < 32; ++j)
    for (int i = 0; i < 32; ++i)
      source.texels.push_back({static_cast<float>(0.2 * sine(0.4 * i)), 0.0f, 0.0f});
  const HapticTexture texture = make_texture(source, "t");
  ProjectedPatch patch;
  const std::vector<std::int32_t> all = test::all_triangles(texture);
  project_patch(texture, all, Pose{}, contact_frame(Vec3::Zero(), Vec3::UnitZ()), Facing::along,
                patch);
  // contact_frame puts u and v where it likes: ask at world points.
  const Mat3 m = contact_frame(Vec3::Zero(), Vec3::UnitZ()).world_from_contact;
  const auto at = [&](double x) -> Vec2 { return (m.transpose() * Vec3(x, 0.5, 0.0)).head<2>(); };
  EXPECT_TRUE(surface_jet(patch, at(15.7 / 31)).is_height_field);  // cos(0.4 i) = 1: stretched
  EXPECT_FALSE(surface_jet(patch, at(7.85 / 31))
                   .is_height_field);  // cos = -1: 0.08 a texel back, 0.032 forth
}

}  // namespace
}  // namespace thigma
