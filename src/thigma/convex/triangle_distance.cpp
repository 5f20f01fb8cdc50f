// Triangle distance by features: the closest points of disjoint triangles lie on two edges, or on a
// corner and a face (Ericson 2005, 5.1.10); triangles intersect when an edge of one pierces the
// other. Everything happens about a corner of the first triangle, so that the distance from the
// origin of the frame costs no digits.
#include "thigma/convex/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/convex/detail/simplex.h"

namespace thigma {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Best {
  double squared = kInfinity;
  Vec3 a, b;
  std::uint8_t corners_a = 0, corners_b = 0;  // masks of the features

  void offer(const Vec3& p, const Vec3& q, int ca, int cb) {
    const double d = (p - q).squaredNorm();
    if (d < squared) {
      squared = d;
      a = p;
      b = q;
      corners_a = static_cast<std::uint8_t>(ca);
      corners_b = static_cast<std::uint8_t>(cb);
    }
  }
};

// Closest points of segments (p, p + u) and (q, q + v), of any length. Offers the interior pair;
// pairs with an end of a segment come from `offer_ends`, so nothing is clamped here.
void offer_interior(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v, int ca, int cb,
                    Best& best) {
  const Vec3 n = u.cross(v), r = q - p;
  const double nn = n.squaredNorm();
  if (!(nn > 1e-28 * u.squaredNorm() * v.squaredNorm()))
    return;  // parallel to rounding: ends are as close
  const double s = r.cross(v).dot(n) / nn, t = r.cross(u).dot(n) / nn;
  if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) return;
  // Along the common normal: exact in direction and length where the points are nearly equal.
  const Vec3 offset = n * (r.dot(n) / nn);
  const double d = offset.squaredNorm();
  if (d < best.squared) {
    best.squared = d;
    best.a = p + s * u;
    best.b = best.a + offset;
    best.corners_a = static_cast<std::uint8_t>(ca);
    best.corners_b = static_cast<std::uint8_t>(cb);
  }
}

// Corner p against triangle t: interior and edges. swapped: p is of b.
void offer_corner(const Vec3& p, const Vec3 t[3], int corner, bool swapped, Best& best) {
  int mask = 0;
  double w[3];
  const Vec3 v = detail::nearest_on_triangle(t[0] - p, t[1] - p, t[2] - p, mask, w);
  const double d = v.squaredNorm();
  if (!(d < best.squared)) return;
  best.squared = d;
  best.a = swapped ? Vec3(p + v) : p;
  best.b = swapped ? p : Vec3(p + v);
  best.corners_a = static_cast<std::uint8_t>(swapped ? mask : 1 << corner);
  best.corners_b = static_cast<std::uint8_t>(swapped ? 1 << corner : mask);
}

// Where the edges of `edges` pierce `face`; adds the points to sum.
int pierce(const Vec3 edges[3], const Vec3 face[3], Vec3& sum) {
  const Vec3 n = (face[1] - face[0]).cross(face[2] - face[0]);
  double h[3];
  for (int i = 0; i < 3; ++i) h[i] = n.dot(edges[i] - face[0]);
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    if (!((h[i] < 0.0 && h[j] > 0.0) || (h[i] > 0.0 && h[j] < 0.0))) continue;
    const Vec3 p = edges[i], d = edges[j] - edges[i];
    double side[3];
    for (int k = 0; k < 3; ++k) side[k] = d.dot((face[k] - p).cross(face[k == 2 ? 0 : k + 1] - p));
    const bool inside = (side[0] >= 0.0 && side[1] >= 0.0 && side[2] >= 0.0) ||
                        (side[0] <= 0.0 && side[1] <= 0.0 && side[2] <= 0.0);
    if (!inside) continue;
    sum += p + (h[i] / (h[i] - h[j])) * d;
    ++count;
  }
  return count;
}

// a and b about a local origin.
TriangleDistance local_distance(const Vec3 a[3], const Vec3 b[3], Best& best) {
  TriangleDistance out;
  for (int i = 0; i < 3; ++i) {
    offer_corner(a[i], b, i, false, best);
    offer_corner(b[i], a, i, true, best);
  }
  for (int i = 0; i < 3; ++i) {
    const int i2 = i == 2 ? 0 : i + 1;
    for (int j = 0; j < 3; ++j) {
      const int j2 = j == 2 ? 0 : j + 1;
      offer_interior(a[i], a[i2] - a[i], b[j], b[j2] - b[j], 1 << i | 1 << i2, 1 << j | 1 << j2,
                     best);
    }
  }
  Vec3 sum = Vec3::Zero();
  const int count = pierce(a, b, sum) + pierce(b, a, sum);
  double reach = 0.0;
  for (int i = 0; i < 3; ++i)
    reach = std::max({reach, a[i].lpNorm<Eigen::Infinity>(), b[i].lpNorm<Eigen::Infinity>()});
  const double noise = 0x1.0p-51 * reach;
  out.intersecting = count > 0 || best.squared <= noise * noise;
  out.point_a = best.a;
  out.point_b = best.b;
  out.distance = std::sqrt(best.squared);
  if (out.intersecting) {
    out.distance = 0.0;
    if (count > 0) out.point_a = out.point_b = sum / count;
  }
  return out;
}

struct Box {
  Vec3 low, high;
};

Box box_of(const Vec3 t[3]) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

double squared_distance(const Box& a, const Box& b) {
  const Vec3 gap = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Vec3::Zero());
  return gap.squaredNorm();
}

std::uint32_t hull_mask(const HullTriangle& t, int corners) {
  std::uint32_t mask = 0;
  for (int i = 0; i < 3; ++i) {
    if (corners >> i & 1) mask |= 1u << t.corner[i];
  }
  return mask;
}

int triangle_holding(const HullView& h, std::uint32_t feature) {
  for (int i = 0; i < h.triangle_count; ++i) {
    if ((feature & ~h.triangles[i].mask) == 0) return i;
  }
  return -1;
}

void measure_triangles(const HullView& a, const HullView& b, const RelativePose& x, double stop,
                       PatchSeparation& out) {
  const Vec3 origin = a.center;
  Vec3 pb[kMaxHullVertices];
  for (int i = 0; i < b.vertex_count; ++i)
    pb[i] = x.rotation * b.vertices[i] + (x.translation - origin);
  // The limit with a margin for the rounding of the boxes: a pair at exactly `stop` must be
  // measured.
  double limit = stop < kInfinity ? stop * stop * (1.0 + 1e-12) : kInfinity;
  Vec3 sum = Vec3::Zero();
  int hits = 0;
  for (int i = 0; i < a.triangle_count; ++i) {
    Vec3 ta[3], tb[3];
    for (int k = 0; k < 3; ++k) ta[k] = a.vertices[a.triangles[i].corner[k]] - origin;
    const Box box_a = box_of(ta);
    for (int j = 0; j < b.triangle_count; ++j) {
      for (int k = 0; k < 3; ++k) tb[k] = pb[b.triangles[j].corner[k]];
      if (squared_distance(box_a, box_of(tb)) > limit) continue;
      ++out.triangle_pairs;
      Best best;
      const TriangleDistance d = local_distance(ta, tb, best);
      if (d.intersecting) {
        sum += d.point_a;
        ++hits;
        limit = 0.0;
      }
      const double squared = d.distance * d.distance;
      if (hits > (d.intersecting ? 1 : 0) || squared > limit) continue;
      limit = squared;
      out.triangle_a = i;
      out.triangle_b = j;
      out.distance = d.distance;
      out.point_a = d.point_a + origin;
      out.point_b = d.point_b + origin;
      out.feature_a = hull_mask(a.triangles[i], best.corners_a);
      out.feature_b = hull_mask(b.triangles[j], best.corners_b);
    }
  }
  out.intersecting = hits > 0;
  if (hits == 0) return;
  out.distance = 0.0;
  out.point_a = out.point_b = sum / hits + origin;
}

}  // namespace

TriangleDistance triangle_distance(const Vec3 a[3], const Vec3 b[3]) noexcept {
  const Vec3 origin = a[0];
  const Vec3 la[3] = {Vec3::Zero(), a[1] - origin, a[2] - origin};
  const Vec3 lb[3] = {b[0] - origin, b[1] - origin, b[2] - origin};
  Best best;
  TriangleDistance out = local_distance(la, lb, best);
  out.point_a += origin;
  out.point_b += origin;
  return out;
}

PatchSeparation patch_separation(const HullView& a, const HullView& b, const RelativePose& x,
                                 double stop, GjkCache& cache) noexcept {
  PatchSeparation out;
  const Separation hulls = closest_points(a, b, x, stop, cache);
  out.distance = hulls.distance;
  if (hulls.distance > stop) return out;
  if (hulls.status == PairStatus::separated) {
    out.triangle_a = triangle_holding(a, hulls.feature_a);
    out.triangle_b = triangle_holding(b, hulls.feature_b);
    if (out.triangle_a >= 0 && out.triangle_b >= 0) {
      out.point_a = hulls.witness_a;
      out.point_b = hulls.witness_b;
      out.feature_a = hulls.feature_a;
      out.feature_b = hulls.feature_b;
      return out;
    }
  }
  out.triangle_a = out.triangle_b = -1;
  out.distance = std::max(hulls.distance, std::nextafter(stop, kInfinity));
  measure_triangles(a, b, x, stop, out);
  return out;
}

}  // namespace thigma
