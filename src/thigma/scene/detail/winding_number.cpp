#include "thigma/scene/detail/winding_number.h"

#include "thigma/math/elementary.h"

namespace thigma::detail {
namespace {

/// Half the solid angle of a triangle seen from the origin, positive from within.
double half_solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  const double below = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
  return arc_tangent2(a.dot(b.cross(c)), below);
}

}  // namespace

double winding_number(const ClodHierarchy& surface, const Vec3& point) {
  double sum = 0.0;
  for (const ClodPatch& patch : surface.patches) {
    const HullView hull = hull_view(surface, patch.node);
    for (int t = 0; t < hull.triangle_count; ++t) {
      const std::uint8_t* corner = hull.triangles[t].corner;
      sum += half_solid_angle(hull.vertices[corner[0]] - point, hull.vertices[corner[1]] - point,
                              hull.vertices[corner[2]] - point);
    }
  }
  return sum / (2.0 * kPi);
}

bool is_inside(const ClodHierarchy& surface, const Vec3& point) {
  constexpr double kInside = 0.75;  // the mouth of an open cup has a half
  return winding_number(surface, point) > kInside;
}

}  // namespace thigma::detail
