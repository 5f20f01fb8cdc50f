#pragma once
// Sums of squared distances to planes: where a collapsed edge starts from (Sec. 3.3.4 step 2).

#include "thigma/math/types.h"

namespace thigma {

/// Q(p) = p^T A p - 2 b . p + c, a weighted sum of squared distances to planes.
struct Quadric {
  Mat3 a = Mat3::Zero();
  Vec3 b = Vec3::Zero();
  double c = 0.0;

  Quadric& operator+=(const Quadric& other) {
    a += other.a;
    b += other.b;
    c += other.c;
    return *this;
  }
};

/// weight times the squared distance to the plane through `point` with unit `normal`.
Quadric plane_quadric(const Vec3& normal, const Vec3& point, double weight);

/// Value at p; up to rounding not negative.
double evaluate(const Quadric& q, const Vec3& p);

/// Point of least value, drawn to `near` in the directions in which the value hardly changes: a
/// flat or singly curved neighbourhood leaves those open.
///
/// near    returned when the quadric is zero [m]
/// Thread  [offline]; no failure. Source Garland and Heckbert 1997.
Vec3 minimize(const Quadric& q, const Vec3& near);

}  // namespace thigma
