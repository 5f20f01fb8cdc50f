#include "reference/offset_surface.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "thigma/math/elementary.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

TEST(OffsetSurface, is_the_largest_over_a_dense_search) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const double radius = random.uniform(5e-4, 3e-3), wavelength = random.uniform(3e-4, 1e-2);
    const double amplitude = random.uniform(-4e-4, 4e-4), at = random.uniform(-0.02, 0.02);
    double best = -1.0;
    constexpr int kSamples = 20000;
    for (int k = 0; k <= kSamples; ++k) {
      const double s = radius * (2.0 * k / kSamples - 1.0);
      best = std::max(best, amplitude * std::cos(2.0 * kPi * (at + s) / wavelength) +
                                std::sqrt(std::max(radius * radius - s * s, 0.0)));
    }
    const OffsetHeight got = disk_on_wave(radius, amplitude, wavelength, at);
    EXPECT_GE(got.height, best - radius - 1e-15);
    EXPECT_LE(got.height, best - radius + 1e-8);
  }
}

TEST(OffsetSurface, slope_is_the_derivative_of_the_height) {
  Random random(2);
  int smooth = 0;
  for (int i = 0; i < 200; ++i) {
    const double radius = random.uniform(5e-4, 3e-3), wavelength = random.uniform(3e-4, 1e-2);
    const double amplitude = random.uniform(0.0, 4e-4), at = random.uniform(-0.02, 0.02),
                 step = 1e-9;
    const double slope = (disk_on_wave(radius, amplitude, wavelength, at + step).height -
                          disk_on_wave(radius, amplitude, wavelength, at - step).height) /
                         (2.0 * step);
    smooth += std::fabs(disk_on_wave(radius, amplitude, wavelength, at).slope - slope) < 1e-5;
  }
  EXPECT_GE(smooth, 198);  // but for cusps
}

TEST(OffsetSurface, rests_on_a_crest_and_spans_a_narrow_valley) {
  EXPECT_NEAR(disk_on_wave(1e-3, 1e-4, 5e-3, 0.0).height, 1e-4, 1e-18);
  EXPECT_EQ(disk_on_wave(1e-3, 0.0, 5e-3, 0.3).height, 0.0);
  EXPECT_NEAR(disk_on_wave(1e-3, 1e-4, 5e-3, 2.5e-3).height, -1e-4,
              1e-18);  // wide: reaches the bottom
  // Narrow: held by the two crests beside it.
  const double half = 1e-4;
  EXPECT_NEAR(disk_on_wave(1e-2, 1e-4, 2.0 * half, half).height,
              1e-4 + std::sqrt(1e-4 - half * half) - 1e-2, 1e-9);
}

TEST(OffsetSurface, scales_with_its_lengths) {
  const OffsetHeight here = disk_on_wave(1e-3, 2e-4, 3e-3, 4e-4);
  for (const double scale : {1e-9, 1e6}) {
    const OffsetHeight there = disk_on_wave(scale * 1e-3, scale * 2e-4, scale * 3e-3, scale * 4e-4);
    EXPECT_NEAR(there.height, scale * here.height, 1e-12 * scale);
    EXPECT_NEAR(there.slope, here.slope, 1e-8);
  }
}

TEST(OffsetSurface, nonsense_gives_no_number) {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan, infinity, 0.0, -1.0}) {
    EXPECT_TRUE(std::isnan(disk_on_wave(bad, 1e-4, 1e-3, 0.0).height)) << bad;
    EXPECT_TRUE(std::isnan(disk_on_wave(1e-3, 1e-4, bad, 0.0).height)) << bad;
  }
  EXPECT_TRUE(std::isnan(disk_on_wave(1e-3, nan, 1e-3, 0.0).height));
  EXPECT_TRUE(std::isnan(disk_on_wave(1e-3, 1e-4, 1e-3, infinity).slope));
}

}  // namespace
}  // namespace thigma
