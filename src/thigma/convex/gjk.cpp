// Distance of two hulls: Gilbert, Johnson, Keerthi 1988, with the simplex of the last call as the
// start. The simplex lives in the Minkowski difference a - b in the frame of a; its nearest point v
// to the origin bounds the distance from above, the support plane orthogonal to v bounds it from
// below. The loop ends when the bounds meet, when the support vertex is already in the simplex
// (optimal up to rounding), or when rounding stops progress; only the last leaves a gap, and then
// the lower bound is what is returned.
#include "thigma/convex/gjk.h"

#include <algorithm>
#include <cmath>

#include "thigma/convex/detail/gjk_batch.h"
#include "thigma/convex/detail/gjk_warm_start.h"
#include "thigma/convex/detail/lanes_sse2.h"
#include "thigma/convex/detail/simplex.h"
#include "thigma/convex/detail/support_candidates.h"
#include "thigma/convex/support.h"

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

void set_point(const HullPair& pair, int ia, int ib, int k, Simplex& s) {
  const RelativePose& x = pair.a_from_b;
  s.a[k] = static_cast<std::uint8_t>(ia);
  s.b[k] = static_cast<std::uint8_t>(ib);
  s.w[k] = pair.a.vertices[ia] - (x.rotation * pair.b.vertices[ib] + x.translation);
}

void start(const HullPair& pair, const GjkCache& cache, Simplex& s) {
  const HullView &a = pair.a, &b = pair.b;
  const RelativePose& x = pair.a_from_b;
  s.n = 0;
  // A cache may come from a front that was rebuilt: indices that do not exist here are not an
  // error.
  for (int i = 0; i < cache.count && i < 4; ++i) {
    if (cache.a[i] < a.vertex_count && cache.b[i] < b.vertex_count)
      set_point(pair, cache.a[i], cache.b[i], s.n++, s);
  }
  if (s.n > 0) return;
  const Vec3 toward = x.rotation * b.center + x.translation - a.center;
  set_point(pair, support_vertex(a, toward), support_vertex(b, -(x.rotation.transpose() * toward)),
            0, s);
  s.n = 1;
}

bool holds(const Simplex& s, int ia, int ib) {
  for (int i = 0; i < s.n; ++i) {
    if (s.a[i] == ia && s.b[i] == ib) return true;
  }
  return false;
}

// Vertices of the simplex, as masks.
struct Feature {
  std::uint32_t a = 0, b = 0;
};

Feature feature_of(const Simplex& s) {
  Feature f;
  for (int i = 0; i < s.n; ++i) {
    f.a |= 1u << s.a[i];
    f.b |= 1u << s.b[i];
  }
  return f;
}

// Whether vertices of the feature combine to points of the simplex only (or, edge against edge, to
// the fourth corner of the parallelogram of which it has three): then the simplex holds its own
// support point if no vertex outside the feature supports.
bool is_provable(const Simplex& s, const Feature& f) {
  const std::uint32_t rest_a = f.a & (f.a - 1), rest_b = f.b & (f.b - 1);  // all but one each
  const bool edges = s.n == 3 && ((rest_a & (rest_a - 1)) | (rest_b & (rest_b - 1))) == 0;
  return s.n <= 3 && (rest_a == 0 || rest_b == 0 || edges);
}

void finish(const HullView& a, const Simplex& s, const Vec3& v, Separation& out, GjkCache& cache) {
  const Feature f = feature_of(s);
  cache.count = static_cast<std::uint8_t>(s.n);
  cache.provable = is_provable(s, f) ? cache.count : 0;
  out.feature_a = f.a;
  out.feature_b = f.b;
  out.witness_a = Vec3::Zero();
  for (int i = 0; i < s.n; ++i) {
    cache.a[i] = s.a[i];
    cache.b[i] = s.b[i];
    out.witness_a += s.weight[i] * a.vertices[s.a[i]];
  }
  out.witness_b = out.witness_a - v;
}

// Rounding of a point of the difference; below it the sign of the separation means nothing.
double rounding_noise(const HullPair& pair) {
  const HullView &a = pair.a, &b = pair.b;
  const RelativePose& x = pair.a_from_b;
  return 0x1.0p-51 * (a.center.lpNorm<1>() + b.center.lpNorm<1>() + x.translation.lpNorm<1>() +
                      a.radius + b.radius);
}

}  // namespace

RelativePose relative_pose(const Pose& world_from_a, const Pose& world_from_b) noexcept {
  const Pose a_from_b = inverse(world_from_a) * world_from_b;
  return {a_from_b.orientation.toRotationMatrix(), a_from_b.position};
}

namespace {

// What the search carries from turn to turn.
struct Turn {
  Simplex simplex;
  Vec3 v = Vec3::Zero();  // nearest point of the simplex to the origin
  double vv = -1.0;       // its square, negative before the first turn
};

struct Limits {
  double size = 0.0;    // of the pair [m]
  double noise2 = 0.0;  // square of the distance below which the sign means nothing [m^2]
  double stop2 = 0.0;   // square of the distance at which the caller knows enough [m^2]
};

enum class Verdict : std::uint8_t { goes_on, optimal, stalled, overlapping, far_enough };

// Bounds of the distance, times v's length.
struct DistanceBounds {
  double low = 0.0;  // v . w of the support point w
  double gap = 0.0;  // upper minus lower
};

// One turn: nearest point, proofs that it is the answer, else the support point as a candidate
// (already in turn.simplex.w[n], not counted).
Verdict take_turn(const HullPair& pair, const Limits& limits, const Turn& previous, Turn& turn,
                  DistanceBounds& bounds) {
  const HullView &a = pair.a, &b = pair.b;
  Simplex& s = turn.simplex;
  turn.v = detail::reduce_to_nearest(s);
  turn.vv = turn.v.squaredNorm();
  if (s.n == 4 || turn.vv <= limits.noise2) return Verdict::overlapping;
  if (previous.vv >= 0.0 && !(turn.vv < previous.vv)) {  // rounding: the new point brought nothing
    turn = previous;
    return Verdict::stalled;
  }
  const double vv = turn.vv;
  const Vec3 v_b = pair.a_from_b.rotation.transpose() * turn.v;
  const Feature f = feature_of(s);
  const std::uint32_t maybe_a = detail::support_candidates(a, s.a[0], -turn.v);
  const std::uint32_t maybe_b = detail::support_candidates(b, s.b[0], v_b);
  if (((maybe_a & ~f.a) | (maybe_b & ~f.b)) == 0 && is_provable(s, f)) return Verdict::optimal;
  const int ia = detail::support_vertex_among(a, maybe_a, -turn.v);
  const int ib = detail::support_vertex_among(b, maybe_b, v_b);
  const int k = s.n;
  set_point(pair, ia, ib, k, s);
  const double vw = turn.v.dot(s.w[k]), gap = vv - vw;
  bounds = {vw, gap};
  if (vw > 0.0 && vw * vw > limits.stop2 * vv) return Verdict::far_enough;
  if (gap <= 0.0 ||
      gap * gap <= kRelativeGap * kRelativeGap * vv * std::max(vv, limits.size * limits.size))
    return Verdict::optimal;
  return holds(s, ia, ib) ? Verdict::optimal : Verdict::goes_on;
}

}  // namespace

namespace detail {

Separation search_closest_points(const HullView& a, const HullView& b, const RelativePose& x,
                                 double stop, GjkCache& cache) noexcept {
  Separation out;
  const HullPair pair{a, b, x};
  const double noise = rounding_noise(pair);
  const Limits limits{a.radius + b.radius, noise * noise, stop > 0.0 ? stop * stop : 0.0};
  Turn turn, previous;
  start(pair, cache, turn.simplex);
  DistanceBounds bounds;
  double lower = 0.0;
  Verdict verdict = Verdict::goes_on;
  for (out.iterations = 1;; ++out.iterations) {
    verdict = take_turn(pair, limits, previous, turn, bounds);
    if (verdict == Verdict::goes_on && out.iterations >= kMaxIterations) verdict = Verdict::stalled;
    if (verdict != Verdict::goes_on) break;
    if (bounds.low > 0.0) lower = std::max(lower, bounds.low / std::sqrt(turn.vv));
    previous = turn;
    ++turn.simplex.n;
  }
  finish(a, turn.simplex, turn.v, out, cache);
  const double distance = std::sqrt(turn.vv);
  const bool open = verdict == Verdict::stalled &&
                    bounds.gap > kStalledGap * distance * std::max(distance, limits.size);
  out.status = open ? GjkStatus::gave_up : GjkStatus::separated;
  out.distance = open ? lower : distance;
  if (verdict == Verdict::overlapping) {
    out.status = GjkStatus::overlapping;
    out.distance = 0.0;
  }
  if (verdict == Verdict::far_enough && bounds.gap > kRelativeGap * turn.vv)
    out.distance = bounds.low / distance;
  return out;
}

}  // namespace detail

namespace {

[[gnu::always_inline]] inline bool confirm(const GjkQuery& q, const detail::PlainPose& x,
                                           Separation& out) {
  using detail::ScalarLanes;
  const GjkQuery* const query[1] = {&q};
  Separation* const to[1] = {&out};
  switch (detail::is_verifiable<ScalarLanes>(q)) {
    case 1:
      return detail::verify_cached_simplices<ScalarLanes, 1>(query, x, to) != 0;
    case 2:
      return detail::verify_cached_simplices<ScalarLanes, 2>(query, x, to) != 0;
    case 3:
      return detail::verify_cached_simplices<ScalarLanes, 3>(query, x, to) != 0;
    default:
      return false;
  }
}

}  // namespace

Separation closest_points(const HullView& a, const HullView& b, const RelativePose& x, double stop,
                          GjkCache& cache) noexcept {
  Separation out;
  const detail::PlainPose plain{x.rotation.data(), x.translation.data(), x.translation.lpNorm<1>()};
  if (confirm({&a, &b, &cache}, plain, out)) return out;
  return detail::search_closest_points(a, b, x, stop, cache);
}

}  // namespace thigma
