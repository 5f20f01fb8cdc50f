#include "thigma/depth/depth_gradient.h"

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

#include "thigma/math/rotation.h"

namespace thigma {
namespace {

constexpr GradientKind kKinds[] = {GradientKind::central_differences, GradientKind::envelope,
                                   GradientKind::smoothed_envelope};

// Two paraboloids of curvatures a and b: depth and gradient in closed form where the object is only
// shifted.
TEST(DepthGradient, of_two_hills_is_the_closed_one) {
  test::Hills hills;
  hills.contact.object.world_from_body = Pose{Vec3(4e-4, -7e-4, 1e-4), Quat::Identity()};
  const double a = 20.0, b = 30.0, stiff = a * b / (a + b);
  const Vec3 t = hills.contact.object.world_from_body.position;
  const Vec2 slope = -stiff * t.head<2>();  // of the depth by the shift
  const double depth = t.z() - 0.5 * stiff * t.head<2>().squaredNorm();
  const auto grid = make_grid_depth({}), branch = make_branch_depth({});
  GradientScratch scratch;
  for (DepthBackend* backend : {grid.get(), branch.get()}) {
    for (const GradientKind kind : kKinds) {
      const DepthRequest request = depth_request(kind, 1e-3, 1e-3);
      const DepthSamples sample = test::depth_of(*backend, hills.contact, request);
      // Interpolation cuts a curved surface by curvature texel^2 / 8 each way.
      const double texel = hills.object.texel_size;
      EXPECT_NEAR(sample.depth[0], depth, 2.0 * 0.125 * (a + b) * texel * texel);
      const DepthGradient got = depth_gradient(hills.contact, sample, kind, scratch);
      ASSERT_TRUE(got.is_valid);
      EXPECT_LE((got.linear - Vec3(slope.x(), slope.y(), 1.0)).norm(), 0.05 * slope.norm())
          << gradient_name(kind);
    }
  }
}

// The whole chain on a smooth contact: envelope gradient against differences of the exact depth
// itself.
TEST(DepthGradient, envelope_is_the_derivative_of_the_depth) {
  test::Hills hills;
  const auto backend = make_branch_depth({});
  GradientScratch scratch;
  const DepthGradient got = depth_gradient(hills.contact, test::depth_of(*backend, hills.contact),
                                           GradientKind::envelope, scratch);
  ASSERT_TRUE(got.is_valid);
  const Vec3 n = hills.contact.normal;
  for (int i = 0; i < 6; ++i) {
    const double step = i < 3 ? 4e-4 : 4e-4 / 0.05;
    const double to =
        test::depth_of(*backend, test::moved(hills.contact, step * Vec6::Unit(i))).depth[0];
    const double fro =
        test::depth_of(*backend, test::moved(hills.contact, -step * Vec6::Unit(i))).depth[0];
    const double tolerance = i < 3 ? 1e-3 : 1e-3 * 0.05;  // texels of 78 um over a step of 400 um
    EXPECT_NEAR(test::six(got)[i], (to - fro) / (2.0 * step), tolerance) << i;
  }
  EXPECT_NEAR(got.linear.dot(n), 1.0, 1e-12);
}

// gradient_at is exact for the interpolated surface: depth at a fixed line along n, by any small
// motion.
TEST(DepthGradient, at_a_fixed_place_agrees_with_differences_to_rounding) {
  Random random(2);
  int good = 0, tried = 0;
  for (int i = 0; i < 40; ++i) {
    const test::PlateContact p(random, {.texels = 16, .bend = 3.0, .noise = 1e-4});
    const ContactFrame frame = contact_frame(p.contact.point, p.contact.normal);
    const Vec2 at(random.uniform(-0.004, 0.004), random.uniform(-0.004, 0.004));
    const auto jet_of = [&](const DepthContact& contact) {
      ProjectedPatch patch;
      project_patch(
          {contact.object.texture, contact.object.triangles, contact.object.world_from_body}, frame,
          Facing::along, patch);
      return surface_jet(patch, at);
    };
    const SurfaceJet here = jet_of(p.contact);
    if (!here.is_covered) continue;
    const Vec6 got = test::six(gradient_at(here, frame, p.contact.centre, here.facet_slope));
    Vec6 want;
    for (int k = 0; k < 6; ++k) {
      const double step = k < 3 ? 1e-8 : 1e-8 / 0.04;
      want[k] = (jet_of(test::moved(p.contact, step * Vec6::Unit(k))).height -
                 jet_of(test::moved(p.contact, -step * Vec6::Unit(k))).height) /
                (2.0 * step);
    }
    ++tried;
    good += (got - want).head<3>().norm() < 1e-6 && (got - want).tail<3>().norm() < 1e-7;
  }
  EXPECT_GT(tried, 30);
  EXPECT_GE(good, tried - 1);
}

TEST(DepthGradient, kinds_agree_where_the_contact_is_smooth) {
  test::Hills hills;
  const auto backend = make_grid_depth({});
  GradientScratch scratch;
  Vec6 of_kind[3];
  for (const GradientKind kind : kKinds) {
    const DepthSamples sample =
        test::depth_of(*backend, hills.contact, depth_request(kind, 1e-3, 0.01));
    of_kind[static_cast<int>(kind)] =
        test::six(depth_gradient(hills.contact, sample, kind, scratch));
  }
  const double size = (of_kind[1].head<3>() - Vec3::UnitZ()).norm();
  EXPECT_LE((of_kind[0] - of_kind[1]).norm(), 0.2 * size);
  EXPECT_LE((of_kind[2] - of_kind[1]).norm(), 0.1 * size);
}

// Two equal hills side by side: a small shift makes the other one the higher. The plain envelope
// jumps, the smoothed one passes through.
TEST(DepthGradient, smoothing_removes_the_jump_between_two_maxima) {
  Random random(3);
  TextureSource source = test::plate_source(random, {.cells = 1, .texels = 257, .bend = 0.0});
  for (int k = 0; k < 257 * 257; ++k) {
    const double x = 0.02 * (k % 257 / 256.0 - 0.5), y = 0.02 * (k / 257 / 256.0 - 0.5);
    const double left = (x + 0.005) * (x + 0.005) + y * y,
                 right = (x - 0.005) * (x - 0.005) + y * y;
    source.texels[static_cast<std::size_t>(k)] = {
        0.0f, 0.0f, static_cast<float>(-20.0 * std::min(left, right))};
  }
  const HapticTexture object = make_texture(source, "hills");
  const HapticTexture scene = make_texture(
      test::plate_source(
          random, {.cells = 1, .texels = 2, .amplitude = 0.0, .bend = 0.0, .is_reversed = true}),
      "flat");
  const std::vector<std::int32_t> triangles = test::all_triangles(object);
  DepthContact contact;
  contact.object = {&object, triangles, Pose{Vec3(0, 0, 1e-4), Quat::Identity()}};
  contact.scene = {&scene, triangles, Pose{}};
  const auto backend = make_grid_depth({.resolution = 101});
  GradientScratch scratch;
  double jump[3] = {};
  Vec6 before[3];
  for (int i = -40; i <= 40; ++i) {
    contact.object.world_from_body.orientation = rotation_from_vector(Vec3(0.0, 1e-4 * i, 0.0));
    for (const GradientKind kind : {GradientKind::envelope, GradientKind::smoothed_envelope}) {
      const DepthSamples sample = test::depth_of(*backend, contact, depth_request(kind, 1e-4, 1.0));
      const int k = static_cast<int>(kind);
      const Vec6 here = test::six(depth_gradient(contact, sample, kind, scratch));
      if (i > -40) jump[k] = std::max(jump[k], (here - before[k]).norm());
      before[k] = here;
    }
  }
  EXPECT_GT(jump[1], 0.009);  // the arm changes from one hill to the other, 10 mm apart
  EXPECT_LT(jump[2], 0.3 * jump[1]);
}

// The edge of a plain block on a slope: the maximum is held by the block's end, and the slope is
// the scene's.
TEST(DepthGradient, at_the_end_of_one_side_the_slope_is_the_other_sides) {
  SurfaceJet object, scene;
  object.slope = Vec2(0.3, 0.1);
  scene.slope = Vec2(0.2, 0.0);  // against n: the surface falls by 0.2 along u
  const SmoothPeak peak = smooth_peak(object, scene, 1e-4);
  EXPECT_EQ(envelope_slope(object, scene, peak, -1), Vec2(-0.2, 0.0));
  EXPECT_EQ(envelope_slope(object, scene, peak, 1), Vec2(0.3, 0.1));
  // Flat both: the mean.
  EXPECT_LE((envelope_slope(object, scene, peak, 0) - Vec2(0.05, 0.05)).norm(), 1e-15);
}

TEST(DepthGradient, is_invalid_without_depth_and_where_a_configuration_has_none) {
  test::Hills hills;
  GradientScratch scratch;
  const auto backend = make_grid_depth({});
  for (const GradientKind kind : kKinds)
    EXPECT_FALSE(depth_gradient(hills.contact, {}, kind, scratch).is_valid);
  DepthSamples sample = test::depth_of(*backend, hills.contact, {.has_differences = true});
  EXPECT_TRUE(
      depth_gradient(hills.contact, sample, GradientKind::central_differences, scratch).is_valid);
  sample.depth[7] = kNoDepth;
  EXPECT_FALSE(
      depth_gradient(hills.contact, sample, GradientKind::central_differences, scratch).is_valid);
}

TEST(DepthGradient, kinds_have_names) {
  for (const GradientKind kind : kKinds) {
    GradientKind found{};
    EXPECT_TRUE(gradient_kind(gradient_name(kind), found));
    EXPECT_EQ(found, kind);
    EXPECT_FALSE(gradient_kind("newton", found));
    EXPECT_EQ(found, kind);
  }
}

}  // namespace
}  // namespace thigma
