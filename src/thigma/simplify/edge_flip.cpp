#include "thigma/simplify/edge_flip.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "thigma/core/index.h"
#include "thigma/mesh/halfedge_flip.h"
#include "thigma/simplify/detail/patch_part.h"
#include "thigma/simplify/detail/triangle_trial.h"

namespace thigma {
namespace {

// Flipping makes the volume grow, so it ends; broken surfaces may take long about it.
constexpr int kSweeps = 12;

struct Flip {
  std::int32_t halfedge = -1;
  FlipQuad quad;
  std::array<std::int32_t, 2> patch{-1, -1};  // of the two triangles
  std::array<std::int32_t, 4> outside{};  // half-edges beside b c, c a, a d, d b; -1 on a boundary
  std::array<Vec3, 2> old_normal;
  double old_quality = 0.0;  // of the worse of the two
  int old_crossings = 0, old_reflex = 0;
  double volume = 0.0;                   // what the object gains [m^3]
  std::vector<detail::PatchPart> parts;  // of the two patches, then those beside them
  std::size_t own_count = 0;             // of the first kind
};

bool is_reflex(const PatchedSurface& s, std::int32_t triangle, std::int32_t apex) {
  return has_plane(s, triangle) && height_over(s, triangle, s.mesh.positions[at(apex)]) > s.flat;
}

/// Of the edges around the quadrilateral, with its triangles as they are now.
int count_reflex(const PatchedSurface& s, const Flip& f,
                 const std::array<std::int32_t, 4>& inside) {
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    count += f.outside[i] >= 0 &&
             is_reflex(s, inside[i], tail_of(s.mesh, previous_halfedge(f.outside[i])));
  return count;
}

Flip describe(const PatchedSurface& s, std::int32_t halfedge) {
  const HalfedgeMesh& m = s.mesh;
  const std::int32_t twin = m.twin[at(halfedge)];
  Flip f;
  f.halfedge = halfedge;
  f.quad = quad_of(m, halfedge);
  const auto [one, two] = f.quad.triangle;
  f.patch = {s.patch_of[at(one)], s.patch_of[at(two)]};
  f.outside = {m.twin[at(next_halfedge(halfedge))], m.twin[at(previous_halfedge(halfedge))],
               m.twin[at(next_halfedge(twin))], m.twin[at(previous_halfedge(twin))]};
  f.old_normal = {s.normal[at(one)], s.normal[at(two)]};
  f.old_quality = std::min(detail::triangle_quality(corners_of(s, one)),
                           detail::triangle_quality(corners_of(s, two)));
  f.old_reflex = 1 + count_reflex(s, f, {one, one, two, two});
  f.old_crossings = detail::count_crossings(s, f.quad.triangle);
  const auto& x = m.positions;
  const Vec3& a = x[at(f.quad.a)];
  f.volume = (x[at(f.quad.b)] - a).cross(x[at(f.quad.c)] - a).dot(x[at(f.quad.d)] - a) / 6.0;
  return f;
}

bool has_good_shape(const PatchedSurface& s, const CollapseParams& params, const Flip& f) {
  const double least = std::min(params.least_quality, f.old_quality);
  for (const std::int32_t t : f.quad.triangle) {
    if (!(detail::triangle_quality(corners_of(s, t)) >= least)) return false;
    for (const Vec3& normal : f.old_normal)
      if (!(s.normal[at(t)].dot(normal) >= 0.1)) return false;
  }
  const std::array<std::int32_t, 4> inside = {f.quad.triangle[1], f.quad.triangle[0],
                                              f.quad.triangle[0], f.quad.triangle[1]};
  for (std::size_t i = 0; i < 4; ++i)
    if (f.outside[i] >= 0 &&
        s.normal[at(inside[i])].dot(s.normal[at(f.outside[i] / 3)]) < detail::kFoldCosine)
      return false;
  return true;
}

bool is_near_original(const PatchedSurface& s, detail::DeviationGuard& guard, const Flip& f) {
  const auto& x = s.mesh.positions;
  const Vec3 &a = x[at(f.quad.a)], &b = x[at(f.quad.b)], &c = x[at(f.quad.c)], &d = x[at(f.quad.d)];
  const std::array<std::int32_t, 3> near = {f.quad.a, f.quad.b, f.quad.c};
  if (!detail::is_within_limit(guard, {a, c, d}, near) ||
      !detail::is_within_limit(guard, {b, c, d}, near))
    return false;
  const auto one = corners_of(s, f.quad.triangle[0]), two = corners_of(s, f.quad.triangle[1]);
  for (const std::int32_t t : f.quad.triangle)
    for (std::int32_t v = guard.first_sample[at(t)]; v >= 0; v = guard.next_sample[at(v)]) {
      const Vec3& p = guard.original->positions[at(v)];
      if (point_triangle_distance(p, one[0], one[1], one[2]) > guard.limit &&
          point_triangle_distance(p, two[0], two[1], two[2]) > guard.limit)
        return false;
    }
  return true;
}

/// Lists the new patch, what is left of the two old ones, and, behind them, the patches beside
/// these.
/// returns  false when one of the own ones is entered
bool list_parts(const PatchedSurface& s, Quickhull& hull, Flip& f) {
  f.parts.assign(1, {});
  f.parts[0].triangles.assign(f.quad.triangle.begin(), f.quad.triangle.end());
  for (std::size_t i = 0; i < 2; ++i)
    detail::append_rest(s, f.patch[i], f.quad.triangle[i], f.parts);
  f.own_count = f.parts.size();
  const std::int32_t shell = s.patches[at(f.patch[0])].shell;
  for (detail::PatchPart& part : f.parts) {
    detail::describe_part(s, part, hull);
    if (!detail::is_hull_clear({s, shell, f.quad.triangle}, part, nullptr, part.half_spaces,
                               part.box))
      return false;
  }
  std::vector<std::int32_t> beside;
  const auto note = [&](std::int32_t halfedge) {
    if (halfedge < 0) return;
    const std::int32_t patch = s.patch_of[at(halfedge / 3)];
    if (patch != f.patch[0] && patch != f.patch[1] &&
        std::find(beside.begin(), beside.end(), patch) == beside.end())
      beside.push_back(patch);
  };
  for (const std::int32_t h : f.outside) note(h);
  for (std::size_t i = 1; i < f.own_count; ++i)
    for (const std::int32_t t : f.parts[i].triangles)
      for (std::int32_t k = 0; k < 3; ++k) note(s.mesh.twin[at(3 * t + k)]);
  for (const std::int32_t patch : beside) {
    detail::PatchPart part;
    part.triangles = s.patches[at(patch)].triangles;
    part.vertices = s.patches[at(patch)].vertices;
    part.patch = patch;
    f.parts.push_back(std::move(part));
  }
  return true;
}

bool enters_other_hull(const PatchedSurface& s, const Flip& f) {
  const std::int32_t shell = s.patches[at(f.patch[0])].shell;
  bool entered = false;
  for (const std::int32_t t : f.quad.triangle)
    s.tree.visit(box_of(corners_of(s, t)), [&](std::int32_t patch) {
      const SurfacePatch& p = s.patches[at(patch)];
      if (entered || patch == f.patch[0] || patch == f.patch[1] || p.shell != shell) return;
      entered = intrudes(s, t, p.half_spaces, p.box);
    });
  return entered;
}

/// Of the same number of patches: is the surface easier to merge, or nearer in volume?
bool is_better(const PatchedSurface& s, const VolumeGuard& volume, const Flip& f) {
  const auto [one, two] = f.quad.triangle;
  if (count_reflex(s, f, {two, one, one, two}) < f.old_reflex) return true;
  return std::isfinite(volume.limit) && std::fabs(volume.now + f.volume - volume.original) <
                                            std::fabs(volume.now - volume.original);
}

/// With the corners of the two triangles as they would be.
FlipOutcome judge(const PatchedSurface& s, CollapseContext& context, Flip& f, int& gain) {
  if (!has_good_shape(s, context.params, f)) return FlipOutcome::quality;
  if (!is_near_original(s, context.guard, f)) return FlipOutcome::deviation;
  if (!keeps_within(context.volume, f.volume)) return FlipOutcome::volume;
  if (detail::count_crossings(s, f.quad.triangle) > f.old_crossings)
    return FlipOutcome::intersection;
  Quickhull& hull = context.scratch.hull;
  if (enters_other_hull(s, f) || !list_parts(s, hull, f)) return FlipOutcome::protrusion;
  const int absorbed = detail::merge_parts({s, s.patches[at(f.patch[0])].shell, f.quad.triangle},
                                           f.own_count, hull, f.parts);
  gain = absorbed + 2 - static_cast<int>(f.own_count);
  const bool is_worth_it = gain > 0 || (gain == 0 && is_better(s, context.volume, f));
  return is_worth_it ? FlipOutcome::flipped : FlipOutcome::gain;
}

/// The original's vertices that the two triangles stood for go to the nearer one.
void hand_over_samples(const PatchedSurface& s, const FlipQuad& quad,
                       detail::DeviationGuard& guard) {
  std::vector<std::int32_t> samples;
  for (const std::int32_t t : quad.triangle) {
    for (std::int32_t v = guard.first_sample[at(t)]; v >= 0; v = guard.next_sample[at(v)])
      samples.push_back(v);
    guard.first_sample[at(t)] = -1;
  }
  const auto one = corners_of(s, quad.triangle[0]), two = corners_of(s, quad.triangle[1]);
  for (const std::int32_t v : samples) {
    const Vec3& p = guard.original->positions[at(v)];
    const bool is_nearer_one = point_triangle_distance(p, one[0], one[1], one[2]) <=
                               point_triangle_distance(p, two[0], two[1], two[2]);
    const std::int32_t t = quad.triangle[is_nearer_one ? 0 : 1];
    guard.next_sample[at(v)] = guard.first_sample[at(t)];
    guard.first_sample[at(t)] = v;
  }
}

/// Numbers of patches that no part has any more, those of the two old ones first.
std::vector<std::int32_t> free_numbers(const Flip& f) {
  std::vector<std::int32_t> numbers(f.patch.begin(), f.patch.end());
  for (const detail::PatchPart& part : f.parts)
    if (part.patch >= 0 && std::find(numbers.begin(), numbers.end(), part.patch) == numbers.end())
      numbers.push_back(part.patch);
  for (const detail::PatchPart& part : f.parts)
    if (!part.is_absorbed) std::erase(numbers, part.patch);
  return numbers;
}

void commit(PatchedSurface& s, CollapseContext& context, Flip& f,
            std::vector<std::int32_t>& successor) {
  hand_over_samples(s, f.quad, context.guard);
  context.volume.now += f.volume;
  const std::int32_t shell = s.patches[at(f.patch[0])].shell;
  std::vector<std::int32_t> numbers = free_numbers(f);
  const std::span<detail::PatchPart> own(f.parts.data(), f.own_count);
  for (detail::PatchPart& part : own) {
    if (part.is_absorbed) continue;
    if (part.patch < 0) {
      part.patch = numbers.front();
      numbers.erase(numbers.begin());
    }
    for (const std::int32_t t : part.triangles) s.patch_of[at(t)] = part.patch;
  }
  for (const std::int32_t patch : numbers) {
    successor[at(patch)] = s.patch_of[at(s.patches[at(patch)].triangles[0])];
    s.patches[at(patch)] = {};
    s.tree.remove(patch);
    --s.patch_count;
  }
  for (detail::PatchPart& part : own) {
    if (part.is_absorbed) continue;
    s.patches[at(part.patch)].shell = shell;
    s.patches[at(part.patch)].triangles = part.triangles;
    set_patch(s, part.patch, part.vertices, part.half_spaces, part.box);
  }
}

}  // namespace

FlipOutcome flip_reflex_edge(PatchedSurface& s, CollapseContext& context, std::int32_t halfedge,
                             std::vector<std::int32_t>& successor) {
  const std::int32_t twin = s.mesh.twin[at(halfedge)];
  if (twin < 0) return FlipOutcome::convex;
  const FlipQuad quad = quad_of(s.mesh, halfedge);
  const auto [one, two] = quad.triangle;
  if (s.patch_of[at(one)] == s.patch_of[at(two)] ||
      (!is_reflex(s, one, quad.d) && !is_reflex(s, two, quad.c)))
    return FlipOutcome::convex;
  if (!can_flip(s.mesh, halfedge)) return FlipOutcome::topology;
  Flip f = describe(s, halfedge);
  const auto set_corners = [&](bool is_flipped) {
    set_flipped_corners(s.mesh, halfedge, quad, is_flipped);
    for (const std::int32_t t : quad.triangle) refresh_triangle(s, t);
  };
  int gain = 0;
  set_corners(true);
  const FlipOutcome outcome = judge(s, context, f, gain);
  if (outcome == FlipOutcome::flipped) commit(s, context, f, successor);
  set_corners(false);
  if (outcome != FlipOutcome::flipped) return outcome;
  flip_edge(s.mesh, halfedge);
  for (const std::int32_t t : quad.triangle) refresh_triangle(s, t);
  return outcome;
}

std::int64_t flip_reflex_edges(PatchedSurface& s, CollapseContext& context,
                               const detail::DeviationLimit& limit,
                               std::vector<std::int32_t>& successor,
                               std::array<std::int64_t, kFlipOutcomes>& outcomes) {
  std::int64_t flipped = 0;
  const auto count = static_cast<std::int32_t>(s.mesh.twin.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const std::int64_t before = flipped;
    for (std::int32_t h = 0; h < count; ++h) {
      if (s.mesh.twin[at(h)] < h) continue;
      const FlipQuad quad = quad_of(s.mesh, h);
      const auto& x = s.mesh.positions;
      context.guard.limit = limit.of((x[at(quad.c)] - x[at(quad.d)]).norm());
      const FlipOutcome outcome = flip_reflex_edge(s, context, h, successor);
      ++outcomes[static_cast<std::size_t>(outcome)];
      flipped += outcome == FlipOutcome::flipped;
    }
    if (flipped == before) break;
  }
  return flipped;
}

}  // namespace thigma
