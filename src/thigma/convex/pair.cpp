// Distance of two hulls: Gilbert, Johnson, Keerthi 1988, with the simplex of the last call as the start.
// The simplex lives in the Minkowski difference a - b in the frame of a; its nearest point v to the origin bounds
// the distance from above, the support plane orthogonal to v bounds it from below. The loop ends when the bounds
// meet, when the support vertex is already in the simplex (optimal up to rounding), or when rounding stops progress;
// only the last leaves a gap, and then the lower bound is what is returned.
#include "thigma/convex/pair.h"

#include <algorithm>
#include <cmath>

#include "thigma/convex/detail/simplex.h"
#include "thigma/convex/detail/support.h"

namespace thigma {
namespace {

using detail::Simplex;

// Upper minus lower bound over the larger of distance and hull size at which they count as equal.
constexpr double kRelativeGap = 1e-12;
// The gap at which a stalled search still counts as finished: rounding in slivers stops above kRelativeGap.
constexpr double kStalledGap = 1e-11;
// A warm simplex is right or nearly so; a cold search of 32 vertices takes about 6 turns, slivers up to 20.
constexpr int kMaxIterations = 64;

void set_point(const HullView& a, const HullView& b, const RelativePose& x, int ia, int ib, int k, Simplex& s) {
  s.a[k] = static_cast<std::uint8_t>(ia);
  s.b[k] = static_cast<std::uint8_t>(ib);
  s.w[k] = a.vertices[ia] - (x.rotation * b.vertices[ib] + x.translation);
}

void start(const HullView& a, const HullView& b, const RelativePose& x, const GjkCache& cache, Simplex& s) {
  s.n = 0;
  // A cache may come from a front that was rebuilt: indices that do not exist here are not an error.
  for (int i = 0; i < cache.count && i < 4; ++i) {
    if (cache.a[i] < a.vertex_count && cache.b[i] < b.vertex_count) set_point(a, b, x, cache.a[i], cache.b[i], s.n++, s);
  }
  if (s.n > 0) return;
  const Vec3 toward = x.rotation * b.center + x.translation - a.center;
  set_point(a, b, x, detail::support_vertex(a, toward), detail::support_vertex(b, -(x.rotation.transpose() * toward)), 0, s);
  s.n = 1;
}

bool holds(const Simplex& s, int ia, int ib) {
  for (int i = 0; i < s.n; ++i) {
    if (s.a[i] == ia && s.b[i] == ib) return true;
  }
  return false;
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

}  // namespace

RelativePose relative_pose(const Pose& world_from_a, const Pose& world_from_b) noexcept {
  const Pose a_from_b = inverse(world_from_a) * world_from_b;
  return {a_from_b.orientation.toRotationMatrix(), a_from_b.position};
}

Separation closest_points(const HullView& a, const HullView& b, const RelativePose& x, double stop,
                          GjkCache& cache) noexcept {
  Separation out;
  Simplex s;
  start(a, b, x, cache, s);
  const double size = a.radius + b.radius;
  // Rounding of a point of the difference; below it the sign of the separation means nothing.
  const double reach = a.center.lpNorm<1>() + b.center.lpNorm<1>() + x.translation.lpNorm<1>() + size;
  const double noise = 0x1.0p-51 * reach;
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
    if (gap <= 0.0 || gap * gap <= kRelativeGap * kRelativeGap * vv * std::max(vv, size * size)) break;
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

}  // namespace thigma
