#include "thigma/response/overlap_area.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

constexpr double kBent = 0.01;            // of the deepest: what w may be off a linear function
constexpr double kSmallest = 1.0 / 96.0;  // of the size: radius of the smallest part
constexpr double kLargest = 1.0 / 24.0;   // and of the largest that is not divided
constexpr int kDivisions = 24;            // of a triangle, at most

using Corners = std::array<OverlapSample, 3>;

struct Walk {
  const OverlapTask& task;
  OverlapScratch& scratch;
  Pose into_from;
  Mat3 world_rotation;  // of `into`
  Vec3 centre;          // in the frame of `into`
  PotentialMoments& moments;
  OverlapStats stats{};
};

OverlapSample sample_at(Walk& walk, const Vec3& at, std::int32_t& guess) noexcept {
  const PointDepth found = depth_inside(walk.task.into, at, guess);
  guess = found.triangle;
  ++walk.stats.points;
  return {at, found.depth + walk.task.tolerance, found.outward};
}

const OverlapSample& sample_vertex(Walk& walk, std::int32_t vertex, std::int32_t guess) noexcept {
  OverlapScratch& scratch = walk.scratch;
  OverlapSample& sample = scratch.vertices[idx(vertex)];
  if (scratch.known[idx(vertex)] == scratch.overlap) return sample;
  scratch.known[idx(vertex)] = scratch.overlap;
  const Vec3 at = transform_point(walk.into_from, walk.task.from.mesh.positions[idx(vertex)]);
  return sample = sample_at(walk, at, guess);
}

/// A corner of a part, with its gradients in the world.
AreaPoint point_of(const Walk& walk, const OverlapSample& sample) noexcept {
  AreaPoint point;
  point.depth = sample.w;
  const double side = walk.task.is_object ? -1.0 : 1.0;
  point.push = side * (walk.world_rotation * sample.outward);
  point.arm = walk.world_rotation * (sample.at - walk.centre);
  point.turn = point.arm.cross(point.push);
  return point;
}

AreaPoint between(const AreaPoint& a, const AreaPoint& b, double share) noexcept {
  AreaPoint p;
  p.depth = a.depth + share * (b.depth - a.depth);
  p.push = a.push + share * (b.push - a.push);
  p.turn = a.turn + share * (b.turn - a.turn);
  p.arm = a.arm + share * (b.arm - a.arm);
  return p;
}

/// Over a triangle between whose corners all is linear: over the part of it where w is above 0.
void integrate_cut(Walk& walk, const Corners& c) noexcept {
  if (!(c[0].w > 0.0 || c[1].w > 0.0 || c[2].w > 0.0)) return;
  ++walk.stats.cells;
  const AreaPoint p[3] = {point_of(walk, c[0]), point_of(walk, c[1]), point_of(walk, c[2])};
  const auto add = [&](const AreaPoint& a, const AreaPoint& b, const AreaPoint& d) {
    add_triangle(a, b, d, walk.task.weight, walk.task.exponent, walk.moments);
  };
  if (c[0].w >= 0.0 && c[1].w >= 0.0 && c[2].w >= 0.0) return add(p[0], p[1], p[2]);
  AreaPoint cut[4];
  std::size_t count = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const AreaPoint &a = p[k], &b = p[(k + 1) % 3];
    if (a.depth >= 0.0) cut[count++] = a;
    if ((a.depth > 0.0 && b.depth < 0.0) || (a.depth < 0.0 && b.depth > 0.0)) {
      cut[count] = between(a, b, a.depth / (a.depth - b.depth));
      cut[count++].depth = 0.0;
    }
  }
  for (std::size_t k = 1; k + 1 < count; ++k) add(cut[0], cut[k], cut[k + 1]);
}

/// Whether w is the linear function that its middle tells, at the corners.
bool is_linear(const Walk& walk, const Corners& corners, const OverlapSample& middle) noexcept {
  double most = std::max({middle.w, walk.task.tolerance, walk.moments.deepest}), off = 0.0;
  for (const OverlapSample& c : corners) {
    most = std::max(most, c.w);
    off = std::max(off, std::fabs(c.w - middle.w + middle.outward.dot(c.at - middle.at)));
  }
  return off <= kBent * most;
}

void walk_part(Walk& walk, const Corners& corners, std::int32_t guess, int division) noexcept {
  const Vec3 center = (corners[0].at + corners[1].at + corners[2].at) / 3.0;
  double radius = 0.0;
  for (const OverlapSample& c : corners) radius = std::max(radius, (c.at - center).norm());
  if (radius <= kSmallest * walk.task.size || division == kDivisions)
    return integrate_cut(walk, corners);
  const OverlapSample middle = sample_at(walk, center, guess);
  // The depth changes by no more than the way.
  if (!(middle.w + radius > 0.0)) return;
  if (radius <= kLargest * walk.task.size && is_linear(walk, corners, middle)) {
    // The middle is known as well: what is still bent is met three times as well.
    for (std::size_t k = 0; k < 3; ++k)
      integrate_cut(walk, {corners[k], corners[(k + 1) % 3], middle});
    return;
  }
  Corners halves;  // between corner k and the next
  for (std::size_t k = 0; k < 3; ++k) {
    std::int32_t near = guess;
    halves[k] = sample_at(walk, 0.5 * (corners[k].at + corners[(k + 1) % 3].at), near);
  }
  for (std::size_t k = 0; k < 3; ++k)
    walk_part(walk, {corners[k], halves[k], halves[(k + 2) % 3]}, guess, division + 1);
  walk_part(walk, halves, guess, division + 1);
}

void walk_triangle(Walk& walk, std::int32_t triangle, std::int32_t guess) noexcept {
  const auto& t = walk.task.from.mesh.triangles[idx(triangle)];
  const std::vector<Vec3>& p = walk.task.from.mesh.positions;
  const double reach =
      std::max((p[idx(t[1])] - p[idx(t[0])]).norm(), (p[idx(t[2])] - p[idx(t[0])]).norm());
  Corners corners;
  corners[0] = sample_vertex(walk, t[0], guess);
  if (!(corners[0].w + reach > 0.0)) return;
  for (std::size_t k = 1; k < 3; ++k) corners[k] = sample_vertex(walk, t[k], guess);
  walk_part(walk, corners, guess, 0);
}

void walk_node(Walk& walk, std::int32_t index, std::int32_t guess) noexcept {
  const TreeNode& node = walk.task.from.tree.nodes[idx(index)];
  const Vec3 center = 0.5 * (node.box.min + node.box.max);
  const double radius = 0.5 * (node.box.max - node.box.min).norm();
  const OverlapSample middle = sample_at(walk, transform_point(walk.into_from, center), guess);
  if (!(middle.w + radius > 0.0)) return;
  if (node.count > 0) {
    for (std::int32_t i = node.first; i < node.first + node.count; ++i)
      walk_triangle(walk, walk.task.from.tree.order[idx(i)], guess);
    return;
  }
  walk_node(walk, index + 1, guess);
  walk_node(walk, node.right, guess);
}

}  // namespace

void reserve_overlap(const SolidSurface& surface, OverlapScratch& scratch) {
  scratch.vertices.resize(surface.mesh.positions.size());
  scratch.known.assign(surface.mesh.positions.size(), 0);
  scratch.overlap = 0;
}

OverlapStats add_overlap(const OverlapTask& task, OverlapScratch& scratch,
                         PotentialMoments& moments) noexcept {
  if (task.from.tree.nodes.empty() || task.into.tree.nodes.empty()) return {};
  if (++scratch.overlap == 0) {  // after 2^32 overlaps
    std::fill(scratch.known.begin(), scratch.known.end(), 0);
    scratch.overlap = 1;
  }
  const Pose into_from_world = inverse(task.world_into);
  Walk walk{task,
            scratch,
            into_from_world * task.world_from,
            rotation_matrix(task.world_into.orientation),
            transform_point(into_from_world, task.centre),
            moments};
  walk_node(walk, 0, -1);
  return walk.stats;
}

}  // namespace thigma
