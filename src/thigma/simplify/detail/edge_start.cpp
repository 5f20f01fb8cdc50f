#include "thigma/simplify/detail/edge_start.h"

#include <cmath>

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

/// Steps that keep the volume, in edge lengths: smaller ones would only unsettle flat and smoothly
/// curved patches, where hardly any position is convex; larger ones are folds.
constexpr double kLeastStep = 0.01, kLargestStep = 0.5;
/// Of the trace: what draws the best convex start to the unconstrained one where the quadric is
/// open.
constexpr double kPull = 0.01;

Quadric edge_quadric(const CollapseContext& context, const EdgeStar& star) {
  Quadric sum = context.quadric[idx(star.tail)];
  sum += context.quadric[idx(star.head)];
  return sum;
}

Vec3 quadric_start(const PatchedSurface& surface, const CollapseContext& context,
                   const EdgeStar& star) {
  const Vec3 &tail = surface.mesh.positions[idx(star.tail)],
             &head = surface.mesh.positions[idx(star.head)];
  const Vec3 middle = 0.5 * tail + 0.5 * head;
  return clamped(minimize(edge_quadric(context, star), middle), middle,
                 kReach * (head - tail).norm());
}

/// That the vertex stays on the side of the triangle (va, vc, vd) on which a patch with both is
/// convex. Half of the height that counts as flat is left to the rounding of the trials.
void add_plane(const PatchedSurface& surface, const Vec3& va, const Vec3& vc, const Vec3& vd,
               std::vector<LinearConstraint>& list) {
  const Vec3 normal = (vc - va).cross(vd - va);
  const double size = normal.norm();
  if (size > 0.0) list.push_back({normal / size, normal.dot(va) / size + 0.5 * surface.flat});
}

/// The conditions of narrow_by_edges and narrow_by_patches as half-spaces.
void list_constraints(const PatchedSurface& surface, CollapseScratch& scratch) {
  const auto& x = surface.mesh.positions;
  scratch.constraints.clear();
  for (std::size_t i = 0; i < scratch.star.patches.size(); ++i) {
    bool has_vertex = false;
    for (const StarTriangle& t : scratch.star.triangles) {
      if (t.patch != scratch.star.patches[i]) continue;
      has_vertex = true;
      for (const std::int32_t v : scratch.patch_vertices[i])
        if (v != scratch.star.tail && v != t.a && v != t.b)
          add_plane(surface, x[idx(t.b)], x[idx(t.a)], x[idx(v)], scratch.constraints);
    }
    if (!has_vertex) continue;
    for (const std::int32_t t : surface.patches[idx(scratch.star.patches[i])].triangles) {
      if (scratch.mark[idx(t)] == scratch.epoch || scratch.mark[idx(t)] == -scratch.epoch ||
          !has_plane(surface, t))
        continue;
      const auto c = corners_of(surface, t);
      add_plane(surface, c[0], c[1], c[2], scratch.constraints);
    }
  }
}

}  // namespace

Vec3 clamped(const Vec3& p, const Vec3& from, double reach) {
  const Vec3 step = p - from;
  const double length = step.norm();
  return length <= reach ? p : Vec3(from + (reach / length) * step);
}

VolumePlane volume_plane(const PatchedSurface& surface, const EdgeStar& star) {
  const auto& x = surface.mesh.positions;
  const Vec3 origin = x[idx(star.tail)];
  VolumePlane plane;
  const auto add_old = [&](std::int32_t t) {
    const auto& v = surface.mesh.triangles[idx(t)];
    plane.offset +=
        (x[idx(v[0])] - origin).dot((x[idx(v[1])] - origin).cross(x[idx(v[2])] - origin));
  };
  for (const StarTriangle& t : star.triangles) {
    plane.normal += (x[idx(t.a)] - origin).cross(x[idx(t.b)] - origin);
    add_old(t.triangle);
  }
  for (const std::int32_t t : star.removed)
    if (t >= 0) add_old(t);
  plane.offset += plane.normal.dot(origin);
  return plane;
}

Vec3 with_volume(const VolumePlane& plane, const Vec3& p, double edge) {
  const double size = plane.normal.norm();
  if (!(size > 0.0)) return p;
  const double step = (plane.offset - plane.normal.dot(p)) / size;
  if (!(std::fabs(step) >= kLeastStep * edge && std::fabs(step) <= kLargestStep * edge)) return p;
  return p + (step / size) * plane.normal;
}

Starts choose_starts(const PatchedSurface& surface, const CollapseContext& context,
                     const EdgeStar& star) {
  const Vec3 &tail = surface.mesh.positions[idx(star.tail)],
             &head = surface.mesh.positions[idx(star.head)];
  const Quadric sum = edge_quadric(context, star);
  Starts starts;
  starts.may_move = !star.is_tail_on_boundary && !star.is_head_on_boundary;
  if (starts.may_move) {
    starts.position[0] = quadric_start(surface, context, star);
    starts.count = 1;
  }
  const bool head_first = star.is_head_on_boundary &&
                          (!star.is_tail_on_boundary || evaluate(sum, head) < evaluate(sum, tail));
  const auto add = [&](const Vec3& p) {
    starts.position[static_cast<std::size_t>(starts.count++)] = p;
  };
  add(head_first ? head : tail);
  if (starts.may_move || star.is_tail_on_boundary == star.is_head_on_boundary)
    add(head_first ? tail : head);
  return starts;
}

std::optional<Vec3> best_convex_start(const PatchedSurface& surface, const CollapseContext& context,
                                      CollapseScratch& scratch) {
  const Vec3 &tail = surface.mesh.positions[idx(scratch.star.tail)],
             &head = surface.mesh.positions[idx(scratch.star.head)];
  const Quadric sum = edge_quadric(context, scratch.star);
  if (!(sum.a.trace() > 0.0)) return std::nullopt;
  list_constraints(surface, scratch);
  const std::optional<Vec3> p = nearest_feasible(quadric_start(surface, context, scratch.star),
                                                 sum.a + kPull * sum.a.trace() * Mat3::Identity(),
                                                 scratch.constraints, 0.1 * surface.flat);
  if (!p || !((*p - 0.5 * (tail + head)).norm() <= kReach * (head - tail).norm()))
    return std::nullopt;
  return p;
}

}  // namespace thigma::detail
