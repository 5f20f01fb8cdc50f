#include "thigma/simplify/resolution.h"

#include <cmath>
#include <limits>

namespace thigma {

double projected_length(const Vec3& edge, const Vec3& n) {
  const double length = edge.norm(), size = n.norm();
  if (!(size > 0.0)) return length;
  const Vec3 unit = n / size;
  const double projected = (edge - edge.dot(unit) * unit).norm();
  return projected > 1e-12 * length ? projected : 0.0;
}

double edge_resolution(const Vec3& v1, const Vec3& v2, const Vec3& n) {
  const double length = projected_length(v1 - v2, n);
  return length > 0.0 ? 1.0 / length : std::numeric_limits<double>::infinity();
}

}  // namespace thigma
