#include "thigma/simplify/filtered_edge_collapse.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "thigma/core/index.h"
#include "thigma/simplify/detail/edge_start.h"
#include "thigma/simplify/detail/trial.h"

namespace thigma {
namespace {

using detail::EdgeStar;
using detail::StarTriangle;

/// Where the new vertex may go: from the start to the relaxed position.
struct VertexPath {
  const Vec3& start;    // v^
  const Vec3& relaxed;  // v~
};

/// The part of a path on which patches stay convex.
struct ConvexPart {
  const PatchedSurface& surface;
  VertexPath path;
  UnitInterval interval{};
};

/// Narrows by one condition on four points. Its slack is the height that counts as flat over the
/// larger of the two triangles it may be read as: the trials that follow measure heights over the
/// right one, and coplanar triangles must not fail here by their rounding.
void narrow(ConvexPart& part, const Vec3& va, const Vec3& vc, const Vec3& vd) {
  const double fixed = (vd - va).cross(vc - va).norm();
  const double moving = (vc - va).cross(part.path.start - va).norm();
  constrain(part.interval, {va, vc, vd, part.surface.flat * std::max(fixed, moving)},
            part.path.start, part.path.relaxed);
}

/// The edges inside patches that the collapse changes: spokes, and edges of the ring (Fig. 3.5).
void narrow_by_edges(ConvexPart& part, const EdgeStar& star,
                     const std::vector<RingTriangle>& ring) {
  for (std::size_t i = 0; i < star.triangles.size() && part.interval.is_feasible; ++i) {
    const StarTriangle& t = star.triangles[i];
    if (t.beyond >= 0 && part.surface.patch_of[idx(t.beyond)] == t.patch)
      narrow(part, ring[i].b, ring[i].a, ring[i].beyond);
    if (t.following >= 0 && star.triangles[idx(t.following)].patch == t.patch)
      narrow(part, ring[i].b, ring[i].a, ring[i].following);
  }
}

/// The rest of what keeps patches convex is linear in the position too: every vertex of a patch
/// below its new triangles, and the new vertex below its old ones.
void narrow_by_patches(ConvexPart& part, const CollapseScratch& scratch) {
  const PatchedSurface& surface = part.surface;
  const EdgeStar& star = scratch.star;
  const auto& x = surface.mesh.positions;
  for (std::size_t i = 0; i < star.patches.size(); ++i) {
    bool has_vertex = false;
    for (const StarTriangle& t : star.triangles) {
      if (t.patch != star.patches[i]) continue;
      has_vertex = true;
      for (const std::int32_t v : scratch.patch_vertices[i])
        if (v != star.tail && v != t.a && v != t.b)
          narrow(part, x[idx(t.b)], x[idx(t.a)], x[idx(v)]);
      if (!part.interval.is_feasible) return;
    }
    if (!has_vertex) continue;
    for (const std::int32_t t : surface.patches[idx(star.patches[i])].triangles) {
      if (std::abs(scratch.mark[idx(t)]) == scratch.epoch || !has_plane(surface, t)) continue;
      const auto c = corners_of(surface, t);
      constrain(part.interval,
                {c[0], c[1], c[2], surface.flat * (c[1] - c[0]).cross(c[2] - c[0]).norm()},
                part.path.start, part.path.relaxed);
      if (!part.interval.is_feasible) return;
    }
  }
}

/// Hands the original's vertices that the star stood for to the nearest of its new triangles.
void hand_over_samples(const PatchedSurface& surface, const EdgeStar& star,
                       detail::DeviationGuard& guard) {
  std::int32_t list = -1;  // of all of them
  const auto take = [&](std::int32_t triangle) {
    std::int32_t& first = guard.first_sample[idx(triangle)];
    while (first >= 0) {
      const std::int32_t v = first;
      first = guard.next_sample[idx(v)];
      guard.next_sample[idx(v)] = list;
      list = v;
    }
  };
  for (const StarTriangle& t : star.triangles) take(t.triangle);
  for (const std::int32_t t : star.removed)
    if (t >= 0) take(t);
  while (list >= 0) {
    const std::int32_t v = list;
    list = guard.next_sample[idx(v)];
    const Vec3& p = guard.original->positions[idx(v)];
    double least = std::numeric_limits<double>::infinity();
    std::int32_t nearest = star.triangles[0].triangle;
    for (const StarTriangle& t : star.triangles) {
      if (squared_distance(surface.box[idx(t.triangle)], p) > kFarther * least * least) continue;
      const auto c = corners_of(surface, t.triangle);
      const double distance = point_triangle_distance(p, c[0], c[1], c[2]);
      if (distance >= least) continue;
      least = distance;
      nearest = t.triangle;
    }
    guard.next_sample[idx(v)] = guard.first_sample[idx(nearest)];
    guard.first_sample[idx(nearest)] = v;
  }
}

}  // namespace

void commit_collapse(PatchedSurface& surface, CollapseContext& context,
                     std::vector<std::int32_t>& successor) {
  CollapseScratch& scratch = context.scratch;
  const EdgeStar& star = scratch.star;
  const Vec3 p = scratch.position;
  const Vec3 tail = surface.mesh.positions[idx(star.tail)];
  const Vec3 edge = surface.mesh.positions[idx(star.head)] - tail;
  const double share =
      std::clamp(edge.dot(p - tail) / std::max(edge.squaredNorm(), 1e-300), 0.0, 1.0);
  context.volume.now += volume_change(scratch.volume, p);
  collapse_edge(surface.mesh, star.halfedge, p, share);
  context.quadric[idx(star.tail)] += context.quadric[idx(star.head)];
  const std::int32_t near = detail::find_within_limit(context.guard, scratch.search, p,
                                                      {star.tail, star.head, star.tail});
  if (near >= 0) context.guard.near[idx(star.tail)] = near;
  for (const StarTriangle& t : star.triangles) refresh_triangle(surface, t.triangle);
  hand_over_samples(surface, star, context.guard);
  for (const std::int32_t t : star.removed) {
    if (t < 0) continue;
    std::erase(surface.patches[idx(surface.patch_of[idx(t)])].triangles, t);
    surface.patch_of[idx(t)] = -1;
  }
  const bool are_current = scratch.has_all_hulls && scratch.hulls_at == p;
  for (std::size_t i = 0; i < star.patches.size(); ++i) {
    const std::int32_t patch = star.patches[i];
    if (surface.patches[idx(patch)].triangles.empty()) {
      surface.patches[idx(patch)] = {};
      surface.tree.remove(patch);
      successor[idx(patch)] = star.triangles[0].patch;
      --surface.patch_count;
      continue;
    }
    if (!are_current)
      list_patch_half_spaces(surface, scratch.patch_vertices[i], scratch.hull,
                             scratch.half_spaces[i], scratch.patch_box[i]);
    set_patch(surface, patch, scratch.patch_vertices[i], scratch.half_spaces[i],
              scratch.patch_box[i]);
  }
}

namespace {

/// The relaxed position that goes with a start.
Vec3 relaxed(const CollapseScratch& scratch, const Vec3& v_hat, double edge) {
  return detail::clamped(relax(v_hat, scratch.ring), v_hat, detail::kReach * edge);
}

/// Tries the positions between a start and its relaxed position; keeps the one it takes.
CollapseOutcome try_start(const PatchedSurface& surface, const CollapseContext& context,
                          const VertexPath& path, bool& has_begun, CollapseScratch& scratch) {
  ConvexPart part{surface, path};
  UnitInterval& interval = part.interval;
  narrow_by_edges(part, scratch.star, scratch.ring);
  if (!interval.is_feasible) return CollapseOutcome::convexity;
  if (!has_begun) detail::begin_trials(surface, scratch);
  has_begun = true;
  narrow_by_patches(part, scratch);
  if (!interval.is_feasible) return CollapseOutcome::convexity;
  if (path.relaxed == path.start) interval.low = interval.high;
  const auto place = [&](double u) { return mix(u, path.start, path.relaxed); };
  const BisectionResult found =
      bisect(interval.low, interval.high, context.params.bisections,
             [&](double u) { return detail::try_position(surface, context, place(u), scratch); });
  if (!found.is_accepted) return scratch.reason;
  scratch.position = place(found.u);
  return CollapseOutcome::collapsed;
}

}  // namespace

std::vector<Quadric> vertex_quadrics(const PatchedSurface& surface) {
  std::vector<Quadric> quadrics(surface.mesh.positions.size());
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    const auto c = corners_of(surface, static_cast<std::int32_t>(t));
    const Vec3& normal = surface.normal[t];
    const double area = 0.5 * (c[1] - c[0]).cross(c[2] - c[0]).norm();
    const Quadric q = plane_quadric(normal, c[0], area);
    for (const std::int32_t v : surface.mesh.triangles[t]) quadrics[idx(v)] += q;
    for (std::size_t k = 0; k < 3; ++k) {
      if (surface.mesh.twin[3 * t + k] >= 0) continue;
      const Vec3 edge = c[(k + 1) % 3] - c[k];
      const Vec3 upright = edge.cross(normal);
      if (!(upright.squaredNorm() > 0.0)) continue;
      const Quadric rim = plane_quadric(upright.normalized(), c[k], edge.squaredNorm());
      quadrics[idx(surface.mesh.triangles[t][k])] += rim;
      quadrics[idx(surface.mesh.triangles[t][(k + 1) % 3])] += rim;
    }
  }
  return quadrics;
}

namespace {

CollapseOutcome find_position(const PatchedSurface& surface, const CollapseContext& context,
                              CollapseScratch& scratch) {
  const detail::Starts starts = detail::choose_starts(surface, context, scratch.star);
  const double edge = (surface.mesh.positions[idx(scratch.star.head)] -
                       surface.mesh.positions[idx(scratch.star.tail)])
                          .norm();
  bool has_begun = false;
  CollapseOutcome reason = CollapseOutcome::convexity;
  const auto succeeds = [&](const Vec3& v_hat, const Vec3& v_tilde) {
    const CollapseOutcome outcome =
        try_start(surface, context, {v_hat, v_tilde}, has_begun, scratch);
    // What stopped a trial tells more than that another start had none.
    if (outcome != CollapseOutcome::convexity) reason = outcome;
    return outcome == CollapseOutcome::collapsed;
  };
  const bool moves = starts.may_move && context.form.is_relaxed;
  const auto succeeds_from = [&](const Vec3& v_hat) {
    return succeeds(v_hat, moves ? relaxed(scratch, v_hat, edge) : v_hat);
  };
  for (int i = 0; i < starts.count; ++i) {
    const Vec3& v_hat = starts.position[static_cast<std::size_t>(i)];
    if (i == 0 && moves && context.form.keeps_volume) {
      const Vec3 v_tilde = relaxed(scratch, v_hat, edge);
      const Vec3 kept = detail::with_volume(scratch.volume, v_tilde, edge);
      if (kept != v_tilde && succeeds(v_hat, kept)) return CollapseOutcome::collapsed;
    }
    if (succeeds_from(v_hat)) return CollapseOutcome::collapsed;
  }
  if (!context.form.seeks_convex_start || !starts.may_move) return reason;
  if (!has_begun) detail::begin_trials(surface, scratch);
  has_begun = true;
  const std::optional<Vec3> best = detail::best_convex_start(surface, context, scratch);
  return best && succeeds_from(*best) ? CollapseOutcome::collapsed : reason;
}

}  // namespace

CollapseOutcome find_collapse(const PatchedSurface& surface, const CollapseContext& context,
                              std::int32_t halfedge, CollapseScratch& scratch) {
  scratch.answers.clear();
  scratch.tried.clear();
  scratch.outcome = CollapseOutcome::topology;
  if (halfedge < 0 || !can_collapse(surface.mesh, halfedge)) return scratch.outcome;
  detail::gather_star(surface, halfedge, scratch.star);
  detail::list_ring(surface, scratch.star, scratch.ring);
  detail::list_rim_boxes(surface, scratch.star, scratch.seen);
  scratch.volume = detail::volume_plane(surface, scratch.star);
  scratch.outcome = find_position(surface, context, scratch);
  return scratch.outcome;
}

CollapseOutcome filtered_edge_collapse(PatchedSurface& surface, CollapseContext& context,
                                       std::int32_t halfedge,
                                       std::vector<std::int32_t>& successor) {
  const CollapseOutcome outcome = find_collapse(surface, context, halfedge, context.scratch);
  if (outcome == CollapseOutcome::collapsed) commit_collapse(surface, context, successor);
  return outcome;
}

}  // namespace thigma
