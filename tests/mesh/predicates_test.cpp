#include "thigma/mesh/predicates.h"

#include <array>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

using Wide = __int128;

int sign(Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

// Coordinates that are integers below 2^40 times a power of two: the determinant is exact in 128
// bits.
struct IntegerPoint {
  std::int64_t x, y, z;
  Vec3 scaled(double s) const {
    return {s * static_cast<double>(x), s * static_cast<double>(y), s * static_cast<double>(z)};
  }
};

int exact_side(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c,
               const IntegerPoint& d) {
  const Wide ax = b.x - a.x, ay = b.y - a.y, az = b.z - a.z;
  const Wide bx = c.x - a.x, by = c.y - a.y, bz = c.z - a.z;
  const Wide cx = d.x - a.x, cy = d.y - a.y, cz = d.z - a.z;
  return sign((ay * bz - az * by) * cx + (az * bx - ax * bz) * cy + (ax * by - ay * bx) * cz);
}

IntegerPoint random_point(Random& random, std::int64_t range) {
  const auto one = [&] {
    return static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(2 * range + 1))) -
           range;
  };
  const std::int64_t x = one(), y = one();
  return {x, y, one()};
}

TEST(Predicates, orient3d_agrees_with_integers_near_and_on_the_plane) {
  Random random(11);
  int zeros = 0;
  for (int i = 0; i < 200000; ++i) {
    const std::int64_t range = i % 2 == 0 ? 20 : (std::int64_t{1} << 39);
    const IntegerPoint a = random_point(random, range), b = random_point(random, range);
    IntegerPoint c = random_point(random, range), d = random_point(random, range);
    if (i % 4 >= 2) {
      // In the plane by construction, or one unit off it.
      const std::int64_t k = static_cast<std::int64_t>(random.below(3)) - 1;
      const std::int64_t half = i % 2 == 0 ? 1 : 0;
      c = {a.x + (b.x - a.x) / 2, a.y + (b.y - a.y) / 2, a.z + (b.z - a.z) / 2 + half};
      d = {a.x + k * (c.x - a.x), a.y + k * (c.y - a.y),
           a.z + k * (c.z - a.z) + static_cast<std::int64_t>(random.below(2))};
    }
    const int want = exact_side(a, b, c, d);
    zeros += want == 0;
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(200)) - 100);
    ASSERT_EQ(orient3d(a.scaled(scale), b.scaled(scale), c.scaled(scale), d.scaled(scale)), want)
        << i;
  }
  EXPECT_GT(zeros, 1000);
}

// A polynomial in B = 2^60 with small coefficients: its sign is that of the highest one, so
// determinants of numbers whose differences do not fit a double have a reference in plain integers.
struct Polynomial {
  std::array<std::int64_t, 4> c{};
};
Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  Polynomial r;
  for (std::size_t i = 0; i < 4; ++i) r.c[i] = a.c[i] - b.c[i];
  return r;
}
Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  Polynomial r;
  for (std::size_t i = 0; i < 4; ++i) r.c[i] = a.c[i] + b.c[i];
  return r;
}
Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  Polynomial r;
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; i + j < 4; ++j) r.c[i + j] += a.c[i] * b.c[j];
  }
  return r;
}

TEST(Predicates, orient3d_is_exact_when_differences_round) {
  Random random(12);
  int zeros = 0;
  for (int i = 0; i < 200000; ++i) {
    std::array<std::array<Polynomial, 3>, 4> p;
    std::array<Vec3, 4> v;
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t small = static_cast<std::int64_t>(random.below(5)) - 2;
        const bool is_far = random.below(3) == 0;
        p[k][axis].c[is_far ? 1 : 0] = small;
        v[k][static_cast<int>(axis)] = static_cast<double>(small) * (is_far ? 0x1.0p60 : 1.0);
      }
    }
    std::array<std::array<Polynomial, 3>, 3> m;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) m[k][axis] = p[k + 1][axis] - p[0][axis];
    }
    const Polynomial det = (m[0][1] * m[1][2] - m[0][2] * m[1][1]) * m[2][0] +
                           (m[0][2] * m[1][0] - m[0][0] * m[1][2]) * m[2][1] +
                           (m[0][0] * m[1][1] - m[0][1] * m[1][0]) * m[2][2];
    int want = 0;
    for (std::size_t k = 4; k-- > 0 && want == 0;) want = sign(det.c[k]);
    zeros += want == 0;
    ASSERT_EQ(orient3d(v[0], v[1], v[2], v[3]), want) << i;
  }
  EXPECT_GT(zeros, 100);
}

TEST(Predicates, orient3d_sees_the_last_bit) {
  // d a last bit above and below a plane through points of very different size.
  const Vec3 a(0.1, 0.1, 0.1), b(1e10, 0.2, 0.1), c(0.3, 1e-10, 0.1);
  EXPECT_EQ(orient3d(a, b, c, Vec3(123.456, 7.0, 0.1)), 0);
  EXPECT_EQ(orient3d(a, b, c, Vec3(123.456, 7.0, std::nextafter(0.1, 1.0))),
            -orient3d(a, b, c, Vec3(123.456, 7.0, std::nextafter(0.1, 0.0))));
  EXPECT_NE(orient3d(a, b, c, Vec3(123.456, 7.0, std::nextafter(0.1, 1.0))), 0);
  // x = y = z: exactly on one plane for every rounding of the numbers, tilted, with differences
  // that round.
  const Vec3 p(0.1, 0.1, 5.0), q(1e9 / 3.0, 1e9 / 3.0, 1e-3), r(1e-7 / 7.0, 1e-7 / 7.0, 1.0 / 3.0);
  EXPECT_EQ(orient3d(p, q, r, Vec3(0.7, 0.7, -1e5)), 0);
  EXPECT_EQ(orient3d(p, q, r, Vec3(std::nextafter(0.7, 1.0), 0.7, -1e5)),
            -orient3d(p, q, r, Vec3(std::nextafter(0.7, 0.0), 0.7, -1e5)));
}

TEST(Predicates, signs_follow_the_documented_handedness) {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(orient3d(a, b, c, {0, 0, 1}), 1);
  EXPECT_EQ(orient3d(a, b, c, {0, 0, -1}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
}

TEST(Predicates, exchanging_two_points_changes_the_sign) {
  Random random(13);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 a = random.in_cube(1.0), b = random.in_cube(1.0), c = random.in_cube(1.0);
    const double u = random.uniform(), v = random.uniform();
    const Vec3 d = a + u * (b - a) + v * (c - a);  // in the plane to rounding
    const int s = orient3d(a, b, c, d);
    ASSERT_EQ(orient3d(b, a, c, d), -s);
    ASSERT_EQ(orient3d(a, c, b, d), -s);
    ASSERT_EQ(orient3d(a, b, d, c), -s);
    ASSERT_EQ(orient3d(c, d, a, b), s);
  }
}

TEST(Predicates, orient2d_agrees_with_integers) {
  Random random(14);
  for (int i = 0; i < 100000; ++i) {
    const IntegerPoint a = random_point(random, 1 << 20), b = random_point(random, 1 << 20);
    const std::int64_t k = static_cast<std::int64_t>(random.below(5)) - 2;
    const IntegerPoint c{a.x + k * (b.x - a.x),
                         a.y + k * (b.y - a.y) + static_cast<std::int64_t>(random.below(2)), 0};
    const int want = sign(Wide{b.x - a.x} * (c.y - a.y) - Wide{b.y - a.y} * (c.x - a.x));
    const double s = 0x1.0p-30;
    const auto at = [&](const IntegerPoint& p) {
      return Vec2(s * static_cast<double>(p.x), s * static_cast<double>(p.y));
    };
    ASSERT_EQ(orient2d(at(a), at(b), at(c)), want);
  }
}

TEST(Predicates, collinear_means_exactly_on_one_line) {
  EXPECT_TRUE(are_collinear({0, 0, 0}, {1, 2, 3}, {0.5, 1.0, 1.5}));
  EXPECT_FALSE(are_collinear({0, 0, 0}, {1, 2, 3}, {0.5, 1.0, std::nextafter(1.5, 2.0)}));
  EXPECT_TRUE(are_collinear({1, 1, 1}, {1, 1, 1}, {0, 5, 2}));
}

TEST(Predicates, a_segment_meets_a_triangle_at_its_border_too) {
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const auto meets = [&](const Vec3& p, const Vec3& q) {
    return segment_meets_triangle(p, q, a, b, c);
  };
  EXPECT_TRUE(meets({1, 1, -1}, {1, 1, 1}));
  EXPECT_TRUE(meets({1, 1, 0}, {1, 1, 1}));   // ends on it
  EXPECT_TRUE(meets({2, 2, -1}, {2, 2, 1}));  // through an edge
  EXPECT_TRUE(meets({0, 0, -1}, {0, 0, 1}));  // through a corner
  EXPECT_FALSE(meets({1, 1, 1}, {1, 1, 2}));  // its line would
  EXPECT_FALSE(meets({3, 3, -1}, {3, 3, 1}));
  EXPECT_TRUE(meets({-1, 1, 0}, {5, 1, 0}));   // in its plane, across
  EXPECT_TRUE(meets({1, 1, 0}, {1.5, 1, 0}));  // in its plane, inside
  EXPECT_TRUE(meets({-1, 0, 0}, {0, 0, 0}));   // in its plane, touching a corner
  EXPECT_FALSE(meets({-1, -1, 0}, {5, -1, 0}));
  EXPECT_FALSE(meets({3, 3, 0}, {5, 5, 0}));
}

TEST(Predicates, coplanar_triangles_meet_when_they_touch) {
  const Vec3 a(0, 0, 1), b(4, 0, 1), c(0, 4, 1);
  const auto meets = [&](const Vec3& d, const Vec3& e, const Vec3& f) {
    return coplanar_triangles_meet(a, b, c, d, e, f);
  };
  EXPECT_TRUE(meets({1, 1, 1}, {1.5, 1, 1}, {1, 1.5, 1}));    // inside
  EXPECT_TRUE(meets({-9, -9, 1}, {30, -9, 1}, {-9, 30, 1}));  // around
  EXPECT_TRUE(meets({2, 2, 1}, {5, 2, 1}, {5, 5, 1}));        // touching in a point
  EXPECT_TRUE(meets({2, -1, 1}, {3, 9, 1}, {9, 9, 1}));  // crossing without a corner in the other
  EXPECT_FALSE(meets({2.1, 2, 1}, {5, 2, 1}, {5, 5, 1}));
  EXPECT_FALSE(meets({5, 0, 1}, {6, 0, 1}, {5, 1, 1}));
}

}  // namespace
}  // namespace thigma
