#include "thigma/mesh/measure.h"

#include "support/mesh_samples.h"
#include <gtest/gtest.h>

#include "thigma/math/elementary.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

Mat3 box_inertia(const Vec3& s) {
  const double m = s.prod();
  return Vec3(s.y() * s.y() + s.z() * s.z(), s.z() * s.z() + s.x() * s.x(),
              s.x() * s.x() + s.y() * s.y())
             .asDiagonal() *
         Mat3(Mat3::Identity()) * (m / 12.0);
}

TEST(Measure, a_box_has_its_closed_form_wherever_and_however_large_it_is) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    for (const double offset : {0.0, 1e7}) {
      const Vec3 size(1.0, 2.0, 3.0);
      const Vec3 at = offset * scale * Vec3(1.0, -1.0, 0.5);
      const MassProperties m = mass_properties(test::moved(make_box(size, {3, 2, 4}), at, scale));
      // At 1e7 radii off the coordinates themselves are rounded to 1e-9 of the size.
      const double tolerance = offset == 0.0 ? 1e-14 : 1e-8;
      EXPECT_NEAR(m.area / (scale * scale), 22.0, 22.0 * tolerance);
      EXPECT_NEAR(m.volume / (scale * scale * scale), 6.0, 6.0 * tolerance);
      EXPECT_LE((m.center_of_mass - at).norm() / scale, tolerance + 1e-15 * offset);
      const Mat3 want = box_inertia(size);
      EXPECT_LE((m.inertia / std::pow(scale, 5.0) - want).norm(), 10.0 * tolerance * want.norm())
          << scale << ' ' << offset;
    }
  }
}

TEST(Measure, a_tetrahedron_at_the_corner_of_the_axes_has_its_closed_form) {
  const TriangleMesh mesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
                          {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
  const MassProperties m = mass_properties(mesh);
  EXPECT_NEAR(m.volume, 1.0 / 6.0, 1e-16);
  EXPECT_NEAR(m.area, 1.5 + 0.5 * std::sqrt(3.0), 1e-15);
  EXPECT_LE((m.center_of_mass - Vec3::Constant(0.25)).norm(), 1e-15);
  // Integral of x^2 is 1/60, of x y 1/120, before the centre's own share.
  const double diagonal = 2.0 * (1.0 / 60.0 - 1.0 / 6.0 / 16.0);
  const double mixed = -(1.0 / 120.0 - 1.0 / 6.0 / 16.0);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(m.inertia(i, j), i == j ? diagonal : mixed, 1e-16);
  }
}

TEST(Measure, a_fine_ball_converges_to_the_sphere) {
  const MassProperties m = mass_properties(make_ball(2.0, 40));
  const double volume = 4.0 / 3.0 * kPi * 8.0;
  EXPECT_NEAR(m.volume / volume, 1.0, 2e-3);
  EXPECT_NEAR(m.area / (16.0 * kPi), 1.0, 2e-3);
  EXPECT_LE((m.inertia - 0.4 * volume * 4.0 * Mat3::Identity()).norm(), 5e-3 * m.inertia.norm());
  EXPECT_LE(m.center_of_mass.norm(), 1e-13);
}

TEST(Measure, turning_the_surface_over_changes_the_sign_of_the_volume_alone) {
  const TriangleMesh box = test::moved(make_box({1.0, 2.0, 3.0}), {4.0, 5.0, 6.0});
  const MassProperties m = mass_properties(box);
  const MassProperties n = mass_properties(flipped(box));
  EXPECT_EQ(n.volume, -m.volume);
  EXPECT_EQ(n.area, m.area);
  EXPECT_LE((n.center_of_mass - m.center_of_mass).norm(), 1e-14);
}

TEST(Measure, a_flat_mesh_has_no_volume_and_finite_numbers) {
  const MassProperties m =
      mass_properties(TriangleMesh{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, {{0, 1, 2}}});
  EXPECT_EQ(m.area, 0.5);
  EXPECT_TRUE(m.center_of_mass.allFinite());
  EXPECT_TRUE(m.inertia.allFinite());
  EXPECT_EQ(mass_properties(TriangleMesh{}).area, 0.0);
}

// A ball around the points is smallest when no direction lets its centre move closer to all points
// on its sphere: the centre is in their hull. Checked by the independent condition that every half
// space through the centre holds one.
TEST(Measure, the_enclosing_ball_is_around_all_points_and_smallest) {
  Random random(7);
  for (int round = 0; round < 300; ++round) {
    const double scale = round % 3 == 0 ? 1e-9 : round % 3 == 1 ? 1.0 : 1e9;
    const int n = 1 + static_cast<int>(random.below(60));
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i) {
      Vec3 p = round % 2 == 0 ? random.in_cube(1.0) : random.direction();
      if (round % 5 == 0) p.z() = 0.0;
      if (round % 7 == 0) p.y() = 0.0;
      points.push_back(scale * (p + Vec3::Constant(round % 4 == 0 ? 3.0 : 0.0)));
    }
    const Ball ball = enclosing_ball(points);
    double reach = 0.0;
    for (const Vec3& p : points) reach = std::max(reach, (p - ball.center).norm());
    ASSERT_LE(reach, ball.radius * (1.0 + 1e-12) + 1e-15 * scale);
    for (int k = 0; k < 200; ++k) {
      const Vec3 to = ball.center + 1e-4 * ball.radius * random.direction();
      double moved = 0.0;
      for (const Vec3& p : points) moved = std::max(moved, (p - to).norm());
      ASSERT_GE(moved, ball.radius * (1.0 - 1e-9)) << "round " << round;
    }
  }
}

TEST(Measure, many_points_on_one_sphere_give_that_sphere) {
  const TriangleMesh ball = test::moved(make_ball(1.0, 60), {1e3, -2e3, 5.0});
  const Ball found = enclosing_ball(ball.positions);
  EXPECT_NEAR(found.radius, 1.0, 1e-9);
  EXPECT_LE((found.center - Vec3(1e3, -2e3, 5.0)).norm(), 1e-6);
}

TEST(Measure, bounds_are_those_of_the_points) {
  const std::vector<Vec3> points{{1.0, 5.0, -1.0}, {-2.0, 7.0, 0.0}};
  EXPECT_EQ(bounds_of(points).min, Vec3(-2.0, 5.0, -1.0));
  EXPECT_EQ(bounds_of(points).max, Vec3(1.0, 7.0, 0.0));
  EXPECT_EQ(enclosing_ball({}).radius, 0.0);
  EXPECT_EQ(enclosing_ball(std::span(points).first(1)).radius, 0.0);
}

}  // namespace
}  // namespace thigma
