#include "thigma/depth/depth.h"

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

TEST(Configurations, move_the_object_along_and_about_the_axes_of_the_contact) {
  Random random(1);
  DepthSamples sample;
  sample.frame = contact_frame(random.in_cube(1.0), random.direction());
  sample.shift = 0.01;
  sample.turn = 0.2;
  const Vec3 centre = random.in_cube(1.0), p = random.in_cube(1.0);
  const Mat3& m = sample.frame.world_from_contact;
  EXPECT_LE((transform_point(configuration_motion(sample, centre, 0), p) - p).norm(), 0.0);
  for (int i = 1; i < kConfigurations; ++i) {
    const Vec3 to = transform_point(configuration_motion(sample, centre, i), p);
    const double sign = i % 2 ? 1.0 : -1.0;
    const int pair = (i - 1) / 2;
    const Vec3 want =
        pair < 2 ? Vec3(p + sign * 0.01 * m.col(pair))
                 : Vec3(centre + Eigen::AngleAxisd(sign * 0.2, m.col(pair - 2)) * (p - centre));
    EXPECT_LE((to - want).norm(), 1e-15) << i;
  }
}

}  // namespace
}  // namespace thigma
