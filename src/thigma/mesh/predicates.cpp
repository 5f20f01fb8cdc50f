// Determinants of differences in three stages: rounded with an error bound; expansions of the
// rounded differences when these were exact (the rule for CAD and single-precision input);
// expansions of the two-term differences. An expansion is a sum of doubles that do not overlap,
// smallest first, so the last nonzero one has the sign.

#include "thigma/mesh/predicates.h"

#include <array>
#include <cmath>
#include <limits>

namespace thigma {
namespace {

constexpr double kHalfUlp = 0.5 * std::numeric_limits<double>::epsilon();

struct TwoTerms {
  double high, low;
};

inline TwoTerms two_sum(double a, double b) noexcept {
  const double s = a + b;
  const double bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

inline TwoTerms two_difference(double a, double b) noexcept { return two_sum(a, -b); }

inline TwoTerms split(double a) noexcept {
  const double c = 134217729.0 * a;  // 2^27 + 1
  const double high = c - (c - a);
  return {high, a - high};
}

inline TwoTerms two_product(double a, double b) noexcept {
  const double p = a * b;
  const TwoTerms x = split(a);
  const TwoTerms y = split(b);
  return {p, x.low * y.low - (((p - x.high * y.high) - x.low * y.high) - x.high * y.low)};
}

template <int N>
struct Expansion {
  std::array<double, N> terms;
  int count = 0;
  void push(double x) noexcept {
    if (x != 0.0) terms[static_cast<std::size_t>(count++)] = x;
  }
  double operator[](int i) const noexcept { return terms[static_cast<std::size_t>(i)]; }
  int sign() const noexcept {
    if (count == 0) return 0;
    return terms[static_cast<std::size_t>(count - 1)] > 0.0 ? 1 : -1;
  }
};

Expansion<2> expand(const TwoTerms& t) noexcept {
  Expansion<2> e;
  e.push(t.low);
  e.push(t.high);
  return e;
}

// Adds one double to a nonoverlapping expansion, in place (Shewchuk 1997, Grow-Expansion).
template <int N>
void grow(Expansion<N>& e, double b) noexcept {
  double carry = b;
  int kept = 0;
  for (int i = 0; i < e.count; ++i) {
    const TwoTerms s = two_sum(carry, e[i]);
    carry = s.high;
    if (s.low != 0.0) e.terms[static_cast<std::size_t>(kept++)] = s.low;
  }
  e.count = kept;
  e.push(carry);
}

template <int N, int M>
Expansion<N + M> add(const Expansion<N>& a, const Expansion<M>& b,
                     double sign_of_b = 1.0) noexcept {
  Expansion<N + M> sum;
  for (int i = 0; i < a.count; ++i) sum.push(a[i]);
  for (int i = 0; i < b.count; ++i) grow(sum, sign_of_b * b[i]);
  return sum;
}

template <int N, int M>
Expansion<2 * N * M> multiply(const Expansion<N>& a, const Expansion<M>& b) noexcept {
  Expansion<2 * N * M> product;
  for (int i = 0; i < a.count; ++i) {
    for (int j = 0; j < b.count; ++j) {
      const TwoTerms p = two_product(a[i], b[j]);
      grow(product, p.low);
      grow(product, p.high);
    }
  }
  return product;
}

template <int N>
int determinant_sign(const std::array<std::array<Expansion<N>, 3>, 3>& m) noexcept {
  const auto minor = [](const std::array<Expansion<N>, 3>& u,
                        const std::array<Expansion<N>, 3>& v) {
    return add(multiply(u[0], v[1]), multiply(u[1], v[0]), -1.0);
  };
  return add(add(multiply(minor(m[1], m[2]), m[0][2]), multiply(minor(m[2], m[0]), m[1][2])),
             multiply(minor(m[0], m[1]), m[2][2]))
      .sign();
}

// Expansions of the rounded differences where these are exact, else of both of their terms.
int orient3d_exact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
  const std::array<const Vec3*, 3> rows = {&a, &b, &c};
  std::array<std::array<Expansion<1>, 3>, 3> one;
  std::array<std::array<Expansion<2>, 3>, 3> two;
  bool exact = true;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) {
      const int axis = static_cast<int>(k);
      const TwoTerms t = two_difference((*rows[i])[axis], d[axis]);
      exact = exact && t.low == 0.0;
      one[i][k].push(t.high);
      two[i][k] = expand(t);
    }
  }
  return exact ? determinant_sign(one) : determinant_sign(two);
}

int orient2d_exact(const Vec2& a, const Vec2& b, const Vec2& c) noexcept {
  const auto left =
      multiply(expand(two_difference(a.x(), c.x())), expand(two_difference(b.y(), c.y())));
  const auto right =
      multiply(expand(two_difference(a.y(), c.y())), expand(two_difference(b.x(), c.x())));
  return add(left, right, -1.0).sign();
}

Vec2 drop_axis(const Vec3& p, int axis) noexcept { return {p[(axis + 1) % 3], p[(axis + 2) % 3]}; }

// An axis along which the triangle projects to one with an area; -1 for a collinear one.
int projection_axis(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  const Vec3 n = (b - a).cross(c - a).cwiseAbs();
  int axis = n.x() >= n.y() ? (n.x() >= n.z() ? 0 : 2) : (n.y() >= n.z() ? 1 : 2);
  for (int i = 0; i < 3; ++i, axis = (axis + 1) % 3) {
    if (orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis)) != 0) return axis;
  }
  return -1;
}

bool is_between(const Vec2& p, const Vec2& a, const Vec2& b) noexcept {
  return std::fmin(a.x(), b.x()) <= p.x() && p.x() <= std::fmax(a.x(), b.x()) &&
         std::fmin(a.y(), b.y()) <= p.y() && p.y() <= std::fmax(a.y(), b.y());
}

bool segments_meet(const Vec2& p, const Vec2& q, const Vec2& a, const Vec2& b) noexcept {
  const int pa = orient2d(p, q, a);
  const int pb = orient2d(p, q, b);
  const int ap = orient2d(a, b, p);
  const int aq = orient2d(a, b, q);
  if (pa * pb < 0 && ap * aq < 0) return true;
  return (pa == 0 && is_between(a, p, q)) || (pb == 0 && is_between(b, p, q)) ||
         (ap == 0 && is_between(p, a, b)) || (aq == 0 && is_between(q, a, b));
}

bool coplanar_segment_meets(const Vec3& p3, const Vec3& q3, const Vec3& a3, const Vec3& b3,
                            const Vec3& c3) noexcept {
  const int axis = projection_axis(a3, b3, c3);
  if (axis < 0) return false;
  const Vec2 p = drop_axis(p3, axis), q = drop_axis(q3, axis);
  const Vec2 a = drop_axis(a3, axis), b = drop_axis(b3, axis), c = drop_axis(c3, axis);
  const int turn = orient2d(a, b, c);
  const bool inside = orient2d(a, b, p) * turn >= 0 && orient2d(b, c, p) * turn >= 0 &&
                      orient2d(c, a, p) * turn >= 0;
  return inside || segments_meet(p, q, a, b) || segments_meet(p, q, b, c) ||
         segments_meet(p, q, c, a);
}

// Whether the line of an edge of s has all of t strictly on its outer side. Two convex polygons
// without a common point are parted by such a line of one of them.
bool edge_separates(const std::array<Vec2, 3>& s, const std::array<Vec2, 3>& t) noexcept {
  const int turn = orient2d(s[0], s[1], s[2]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2& p = s[i];
    const Vec2& q = s[(i + 1) % 3];
    if (orient2d(p, q, t[0]) * turn < 0 && orient2d(p, q, t[1]) * turn < 0 &&
        orient2d(p, q, t[2]) * turn < 0)
      return true;
  }
  return false;
}

}  // namespace

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) noexcept {
  const double ax = a.x() - d.x(), ay = a.y() - d.y(), az = a.z() - d.z();
  const double bx = b.x() - d.x(), by = b.y() - d.y(), bz = b.z() - d.z();
  const double cx = c.x() - d.x(), cy = c.y() - d.y(), cz = c.z() - d.z();
  const double bxcy = bx * cy, bycx = by * cx;
  const double cxay = cx * ay, cyax = cy * ax;
  const double axby = ax * by, aybx = ay * bx;
  // Positive when d lies where a, b, c run clockwise, hence the exchange of signs below.
  const double det = az * (bxcy - bycx) + bz * (cxay - cyax) + cz * (axby - aybx);
  const double size = (std::fabs(bxcy) + std::fabs(bycx)) * std::fabs(az) +
                      (std::fabs(cxay) + std::fabs(cyax)) * std::fabs(bz) +
                      (std::fabs(axby) + std::fabs(aybx)) * std::fabs(cz);
  // Shewchuk 1997: the rounding error of det is below (7 + 56 u) u size.
  const double bound = (7.0 + 56.0 * kHalfUlp) * kHalfUlp * size;
  if (det > bound) return -1;
  if (-det > bound) return 1;
  // A plane along two axes, the rule for CAD parts: a column of exact zeros.
  if ((ax == 0.0 && bx == 0.0 && cx == 0.0) || (ay == 0.0 && by == 0.0 && cy == 0.0) ||
      (az == 0.0 && bz == 0.0 && cz == 0.0)) {
    return 0;
  }
  return -orient3d_exact(a, b, c, d);
}

int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) noexcept {
  const double left = (a.x() - c.x()) * (b.y() - c.y());
  const double right = (a.y() - c.y()) * (b.x() - c.x());
  const double det = left - right;
  const double bound = (3.0 + 16.0 * kHalfUlp) * kHalfUlp * (std::fabs(left) + std::fabs(right));
  if (det > bound) return 1;
  if (-det > bound) return -1;
  if ((a.x() == c.x() && b.x() == c.x()) || (a.y() == c.y() && b.y() == c.y())) return 0;
  return orient2d_exact(a, b, c);
}

bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c) noexcept {
  for (int axis = 0; axis < 3; ++axis) {
    if (orient2d(drop_axis(a, axis), drop_axis(b, axis), drop_axis(c, axis)) != 0) return false;
  }
  return true;
}

bool coplanar_triangles_meet(const Vec3& a3, const Vec3& b3, const Vec3& c3, const Vec3& d3,
                             const Vec3& e3, const Vec3& f3) noexcept {
  const int axis = projection_axis(a3, b3, c3);
  if (axis < 0) return false;
  const std::array<Vec2, 3> s = {drop_axis(a3, axis), drop_axis(b3, axis), drop_axis(c3, axis)};
  const std::array<Vec2, 3> t = {drop_axis(d3, axis), drop_axis(e3, axis), drop_axis(f3, axis)};
  return !edge_separates(s, t) && !edge_separates(t, s);
}

bool segment_meets_triangle(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b,
                            const Vec3& c) noexcept {
  const int side_p = orient3d(a, b, c, p);
  const int side_q = orient3d(a, b, c, q);
  if (side_p * side_q > 0) return false;
  if (side_p == 0 && side_q == 0) return coplanar_segment_meets(p, q, a, b, c);
  // The line of the segment crosses the plane in one point, which lies on the segment: is it in the
  // triangle?
  const int ab = orient3d(p, q, a, b);
  const int bc = orient3d(p, q, b, c);
  if (ab * bc < 0) return false;
  const int ca = orient3d(p, q, c, a);
  return ab * ca >= 0 && bc * ca >= 0;
}

}  // namespace thigma
