#include "thigma/contact/detail/patch_pair.h"

#include <bit>
#include <cmath>
#include <limits>

#include "thigma/convex/triangle_distance.h"

// A query that remembers must report the same bits as one that starts afresh. The closest points of disjoint convex
// hulls are determined by the hull vertices that support them: the sets of vertices within a hair of the two support
// planes. Where these are a vertex, an edge or a face on each side, not both more than a vertex unless two crossing
// edges, and the points lie well inside them, a closed form in those vertices, taken in order, is the answer, however
// the sets were found: remembered from the last frame and verified, or by GJK. Everything else (parallel faces,
// virtual faces of the hull, overlap) goes to pair_contact without memory.

namespace thigma::detail {
namespace {

// Times the sum of the radii. Distances below kNear leave the direction too uncertain for kActive, which has to be
// far above the rounding of a height (1e-16 / kNear = 1e-10) and far below the height of a real neighbour.
constexpr double kNear = 1e-6;
constexpr double kActive = 1e-8;
// How far inside an edge or a triangle a closest point has to lie (barycentric) and how far from parallel edges are.
constexpr double kInside = 1e-7;
constexpr double kCrossing = 1e-8;

struct Placement {
  const HullView& a;
  const HullView& b;
  const RelativePose& pose;
  Vec3 offset;  // from the centre of a to that of b [frame of a]
  double size;  // sum of the radii [m]

  Vec3 of_a(int i) const noexcept { return a.vertices[i] - a.center; }
  Vec3 of_b(int i) const noexcept { return pose.rotation * (b.vertices[i] - b.center) + offset; }
};

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

bool between_segments(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1, Closest& c) noexcept {
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

// Closest points of the features that two vertex sets span; false where there is no single real one.
bool closest_of_sets(const Placement& place, std::uint32_t ma, std::uint32_t mb, Closest& c) noexcept {
  const int na = std::popcount(ma), nb = std::popcount(mb);
  if (na == 0 || nb == 0) return false;
  if (na == 1 && nb == 1) {
    c = {place.of_a(lowest(ma)), place.of_b(lowest(mb))};
    return true;
  }
  if (na == 1) {
    c.p = place.of_a(lowest(ma));
    if (nb == 2) {
      return is_original_edge(place.b, mb) && on_segment(c.p, place.of_b(lowest(mb)), place.of_b(highest(mb)), c.q);
    }
    for (int t = 0; t < place.b.triangle_count; ++t) {
      const HullTriangle& tri = place.b.triangles[t];
      if ((tri.mask & mb) != tri.mask) continue;
      if (on_triangle(c.p, place.of_b(tri.corner[0]), place.of_b(tri.corner[1]), place.of_b(tri.corner[2]), c.q)) {
        return true;
      }
    }
    return false;
  }
  if (nb == 1) {
    c.q = place.of_b(lowest(mb));
    if (na == 2) {
      return is_original_edge(place.a, ma) && on_segment(c.q, place.of_a(lowest(ma)), place.of_a(highest(ma)), c.p);
    }
    for (int t = 0; t < place.a.triangle_count; ++t) {
      const HullTriangle& tri = place.a.triangles[t];
      if ((tri.mask & ma) != tri.mask) continue;
      if (on_triangle(c.q, place.of_a(tri.corner[0]), place.of_a(tri.corner[1]), place.of_a(tri.corner[2]), c.p)) {
        return true;
      }
    }
    return false;
  }
  return na == 2 && nb == 2 && is_original_edge(place.a, ma) && is_original_edge(place.b, mb) &&
         between_segments(place.of_a(lowest(ma)), place.of_a(highest(ma)), place.of_b(lowest(mb)),
                          place.of_b(highest(mb)), c);
}

struct Supports {
  std::uint32_t a = 0, b = 0;  // vertices within kActive of the two support planes
  double reach = 0.0;          // how far the hulls reach beyond the given heights, at most [m]
};

// Vertices of a no lower than top - hair and of b no higher than bottom + hair, along n.
Supports supports(const Placement& place, const Vec3& n, double top, double bottom) noexcept {
  Supports s;
  const double hair = kActive * place.size;
  for (int i = 0; i < place.a.vertex_count; ++i) {
    const double height = n.dot(place.of_a(i)) - top;
    s.a |= static_cast<std::uint32_t>(height > -hair) << i;
    s.reach = height > s.reach ? height : s.reach;
  }
  const Vec3 in_b = place.pose.rotation.transpose() * n;
  const double base = bottom - n.dot(place.offset);
  for (int i = 0; i < place.b.vertex_count; ++i) {
    const double height = base - in_b.dot(place.b.vertices[i] - place.b.center);
    s.b |= static_cast<std::uint32_t>(height > -hair) << i;
    s.reach = height > s.reach ? height : s.reach;
  }
  return s;
}

// The closest points by a closed form, when the sets prove to be the support sets.
bool verify(const Placement& place, std::uint32_t ma, std::uint32_t mb, PatchPair& result) noexcept {
  Closest c;
  if (!closest_of_sets(place, ma, mb, c)) return false;
  const Vec3 w = c.q - c.p;
  const double distance = std::sqrt(w.squaredNorm());
  if (!(distance > kNear * place.size)) return false;
  const Vec3 n = w / distance;
  const Supports s = supports(place, n, n.dot(c.p), n.dot(c.q));
  if (s.a != ma || s.b != mb || s.reach > kActive * place.size) return false;
  // Back to back, the pair may be through.
  if (backs_facing(place.a, ma, place.b, mb, place.pose, n) > 0.0) return false;
  result.status = PairContactStatus::separated;
  result.depth = -distance;
  result.separation = distance;
  result.feature_a = ma;
  result.feature_b = mb;
  result.normal = n;
  result.witness_a = c.p + place.a.center;
  result.witness_b = c.q + place.a.center;
  return true;
}

void remember(FrontNode& memory, const Vec3& normal, bool is_normal) noexcept {
  memory.has_normal = is_normal;
  for (int i = 0; i < 3; ++i) memory.axis[i] = static_cast<float>(normal[i]);
}

PatchPair measure_cold(const HullView& a, const HullView& b, const RelativePose& pose, double tolerance,
                       bool keep_direction, const SegmentProbe& probe, const EarlyDecision& early, FrontNode& memory,
                       QueryStats& stats) noexcept {
  GjkCache fresh;
  Vec3 last(memory.axis[0], memory.axis[1], memory.axis[2]);
  const bool has_last = keep_direction && memory.has_normal && last.squaredNorm() > 0.5;
  if (has_last) last.normalize();
  const PatchSeparation gap = patch_separation(a, b, pose, tolerance, keep_direction ? memory.gjk : fresh);
  ++stats.pair_queries;
  stats.triangle_pairs += gap.triangle_pairs;
  if (early.decide != nullptr && !(gap.distance > tolerance) &&
      !early.decide(early.context, gap.feature_a, gap.feature_b, gap.point_a, gap.point_b)) {
    memory.support_a = memory.support_b = 0;
    PatchPair part;
    part.status = PairContactStatus::separated;
    return part;
  }
  const PairContact pair = pair_contact(a, b, pose, tolerance, gap, has_last ? &last : nullptr, probe);
  memory.support_a = memory.support_b = 0;
  const bool touches = pair.status != PairContactStatus::apart;
  if (touches) remember(memory, pair.normal, true);
  else memory.has_normal = false;
  return {pair.status,     pair.depth,      pair.normal.normalized(), pair.witness_a,
          pair.witness_b,  pair.separation, pair.feature_a,           pair.feature_b};
}

}  // namespace

PatchPair measure_patches(const HullView& a, const HullView& b, const RelativePose& pose, double tolerance,
                          bool keep_direction, const SegmentProbe& probe, FrontNode& memory,
                          QueryStats& stats) noexcept {
  return measure_patches(a, b, pose, tolerance, keep_direction, probe, {}, memory, stats);
}

PatchPair measure_patches(const HullView& a, const HullView& b, const RelativePose& pose, double tolerance,
                          bool keep_direction, const SegmentProbe& probe, const EarlyDecision& early,
                          FrontNode& memory, QueryStats& stats) noexcept {
  const Placement place{a, b, pose, pose.rotation * b.center + pose.translation - a.center, a.radius + b.radius};
  PatchPair result;
  bool found = memory.support_a != 0 && verify(place, memory.support_a, memory.support_b, result);
  if (!found) {
    ++stats.pair_queries;
    const Separation s = closest_points(a, b, pose, std::numeric_limits<double>::infinity(), memory.gjk);
    const Vec3 w = s.witness_b - s.witness_a;
    if (s.status == PairStatus::separated && s.distance > kNear * place.size) {
      const Vec3 n = w / s.distance;
      if (s.distance > tolerance + 1e-9 * (place.size + tolerance)) {
        remember(memory, n, false);
        result.depth = -(s.distance - 1e-9 * place.size);
        return result;
      }
      const Supports sets = supports(place, n, n.dot(s.witness_a - a.center), n.dot(s.witness_b - a.center));
      found = verify(place, sets.a, sets.b, result);
      memory.support_a = found ? sets.a : 0;
      memory.support_b = found ? sets.b : 0;
    }
  }
  if (!found) return measure_cold(a, b, pose, tolerance, keep_direction, probe, early, memory, stats);
  const bool touches = -result.depth <= tolerance;
  remember(memory, result.normal, touches);
  if (!touches) result.status = PairContactStatus::apart;
  else if (early.decide != nullptr) {
    early.decide(early.context, result.feature_a, result.feature_b, result.witness_a, result.witness_b);
  }
  return result;
}

}  // namespace thigma::detail
