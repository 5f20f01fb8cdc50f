#pragma once
// Whether the simplices that a group of pairs remember still are the answers: one pair a lane, the
// same arithmetic in every lane whatever the width, so that the scalar, the SSE2 and the AVX2
// instantiation give the same bits. This header is compiled for AVX2 too: everything in it is a
// template over the width, and no function of another header is called, so that the linker can
// never pick AVX2 code for the baseline.

#include <cstddef>
#include <cstdint>

#include "thigma/convex/gjk.h"

namespace thigma::detail {

/// The numbers of a relative pose, not owned.
struct PlainPose {
  const double* r;   // rotation, column after column
  const double* t;   // translation [m]
  double far = 0.0;  // sum of the translation's magnitudes [m]
};

/// The distance search from the cached simplex on: what a pair that is not confirmed needs.
/// Arguments as closest_points. Thread [contact]; no failure, no allocation.
Separation search_closest_points(const HullView& a, const HullView& b, const RelativePose& x,
                                 double stop, GjkCache& cache) noexcept;

/// A triple in every lane. T names a width: T::Real holds T::kLanes doubles and has the operators
/// of double.
template <class T>
struct LaneVec {
  typename T::Real x, y, z;
};

template <class T>
[[gnu::always_inline]] inline LaneVec<T> minus(const LaneVec<T>& p, const LaneVec<T>& q) {
  return {p.x - q.x, p.y - q.y, p.z - q.z};
}

template <class T>
[[gnu::always_inline]] inline LaneVec<T> plus_scaled(const LaneVec<T>& p, typename T::Real s,
                                                     const LaneVec<T>& q) {
  return {p.x + s * q.x, p.y + s * q.y, p.z + s * q.z};
}

template <class T>
[[gnu::always_inline]] inline LaneVec<T> scaled(typename T::Real s, const LaneVec<T>& p) {
  return {s * p.x, s * p.y, s * p.z};
}

template <class T>
[[gnu::always_inline]] inline typename T::Real dot(const LaneVec<T>& p, const LaneVec<T>& q) {
  return p.x * q.x + p.y * q.y + p.z * q.z;
}

template <class T>
[[gnu::always_inline]] inline typename T::Real sum_of_magnitudes(const LaneVec<T>& p) {
  return T::magnitude(p.x) + T::magnitude(p.y) + T::magnitude(p.z);
}

template <class T>
[[gnu::always_inline]] inline LaneVec<T> cross(const LaneVec<T>& p, const LaneVec<T>& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

/// b's point in the frame of a.
template <class T>
[[gnu::always_inline]] inline LaneVec<T> placed(const PlainPose& x, const LaneVec<T>& p) {
  const double* r = x.r;
  return {r[0] * p.x + r[3] * p.y + r[6] * p.z + x.t[0],
          r[1] * p.x + r[4] * p.y + r[7] * p.z + x.t[1],
          r[2] * p.x + r[5] * p.y + r[8] * p.z + x.t[2]};
}

/// a's direction in the frame of b.
template <class T>
[[gnu::always_inline]] inline LaneVec<T> turned_back(const PlainPose& x, const LaneVec<T>& p) {
  const double* r = x.r;
  return {r[0] * p.x + r[1] * p.y + r[2] * p.z, r[3] * p.x + r[4] * p.y + r[5] * p.z,
          r[6] * p.x + r[7] * p.y + r[8] * p.z};
}

/// The nearest point to the origin of the simplex w[0..N), if it is inside the simplex: then a bit
/// is set for the lane.
template <class T, int N>
[[gnu::always_inline]] inline unsigned nearest_inside(const LaneVec<T> (&w)[N],
                                                      typename T::Real (&weight)[3],
                                                      LaneVec<T>& v) {
  using Real = typename T::Real;
  const Real one = T::splat(1.0), zero = T::splat(0.0);
  v = w[0];
  weight[0] = one;
  if constexpr (N == 1) return (1u << T::kLanes) - 1;
  if constexpr (N == 2) {
    const LaneVec<T> ab = minus<T>(w[1], w[0]);
    const Real t = zero - dot<T>(w[0], ab), d = dot<T>(ab, ab);
    weight[1] = t / d;
    weight[0] = one - weight[1];
    v = plus_scaled<T>(w[0], weight[1], ab);
    return T::bits((t > zero) & (t < d));
  }
  if constexpr (N == 3) {
    // As nearest_on_triangle: the signs of the shares alone decide, and v along the normal is
    // exact in direction even where its length is all cancellation.
    const LaneVec<T> ab = minus<T>(w[1], w[0]), ac = minus<T>(w[2], w[0]);
    const Real abab = dot<T>(ab, ab), abac = dot<T>(ab, ac), acac = dot<T>(ac, ac);
    const Real d1 = zero - dot<T>(ab, w[0]), d2 = zero - dot<T>(ac, w[0]);
    const Real d3 = d1 - abab, d4 = d2 - abac, d5 = d1 - abac, d6 = d2 - acac;
    const Real va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    const LaneVec<T> n = cross<T>(ab, ac);
    const Real nn = dot<T>(n, n), share = one / (va + vb + vc);
    weight[1] = vb * share;
    weight[2] = vc * share;
    weight[0] = one - weight[1] - weight[2];
    v = scaled<T>(dot<T>(w[0], n) / nn, n);
    return T::bits((va > zero) & (vb > zero) & (vc > zero) & (nn > T::splat(1e-28) * abab * acac));
  }
}

/// The hull vertices of one lane's simplex.
struct LaneFeature {
  std::uint32_t a = 0, b = 0;
};

template <class T, int N>
[[gnu::always_inline]] inline LaneFeature feature_of(const GjkCache& cache) {
  LaneFeature f;
  for (int k = 0; k < N; ++k) {
    f.a |= 1u << cache.a[k];
    f.b |= 1u << cache.b[k];
  }
  return f;
}

/// Whether no vertex outside its feature may support the hull of a lane: support_candidates (see
/// there for the slack) of every lane. vertex is one of the feature's.
template <class T>
[[gnu::always_inline]] inline unsigned supports(const HullView* const (&hull)[T::kLanes],
                                                const std::uint32_t (&feature)[T::kLanes],
                                                const LaneVec<T>& vertex,
                                                const LaneVec<T>& direction) {
  using Small = typename T::Small;
  const Small dx = T::narrow(direction.x), dy = T::narrow(direction.y), dz = T::narrow(direction.z);
  const double *radius[T::kLanes], *center[T::kLanes];
  for (int l = 0; l < T::kLanes; ++l) {
    radius[l] = &hull[l]->radius;
    center[l] = reinterpret_cast<const double*>(&hull[l]->center);
  }
  const Small slacks = T::small(0x1.0p-18f) * T::narrow(T::pick(radius)) *
                       (T::magnitude(dx) + T::magnitude(dy) + T::magnitude(dz));
  LaneVec<T> origin;
  T::gather(center, origin.x, origin.y, origin.z);
  const Small limits = T::narrow(dot<T>(minus<T>(vertex, origin), direction)) - slacks;
  float d[3][T::kLanes], limit[T::kLanes];
  T::store(dx, d[0]);
  T::store(dy, d[1]);
  T::store(dz, d[2]);
  T::store(limits, limit);
  unsigned proven = 0;
  for (int l = 0; l < T::kLanes; ++l) {
    // The padding repeats the last vertex.
    const std::uint32_t present = 0xffffffffu >> (kMaxHullVertices - hull[l]->vertex_count);
    const std::uint32_t rivals =
        T::not_lower(hull[l]->lanes, hull[l]->lane_count, d[0][l], d[1][l], d[2][l], limit[l]) &
        present & ~feature[l];
    proven |= static_cast<unsigned>(rivals == 0) << l;
  }
  return proven & T::small_bits((slacks > T::small(1e-30f)) & (slacks < T::small(1e30f)));
}

/// Writes what confirmed lanes have found.
template <class T>
[[gnu::always_inline]] inline void store_separations(typename T::Real distances,
                                                     const LaneVec<T>& witness,
                                                     const LaneVec<T>& witness_b,
                                                     const std::uint32_t (&feature_a)[T::kLanes],
                                                     const std::uint32_t (&feature_b)[T::kLanes],
                                                     Separation* const (&out)[T::kLanes]) {
  constexpr int kLanes = T::kLanes;
  double distance[kLanes], *to_a[kLanes], *to_b[kLanes];
  T::store(distances, distance);
  for (int l = 0; l < kLanes; ++l) {
    Separation& s = *out[l];
    s.status = GjkStatus::separated;
    s.distance = distance[l];
    s.feature_a = feature_a[l];
    s.feature_b = feature_b[l];
    s.iterations = 1;
    to_a[l] = reinterpret_cast<double*>(&s.witness_a);
    to_b[l] = reinterpret_cast<double*>(&s.witness_b);
  }
  T::scatter(witness.x, witness.y, witness.z, to_a);
  T::scatter(witness_b.x, witness_b.y, witness_b.z, to_b);
}

/// Confirms the provable cached simplices of N points, with existing vertices and lanes, of
/// T::kLanes pairs.
/// Writes every out; only those of the lanes in the returned bits count.
template <class T, int N>
[[gnu::always_inline]] inline unsigned verify_cached_simplices(
    const GjkQuery* const (&query)[T::kLanes], const PlainPose& x,
    Separation* const (&out)[T::kLanes]) {
  using Real = typename T::Real;
  constexpr int kLanes = T::kLanes;
  const HullView *a[kLanes], *b[kLanes];
  for (int l = 0; l < kLanes; ++l) {
    a[l] = query[l]->a;
    b[l] = query[l]->b;
  }
  LaneVec<T> pa[N], pb[N], w[N];
  Real far = T::splat(x.far);
  for (int k = 0; k < N; ++k) {
    const double *at[kLanes], *bt[kLanes];
    for (int l = 0; l < kLanes; ++l) {
      at[l] = reinterpret_cast<const double*>(a[l]->vertices + query[l]->cache->a[k]);
      bt[l] = reinterpret_cast<const double*>(b[l]->vertices + query[l]->cache->b[k]);
    }
    T::gather(at, pa[k].x, pa[k].y, pa[k].z);
    T::gather(bt, pb[k].x, pb[k].y, pb[k].z);
    if (k == 0) far = far + sum_of_magnitudes<T>(pa[0]) + sum_of_magnitudes<T>(pb[0]);
    w[k] = minus<T>(pa[k], placed<T>(x, pb[k]));
  }
  const double *radius_a[kLanes], *radius_b[kLanes];
  for (int l = 0; l < kLanes; ++l) {
    radius_a[l] = &a[l]->radius;
    radius_b[l] = &b[l]->radius;
  }
  // At least the noise of the search: a center is at most sqrt(3) radii from a vertex.
  const Real noise = T::splat(0x1.0p-50) * (far + T::pick(radius_a) + T::pick(radius_b));

  Real weight[3];
  LaneVec<T> v;
  unsigned good = nearest_inside<T, N>(w, weight, v);
  const Real vv = dot<T>(v, v);
  good &= T::bits(vv > noise * noise);

  std::uint32_t feature_a[kLanes], feature_b[kLanes];
  for (int l = 0; l < kLanes; ++l) {
    const LaneFeature f = feature_of<T, N>(*query[l]->cache);
    feature_a[l] = f.a;
    feature_b[l] = f.b;
  }
  const LaneVec<T> zero = {T::splat(0.0), T::splat(0.0), T::splat(0.0)};
  good &= supports<T>(a, feature_a, pa[0], minus<T>(zero, v));
  good &= supports<T>(b, feature_b, pb[0], turned_back<T>(x, v));

  LaneVec<T> witness = scaled<T>(weight[0], pa[0]);
  for (int k = 1; k < N; ++k) witness = plus_scaled<T>(witness, weight[k], pa[k]);
  const LaneVec<T> witness_b = minus<T>(witness, v);
  store_separations<T>(T::root(vv), witness, witness_b, feature_a, feature_b, out);
  return good;
}

}  // namespace thigma::detail
