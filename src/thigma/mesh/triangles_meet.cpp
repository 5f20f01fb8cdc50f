#include "thigma/mesh/triangles_meet.h"

#include <cmath>
#include <utility>

#include "thigma/mesh/predicates.h"

namespace thigma {
namespace {

using Triangle = std::array<std::int32_t, 3>;
using Points = std::span<const Vec3>;

const Vec3& at(Points s, std::int32_t v) { return s[static_cast<std::size_t>(v)]; }

bool segment_meets(Points s, std::int32_t p, std::int32_t q, const Triangle& t) {
  return segment_meets_triangle(at(s, p), at(s, q), at(s, t[0]), at(s, t[1]), at(s, t[2]));
}

// Both turned so that the shared vertices come first; returns their number.
int align_shared(Triangle& a, Triangle& b) {
  int shared = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = static_cast<std::size_t>(shared); j < 3; ++j) {
      if (a[i] != b[j]) continue;
      std::swap(a[i], a[static_cast<std::size_t>(shared)]);
      std::swap(b[j], b[static_cast<std::size_t>(shared)]);
      ++shared;
      break;
    }
  }
  return shared;
}

// Two triangles on one edge overlap when they are coplanar with their third corners on the same
// side of it.
bool share_edge_and_overlap(Points s, const Triangle& a, const Triangle& b) {
  if (orient3d(at(s, a[0]), at(s, a[1]), at(s, a[2]), at(s, b[2])) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const auto flat = [&](std::int32_t v) {
      return Vec2(at(s, v)[(axis + 1) % 3], at(s, v)[(axis + 2) % 3]);
    };
    const int side = orient2d(flat(a[0]), flat(a[1]), flat(a[2]));
    if (side != 0) return side == orient2d(flat(b[0]), flat(b[1]), flat(b[2]));
  }
  return false;
}

// Sides of the plane of a on which b's corners lie.
std::array<int, 3> sides(Points s, const Triangle& a, const Triangle& b) {
  std::array<int, 3> side{};
  for (std::size_t k = 0; k < 3; ++k)
    side[k] = orient3d(at(s, a[0]), at(s, a[1]), at(s, a[2]), at(s, b[k]));
  return side;
}

bool is_one_side(const std::array<int, 3>& side) {
  return side[0] != 0 && side[0] == side[1] && side[0] == side[2];
}

// Times the lengths that span a height: below it the side of a plane is likely to need exact
// arithmetic.
constexpr double kNearlyCoplanar = 1e-12;

bool are_nearly_coplanar(Points s, const Triangle& a, const Triangle& b) {
  const Vec3& p = at(s, a[0]);
  const Vec3 u = at(s, a[1]) - p, v = at(s, a[2]) - p, n = u.cross(v);
  const double most = kNearlyCoplanar * u.lpNorm<1>() * v.lpNorm<1>();
  for (const std::int32_t corner : b) {
    const Vec3 w = at(s, corner) - p;
    if (std::fabs(n.dot(w)) > most * w.lpNorm<1>()) return false;
  }
  return true;
}

bool disjoint_corners_meet(Points s, const Triangle& a, const Triangle& b) {
  // In surfaces that were squashed flat nearly all pairs lie beside each other, and exact sides of
  // their planes are dear. What does not meet seen along an axis does not meet.
  if (are_nearly_coplanar(s, a, b) &&
      !coplanar_triangles_meet(at(s, a[0]), at(s, a[1]), at(s, a[2]), at(s, b[0]), at(s, b[1]),
                               at(s, b[2])))
    return false;
  const std::array<int, 3> of_b = sides(s, a, b);
  if (is_one_side(of_b)) return false;
  if (of_b == std::array<int, 3>{0, 0, 0}) {
    return coplanar_triangles_meet(at(s, a[0]), at(s, a[1]), at(s, a[2]), at(s, b[0]), at(s, b[1]),
                                   at(s, b[2]));
  }
  if (is_one_side(sides(s, b, a))) return false;
  for (std::size_t k = 0; k < 3; ++k) {
    if (segment_meets(s, a[k], a[(k + 1) % 3], b) || segment_meets(s, b[k], b[(k + 1) % 3], a))
      return true;
  }
  return false;
}

}  // namespace

bool triangles_meet(std::span<const Vec3> positions, std::array<std::int32_t, 3> a,
                    std::array<std::int32_t, 3> b) {
  switch (align_shared(a, b)) {
    case 3:
      return true;
    case 2:
      return share_edge_and_overlap(positions, a, b);
    case 1:
      // The common part is convex and holds the shared vertex; if it is more, it reaches the edge
      // across from that vertex in one of the two.
      return segment_meets(positions, a[1], a[2], b) || segment_meets(positions, b[1], b[2], a);
    default:
      break;
  }
  return disjoint_corners_meet(positions, a, b);
}

}  // namespace thigma
