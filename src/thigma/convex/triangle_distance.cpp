// Triangle distance by features: the closest points of disjoint triangles lie on two edges, or on a
// corner and a face (Ericson 2005, 5.1.10); triangles intersect when an edge of one pierces the
// other. Everything happens about a corner of the first triangle, so that the distance from the
// origin of the frame costs no digits.
#include "thigma/convex/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

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
  // The lines' distance bounds that of the segments; most pairs end here.
  const double along = r.dot(n);
  if (along * along > best.squared * nn * (1.0 + 1e-12)) return;
  const double s = r.cross(v).dot(n) / nn, t = r.cross(u).dot(n) / nn;
  if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) return;
  // Along the common normal: exact in direction and length where the points are nearly equal.
  const Vec3 offset = n * (along / nn);
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

// The least distance by features; blind to edges that pierce faces. best: nothing farther is offered.
void offer_features(const Vec3 a[3], const Vec3 b[3], Best& best) {
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
}

double reach_of(const Vec3 a[3], const Vec3 b[3]) {
  double reach = 0.0;
  for (int i = 0; i < 3; ++i)
    reach = std::max({reach, a[i].lpNorm<Eigen::Infinity>(), b[i].lpNorm<Eigen::Infinity>()});
  return reach;
}

// a and b about a local origin.
TriangleDistance local_distance(const Vec3 a[3], const Vec3 b[3], Best& best) {
  TriangleDistance out;
  Vec3 sum = Vec3::Zero();
  const int count = pierce(a, b, sum) + pierce(b, a, sum);
  if (count > 0) {
    out.intersecting = true;
    out.point_a = out.point_b = sum / count;
    return out;
  }
  offer_features(a, b, best);
  const double noise = 0x1.0p-51 * reach_of(a, b);
  out.intersecting = best.squared <= noise * noise;
  out.point_a = best.a;
  out.point_b = best.b;
  out.distance = out.intersecting ? 0.0 : std::sqrt(best.squared);
  return out;
}

struct Box {
  Vec3 low, high;
};

Box box_of(const Vec3 t[3]) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

Box empty_box() { return {Vec3::Constant(kInfinity), Vec3::Constant(-kInfinity)}; }

Box joined(const Box& a, const Box& b) { return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)}; }

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

// A triangle with what rejects most pairs before they are measured.
struct Placed {
  Vec3 p[3];
  Vec3 normal;  // not normalized; may be zero
  double inverse_squared = 0.0;  // 1 / |normal|^2, 0 without one
  Box box;
};

Placed placed(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  Placed t{{p0, p1, p2}, (p1 - p0).cross(p2 - p0), 0.0, {}};
  const double squared = t.normal.squaredNorm();
  if (squared > 0.0) t.inverse_squared = 1.0 / squared;
  t.box = box_of(t.p);
  return t;
}

// Squared distance that the plane of t keeps the triangle `other` away, at least; 0 when it crosses it.
double plane_gap(const Placed& t, const Placed& other) {
  double h[3];
  for (int i = 0; i < 3; ++i) h[i] = t.normal.dot(other.p[i] - t.p[0]);
  const double low = std::min({h[0], h[1], h[2]}), high = std::max({h[0], h[1], h[2]});
  const double gap = low > 0.0 ? low : high < 0.0 ? high : 0.0;
  return gap * gap * t.inverse_squared;
}

// All triangle pairs of two patches, about a local origin.
class TrianglePairs {
 public:
  TrianglePairs(const HullView& a, const HullView& b, const RelativePose& x) : a_(a), b_(b), origin_(a.center) {
    const Vec3 shift = x.translation - origin_;
    for (int i = 0; i < a.vertex_count; ++i) pa_[i] = a.vertices[i] - origin_;
    for (int i = 0; i < b.vertex_count; ++i) pb_[i] = x.rotation * b.vertices[i] + shift;
    count_a_ = place(a, pa_, placed_a_, used_a_);
    count_b_ = place(b, pb_, placed_b_, used_b_);
    box_a_ = box_around(placed_a_, count_a_);
    box_b_ = box_around(placed_b_, count_b_);
  }

  // Where triangles pierce each other: one pass that needs no distances.
  bool intersect(PatchSeparation& out) {
    Vec3 sum = Vec3::Zero();
    int hits = 0;
    const Near near(*this, 0.0);
    for (const std::uint8_t i : near.of_a()) {
      const Placed& ta = placed_a_[i];
      for (const std::uint8_t j : near.of_b()) {
        const Placed& tb = placed_b_[j];
        if (squared_distance(ta.box, tb.box) > 0.0 || plane_gap(ta, tb) > 0.0 || plane_gap(tb, ta) > 0.0) continue;
        ++out.triangle_pairs;
        Vec3 points = Vec3::Zero();
        const int count = pierce(ta.p, tb.p, points) + pierce(tb.p, ta.p, points);
        if (count == 0) continue;
        if (hits++ == 0) keep(i, j, 0, 0, out);
        sum += points / count;
      }
    }
    if (hits == 0) return false;
    meet(sum / hits, out);
    return true;
  }

  // The least distance; triangles that only touch intersect as well.
  void measure(double stop, PatchSeparation& out) {
    // With a margin for the rounding of the bounds: a pair at exactly `stop` must be measured.
    constexpr double kMargin = 1.0 + 1e-12;
    double limit = stop < kInfinity ? stop * stop * kMargin : kInfinity;
    limit = std::min(limit, least_corner_distance() * kMargin);
    Vec3 sum = Vec3::Zero();
    int touches = 0;
    const Near near(*this, limit * kMargin);
    for (const std::uint8_t i : near.of_a()) {
      const Placed& ta = placed_a_[i];
      for (const std::uint8_t j : near.of_b()) {
        const Placed& tb = placed_b_[j];
        const double bound = limit * kMargin;
        if (squared_distance(ta.box, tb.box) > bound || plane_gap(ta, tb) > bound || plane_gap(tb, ta) > bound) continue;
        ++out.triangle_pairs;
        Best best;
        offer_features(ta.p, tb.p, best);
        const double noise = 0x1.0p-51 * reach_of(ta.p, tb.p);
        if (best.squared <= noise * noise) {
          if (touches++ == 0) keep(i, j, best.corners_a, best.corners_b, out);
          sum += best.a;
          limit = 0.0;
        } else if (touches == 0 && best.squared <= limit) {
          limit = best.squared;
          keep(i, j, best.corners_a, best.corners_b, out);
          out.distance = std::sqrt(best.squared);
          out.point_a = best.a + origin_;
          out.point_b = best.b + origin_;
        }
      }
    }
    if (touches > 0) meet(sum / touches, out);
  }

 private:
  // A surface patch on at most 32 hull vertices has at most 60 triangles.
  static constexpr int kMost = 2 * kMaxHullVertices;

  // The triangles of each side, in order, whose boxes come within a squared distance of the box around the other side:
  // of large patches that meet at a corner, a few.
  class Near {
   public:
    Near(const TrianglePairs& pairs, double bound) {
      // The second side against what is left of the first.
      Box left = empty_box();
      for (int i = 0; i < pairs.count_a_; ++i) {
        if (squared_distance(pairs.placed_a_[i].box, pairs.box_b_) > bound) continue;
        a_[count_a_++] = static_cast<std::uint8_t>(i);
        left = joined(left, pairs.placed_a_[i].box);
      }
      for (int j = 0; count_a_ > 0 && j < pairs.count_b_; ++j) {
        if (squared_distance(left, pairs.placed_b_[j].box) <= bound) b_[count_b_++] = static_cast<std::uint8_t>(j);
      }
    }
    std::span<const std::uint8_t> of_a() const { return {a_, count_a_}; }
    std::span<const std::uint8_t> of_b() const { return {b_, count_b_}; }

   private:
    std::uint8_t a_[kMost], b_[kMost];
    std::size_t count_a_ = 0, count_b_ = 0;
  };

  static Box box_around(const Placed* triangles, int count) {
    Box box = empty_box();
    for (int i = 0; i < count; ++i) box = joined(box, triangles[i].box);
    return box;
  }

  static int place(const HullView& h, const Vec3* p, Placed* out, std::uint32_t& used) {
    const int count = std::min(h.triangle_count, kMost);
    for (int i = 0; i < count; ++i) {
      const std::uint8_t* c = h.triangles[i].corner;
      out[i] = placed(p[c[0]], p[c[1]], p[c[2]]);
      used |= h.triangles[i].mask;
    }
    return count;
  }

  // Squared; bounds the distance of the triangles from above, which spares most pairs.
  double least_corner_distance() const {
    double least = kInfinity;
    for (int i = 0; i < a_.vertex_count; ++i) {
      if ((used_a_ >> i & 1u) == 0) continue;
      for (int j = 0; j < b_.vertex_count; ++j) {
        if ((used_b_ >> j & 1u) != 0) least = std::min(least, (pa_[i] - pb_[j]).squaredNorm());
      }
    }
    return least;
  }

  void keep(int i, int j, int corners_a, int corners_b, PatchSeparation& out) const {
    out.triangle_a = i;
    out.triangle_b = j;
    out.feature_a = hull_mask(a_.triangles[i], corners_a);
    out.feature_b = hull_mask(b_.triangles[j], corners_b);
  }

  void meet(const Vec3& point, PatchSeparation& out) const {
    out.intersecting = true;
    out.distance = 0.0;
    out.point_a = out.point_b = point + origin_;
  }

  const HullView& a_;
  const HullView& b_;
  Vec3 origin_;
  Vec3 pa_[kMaxHullVertices], pb_[kMaxHullVertices];
  std::uint32_t used_a_ = 0, used_b_ = 0;  // hull vertices that are corners
  Placed placed_a_[kMost], placed_b_[kMost];
  Box box_a_, box_b_;
  int count_a_ = 0, count_b_ = 0;
};

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
  TrianglePairs pairs(a, b, x);
  // Triangles of disjoint hulls do not intersect.
  if (hulls.status == PairStatus::separated || !pairs.intersect(out)) pairs.measure(stop, out);
  return out;
}

}  // namespace thigma
