#include "thigma/contact/detail/support_sets.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <emmintrin.h>

namespace thigma::detail {
namespace {

// How far inside an edge or a triangle a closest point has to lie (barycentric) and how far from
// parallel edges are.
constexpr double kInside = 1e-7;
constexpr double kCrossing = 1e-8;
// Faces with more vertices are not looked through for a triangle below a point.
constexpr int kMaxFaceVertices = 6;

// Closest points, relative to the centre of a.
struct Closest {
  Vec3 p, q;
};

int lowest(std::uint32_t mask) noexcept { return std::countr_zero(mask); }
int highest(std::uint32_t mask) noexcept { return 31 - std::countl_zero(mask); }

bool is_original_edge(const HullView& hull, std::uint32_t mask) noexcept {
  for (int t = 0; t < hull.triangle_count; ++t) {
    if ((hull.triangles[t].mask & mask) == mask) return true;
  }
  return false;
}

bool on_segment(const Vec3& p, const Vec3& s0, const Vec3& s1, Vec3& q) noexcept {
  const Vec3 e = s1 - s0;
  const double length2 = e.squaredNorm();
  const double t = (p - s0).dot(e);
  if (!(t > kInside * length2 && t < (1.0 - kInside) * length2)) return false;
  q = s0 + (t / length2) * e;
  return true;
}

bool on_triangle(const Vec3& p, const Vec3& c0, const Vec3& c1, const Vec3& c2, Vec3& q) noexcept {
  const Vec3 n = (c1 - c0).cross(c2 - c0);
  const double area2 = n.squaredNorm();
  const double u = (c2 - c1).cross(p - c1).dot(n);
  const double v = (c0 - c2).cross(p - c2).dot(n);
  const double w = (c1 - c0).cross(p - c0).dot(n);
  const double least = kInside * area2;
  if (!(u > least && v > least && w > least)) return false;
  q = p - ((p - c0).dot(n) / area2) * n;
  return true;
}

bool between_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1,
                      Closest& c) noexcept {
  const Vec3 d1 = p1 - p0, d2 = q1 - q0, r = p0 - q0;
  const double a = d1.squaredNorm(), e = d2.squaredNorm(), b = d1.dot(d2);
  const double cross2 = d1.cross(d2).squaredNorm();  // = a e - b b, without its cancellation
  if (!(cross2 > kCrossing * a * e)) return false;
  const double f = d2.dot(r), g = d1.dot(r);
  const double s = (b * f - g * e) / cross2;
  const double t = (a * f - b * g) / cross2;
  if (!(s > kInside && s < 1.0 - kInside && t > kInside && t < 1.0 - kInside)) return false;
  c = {p0 + s * d1, q0 + t * d2};
  return true;
}

// Vertices that span an edge or a face of a hull.
struct HullFeature {
  const HullView& hull;
  std::uint32_t mask;
  Features features;  // that count
};

// Point p against an edge or a face of a hull whose vertices `at` gives.
template <class At>
bool below_point(const HullFeature& feature, const Vec3& p, At at, Vec3& q) noexcept {
  const HullView& hull = feature.hull;
  std::uint32_t mask = feature.mask;
  const bool is_real = feature.features == Features::real;
  if (std::popcount(mask) == 2) {
    return (!is_real || is_original_edge(hull, mask)) &&
           on_segment(p, at(lowest(mask)), at(highest(mask)), q);
  }
  if (is_real) {
    for (int t = 0; t < hull.triangle_count; ++t) {
      const HullTriangle& tri = hull.triangles[t];
      if ((tri.mask & mask) != tri.mask) continue;
      if (on_triangle(p, at(tri.corner[0]), at(tri.corner[1]), at(tri.corner[2]), q)) return true;
    }
    return false;
  }
  // Any three vertices of the face that lie around the point.
  if (std::popcount(mask) > kMaxFaceVertices) return false;
  int vertex[kMaxFaceVertices], count = 0;
  for (; mask != 0; mask &= mask - 1) vertex[count++] = lowest(mask);
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      for (int k = j + 1; k < count; ++k) {
        if (on_triangle(p, at(vertex[i]), at(vertex[j]), at(vertex[k]), q)) return true;
      }
    }
  }
  return false;
}

// Closest points of the features that two vertex sets span; false where there is no single one.
bool closest_of_sets(const Placement& place, std::uint32_t ma, std::uint32_t mb, Features features,
                     Closest& c) noexcept {
  const int na = std::popcount(ma), nb = std::popcount(mb);
  if (na == 0 || nb == 0) return false;
  const auto of_a = [&](int i) { return place.of_a(i); };
  const auto of_b = [&](int i) { return place.of_b(i); };
  if (na == 1) c.p = place.of_a(lowest(ma));
  if (nb == 1) c.q = place.of_b(lowest(mb));
  if (na == 1 && nb == 1) return true;
  if (na == 1) return below_point({place.b, mb, features}, c.p, of_b, c.q);
  if (nb == 1) return below_point({place.a, ma, features}, c.q, of_a, c.p);
  if (na != 2 || nb != 2) return false;
  if (features == Features::real &&
      !(is_original_edge(place.a, ma) && is_original_edge(place.b, mb)))
    return false;
  return between_segments(place.of_a(lowest(ma)), place.of_a(highest(ma)), place.of_b(lowest(mb)),
                          place.of_b(highest(mb)), c);
}

// Of heights in single precision, times the radius.
constexpr double kFloatRounding = 2e-6;

// Vertices of a hull that may be higher than `least` along n, a mask. Four a step.
std::uint32_t maybe_above(const HullView& hull, const Vec3& n, double least) noexcept {
  const __m128 nx = _mm_set1_ps(static_cast<float>(n.x())),
               ny = _mm_set1_ps(static_cast<float>(n.y())),
               nz = _mm_set1_ps(static_cast<float>(n.z()));
  const __m128 limit = _mm_set1_ps(static_cast<float>(least - kFloatRounding * hull.radius));
  const float* const x = hull.lanes;
  const float* const y = x + hull.lane_count;
  const float* const z = y + hull.lane_count;
  std::uint32_t mask = 0;
  for (int i = 0; i < hull.lane_count; i += 4) {
    const __m128 height = _mm_add_ps(
        _mm_add_ps(_mm_mul_ps(nx, _mm_load_ps(x + i)), _mm_mul_ps(ny, _mm_load_ps(y + i))),
        _mm_mul_ps(nz, _mm_load_ps(z + i)));
    mask |= static_cast<std::uint32_t>(_mm_movemask_ps(_mm_cmpge_ps(height, limit))) << i;
  }
  return mask & (0xffffffffu >> (kMaxHullVertices - hull.vertex_count));
}

// Which vertices of a hull are higher than `least` along n, a mask, and the height of the highest
// where it is above `top`, which is no lower than `least`. Single precision rejects most; the rest
// is decided in double.
std::uint32_t vertices_above(const HullView& hull, const Vec3& n, double least,
                             double& top) noexcept {
  std::uint32_t mask = 0;
  for (std::uint32_t left = maybe_above(hull, n, least); left != 0; left &= left - 1) {
    // About the centre: far from the origin of the body heights would lose their digits.
    const Vec3 p = hull.vertices[lowest(left)] - hull.center;
    const double height = p.x() * n.x() + p.y() * n.y() + p.z() * n.z();
    top = std::max(top, height);
    if (height > least) mask |= left & (0u - left);
  }
  return mask;
}

// The sets, and how far the hulls reach beyond the planes through p and q, at most [m].
SupportSets support_along(const Placement& place, const Vec3& n, const Vec3& p, const Vec3& q,
                          double& reach) noexcept {
  const double hair = kActive * place.size;
  const double top = n.dot(p);
  const Vec3 back = -(place.pose.rotation.transpose() * n);
  const double bottom = n.dot(place.offset) - n.dot(q);
  double highest_a = top, highest_b = bottom;
  SupportSets sets;
  sets.a = vertices_above(place.a, n, top - hair, highest_a);
  sets.b = vertices_above(place.b, back, bottom - hair, highest_b);
  reach = std::max(highest_a - top, highest_b - bottom);
  return sets;
}

}  // namespace

SupportSets support_sets(const Placement& place, const Vec3& p, const Vec3& q) noexcept {
  double reach = 0.0;
  const Vec3 w = q - p;
  return support_along(place, w / std::sqrt(w.squaredNorm()), p, q, reach);
}

bool closest_by_support(const Placement& place, const SupportSets& sets, Features features,
                        SupportedDistance& out) noexcept {
  Closest c;
  if (!closest_of_sets(place, sets.a, sets.b, features, c)) return false;
  const Vec3 w = c.q - c.p;
  const double distance = std::sqrt(w.squaredNorm());
  if (!(distance > kNear * place.size)) return false;
  const Vec3 n = w / distance;
  double reach = 0.0;
  const SupportSets found = support_along(place, n, c.p, c.q, reach);
  if (found.a != sets.a || found.b != sets.b || reach > kActive * place.size) return false;
  out = {distance, c.p, c.q, n};
  return true;
}

}  // namespace thigma::detail
