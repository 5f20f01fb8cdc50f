// Distance of two hulls: Gilbert, Johnson, Keerthi 1988, with the simplex of the last call as the
// start. The simplex lives in the Minkowski difference a - b in the frame of a; its nearest point v
// to the origin bounds the distance from above, the support plane orthogonal to v bounds it from
// below. The loop ends when the bounds meet, when the support vertex is already in the simplex
// (optimal up to rounding), or when rounding stops progress; only the last leaves a gap, and then
// the lower bound is what is returned.
#include "thigma/convex/pair.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "thigma/convex/detail/feature_certificate.h"
#include "thigma/convex/detail/simplex.h"
#include "thigma/convex/detail/support.h"

namespace thigma {
namespace {

using detail::Simplex;

// Upper minus lower bound over the larger of distance and hull size at which they count as equal.
constexpr double kRelativeGap = 1e-12;
// The gap at which a stalled search still counts as finished: rounding in slivers stops above
// kRelativeGap.
constexpr double kStalledGap = 1e-11;
// A warm simplex is right or nearly so; a cold search of 32 vertices takes about 6 turns, slivers
// up to 20.
constexpr int kMaxIterations = 64;

void set_point(const HullView& a, const HullView& b, const RelativePose& x, int ia, int ib, int k,
               Simplex& s) {
  s.a[k] = static_cast<std::uint8_t>(ia);
  s.b[k] = static_cast<std::uint8_t>(ib);
  s.w[k] = a.vertices[ia] - (x.rotation * b.vertices[ib] + x.translation);
}

void start(const HullView& a, const HullView& b, const RelativePose& x, const GjkCache& cache,
           Simplex& s) {
  s.n = 0;
  // A cache may come from a front that was rebuilt: indices that do not exist here are not an
  // error.
  for (int i = 0; i < cache.count && i < 4; ++i) {
    if (cache.a[i] < a.vertex_count && cache.b[i] < b.vertex_count)
      set_point(a, b, x, cache.a[i], cache.b[i], s.n++, s);
  }
  if (s.n > 0) return;
  const Vec3 toward = x.rotation * b.center + x.translation - a.center;
  set_point(a, b, x, detail::support_vertex(a, toward),
            detail::support_vertex(b, -(x.rotation.transpose() * toward)), 0, s);
  s.n = 1;
}

bool holds(const Simplex& s, int ia, int ib) {
  for (int i = 0; i < s.n; ++i) {
    if (s.a[i] == ia && s.b[i] == ib) return true;
  }
  return false;
}

// Whether the simplex is known to hold its own support point: no other vertex of either hull can
// support along v, and the vertices that do combine to points of the simplex (or, edge against
// edge, to the fourth corner of the parallelogram of which it has three). The usual end of a warm
// call, at half the price of a search in double.
inline bool is_certified(const HullView& a, const HullView& b, const std::uint8_t* ia,
                         const std::uint8_t* ib, int n, const Vec3& v, const Vec3& v_b) {
  std::uint32_t feature_a = 0, feature_b = 0;
  for (int i = 0; i < n; ++i) {
    feature_a |= 1u << ia[i];
    feature_b |= 1u << ib[i];
  }
  const bool one_a = (feature_a & (feature_a - 1)) == 0, one_b = (feature_b & (feature_b - 1)) == 0;
  const bool edges = n == 3 && std::popcount(feature_a) == 2 && std::popcount(feature_b) == 2;
  if (!one_a && !one_b && !edges) return false;
  return detail::feature_supports(a, feature_a, ia[0], -v) &&
         detail::feature_supports(b, feature_b, ib[0], v_b);
}

void finish(const HullView& a, const Simplex& s, const Vec3& v, Separation& out, GjkCache& cache) {
  cache.count = static_cast<std::uint8_t>(s.n);
  out.witness_a = Vec3::Zero();
  out.feature_a = out.feature_b = 0;
  for (int i = 0; i < s.n; ++i) {
    cache.a[i] = s.a[i];
    cache.b[i] = s.b[i];
    out.witness_a += s.weight[i] * a.vertices[s.a[i]];
    out.feature_a |= 1u << s.a[i];
    out.feature_b |= 1u << s.b[i];
  }
  out.witness_b = out.witness_a - v;
}

// Rounding of a point of the difference; below it the sign of the separation means nothing.
double rounding_noise(const HullView& a, const HullView& b, const RelativePose& x) {
  return 0x1.0p-51 * (a.center.lpNorm<1>() + b.center.lpNorm<1>() + x.translation.lpNorm<1>() +
                      a.radius + b.radius);
}

// The first turn of the search when the cached simplex of N points still is the answer: the same
// arithmetic as the loop, unrolled. False, and nothing changed but `out`, when it is not, and the
// search has to begin.
template <int N>
inline bool confirm_cached(const HullView& a, const HullView& b, const RelativePose& x,
                           const GjkCache& cache, Separation& out) {
  Vec3 w[N];
  for (int i = 0; i < N; ++i) {
    if (cache.a[i] >= a.vertex_count || cache.b[i] >= b.vertex_count) return false;
    w[i] = a.vertices[cache.a[i]] - (x.rotation * b.vertices[cache.b[i]] + x.translation);
  }
  int mask = 1;
  double weight[3] = {1.0, 0.0, 0.0};
  Vec3 v = w[0];
  if constexpr (N == 2) v = detail::nearest_on_segment(w[0], w[1], mask, weight);
  if constexpr (N == 3) v = detail::nearest_on_triangle(w[0], w[1], w[2], mask, weight);
  const double vv = v.squaredNorm(), noise = rounding_noise(a, b, x);
  if (mask != (1 << N) - 1 || vv <= noise * noise) return false;
  if (!is_certified(a, b, cache.a, cache.b, N, v, x.rotation.transpose() * v)) return false;
  out.status = PairStatus::separated;
  out.distance = std::sqrt(vv);
  out.iterations = 1;
  out.feature_a = out.feature_b = 0;
  out.witness_a = Vec3::Zero();
  for (int i = 0; i < N; ++i) {
    out.witness_a += weight[i] * a.vertices[cache.a[i]];
    out.feature_a |= 1u << cache.a[i];
    out.feature_b |= 1u << cache.b[i];
  }
  out.witness_b = out.witness_a - v;
  return true;
}

}  // namespace

RelativePose relative_pose(const Pose& world_from_a, const Pose& world_from_b) noexcept {
  const Pose a_from_b = inverse(world_from_a) * world_from_b;
  return {a_from_b.orientation.toRotationMatrix(), a_from_b.position};
}

namespace {

inline bool confirm(const HullView& a, const HullView& b, const RelativePose& x,
                    const GjkCache& cache, Separation& out) {
  switch (cache.count) {
    case 1:
      return confirm_cached<1>(a, b, x, cache, out);
    case 2:
      return confirm_cached<2>(a, b, x, cache, out);
    case 3:
      return confirm_cached<3>(a, b, x, cache, out);
    default:
      return false;
  }
}

Separation search(const HullView& a, const HullView& b, const RelativePose& x, double stop,
                  GjkCache& cache) noexcept {
  Separation out;
  Simplex s;
  start(a, b, x, cache, s);
  const double size = a.radius + b.radius;
  const double noise = rounding_noise(a, b, x);
  const double stop2 = stop > 0.0 ? stop * stop : 0.0;
  Simplex previous;
  Vec3 v, v_previous = Vec3::Zero();
  double vv = 0.0, vv_previous = -1.0, gap = 0.0, lower = 0.0;
  bool stalled = false;
  for (out.iterations = 1;; ++out.iterations) {
    v = detail::reduce_to_nearest(s);
    vv = v.squaredNorm();
    if (s.n == 4 || vv <= noise * noise) {
      out.status = PairStatus::overlapping;
      out.distance = 0.0;
      finish(a, s, v, out, cache);
      return out;
    }
    if (vv_previous >= 0.0 && !(vv < vv_previous)) {  // rounding: the new point brought nothing
      s = previous;
      v = v_previous;
      vv = vv_previous;
      stalled = true;
      break;
    }
    const Vec3 v_b = x.rotation.transpose() * v;
    if (is_certified(a, b, s.a, s.b, s.n, v, v_b)) break;
    const int ia = detail::support_vertex(a, -v);
    const int ib = detail::support_vertex(b, v_b);
    const int k = s.n;
    set_point(a, b, x, ia, ib, k, s);  // w[k] is read below; s.n counts it only if it is kept
    const double vw = v.dot(s.w[k]);
    gap = vv - vw;
    if (vw > 0.0 && vw * vw > stop2 * vv) {
      out.status = PairStatus::separated;
      out.distance = vw / std::sqrt(vv);
      finish(a, s, v, out, cache);
      if (gap <= kRelativeGap * vv) out.distance = std::sqrt(vv);
      return out;
    }
    if (gap <= 0.0 || gap * gap <= kRelativeGap * kRelativeGap * vv * std::max(vv, size * size))
      break;
    if (holds(s, ia, ib)) break;
    if (out.iterations >= kMaxIterations) {
      stalled = true;
      break;
    }
    if (vw > 0.0) lower = std::max(lower, vw / std::sqrt(vv));
    previous = s;
    v_previous = v;
    vv_previous = vv;
    ++s.n;
  }
  finish(a, s, v, out, cache);
  const double distance = std::sqrt(vv);
  const bool open = stalled && gap > kStalledGap * distance * std::max(distance, size);
  out.status = open ? PairStatus::gave_up : PairStatus::separated;
  out.distance = open ? lower : distance;
  return out;
}

}  // namespace

Separation closest_points(const HullView& a, const HullView& b, const RelativePose& x, double stop,
                          GjkCache& cache) noexcept {
  Separation out;
  return confirm(a, b, x, cache, out) ? out : search(a, b, x, stop, cache);
}

void closest_points_batch(std::span<const PairQuery> queries, const RelativePose& a_from_b,
                          double stop, Separation* out) noexcept {
  const RelativePose x = a_from_b;  // a copy that nothing written below can alias
  for (std::size_t i = 0; i < queries.size(); ++i) {
    const PairQuery& q = queries[i];
    if (!confirm(*q.a, *q.b, x, *q.cache, out[i])) out[i] = search(*q.a, *q.b, x, stop, *q.cache);
  }
}

}  // namespace thigma
