#include "depth/textured_plates.h"
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
    // more turns over
    const test::PlateContact p(random, {.cells = 1 + i % 4, .bend = 3.0, .noise = 3e-5});
    const ContactFrame frame = contact_frame(p.contact.point, p.contact.normal);
    const Vec3 u = frame.world_from_contact.col(0), v = frame.world_from_contact.col(1);
    for (const Facing facing : {Facing::along, Facing::against}) {
      const TexturedPatch& side = facing == Facing::along ? p.contact.object : p.contact.scene;
      const Vec3 direction = facing == Facing::along ? p.contact.normal : Vec3(-p.contact.normal);
      ProjectedPatch patch;
      project_patch({side.texture, side.triangles, side.world_from_body}, frame, facing, patch);
      std::int32_t near = -1;
      for (int k = 0; k < 50; ++k) {
        const Vec2 at(random.uniform(-0.015, 0.015), random.uniform(-0.015, 0.015));
        const Vec3 world = p.contact.point + at.x() * u + at.y() * v;
        const double want = test::slow_height(side, world, u, v, direction);
        const double got = height_at(patch, at, near);
        const SurfaceJet jet = surface_jet(patch, at);
        if (want == kNoDepth) {
          // Over the coarse surface still, the nearest fine point of its edge stands in.
          const bool is_beside = test::slow_height(side, world, u, v, direction,
                                                   test::SlowHeight::of_maps) != kNoDepth;
          EXPECT_EQ(got == kNoSurface, !is_beside);
          EXPECT_EQ(jet.is_covered, is_beside);
          open += !is_beside;
        } else {
          EXPECT_NEAR(got, want, 1e-10);  // as near as fine points are looked for
          EXPECT_NEAR(jet.height, want, 1e-10);
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
  project_patch({&p.object, p.object_triangles, p.contact.object.world_from_body}, frame,
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

/// A flat plate under waves, its fine points `apart` beside their coarse ones in the middle and
/// less towards the rim: the same fine surface, however far.
TextureSource paired_plate(double apart) {
  Random random(1);
  TextureSource source = test::plate_source(random, {.texels = 257, .amplitude = 0.0, .bend = 0.0});
  for (int j = 0; j < 257; ++j) {
    for (int i = 0; i < 257; ++i) {
      const double x = 0.02 * (i / 256.0 - 0.5), y = 0.02 * (j / 256.0 - 0.5);
      const double rim = (1.0 - 1e4 * x * x) * (1.0 - 1e4 * y * y);
      const Vec2 to(x + apart * rim, y - 0.7 * apart * rim);
      const double z = 3e-4 * sine(2.0 * kPi * to.x() / 0.004) * cosine(2.0 * kPi * to.y() / 0.005);
      source.texels[static_cast<std::size_t>(257 * j + i)] = {
          static_cast<float>(to.x() - x), static_cast<float>(to.y() - y), static_cast<float>(z)};
    }
  }
  return source;
}

// What is displaced sideways is followed: height, slope and curvature are those of the fine
// surface, whatever coarse points its points belong to. Not followed, heights are off by a third of
// the waves.
TEST(ProjectedPatch, fine_surface_is_the_same_however_its_points_are_paired) {
  const HapticTexture straight = make_texture(paired_plate(0.0), "straight"),
                      aside = make_texture(paired_plate(7e-4), "aside");
  const std::vector<std::int32_t> all = test::all_triangles(straight);
  Random random(5);
  double off = 0.0, off_slope = 0.0, off_curvature = 0.0, not_followed = 0.0;
  for (int i = 0; i < 10; ++i) {
    const Vec3 normal =
        (rotation_from_vector(0.3 * random.in_cube(1.0)) * Vec3::UnitZ()).normalized();
    const ContactFrame frame = contact_frame(Vec3::Zero(), normal);
    ProjectedPatch a, b;
    project_patch({&straight, all, Pose{}}, frame, Facing::along, a);
    project_patch({&aside, all, Pose{}}, frame, Facing::along, b);
    for (int k = 0; k < 100; ++k) {
      const Vec2 at(random.uniform(-0.006, 0.006), random.uniform(-0.006, 0.006));
      const SurfaceJet want = surface_jet(a, at), got = surface_jet(b, at);
      ASSERT_TRUE(want.is_covered && got.is_covered && got.is_height_field);
      std::int32_t near = -1;
      EXPECT_NEAR(height_at(b, at, near), got.height, 1e-12);
      off = std::max(off, std::fabs(got.height - want.height));
      off_slope = std::max(off_slope, (got.slope - want.slope).norm());
      // of the waves
      off_curvature = std::max(off_curvature, (got.curvature - want.curvature).norm() / 1500.0);
      not_followed = std::max(
          not_followed,
          std::fabs(height_on(b, b.triangles[static_cast<std::size_t>(near)], at) - want.height));
      EXPECT_NEAR((got.point - Vec3(at.x(), at.y(), got.height)).norm(), 0.0, 1e-15);
    }
  }
  EXPECT_LT(off, 2e-6);
  EXPECT_LT(off_slope, 0.02);
  EXPECT_LT(off_curvature, 0.1);
  EXPECT_GT(not_followed, 1e-4);
}

// Feet of other places, and those that nothing has: a foot is where to look first, no more.
TEST(ProjectedPatch, finds_the_same_height_whatever_the_foot) {
  Random random(9);
  int found = 0;
  for (int i = 0; i < 20; ++i) {
    const test::PlateContact p(random, {.cells = 2 + i % 4, .bend = 3.0, .noise = 1.6e-4});
    const ContactFrame frame = contact_frame(p.contact.point, p.contact.normal);
    ProjectedPatch patch;
    project_patch(p.contact.object, frame, Facing::along, patch);
    const int triangles = static_cast<int>(patch.triangles.size());
    for (int k = 0; k < 200; ++k) {
      // Beside edges the fine surface of one triangle lies over another.
      const auto& corners = patch.triangles[random.below(patch.triangles.size())].at;
      const Vec2 at = corners[0] + random.uniform() * (corners[1] - corners[0]) +
                      1e-4 * Vec2(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
      std::int32_t near = -1;
      const double want = height_at(patch, at, near);
      if (!surface_jet(patch, at).is_height_field) continue;  // of several sheets any is right
      const bool is_own = k % 2 == 0 && near >= 0;
      SurfaceFoot foot{is_own ? near
                              : static_cast<std::int32_t>(
                                    random.below(static_cast<std::uint32_t>(triangles + 2))) -
                                    1,
                       random.uniform(0.0, 4e-3) * Vec2(random.uniform(-1.0, 1.0), 1.0)};
      const double got = height_at(patch, at, foot);
      ASSERT_EQ(got == kNoSurface, want == kNoSurface) << i << ' ' << k;
      if (want == kNoSurface) continue;
      EXPECT_NEAR(got, want, 1e-9) << i << ' ' << k;
      ++found;
    }
  }
  EXPECT_GT(found, 1000);
}

// On a bent surface displacements cross from one triangle to the next.
TEST(ProjectedPatch, follows_across_triangles) {
  Random random(6);
  int moved = 0;
  for (int i = 0; i < 10; ++i) {
    const test::PlateContact p(random, {.cells = 6, .texels = 128, .bend = 8.0});
    ProjectedPatch patch;
    project_patch({&p.object, p.object_triangles, p.contact.object.world_from_body},
                  contact_frame(p.contact.point, p.contact.normal), Facing::along, patch);
    for (int k = 0; k < 100; ++k) {
      const Vec2 at(random.uniform(-0.005, 0.005), random.uniform(-0.005, 0.005));
      std::int32_t near = -1;
      if (height_at(patch, at, near) == kNoSurface) continue;
      const ProjectedTriangle& t = patch.triangles[static_cast<std::size_t>(near)];
      Vec2 place;
      ASSERT_TRUE(find_below(patch, t, at, place)) << "the triangle that holds the coarse point";
      moved += test::barycentric(t.at[0], t.at[1], t.at[2], at).minCoeff() < 0.0;
    }
  }
  EXPECT_GT(moved, 5) << "or no fine point lies over another triangle than its own";
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
  project_patch({&box, top, Pose{}}, frame, Facing::along, patch);
  EXPECT_TRUE(is_height_field(patch, middle));
  project_patch({&box, all, Pose{}}, frame, Facing::along, patch);
  EXPECT_EQ(patch.triangles.size(), 2u);
  EXPECT_FALSE(is_height_field(patch, middle));  // the bottom faces away
  project_patch({&box, top, Pose{}}, frame, Facing::against, patch);
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
  project_patch({&box, with_wall, Pose{}}, frame, Facing::along, patch);
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
  project_patch({&texture, all, Pose{}}, contact_frame(Vec3::Zero(), Vec3::UnitZ()), Facing::along,
                patch);
  // contact_frame puts u and v where it likes: ask at world points.
  const Mat3 m = contact_frame(Vec3::Zero(), Vec3::UnitZ()).world_from_contact;
  const auto at = [&](double x) -> Vec2 { return (m.transpose() * Vec3(x, 0.5, 0.0)).head<2>(); };
  EXPECT_TRUE(surface_jet(patch, at(15.7 / 31)).is_height_field);  // cos(0.4 i) = 1: stretched
  EXPECT_FALSE(surface_jet(patch, at(7.85 / 31))
                   .is_height_field);  // cos = -1: 0.08 a texel back, 0.032 forth
}

// What moves sideways comes over the end of a patch from the triangles beside it.
TEST(ProjectedPatch, sees_the_fine_surface_of_triangles_around) {
  Random random(12);
  constexpr double kAside = 4e-4;
  TextureSource source = test::plate_source(random, {.cells = 4, .texels = 128});
  for (Texel& t : source.texels) t.x -= static_cast<float>(kAside);
  const HapticTexture texture = make_texture(std::move(source), "aside");
  const std::vector<std::int32_t> all = test::all_triangles(texture);
  std::vector<std::int32_t> left, right;
  for (const std::int32_t t : all) {
    double sum = 0.0;
    for (const std::int32_t v : texture.coarse.triangles[static_cast<std::size_t>(t)])
      sum += texture.coarse.positions[static_cast<std::size_t>(v)].x();
    (sum < 0.0 ? left : right).push_back(t);
  }
  const ContactFrame frame = contact_frame(Vec3::Zero(), Vec3::UnitZ());
  ProjectedPatch whole, cut, seen;
  project_patch({&texture, all, Pose{}}, frame, Facing::along, whole);
  project_patch({&texture, left, Pose{}}, frame, Facing::along, cut);
  project_patch({&texture, left, Pose{}, right}, frame, Facing::along, seen);
  ASSERT_FALSE(seen.around.empty());
  EXPECT_EQ(seen.box.high, cut.box.high) << "no ground to stand on";
  double worst_cut = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Vec3 world(-random.uniform(0.05, 0.95) * kAside, random.uniform(-0.009, 0.009), 0.0);
    const Vec2 at = (frame.world_from_contact.transpose() * world).head<2>();
    std::int32_t near = -1;
    const double want = height_at(whole, at, near);
    near = -1;
    const double got = height_at(seen, at, near);
    EXPECT_NEAR(got, want, 1e-9);
    EXPECT_GE(near, static_cast<std::int32_t>(seen.triangles.size()));
    EXPECT_NEAR(surface_jet(seen, at).height, want, 1e-9);
    near = -1;
    worst_cut = std::max(worst_cut, std::fabs(height_at(cut, at, near) - want));
    near = -1;
    const Vec3 beyond(1e-5, world.y(), 0.0);
    EXPECT_EQ(height_at(seen, (frame.world_from_contact.transpose() * beyond).head<2>(), near),
              kNoSurface);
  }
  EXPECT_GT(worst_cut, 2e-5) << "or there is nothing to see";
}

}  // namespace
}  // namespace thigma
