#pragma once
// The vertices of a placed hull side by side, two to a step of SSE2, and what is asked of all of
// them at once.

#include <bit>
#include <cstdint>

#include <emmintrin.h>

#include "thigma/convex/gjk.h"

namespace thigma::detail {

/// At most kMaxHullVertices points about a local origin; an odd count is padded by the last point
/// again.
struct Corners {
  alignas(16) double x[kMaxHullVertices], y[kMaxHullVertices], z[kMaxHullVertices];
  int count = 0;  // >= 1

  Vec3 operator[](int i) const { return {x[i], y[i], z[i]}; }
  std::uint32_t all() const { return 0xffffffffu >> (kMaxHullVertices - count); }
};

inline void put(Corners& c, const Vec3& p) {
  for (int i = c.count++, last = i | 1; i <= last; ++i) {
    c.x[i] = p.x();
    c.y[i] = p.y();
    c.z[i] = p.z();
  }
}

/// Vertices of a hull minus an origin.
inline void place_corners(const HullView& hull, const Vec3& origin, Corners& c) {
  for (int i = 0; i < hull.vertex_count; ++i) put(c, hull.vertices[i] - origin);
}

/// The same of the hull of the other body.
inline void place_corners(const HullView& hull, const RelativePose& x, const Vec3& origin,
                          Corners& c) {
  const Vec3 shift = x.translation - origin;
  for (int i = 0; i < hull.vertex_count; ++i) put(c, x.rotation * hull.vertices[i] + shift);
}

/// Heights of corners i and i + 1 along an axis; in the order of operations of Vec3::dot.
struct Heights {
  __m128d x, y, z;
  explicit Heights(const Vec3& n)
      : x(_mm_set1_pd(n.x())), y(_mm_set1_pd(n.y())), z(_mm_set1_pd(n.z())) {}
  __m128d of(__m128d px, __m128d py, __m128d pz) const {
    return _mm_add_pd(_mm_add_pd(_mm_mul_pd(px, x), _mm_mul_pd(py, y)), _mm_mul_pd(pz, z));
  }
  __m128d at(const Corners& c, int i) const {
    return of(_mm_load_pd(c.x + i), _mm_load_pd(c.y + i), _mm_load_pd(c.z + i));
  }
};

/// Largest height of the corners along n.
inline double top_along(const Corners& c, const Vec3& n) {
  const Heights h(n);
  __m128d top = h.at(c, 0);
  for (int i = 2; i < c.count; i += 2) top = _mm_max_pd(top, h.at(c, i));
  return _mm_cvtsd_f64(_mm_max_sd(top, _mm_unpackhi_pd(top, top)));
}

/// Heights of all corners along n, as many as are padded.
inline void heights_along(const Corners& c, const Vec3& n, double* height) {
  const Heights h(n);
  for (int i = 0; i < c.count; i += 2) _mm_store_pd(height + i, h.at(c, i));
}

/// Smallest height of the corners along n.
inline double bottom_along(const Corners& c, const Vec3& n) {
  const Heights h(n);
  __m128d bottom = h.at(c, 0);
  for (int i = 2; i < c.count; i += 2) bottom = _mm_min_pd(bottom, h.at(c, i));
  return _mm_cvtsd_f64(_mm_min_sd(bottom, _mm_unpackhi_pd(bottom, bottom)));
}

/// On which side of a plane the corners lie.
struct Sides {
  std::uint32_t above = 0,
                below = 0;  // masks of those farther than a margin; neither: near the plane

  bool straddles(std::uint32_t some) const { return (some & ~above) != 0 && (some & ~below) != 0; }
};

/// n need not be of unit length: margin is in its units.
inline Sides sides_of(const Corners& c, const Vec3& n, const Vec3& on_plane, double margin) {
  const Heights h(n);
  const __m128d ox = _mm_set1_pd(on_plane.x()), oy = _mm_set1_pd(on_plane.y()),
                oz = _mm_set1_pd(on_plane.z());
  const __m128d high = _mm_set1_pd(margin), low = _mm_set1_pd(-margin);
  Sides s{0, 0};
  for (int i = 0; i < c.count; i += 2) {
    const __m128d height =
        h.of(_mm_sub_pd(_mm_load_pd(c.x + i), ox), _mm_sub_pd(_mm_load_pd(c.y + i), oy),
             _mm_sub_pd(_mm_load_pd(c.z + i), oz));
    s.above |= static_cast<std::uint32_t>(_mm_movemask_pd(_mm_cmpgt_pd(height, high))) << i;
    s.below |= static_cast<std::uint32_t>(_mm_movemask_pd(_mm_cmplt_pd(height, low))) << i;
  }
  return s;
}

/// An axis-parallel box.
struct Box {
  Vec3 low, high;
};

inline Box box_of(const Vec3 t[3]) {
  return {t[0].cwiseMin(t[1]).cwiseMin(t[2]), t[0].cwiseMax(t[1]).cwiseMax(t[2])};
}

inline double squared_distance(const Box& a, const Box& b) {
  const Vec3 gap = (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(Vec3::Zero());
  return gap.squaredNorm();
}

/// Around the corners of a mask, which is not empty.
inline Box box_around(const Corners& c, std::uint32_t some) {
  Box box{c[std::countr_zero(some)], c[std::countr_zero(some)]};
  for (some &= some - 1; some != 0; some &= some - 1) {
    const Vec3 p = c[std::countr_zero(some)];
    box = {box.low.cwiseMin(p), box.high.cwiseMax(p)};
  }
  return box;
}

/// Which corners are on the inner side of each face of a box: what has no corner inside one of them
/// is apart.
struct BoxSides {
  std::uint32_t inside[6];

  bool may_meet(std::uint32_t some) const {
    bool meets = true;
    for (const std::uint32_t mask : inside) meets &= (some & mask) != 0;
    return meets;
  }
};

inline BoxSides sides_of(const Corners& c, const Box& box) {
  BoxSides s{};
  const double* const axis[3] = {c.x, c.y, c.z};
  for (int k = 0; k < 3; ++k) {
    const __m128d low = _mm_set1_pd(box.low[k]), high = _mm_set1_pd(box.high[k]);
    for (int i = 0; i < c.count; i += 2) {
      const __m128d p = _mm_load_pd(axis[k] + i);
      s.inside[2 * k] |= static_cast<std::uint32_t>(_mm_movemask_pd(_mm_cmpge_pd(p, low))) << i;
      s.inside[2 * k + 1] |= static_cast<std::uint32_t>(_mm_movemask_pd(_mm_cmple_pd(p, high)))
                             << i;
    }
  }
  return s;
}

}  // namespace thigma::detail
