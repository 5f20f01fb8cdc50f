#include "reference/depth_hessian.h"

#include "depth/textured_plates.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

Vec6 gradient_after(DepthBackend& backend, const DepthContact& contact, const Vec6& by,
                    GradientScratch& scratch) {
  DepthContact there = test::moved(contact, by);
  there.centre += by.head<3>();  // the object's, which goes along
  return test::six(
      depth_gradient(there, test::depth_of(backend, there), GradientKind::envelope, scratch));
}

/// Largest differences between derivatives and differences of the gradient, over the largest
/// derivative: by ways and by rotations.
Vec2 off(const DepthContact& contact, const Mat6& got, double step, double arm) {
  const auto backend = make_branch_depth({});
  GradientScratch scratch;
  Mat6 want;
  for (int i = 0; i < 6; ++i) {
    const double h = i < 3 ? step : step / arm;
    want.col(i) = (gradient_after(*backend, contact, h * Vec6::Unit(i), scratch) -
                   gradient_after(*backend, contact, -h * Vec6::Unit(i), scratch)) /
                  (2.0 * h);
  }
  Vec6 unit;  // lengths and angles become alike
  unit << 1.0, 1.0, 1.0, 1.0 / arm, 1.0 / arm, 1.0 / arm;
  const Mat6 difference = unit.asDiagonal() * (got - want) * unit.asDiagonal(),
             all = unit.asDiagonal() * want * unit.asDiagonal();
  return Vec2(difference.leftCols<3>().cwiseAbs().maxCoeff(),
              difference.rightCols<3>().cwiseAbs().maxCoeff()) /
         all.cwiseAbs().maxCoeff();
}

TEST(DepthHessian, is_the_derivative_of_the_gradient) {
  test::Hills hills;
  hills.contact.object.world_from_body =
      Pose{Vec3(4e-4, -7e-4, 1e-4), rotation_from_vector(Vec3(0.02, -0.03, 0.4))};
  hills.contact.centre = Vec3(0.01, -0.02, 0.04);
  const auto backend = make_branch_depth({});
  GradientScratch scratch;
  const DepthHessian got =
      depth_hessian(hills.contact, test::depth_of(*backend, hills.contact), scratch);
  ASSERT_TRUE(got.is_valid);
  const Vec2 errors = off(hills.contact, got.gradient_by_motion, 2e-4, 0.05);
  EXPECT_LT(errors[0], 0.01);
  EXPECT_LT(errors[1], 0.01);
}

// Waves on tilted, bent plates, displaced in any direction.
TEST(DepthHessian, is_that_of_waves_as_well) {
  Random random(7);
  int valid = 0, good = 0;
  for (int i = 0; i < 30; ++i) {
    const test::PlateContact p(random,
                               {.texels = 512, .amplitude = 4e-4, .bend = 0.0, .waves = 2.0});
    const auto backend = make_branch_depth({});
    GradientScratch scratch;
    const DepthHessian got = depth_hessian(p.contact, test::depth_of(*backend, p.contact), scratch);
    if (!got.is_valid) continue;
    ++valid;
    const Vec2 errors = off(p.contact, got.gradient_by_motion, 4e-5, 0.05);
    good += errors.maxCoeff() < 0.05;
  }
  EXPECT_GT(valid, 5);
  EXPECT_GE(good, valid - 1);
}

TEST(DepthHessian, is_not_valid_without_a_smooth_maximum) {
  test::Hills hills;
  GradientScratch scratch;
  EXPECT_FALSE(depth_hessian(hills.contact, {}, scratch).is_valid);
  // Flat on flat: every place is as deep as the others.
  Random random(8);
  const test::PlateContact flat(random, {.texels = 64, .amplitude = 0.0, .bend = 0.0});
  const auto backend = make_grid_depth({});
  const DepthSamples sample = test::depth_of(*backend, flat.contact);
  ASSERT_TRUE(sample.is_found);
  EXPECT_FALSE(depth_hessian(flat.contact, sample, scratch).is_valid);
}

}  // namespace
}  // namespace thigma
