#include "thigma/simplify/quadric.h"

#include <Eigen/Cholesky>

namespace thigma {

Quadric plane_quadric(const Vec3& normal, const Vec3& point, double weight) {
  const double offset = normal.dot(point);
  return {weight * normal * normal.transpose(), weight * offset * normal, weight * offset * offset};
}

double evaluate(const Quadric& q, const Vec3& p) { return p.dot(q.a * p) - 2.0 * q.b.dot(p) + q.c; }

Vec3 minimize(const Quadric& q, const Vec3& near) {
  const double size = q.a.trace();
  if (!(size > 0.0)) return near;
  // 1e-4 of the trace: directions that curve a hundred times less than the sharpest stay with
  // `near`.
  const Mat3 damped = q.a + 1e-4 * size * Mat3::Identity();
  const Vec3 step = damped.ldlt().solve(q.b - q.a * near);
  return step.allFinite() ? Vec3(near + step) : near;
}

}  // namespace thigma
