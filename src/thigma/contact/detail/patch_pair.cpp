#include "thigma/contact/detail/patch_pair.h"

#include <cmath>
#include <limits>

#include "thigma/contact/detail/support_sets.h"
#include "thigma/convex/patch_separation.h"

// A query that remembers must report the same bits as one that starts afresh. The closest points of
// disjoint convex hulls are determined by the hull vertices that support them: the sets of vertices
// within a hair of the two support planes. Where these are a vertex, an edge or a face on each
// side, not both more than a vertex unless two crossing edges, and the points lie well inside them,
// a closed form in those vertices, taken in order, is the answer, however the sets were found:
// remembered from the last frame and verified, or by GJK. Everything else (parallel faces, virtual
// faces of the hull, overlap) goes to pair_contact without memory.

namespace thigma::detail {
namespace {

// The closest points by a closed form, when the sets prove to be the support sets.
bool verify(const Placement& place, const SupportSets& sets, PatchPair& result) noexcept {
  SupportedDistance found;
  if (!closest_by_support(place, sets, Features::real, found)) return false;
  // Back to back, the pair may be through.
  if (backs_facing({place.a, place.b, place.pose}, sets.a, sets.b, found.normal) > 0.0)
    return false;
  result.status = PairContactStatus::separated;
  result.depth = -found.distance;
  result.separation = found.distance;
  result.feature_a = sets.a;
  result.feature_b = sets.b;
  result.is_of_hulls = true;
  result.normal = found.normal;
  result.witness_a = found.p + place.a.center;
  result.witness_b = found.q + place.a.center;
  return true;
}

void remember(FrontNode& memory, const Vec3& normal, bool is_normal) noexcept {
  memory.has_normal = is_normal;
  for (int i = 0; i < 3; ++i) memory.axis[i] = static_cast<float>(normal[i]);
}

// The contact that hulls which are apart make, by GJK without memory; false: by none, as they are
// too near for that.
bool measure_hulls(const PatchQuery& query, const Placement& place, FrontNode& memory,
                   PatchPair& result) noexcept {
  GjkCache fresh;
  const Separation s = closest_points(query.a, query.b, query.a_from_b,
                                      std::numeric_limits<double>::infinity(), fresh);
  if (s.status != GjkStatus::separated || !(s.distance > kNear * place.size)) return false;
  const bool touches = s.distance <= query.tolerance;
  result.status = touches ? PairContactStatus::separated : PairContactStatus::apart;
  result.depth = -s.distance;
  result.separation = s.distance;
  result.is_of_hulls = true;
  result.normal = (s.witness_b - s.witness_a).normalized();
  result.witness_a = s.witness_a;
  result.witness_b = s.witness_b;
  remember(memory, result.normal, touches);
  return true;
}

// The contact of two patches whose triangles were measured.
PatchPair contact_of(const PatchQuery& query, const PatchSeparation& gap, FrontNode& memory,
                     QueryStats& stats) noexcept {
  const EarlyDecision& early = query.early;
  Vec3 last(memory.axis[0], memory.axis[1], memory.axis[2]);
  const bool has_last = query.keeps_direction && memory.has_normal && last.squaredNorm() > 0.5;
  if (has_last) last.normalize();
  stats.triangle_pairs += gap.triangle_pairs;
  if (early.decide != nullptr && !(gap.distance > query.tolerance) &&
      !early.decide(early.context, gap.feature_a, gap.feature_b, gap.point_a, gap.point_b)) {
    memory.support_a = memory.support_b = 0;
    PatchPair part;
    part.status = PairContactStatus::separated;
    return part;
  }
  const PairContact pair = pair_contact({query.a, query.b, query.a_from_b}, query.tolerance, gap,
                                        has_last ? &last : nullptr, query.probe);
  memory.support_a = memory.support_b = 0;
  const bool touches = pair.status != PairContactStatus::apart;
  if (touches)
    remember(memory, pair.normal, true);
  else
    memory.has_normal = false;
  return {pair.status,     pair.depth,     pair.normal.normalized(), pair.witness_a, pair.witness_b,
          pair.separation, pair.feature_a, pair.feature_b,           false};
}

}  // namespace

PatchPair measure_patches(const PatchQuery& query, FrontNode& memory, QueryStats& stats) noexcept {
  const HullView &a = query.a, &b = query.b;
  const RelativePose& pose = query.a_from_b;
  const double tolerance = query.tolerance;
  const Placement place(a, b, pose);
  PatchPair result;
  PatchSeparation gap;
  // Triangles that meet need no look at the hulls, and those that met are likely to.
  if (memory.triangles.meet && triangles_pierce({a, b, pose}, memory.triangles, gap))
    return contact_of(query, gap, memory, stats);
  bool disjoint = false;
  bool found = memory.support_a != 0 && verify(place, {memory.support_a, memory.support_b}, result);
  if (!found) {
    ++stats.pair_queries;
    const Separation s =
        closest_points(a, b, pose, std::numeric_limits<double>::infinity(), memory.gjk);
    const Vec3 w = s.witness_b - s.witness_a;
    if (s.status == GjkStatus::separated && s.distance > kNear * place.size) {
      disjoint = true;
      const Vec3 n = w / s.distance;
      if (s.distance > tolerance + 1e-9 * (place.size + tolerance)) {
        remember(memory, n, false);
        result.depth = -(s.distance - 1e-9 * place.size);
        return result;
      }
      const SupportSets sets = support_sets(place, s.witness_a - a.center, s.witness_b - a.center);
      found = verify(place, sets, result);
      memory.support_a = found ? sets.a : 0;
      memory.support_b = found ? sets.b : 0;
      if (!found && query.measures_hulls && measure_hulls(query, place, memory, result))
        return result;
    }
  }
  if (!found) {
    gap = triangle_separation({a, b, pose}, tolerance, disjoint, memory.triangles);
    return contact_of(query, gap, memory, stats);
  }
  const bool touches = -result.depth <= tolerance;
  remember(memory, result.normal, touches);
  if (!touches)
    result.status = PairContactStatus::apart;
  else if (query.early.decide != nullptr) {
    query.early.decide(query.early.context, result.feature_a, result.feature_b, result.witness_a,
                       result.witness_b);
  }
  return result;
}

}  // namespace thigma::detail
