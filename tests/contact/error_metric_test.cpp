#include "thigma/contact/error_metric.h"

#include <gtest/gtest.h>

#include "thigma/math/infinity.h"

namespace thigma {
namespace {

TEST(ErrorMetric, larger_feature_over_larger_area_decides) {
  const LevelError coarse{
      .deviation = 4e-3, .resolution = 100.0, .support_area = 2e-5};                    // 4e-7 m^3
  const LevelError fine{.deviation = 1e-4, .resolution = 500.0, .support_area = 8e-5};  // 4e-10 m^3
  EXPECT_DOUBLE_EQ(weighted_deviation(coarse, fine), 4e-7 / 8e-5);
  EXPECT_EQ(weighted_deviation(coarse, fine), weighted_deviation(fine, coarse));
  EXPECT_DOUBLE_EQ(weighted_deviation(coarse, fine, SupportArea::smaller), 4e-7 / 2e-5);
}

TEST(ErrorMetric, same_contact_in_other_units_gives_the_same_fraction) {
  for (const double scale : {1e-9, 1e-3, 1e3}) {
    const LevelError a{.deviation = 1e-3 * scale,
                       .resolution = 50.0 / scale,
                       .support_area = 1e-5 * scale * scale};
    const LevelError b{.deviation = 2e-3 * scale,
                       .resolution = 90.0 / scale,
                       .support_area = 3e-5 * scale * scale};
    EXPECT_NEAR(weighted_deviation(a, b) / scale, 1e-3 / 2500.0 / 3e-5, 1e-12);
  }
}

TEST(ErrorMetric, free_levels_and_points_are_always_refined) {
  const LevelError level{.deviation = 1e-3, .resolution = 100.0, .support_area = 1e-5};
  const LevelError merged{.is_free = true};
  const LevelError point{.deviation = 1e-3, .resolution = 100.0, .support_area = 0.0};
  const LevelError exact{.deviation = 0.0, .resolution = 100.0, .support_area = 0.0};
  EXPECT_EQ(weighted_deviation(level, merged), kInfinity);
  EXPECT_EQ(weighted_deviation(merged, level), kInfinity);
  EXPECT_EQ(weighted_deviation(point, point), kInfinity);
  EXPECT_EQ(weighted_deviation(exact, exact), 0.0);
}

TEST(ErrorMetric, the_view_threshold_grows_with_distance) {
  ViewThreshold view{.pixels = 2.0,
                     .distance = 0.5,
                     .frustum_size = 0.1,
                     .near_distance = 0.1,
                     .image_size = 1000.0};
  EXPECT_DOUBLE_EQ(view_threshold(view), 1e-3);
  view.distance *= 3.0;
  EXPECT_DOUBLE_EQ(view_threshold(view), 3e-3);
}

}  // namespace
}  // namespace thigma
