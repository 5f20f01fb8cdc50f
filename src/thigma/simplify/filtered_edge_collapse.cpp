#include "thigma/simplify/filtered_edge_collapse.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/simplify/detail/trial.h"

namespace thigma {
namespace {

std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }

using detail::EdgeStar;
using detail::StarTriangle;

/// A position never starts or relaxes farther than this many edge lengths away from the edge.
constexpr double kReach = 2.0;
/// Steps that keep the volume, in edge lengths: smaller ones would only unsettle flat and smoothly
/// curved patches, where hardly any position is convex; larger ones are folds.
constexpr double kLeastStep = 0.01, kLargestStep = 0.5;

/// Narrows by one condition on four points. Its slack is the height that counts as flat over the
/// larger of the two triangles it may be read as: the trials that follow measure heights over the
/// right one, and coplanar triangles must not fail here by their rounding.
void narrow(UnitInterval& interval, const PatchedSurface& s, const Vec3& va, const Vec3& vc,
            const Vec3& vd, const Vec3& v_hat, const Vec3& v_tilde) {
  const double fixed = (vd - va).cross(vc - va).norm();
  const double moving = (vc - va).cross(v_hat - va).norm();
  constrain(interval, {va, vc, vd, s.flat * std::max(fixed, moving)}, v_hat, v_tilde);
}

/// The edges inside patches that the collapse changes: spokes, and edges of the ring (Fig. 3.5).
void narrow_by_edges(UnitInterval& interval, const PatchedSurface& s, const EdgeStar& star,
                     const std::vector<RingTriangle>& ring, const Vec3& v_hat,
                     const Vec3& v_tilde) {
  for (std::size_t i = 0; i < star.triangles.size() && interval.is_feasible; ++i) {
    const StarTriangle& t = star.triangles[i];
    if (t.beyond >= 0 && s.patch_of[at(t.beyond)] == t.patch)
      narrow(interval, s, ring[i].b, ring[i].a, ring[i].beyond, v_hat, v_tilde);
    if (t.following >= 0 && star.triangles[at(t.following)].patch == t.patch)
      narrow(interval, s, ring[i].b, ring[i].a, ring[i].following, v_hat, v_tilde);
  }
}

/// The rest of what keeps patches convex is linear in the position too: every vertex of a patch
/// below its new triangles, and the new vertex below its old ones.
void narrow_by_patches(UnitInterval& interval, const PatchedSurface& s,
                       const detail::EdgeStar& star, const CollapseScratch& k, const Vec3& v_hat,
                       const Vec3& v_tilde) {
  const auto& x = s.mesh.positions;
  for (std::size_t i = 0; i < star.patches.size(); ++i) {
    bool has_vertex = false;
    for (const StarTriangle& t : star.triangles) {
      if (t.patch != star.patches[i]) continue;
      has_vertex = true;
      for (const std::int32_t v : k.patch_vertices[i])
        if (v != star.tail && v != t.a && v != t.b)
          narrow(interval, s, x[at(t.b)], x[at(t.a)], x[at(v)], v_hat, v_tilde);
      if (!interval.is_feasible) return;
    }
    if (!has_vertex) continue;
    for (const std::int32_t t : s.patches[at(star.patches[i])].triangles) {
      if (k.mark[at(t)] == k.epoch || k.mark[at(t)] == -k.epoch || !has_plane(s, t)) continue;
      const auto c = corners_of(s, t);
      constrain(interval, {c[0], c[1], c[2], s.flat * (c[1] - c[0]).cross(c[2] - c[0]).norm()},
                v_hat, v_tilde);
      if (!interval.is_feasible) return;
    }
  }
}

Vec3 clamped(const Vec3& p, const Vec3& from, double reach) {
  const Vec3 step = p - from;
  const double length = step.norm();
  return length <= reach ? p : Vec3(from + (reach / length) * step);
}

/// Where the new vertex may lie for the volume under the star to stay what it was: a plane.
struct VolumePlane {
  Vec3 normal = Vec3::Zero();  // twice the vector area of the ring [m^2]
  double offset = 0.0;         // [m^3]
};

VolumePlane volume_plane(const PatchedSurface& s, const EdgeStar& star) {
  const auto& x = s.mesh.positions;
  const Vec3 origin = x[at(star.tail)];
  VolumePlane plane;
  const auto add_old = [&](std::int32_t t) {
    const auto& v = s.mesh.triangles[at(t)];
    plane.offset += (x[at(v[0])] - origin).dot((x[at(v[1])] - origin).cross(x[at(v[2])] - origin));
  };
  for (const StarTriangle& t : star.triangles) {
    plane.normal += (x[at(t.a)] - origin).cross(x[at(t.b)] - origin);
    add_old(t.triangle);
  }
  for (const std::int32_t t : star.removed)
    if (t >= 0) add_old(t);
  plane.offset += plane.normal.dot(origin);
  return plane;
}

/// p moved onto the plane, if that is a step worth taking and no leap.
Vec3 with_volume(const VolumePlane& plane, const Vec3& p, double edge) {
  const double size = plane.normal.norm();
  if (!(size > 0.0)) return p;
  const double step = (plane.offset - plane.normal.dot(p)) / size;
  if (!(std::fabs(step) >= kLeastStep * edge && std::fabs(step) <= kLargestStep * edge)) return p;
  return p + (step / size) * plane.normal;
}

struct Starts {
  std::array<Vec3, 3> position;
  int count = 0;
  bool may_move = true;  // relax from there
};

/// Where the vertex may start, best first.
Starts choose_starts(const PatchedSurface& s, const CollapseContext& context) {
  const EdgeStar& star = context.scratch.star;
  const Vec3 &tail = s.mesh.positions[at(star.tail)], &head = s.mesh.positions[at(star.head)];
  Quadric sum = context.quadric[at(star.tail)];
  sum += context.quadric[at(star.head)];
  Starts starts;
  starts.may_move = !star.is_tail_on_boundary && !star.is_head_on_boundary;
  if (starts.may_move) {
    const Vec3 middle = 0.5 * tail + 0.5 * head;
    const double length = (head - tail).norm();
    starts.position[0] = clamped(minimize(sum, middle), middle, kReach * length);
    starts.count = 1;
  }
  const bool head_first = star.is_head_on_boundary &&
                          (!star.is_tail_on_boundary || evaluate(sum, head) < evaluate(sum, tail));
  const auto add = [&](const Vec3& p) {
    starts.position[static_cast<std::size_t>(starts.count++)] = p;
  };
  if (starts.may_move || star.is_tail_on_boundary == star.is_head_on_boundary) {
    add(head_first ? head : tail);
    add(head_first ? tail : head);
  } else {
    add(head_first ? head : tail);
  }
  return starts;
}

/// Hands the original's vertices that the star stood for to the nearest of its new triangles.
void hand_over_samples(const PatchedSurface& s, const EdgeStar& star,
                       detail::DeviationGuard& guard) {
  std::int32_t list = -1;  // of all of them
  const auto take = [&](std::int32_t triangle) {
    std::int32_t& first = guard.first_sample[at(triangle)];
    while (first >= 0) {
      const std::int32_t v = first;
      first = guard.next_sample[at(v)];
      guard.next_sample[at(v)] = list;
      list = v;
    }
  };
  for (const StarTriangle& t : star.triangles) take(t.triangle);
  for (const std::int32_t t : star.removed)
    if (t >= 0) take(t);
  while (list >= 0) {
    const std::int32_t v = list;
    list = guard.next_sample[at(v)];
    double least = std::numeric_limits<double>::infinity();
    std::int32_t nearest = star.triangles[0].triangle;
    for (const StarTriangle& t : star.triangles) {
      const auto c = corners_of(s, t.triangle);
      const double distance =
          point_triangle_distance(guard.original->positions[at(v)], c[0], c[1], c[2]);
      if (distance >= least) continue;
      least = distance;
      nearest = t.triangle;
    }
    guard.next_sample[at(v)] = guard.first_sample[at(nearest)];
    guard.first_sample[at(nearest)] = v;
  }
}

void commit(PatchedSurface& s, CollapseContext& context, const Vec3& p,
            std::vector<std::int32_t>& successor) {
  CollapseScratch& k = context.scratch;
  const EdgeStar& star = k.star;
  const Vec3 tail = s.mesh.positions[at(star.tail)];
  const Vec3 edge = s.mesh.positions[at(star.head)] - tail;
  const double share =
      std::clamp(edge.dot(p - tail) / std::max(edge.squaredNorm(), 1e-300), 0.0, 1.0);
  collapse_edge(s.mesh, star.halfedge, p, share);
  context.quadric[at(star.tail)] += context.quadric[at(star.head)];
  const std::int32_t near =
      detail::find_within_limit(context.guard, p, {star.tail, star.head, star.tail});
  if (near >= 0) context.guard.near[at(star.tail)] = near;
  for (const StarTriangle& t : star.triangles) refresh_triangle(s, t.triangle);
  hand_over_samples(s, star, context.guard);
  for (const std::int32_t t : star.removed) {
    if (t < 0) continue;
    std::erase(s.patches[at(s.patch_of[at(t)])].triangles, t);
    s.patch_of[at(t)] = -1;
  }
  const bool are_current = k.has_all_hulls && k.hulls_at == p;
  for (std::size_t i = 0; i < star.patches.size(); ++i) {
    const std::int32_t patch = star.patches[i];
    if (s.patches[at(patch)].triangles.empty()) {
      s.patches[at(patch)] = {};
      s.tree.remove(patch);
      successor[at(patch)] = star.triangles[0].patch;
      --s.patch_count;
      continue;
    }
    if (!are_current)
      list_patch_half_spaces(s, k.patch_vertices[i], k.hull, k.half_spaces[i], k.patch_box[i]);
    set_patch(s, patch, k.patch_vertices[i], k.half_spaces[i], k.patch_box[i]);
  }
}

/// The relaxed position that goes with a start.
Vec3 relaxed(const CollapseContext& context, const Vec3& v_hat, double edge) {
  return clamped(relax(v_hat, context.scratch.ring), v_hat, kReach * edge);
}

/// Tries the positions between a start and its relaxed position; commits the one it takes.
CollapseOutcome try_start(PatchedSurface& s, CollapseContext& context, const Vec3& v_hat,
                          const Vec3& v_tilde, bool& has_begun,
                          std::vector<std::int32_t>& successor) {
  CollapseScratch& k = context.scratch;
  UnitInterval interval;
  narrow_by_edges(interval, s, k.star, k.ring, v_hat, v_tilde);
  if (!interval.is_feasible) return CollapseOutcome::convexity;
  if (!has_begun) detail::begin_trials(s, context);
  has_begun = true;
  narrow_by_patches(interval, s, k.star, k, v_hat, v_tilde);
  if (!interval.is_feasible) return CollapseOutcome::convexity;
  if (v_tilde == v_hat) interval.low = interval.high;
  const BisectionResult found =
      bisect(interval.low, interval.high, context.params.bisections,
             [&](double u) { return detail::try_position(s, context, mix(u, v_hat, v_tilde)); });
  if (!found.is_accepted) return k.reason;
  commit(s, context, mix(found.u, v_hat, v_tilde), successor);
  return CollapseOutcome::collapsed;
}

}  // namespace

std::vector<Quadric> vertex_quadrics(const PatchedSurface& s) {
  std::vector<Quadric> quadrics(s.mesh.positions.size());
  for (std::size_t t = 0; t < s.mesh.triangles.size(); ++t) {
    const auto c = corners_of(s, static_cast<std::int32_t>(t));
    const Vec3& normal = s.normal[t];
    const double area = 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm();
    const Quadric q = plane_quadric(normal, c[0], area);
    for (const std::int32_t v : s.mesh.triangles[t]) quadrics[at(v)] += q;
    for (std::size_t k = 0; k < 3; ++k) {
      if (s.mesh.twin[3 * t + k] >= 0) continue;
      const Vec3 edge = c[(k + 1) % 3] - c[k];
      const Vec3 upright = edge.cross(normal);
      if (!(upright.squaredNorm() > 0.0)) continue;
      const Quadric rim = plane_quadric(upright.normalized(), c[k], edge.squaredNorm());
      quadrics[at(s.mesh.triangles[t][k])] += rim;
      quadrics[at(s.mesh.triangles[t][(k + 1) % 3])] += rim;
    }
  }
  return quadrics;
}

CollapseOutcome filtered_edge_collapse(PatchedSurface& s, CollapseContext& context,
                                       std::int32_t halfedge,
                                       std::vector<std::int32_t>& successor) {
  if (!can_collapse(s.mesh, halfedge)) return CollapseOutcome::topology;
  CollapseScratch& k = context.scratch;
  detail::gather_star(s, halfedge, k.star);
  detail::list_ring(s, k.star, k.ring);
  const Starts starts = choose_starts(s, context);
  const double edge =
      (s.mesh.positions[at(k.star.head)] - s.mesh.positions[at(k.star.tail)]).norm();
  bool has_begun = false;
  CollapseOutcome reason = CollapseOutcome::convexity;
  const auto succeeds = [&](const Vec3& v_hat, const Vec3& v_tilde) {
    const CollapseOutcome outcome = try_start(s, context, v_hat, v_tilde, has_begun, successor);
    // What stopped a trial tells more than that another start had none.
    if (outcome != CollapseOutcome::convexity) reason = outcome;
    return outcome == CollapseOutcome::collapsed;
  };
  for (int i = 0; i < starts.count; ++i) {
    const Vec3& v_hat = starts.position[static_cast<std::size_t>(i)];
    const bool moves = starts.may_move && context.params.is_relaxed;
    const Vec3 v_tilde = moves ? relaxed(context, v_hat, edge) : v_hat;
    if (i == 0 && moves && context.params.keeps_volume) {
      const Vec3 kept = with_volume(volume_plane(s, k.star), v_tilde, edge);
      if (kept != v_tilde && succeeds(v_hat, kept)) return CollapseOutcome::collapsed;
    }
    if (succeeds(v_hat, v_tilde)) return CollapseOutcome::collapsed;
  }
  return reason;
}

}  // namespace thigma
