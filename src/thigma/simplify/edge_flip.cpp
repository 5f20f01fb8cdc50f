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

bool is_reflex(const PatchedSurface& surface, std::int32_t triangle, std::int32_t apex) {
  return has_plane(surface, triangle) &&
         height_over(surface, triangle, surface.mesh.positions[idx(apex)]) > surface.flat;
}

/// Of the edges around the quadrilateral, with its triangles as they are now.
int count_reflex(const PatchedSurface& surface, const Flip& flip,
                 const std::array<std::int32_t, 4>& inside) {
  int count = 0;
  for (std::size_t i = 0; i < 4; ++i)
    count +=
        flip.outside[i] >= 0 &&
        is_reflex(surface, inside[i], tail_of(surface.mesh, previous_halfedge(flip.outside[i])));
  return count;
}

Flip describe(const PatchedSurface& surface, std::int32_t halfedge) {
  const HalfedgeMesh& mesh = surface.mesh;
  const std::int32_t twin = mesh.twin[idx(halfedge)];
  Flip flip;
  flip.halfedge = halfedge;
  flip.quad = quad_of(mesh, halfedge);
  const auto [one, two] = flip.quad.triangle;
  flip.patch = {surface.patch_of[idx(one)], surface.patch_of[idx(two)]};
  flip.outside = {mesh.twin[idx(next_halfedge(halfedge))],
                  mesh.twin[idx(previous_halfedge(halfedge))], mesh.twin[idx(next_halfedge(twin))],
                  mesh.twin[idx(previous_halfedge(twin))]};
  flip.old_normal = {surface.normal[idx(one)], surface.normal[idx(two)]};
  flip.old_quality = std::min(detail::triangle_quality(corners_of(surface, one)),
                              detail::triangle_quality(corners_of(surface, two)));
  flip.old_reflex = 1 + count_reflex(surface, flip, {one, one, two, two});
  flip.old_crossings = detail::count_crossings(surface, flip.quad.triangle);
  const auto& x = mesh.positions;
  const Vec3& a = x[idx(flip.quad.a)];
  flip.volume =
      (x[idx(flip.quad.b)] - a).cross(x[idx(flip.quad.c)] - a).dot(x[idx(flip.quad.d)] - a) / 6.0;
  return flip;
}

bool has_good_shape(const PatchedSurface& surface, const CollapseParams& params, const Flip& flip) {
  const double least = std::min(params.least_quality, flip.old_quality);
  for (const std::int32_t t : flip.quad.triangle) {
    if (!(detail::triangle_quality(corners_of(surface, t)) >= least)) return false;
    for (const Vec3& normal : flip.old_normal)
      if (!(surface.normal[idx(t)].dot(normal) >= 0.1)) return false;
  }
  const std::array<std::int32_t, 4> inside = {flip.quad.triangle[1], flip.quad.triangle[0],
                                              flip.quad.triangle[0], flip.quad.triangle[1]};
  for (std::size_t i = 0; i < 4; ++i)
    if (flip.outside[i] >= 0 && surface.normal[idx(inside[i])].dot(
                                    surface.normal[idx(flip.outside[i] / 3)]) < detail::kFoldCosine)
      return false;
  return true;
}

bool is_near_original(const PatchedSurface& surface, CollapseContext& context, const Flip& flip) {
  const detail::DeviationGuard& guard = context.guard;
  detail::DeviationSearch& search = context.scratch.search;
  const auto& x = surface.mesh.positions;
  const Vec3 &a = x[idx(flip.quad.a)], &b = x[idx(flip.quad.b)], &c = x[idx(flip.quad.c)],
             &d = x[idx(flip.quad.d)];
  const std::array<std::int32_t, 3> near = {flip.quad.a, flip.quad.b, flip.quad.c};
  for (const std::array<Vec3, 3>& corners : {std::array{a, c, d}, std::array{b, c, d}})
    if (!detail::is_within_limit(guard, search, corners, near,
                                 detail::count_divisions(search.limit, corners)))
      return false;
  const auto one = corners_of(surface, flip.quad.triangle[0]),
             two = corners_of(surface, flip.quad.triangle[1]);
  for (const std::int32_t t : flip.quad.triangle)
    for (std::int32_t v = guard.first_sample[idx(t)]; v >= 0; v = guard.next_sample[idx(v)]) {
      const Vec3& p = guard.original->positions[idx(v)];
      if (point_triangle_distance(p, one[0], one[1], one[2]) > search.limit &&
          point_triangle_distance(p, two[0], two[1], two[2]) > search.limit)
        return false;
    }
  return true;
}

/// Lists the new patch, what is left of the two old ones, and, behind them, the patches beside
/// these.
/// returns  false when one of the own ones is entered
bool list_parts(const PatchedSurface& surface, Quickhull& hull, Flip& flip) {
  flip.parts.assign(1, {});
  flip.parts[0].triangles.assign(flip.quad.triangle.begin(), flip.quad.triangle.end());
  for (std::size_t i = 0; i < 2; ++i)
    detail::append_rest(surface, flip.patch[i], flip.quad.triangle[i], flip.parts);
  flip.own_count = flip.parts.size();
  const std::int32_t shell = surface.patches[idx(flip.patch[0])].shell;
  for (detail::PatchPart& part : flip.parts) {
    detail::describe_part(surface, part, hull);
    if (!detail::is_hull_clear({surface, shell, flip.quad.triangle}, part, nullptr,
                               part.half_spaces, part.box))
      return false;
  }
  std::vector<std::int32_t> beside;
  const auto note = [&](std::int32_t halfedge) {
    if (halfedge < 0) return;
    const std::int32_t patch = surface.patch_of[idx(halfedge / 3)];
    if (patch != flip.patch[0] && patch != flip.patch[1] &&
        std::find(beside.begin(), beside.end(), patch) == beside.end())
      beside.push_back(patch);
  };
  for (const std::int32_t h : flip.outside) note(h);
  for (std::size_t i = 1; i < flip.own_count; ++i)
    for (const std::int32_t t : flip.parts[i].triangles)
      for (std::int32_t k = 0; k < 3; ++k) note(surface.mesh.twin[idx(3 * t + k)]);
  for (const std::int32_t patch : beside) {
    detail::PatchPart part;
    part.triangles = surface.patches[idx(patch)].triangles;
    part.vertices = surface.patches[idx(patch)].vertices;
    part.patch = patch;
    flip.parts.push_back(std::move(part));
  }
  return true;
}

bool enters_other_hull(const PatchedSurface& surface, const Flip& flip) {
  const std::int32_t shell = surface.patches[idx(flip.patch[0])].shell;
  bool entered = false;
  for (const std::int32_t t : flip.quad.triangle)
    surface.tree.visit(surface.box[idx(t)], [&](std::int32_t patch) {
      const SurfacePatch& p = surface.patches[idx(patch)];
      if (entered || patch == flip.patch[0] || patch == flip.patch[1] || p.shell != shell) return;
      entered = intrudes(surface, t, p.half_spaces, p.box);
    });
  return entered;
}

/// Of the same number of patches: is the surface easier to merge, or nearer in volume?
bool is_better(const PatchedSurface& surface, const VolumeGuard& volume, const Flip& flip) {
  const auto [one, two] = flip.quad.triangle;
  if (count_reflex(surface, flip, {two, one, one, two}) < flip.old_reflex) return true;
  return std::isfinite(volume.limit) && std::fabs(volume.now + flip.volume - volume.original) <
                                            std::fabs(volume.now - volume.original);
}

/// With the corners of the two triangles as they would be.
FlipOutcome judge(const PatchedSurface& surface, CollapseContext& context, Flip& flip, int& gain) {
  if (!has_good_shape(surface, context.params, flip)) return FlipOutcome::quality;
  if (!is_near_original(surface, context, flip)) return FlipOutcome::deviation;
  if (!keeps_within(context.volume, flip.volume)) return FlipOutcome::volume;
  if (detail::count_crossings(surface, flip.quad.triangle) > flip.old_crossings)
    return FlipOutcome::intersection;
  Quickhull& hull = context.scratch.hull;
  if (enters_other_hull(surface, flip) || !list_parts(surface, hull, flip))
    return FlipOutcome::protrusion;
  const int absorbed =
      detail::merge_parts({surface, surface.patches[idx(flip.patch[0])].shell, flip.quad.triangle},
                          flip.own_count, hull, flip.parts);
  gain = absorbed + 2 - static_cast<int>(flip.own_count);
  const bool is_worth_it = gain > 0 || (gain == 0 && is_better(surface, context.volume, flip));
  return is_worth_it ? FlipOutcome::flipped : FlipOutcome::gain;
}

/// The original's vertices that the two triangles stood for go to the nearer one.
void hand_over_samples(const PatchedSurface& surface, const FlipQuad& quad,
                       detail::DeviationGuard& guard) {
  std::vector<std::int32_t> samples;
  for (const std::int32_t t : quad.triangle) {
    for (std::int32_t v = guard.first_sample[idx(t)]; v >= 0; v = guard.next_sample[idx(v)])
      samples.push_back(v);
    guard.first_sample[idx(t)] = -1;
  }
  const auto one = corners_of(surface, quad.triangle[0]),
             two = corners_of(surface, quad.triangle[1]);
  for (const std::int32_t v : samples) {
    const Vec3& p = guard.original->positions[idx(v)];
    const bool is_nearer_one = point_triangle_distance(p, one[0], one[1], one[2]) <=
                               point_triangle_distance(p, two[0], two[1], two[2]);
    const std::int32_t t = quad.triangle[is_nearer_one ? 0 : 1];
    guard.next_sample[idx(v)] = guard.first_sample[idx(t)];
    guard.first_sample[idx(t)] = v;
  }
}

/// Numbers of patches that no part has any more, those of the two old ones first.
std::vector<std::int32_t> free_numbers(const Flip& flip) {
  std::vector<std::int32_t> numbers(flip.patch.begin(), flip.patch.end());
  for (const detail::PatchPart& part : flip.parts)
    if (part.patch >= 0 && std::find(numbers.begin(), numbers.end(), part.patch) == numbers.end())
      numbers.push_back(part.patch);
  for (const detail::PatchPart& part : flip.parts)
    if (!part.is_absorbed) std::erase(numbers, part.patch);
  return numbers;
}

void commit(PatchedSurface& surface, CollapseContext& context, Flip& flip,
            std::vector<std::int32_t>& successor) {
  hand_over_samples(surface, flip.quad, context.guard);
  context.volume.now += flip.volume;
  const std::int32_t shell = surface.patches[idx(flip.patch[0])].shell;
  std::vector<std::int32_t> numbers = free_numbers(flip);
  const std::span<detail::PatchPart> own(flip.parts.data(), flip.own_count);
  for (detail::PatchPart& part : own) {
    if (part.is_absorbed) continue;
    if (part.patch < 0) {
      part.patch = numbers.front();
      numbers.erase(numbers.begin());
    }
    for (const std::int32_t t : part.triangles) surface.patch_of[idx(t)] = part.patch;
  }
  for (const std::int32_t patch : numbers) {
    successor[idx(patch)] = surface.patch_of[idx(surface.patches[idx(patch)].triangles[0])];
    surface.patches[idx(patch)] = {};
    surface.tree.remove(patch);
    --surface.patch_count;
  }
  for (detail::PatchPart& part : own) {
    if (part.is_absorbed) continue;
    surface.patches[idx(part.patch)].shell = shell;
    surface.patches[idx(part.patch)].triangles = part.triangles;
    set_patch(surface, part.patch, part.vertices, part.half_spaces, part.box);
  }
}

}  // namespace

FlipOutcome flip_reflex_edge(PatchedSurface& surface, CollapseContext& context,
                             std::int32_t halfedge, std::vector<std::int32_t>& successor) {
  const std::int32_t twin = surface.mesh.twin[idx(halfedge)];
  if (twin < 0) return FlipOutcome::convex;
  const FlipQuad quad = quad_of(surface.mesh, halfedge);
  const auto [one, two] = quad.triangle;
  if (surface.patch_of[idx(one)] == surface.patch_of[idx(two)] ||
      (!is_reflex(surface, one, quad.d) && !is_reflex(surface, two, quad.c)))
    return FlipOutcome::convex;
  if (!can_flip(surface.mesh, halfedge)) return FlipOutcome::topology;
  Flip flip = describe(surface, halfedge);
  const auto set_corners = [&](bool is_flipped) {
    set_flipped_corners(surface.mesh, halfedge, quad, is_flipped);
    for (const std::int32_t t : quad.triangle) refresh_triangle(surface, t);
  };
  int gain = 0;
  set_corners(true);
  const FlipOutcome outcome = judge(surface, context, flip, gain);
  if (outcome == FlipOutcome::flipped) commit(surface, context, flip, successor);
  set_corners(false);
  if (outcome != FlipOutcome::flipped) return outcome;
  flip_edge(surface.mesh, halfedge);
  for (const std::int32_t t : quad.triangle) refresh_triangle(surface, t);
  return outcome;
}

std::int64_t flip_reflex_edges(PatchedSurface& surface, CollapseContext& context,
                               const detail::DeviationLimit& limit,
                               std::vector<std::int32_t>& successor,
                               std::array<std::int64_t, kFlipOutcomes>& outcomes) {
  std::int64_t flipped = 0;
  const auto count = static_cast<std::int32_t>(surface.mesh.twin.size());
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const std::int64_t before = flipped;
    for (std::int32_t h = 0; h < count; ++h) {
      if (surface.mesh.twin[idx(h)] < h) continue;
      const FlipQuad quad = quad_of(surface.mesh, h);
      const auto& x = surface.mesh.positions;
      context.scratch.search.limit = limit.of((x[idx(quad.c)] - x[idx(quad.d)]).norm());
      const FlipOutcome outcome = flip_reflex_edge(surface, context, h, successor);
      ++outcomes[static_cast<std::size_t>(outcome)];
      flipped += outcome == FlipOutcome::flipped;
    }
    if (flipped == before) break;
  }
  return flipped;
}

}  // namespace thigma
