#include "thigma/convex/patch_separation.h"

#include <algorithm>
#include <cmath>

#include "thigma/convex/detail/corners.h"
#include "thigma/convex/detail/triangle_features.h"
#include "thigma/math/infinity.h"

// Pairs of triangles are left out by masks of hull vertices: a triangle all of whose corners are
// beyond one face of a box, or on one side of another's plane. What is left is measured feature by
// feature, but for features that are too far apart along the line of the closest points of a first
// guess. Everything happens about the centre of a.

namespace thigma {
namespace {

using detail::Box;
using detail::Corners;
using detail::PlacedTriangle;
using detail::Sides;

// A bound on squared distances that is too small by rounding must not leave out the pair it came
// from.
constexpr double kMargin = 1.0 + 1e-12;
// Of the distance from which on pairs are left out, by the size of the pair: far above the rounding
// of a plane's height, so that what is kept does not depend on how well the first guess was.
constexpr double kRounding = 1e-10;

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

// A triangle that may be near the other patch.
struct NearTriangle {
  int index;
  std::uint32_t mask;
  PlacedTriangle triangle;
  Box box;
  Sides others;  // corners of the other patch against its plane

  NearTriangle() noexcept {}  // set when it is found to be near: most never are
};

// Masks of hull vertices of the two patches.
struct CornerMasks {
  std::uint32_t a = 0, b = 0;
};

// The triangles of one patch that may come within a reach of the other.
struct NearTriangles {
  // A surface patch on at most 32 hull vertices has at most 60 triangles.
  static constexpr int kMost = 2 * kMaxHullVertices;
  NearTriangle triangle[kMost];
  int count = 0;
  std::uint32_t corners = 0;  // of all of them

  const NearTriangle* begin() const { return triangle; }
  const NearTriangle* end() const { return triangle + count; }
};

PlacedTriangle placed(const Corners& c, const HullTriangle& t) {
  return detail::place_triangle(c[t.corner[0]], c[t.corner[1]], c[t.corner[2]]);
}

Box grown(const Box& box, double by) {
  return {box.low - Vec3::Constant(by), box.high + Vec3::Constant(by)};
}

// One patch of a pair.
struct Patch {
  const HullView& hull;
  Corners corners;
  std::uint32_t used = 0;  // vertices that are corners of triangles
  int triangle_count = 0;

  explicit Patch(const HullView& h)
      : hull(h), triangle_count(std::min(h.triangle_count, NearTriangles::kMost)) {
    for (int i = 0; i < triangle_count; ++i) used |= h.triangles[i].mask;
  }
};

// some: of the corners; a triangle without one of them is left out.
void find_near(const Patch& patch, const Box& other, double reach, std::uint32_t some,
               NearTriangles& near) {
  const detail::BoxSides sides = sides_of(patch.corners, grown(other, reach));
  for (int i = 0; i < patch.triangle_count; ++i) {
    const HullTriangle& t = patch.hull.triangles[i];
    if ((t.mask & some) == 0 || !sides.may_meet(t.mask)) continue;
    NearTriangle& n = near.triangle[near.count++];
    n.index = i;
    n.mask = t.mask;
    near.corners |= t.mask;
  }
}

// Places the triangles, and drops those whose plane has all that is left of the other patch on one
// side.
void drop_by_planes(const Patch& patch, const Patch& other, std::uint32_t others, double reach,
                    NearTriangles& near) {
  int kept = 0;
  near.corners = 0;
  for (int i = 0; i < near.count; ++i) {
    NearTriangle& n = near.triangle[i];
    n.triangle = placed(patch.corners, patch.hull.triangles[n.index]);
    const double margin =
        reach > 0.0 ? reach * std::sqrt(n.triangle.normal.squaredNorm()) * kMargin : 0.0;
    n.others = sides_of(other.corners, n.triangle.normal, n.triangle.p[0], margin);
    if (!n.others.straddles(others)) continue;
    n.box = detail::box_of(n.triangle.p);
    near.corners |= n.mask;
    if (kept != i) near.triangle[kept] = n;
    ++kept;
  }
  near.count = kept;
}

// Squared distance that the plane of t keeps the triangle `other` away, at least; 0 when it crosses
// it.
double plane_gap(const PlacedTriangle& t, const PlacedTriangle& other) {
  const double h[3] = {t.height(other.p[0]), t.height(other.p[1]), t.height(other.p[2])};
  const double low = std::min({h[0], h[1], h[2]}), high = std::max({h[0], h[1], h[2]});
  const double gap = low > 0.0 ? low : high < 0.0 ? high : 0.0;
  return gap * gap * t.inverse_squared;
}

// All triangle pairs of two patches.
class TrianglePairs {
 public:
  explicit TrianglePairs(const HullPair& pair) : a_(pair.a), b_(pair.b), origin_(pair.a.center) {
    const HullView &a = pair.a, &b = pair.b;
    const RelativePose& x = pair.a_from_b;
    place_corners(a, origin_, a_.corners);
    place_corners(b, x, origin_, b_.corners);
    size_ = a.radius + b.radius + (x.rotation * b.center + x.translation - origin_).lpNorm<1>();
  }

  bool has_triangles() const { return a_.used != 0 && b_.used != 0; }

  // Where triangles pierce each other: one pass that needs no distances.
  bool intersect(PatchSeparation& out) {
    find_pairs(0.0, {~0u, ~0u});
    Vec3 sum = Vec3::Zero();
    CornerMasks met;
    int hits = 0;
    for (const NearTriangle& a : near_a_) {
      for (const NearTriangle& b : near_b_) {
        if (!a.others.straddles(b.mask) || !b.others.straddles(a.mask) ||
            squared_distance(a.box, b.box) > 0.0)
          continue;
        ++out.triangle_pairs;
        Vec3 points = Vec3::Zero();
        const int count =
            pierce(a.triangle.p, b.triangle, points) + pierce(b.triangle.p, a.triangle, points);
        if (count == 0) continue;
        if (hits++ == 0) keep(a.index, b.index, 0, 0, out);
        met.a |= a.mask;
        met.b |= b.mask;
        sum += points / count;
      }
    }
    if (hits == 0) return false;
    meet(sum / hits, met, out);
    return true;
  }

  // The least distance; triangles that only touch intersect as well.
  void measure(double stop, const TriangleHint& hint, PatchSeparation& out) {
    const double farthest = stop + kRounding * size_;
    Vec3 line;
    double limit = std::min(farthest * farthest, guess(hint, line));
    const Levels levels(*this, line);
    double most = levels.gap(limit);
    find_pairs(std::sqrt(limit * kMargin), levels.near(most));
    Vec3 sum = Vec3::Zero();
    CornerMasks met;
    int touches = 0;
    for (const NearTriangle& a : near_a_) {
      for (const NearTriangle& b : near_b_) {
        if (!a.others.straddles(b.mask) || !b.others.straddles(a.mask)) continue;
        detail::CornerHeights along;
        if (!levels.may_be_nearer(a, b, most, along)) continue;
        const double bound = limit * kMargin;
        if (squared_distance(a.box, b.box) > bound || plane_gap(a.triangle, b.triangle) > bound ||
            plane_gap(b.triangle, a.triangle) > bound)
          continue;
        ++out.triangle_pairs;
        const double noise = touch_distance(a.triangle, b.triangle);
        detail::ClosestFeatures best;
        best.squared = std::max(bound, 2.0 * noise * noise);
        offer_features(a.triangle, b.triangle, along, best);
        if (best.corners_a == 0) continue;
        if (best.squared <= noise * noise) {
          if (touches++ == 0) keep(a.index, b.index, best.corners_a, best.corners_b, out);
          met.a |= a.mask;
          met.b |= b.mask;
          sum += best.a;
          limit = 0.0;
          most = levels.gap(limit);
        } else if (touches == 0 && best.squared <= limit) {
          limit = best.squared;
          most = levels.gap(limit);
          keep(a.index, b.index, best.corners_a, best.corners_b, out);
          out.distance = std::sqrt(best.squared);
          out.point_a = best.a + origin_;
          out.point_b = best.b + origin_;
        }
      }
    }
    if (touches > 0) meet(sum / touches, met, out);
  }

 private:
  // Triangles within reach of the other patch, and with a corner of `some`.
  void find_pairs(double reach, const CornerMasks& some) {
    near_a_.count = near_b_.count = 0;
    near_a_.corners = near_b_.corners = 0;
    find_near(a_, box_around(b_.corners, b_.used), reach, some.a, near_a_);
    // The second side against what is left of the first.
    if (near_a_.count > 0)
      find_near(b_, box_around(a_.corners, near_a_.corners), reach, some.b, near_b_);
    drop_by_planes(a_, b_, near_b_.corners, reach, near_a_);
    drop_by_planes(b_, a_, near_a_.corners, reach, near_b_);
  }

  // Heights of all corners along a line: where b is farther above a than the limit, nothing is
  // nearer.
  struct Levels {
    const TrianglePairs& pairs;
    double length, rounding;
    alignas(16) double a[kMaxHullVertices], b[kMaxHullVertices];

    Levels(const TrianglePairs& p, const Vec3& line)
        : pairs(p), length(std::sqrt(line.squaredNorm())), rounding(kRounding * p.size_) {
      heights_along(p.a_.corners, line, a);
      heights_along(p.b_.corners, line, b);
    }

    // Of features within a squared distance, at most.
    double gap(double limit) const { return length * (std::sqrt(limit * kMargin) + rounding); }

    // Corners that are not beyond all of the other patch.
    CornerMasks near(double most) const {
      double top = a[0], bottom = b[0];
      for (int i = 1; i < pairs.a_.corners.count; ++i) top = std::max(top, a[i]);
      for (int i = 1; i < pairs.b_.corners.count; ++i) bottom = std::min(bottom, b[i]);
      CornerMasks masks;
      for (int i = 0; i < pairs.a_.corners.count; ++i)
        masks.a |= static_cast<std::uint32_t>(!(bottom - a[i] > most)) << i;
      for (int i = 0; i < pairs.b_.corners.count; ++i)
        masks.b |= static_cast<std::uint32_t>(!(b[i] - top > most)) << i;
      return masks;
    }

    bool may_be_nearer(const NearTriangle& ta, const NearTriangle& tb, double most,
                       detail::CornerHeights& along) const {
      const std::uint8_t* ca = pairs.a_.hull.triangles[ta.index].corner;
      const std::uint8_t* cb = pairs.b_.hull.triangles[tb.index].corner;
      along = {{a[ca[0]], a[ca[1]], a[ca[2]]}, {b[cb[0]], b[cb[1]], b[cb[2]]}, most};
      return !(std::min({along.b[0], along.b[1], along.b[2]}) -
                   std::max({along.a[0], along.a[1], along.a[2]}) >
               most);
    }
  };

  // Squared; the distance of the triangles is no larger. Of the hint, or of the corners. line: from
  // one to the other
  double guess(const TriangleHint& hint, Vec3& line) const {
    double least = kInfinity;
    line = Vec3::Zero();
    if (hint.a < a_.triangle_count && hint.b < b_.triangle_count) {
      detail::ClosestFeatures best;
      offer_features(placed(a_.corners, a_.hull.triangles[hint.a]),
                     placed(b_.corners, b_.hull.triangles[hint.b]), best);
      least = best.squared;
      if (best.corners_a != 0) line = best.b - best.a;
    } else {
      for (std::uint32_t left = a_.used; left != 0; left &= left - 1) {
        const Vec3 p = a_.corners[std::countr_zero(left)];
        for (std::uint32_t other = b_.used; other != 0; other &= other - 1) {
          const Vec3 between = b_.corners[std::countr_zero(other)] - p;
          const double squared = between.squaredNorm();
          if (!(squared < least)) continue;
          least = squared;
          line = between;
        }
      }
    }
    const double distance = std::sqrt(least) + kRounding * size_;
    return distance * distance;
  }

  void keep(int i, int j, int corners_a, int corners_b, PatchSeparation& out) const {
    out.triangle_a = i;
    out.triangle_b = j;
    out.feature_a = hull_mask(a_.hull.triangles[i], corners_a);
    out.feature_b = hull_mask(b_.hull.triangles[j], corners_b);
  }

  void meet(const Vec3& point, const CornerMasks& corners, PatchSeparation& out) const {
    out.intersecting = true;
    out.distance = 0.0;
    out.feature_a = corners.a;
    out.feature_b = corners.b;
    out.point_a = out.point_b = point + origin_;
  }

  Patch a_, b_;
  Vec3 origin_;
  double size_;  // of the pair: coordinates are no larger [m]
  NearTriangles near_a_, near_b_;
};

void remember(const PatchSeparation& found, TriangleHint& hint) {
  hint.meet = found.intersecting;
  if (found.triangle_a < 0) return;
  hint.a = static_cast<std::uint8_t>(found.triangle_a);
  hint.b = static_cast<std::uint8_t>(found.triangle_b);
}

}  // namespace

PatchSeparation triangle_separation(const HullPair& pair, double stop, bool disjoint,
                                    TriangleHint& hint) noexcept {
  PatchSeparation out;
  out.distance = std::nextafter(stop, kInfinity);
  TrianglePairs pairs(pair);
  if (!pairs.has_triangles()) return out;
  if (disjoint || !pairs.intersect(out)) pairs.measure(stop, hint, out);
  remember(out, hint);
  if (out.distance > stop) out.triangle_a = out.triangle_b = -1;
  return out;
}

bool triangles_pierce(const HullPair& pair, TriangleHint& hint, PatchSeparation& out) noexcept {
  out = {};
  TrianglePairs pairs(pair);
  hint.meet = pairs.has_triangles() && pairs.intersect(out);
  if (hint.meet) remember(out, hint);
  return hint.meet;
}

PatchSeparation patch_separation(const HullPair& pair, double stop, GjkCache& cache) noexcept {
  PatchSeparation out;
  const Separation hulls = closest_points(pair.a, pair.b, pair.a_from_b, stop, cache);
  out.distance = hulls.distance;
  if (hulls.distance > stop) return out;
  if (hulls.status == GjkStatus::separated) {
    out.triangle_a = triangle_holding(pair.a, hulls.feature_a);
    out.triangle_b = triangle_holding(pair.b, hulls.feature_b);
    if (out.triangle_a >= 0 && out.triangle_b >= 0) {
      out.point_a = hulls.witness_a;
      out.point_b = hulls.witness_b;
      out.feature_a = hulls.feature_a;
      out.feature_b = hulls.feature_b;
      return out;
    }
  }
  // Triangles of disjoint hulls do not intersect.
  TriangleHint none;
  out = triangle_separation(pair, stop, hulls.status == GjkStatus::separated, none);
  out.distance = out.triangle_a < 0 ? std::max(hulls.distance, out.distance) : out.distance;
  return out;
}

}  // namespace thigma
