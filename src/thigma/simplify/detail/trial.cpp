#include "thigma/simplify/detail/trial.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/mesh/triangles_meet.h"
#include "thigma/simplify/detail/triangle_trial.h"

namespace thigma::detail {
namespace {

bool is_in_star(const CollapseScratch& scratch, std::int32_t t) {
  return scratch.mark[idx(t)] == scratch.epoch;
}
bool is_removed(const CollapseScratch& scratch, std::int32_t t) {
  return scratch.mark[idx(t)] == -scratch.epoch;
}

std::array<std::int32_t, 3> new_corners(const CollapseScratch& scratch, std::size_t i) {
  return {scratch.star.tail, scratch.star.triangles[i].a, scratch.star.triangles[i].b};
}

/// Whether a new triangle meets another of the star, or of the surface, with the vertex at p.
bool new_triangle_meets(const PatchedSurface& surface, const CollapseScratch& scratch,
                        const Vec3& p, std::size_t i, const std::array<std::int32_t, 3>& other) {
  const std::array<std::int32_t, 3> own = new_corners(scratch, i);
  std::array<Vec3, 6> corners;
  std::array<std::int32_t, 3> places{};
  for (std::size_t k = 0; k < 3; ++k) {
    corners[k] = k == 0 ? p : surface.mesh.positions[idx(own[k])];
    corners[3 + k] = other[k] == own[0] ? p : surface.mesh.positions[idx(other[k])];
    const auto same = std::find(own.begin(), own.end(), other[k]);
    places[k] = static_cast<std::int32_t>(same == own.end() ? 3 + k : same - own.begin());
  }
  return triangles_meet(corners, {0, 1, 2}, places);
}

/// Shape of the new triangles; fills what the later tests need of them.
bool has_good_shape(const PatchedSurface& surface, const CollapseParams& params, const Vec3& p,
                    CollapseScratch& scratch) {
  const double least = std::min(params.least_quality, scratch.worst_old_quality);
  for (std::size_t i = 0; i < scratch.star.triangles.size(); ++i) {
    const StarTriangle& t = scratch.star.triangles[i];
    const Vec3 &a = surface.mesh.positions[idx(t.a)], &b = surface.mesh.positions[idx(t.b)];
    const Vec3 cross = (a - p).cross(b - p);
    const double area2 = cross.norm();
    const double pa = (a - p).squaredNorm(), pb = (b - p).squaredNorm(), ab = (b - a).squaredNorm();
    if (!(2.0 * std::sqrt(3.0) * area2 >= least * (pa + pb + ab))) return false;
    const double longest2 = std::max({pa, pb, ab});
    const bool has_area = area2 > 1e-15 * longest2;
    scratch.new_normal[i] = has_area ? Vec3(cross / area2) : Vec3(Vec3::Zero());
    scratch.new_height[i] = has_area ? area2 / std::sqrt(longest2) : 0.0;
    scratch.new_box[i] = box_of({p, a, b});
    if (scratch.old_quality[i] >= params.sliver_quality &&
        scratch.new_normal[i].dot(surface.normal[idx(t.triangle)]) < 0.1)
      return false;
  }
  return true;
}

int count_new_folds(const PatchedSurface& surface, const CollapseScratch& scratch) {
  int folds = 0;
  for (std::size_t i = 0; i < scratch.star.triangles.size(); ++i) {
    const StarTriangle& t = scratch.star.triangles[i];
    if (t.beyond >= 0)
      folds += scratch.new_normal[i].dot(surface.normal[idx(t.beyond)]) < kFoldCosine;
    if (t.following >= 0)
      folds += scratch.new_normal[i].dot(scratch.new_normal[idx(t.following)]) < kFoldCosine;
  }
  return folds;
}

int count_old_folds(const PatchedSurface& surface, const CollapseScratch& scratch) {
  int folds = 0;
  const auto count = [&](std::int32_t t) {
    for (std::int32_t side = 0; side < 3; ++side) {
      const std::int32_t h = 3 * t + side, other = surface.mesh.twin[idx(h)];
      if (other < 0) continue;
      const bool is_inside = is_in_star(scratch, other / 3) || is_removed(scratch, other / 3);
      if (is_inside && other < h) continue;
      folds += surface.normal[idx(t)].dot(surface.normal[idx(other / 3)]) < kFoldCosine;
    }
  };
  for (const StarTriangle& t : scratch.star.triangles) count(t.triangle);
  for (const std::int32_t t : scratch.star.removed)
    if (t >= 0) count(t);
  return folds;
}

/// Two triangles of the star beside each other have the samples of their common edge in common
/// when they are divided alike: the second tests them.
bool is_near_original(const PatchedSurface& surface, const DeviationGuard& guard, const Vec3& p,
                      CollapseScratch& scratch) {
  const EdgeStar& star = scratch.star;
  DeviationSearch& search = scratch.search;
  if (find_within_limit(guard, search, p, {star.tail, star.head, star.tail}) < 0) return false;
  const auto corners = [&](const StarTriangle& t) {
    return std::array{p, surface.mesh.positions[idx(t.a)], surface.mesh.positions[idx(t.b)]};
  };
  scratch.divisions.clear();
  for (const StarTriangle& t : star.triangles)
    scratch.divisions.push_back(count_divisions(search.limit, corners(t)));
  for (std::size_t i = 0; i < star.triangles.size(); ++i) {
    const StarTriangle& t = star.triangles[i];
    const int divisions = scratch.divisions[i];
    const bool is_shared = t.following >= 0 && scratch.divisions[idx(t.following)] == divisions;
    if (!is_within_limit(guard, search, corners(t), {star.tail, t.a, t.b}, divisions, !is_shared))
      return false;
  }
  return true;
}

/// Vertices of the original that the star stands for, to the new triangles.
bool is_original_near(const PatchedSurface& surface, const DeviationGuard& guard, const Vec3& p,
                      const CollapseScratch& scratch) {
  const double limit = scratch.search.limit;
  const auto is_near = [&](const Vec3& x, std::size_t i) {
    const StarTriangle& t = scratch.star.triangles[i];
    return squared_distance(scratch.new_box[i], x) <= kFarther * limit * limit &&
           point_triangle_distance(x, p, surface.mesh.positions[idx(t.a)],
                                   surface.mesh.positions[idx(t.b)]) <= limit;
  };
  const std::size_t count = scratch.star.triangles.size();
  const auto are_near = [&](std::int32_t triangle, std::size_t own) {
    for (std::int32_t v = guard.first_sample[idx(triangle)]; v >= 0;
         v = guard.next_sample[idx(v)]) {
      const Vec3& x = guard.original->positions[idx(v)];
      if (own < count && is_near(x, own)) continue;
      std::size_t i = 0;
      while (i < count && !is_near(x, i)) ++i;
      if (i == count) return false;
    }
    return true;
  };
  for (std::size_t i = 0; i < count; ++i)
    if (!are_near(scratch.star.triangles[i].triangle, i)) return false;
  for (const std::int32_t t : scratch.star.removed)
    if (t >= 0 && !are_near(t, count)) return false;
  return true;
}

bool are_patches_convex(const PatchedSurface& surface, const CollapseScratch& scratch,
                        const Vec3& p) {
  for (std::size_t i = 0; i < scratch.star.patches.size(); ++i) {
    const std::int32_t patch = scratch.star.patches[i];
    bool has_vertex = false;
    for (std::size_t j = 0; j < scratch.star.triangles.size(); ++j) {
      if (scratch.star.triangles[j].patch != patch) continue;
      has_vertex = true;
      if (!(scratch.new_height[j] > surface.flat)) continue;
      for (const std::int32_t v : scratch.patch_vertices[i])
        if (v != scratch.star.tail &&
            scratch.new_normal[j].dot(surface.mesh.positions[idx(v)] - p) > surface.flat)
          return false;
    }
    if (!has_vertex) continue;
    for (const std::int32_t t : surface.patches[idx(patch)].triangles)
      if (!is_in_star(scratch, t) && !is_removed(scratch, t) && has_plane(surface, t) &&
          height_over(surface, t, p) > surface.flat)
        return false;
  }
  return true;
}

TreeBox star_box(const CollapseScratch& scratch) {
  TreeBox box = scratch.new_box[0];
  for (std::size_t i = 1; i < scratch.star.triangles.size(); ++i)
    box = united(box, scratch.new_box[i]);
  return box;
}

/// Calls visit(patch) for the patches of the star's shell that the box meets.
template <class Visit>
void visit_patches(const PatchedSurface& surface, const CollapseScratch& scratch,
                   const TreeBox& box, Visit visit) {
  const std::int32_t shell = surface.patches[idx(scratch.star.patches[0])].shell;
  surface.tree.visit(box, [&](std::int32_t patch) {
    const SurfacePatch& p = surface.patches[idx(patch)];
    if (p.shell == shell && p.box.overlaps(box)) visit(patch, p);
  });
}

int count_new_crossings(const PatchedSurface& surface, const Vec3& p, CollapseScratch& scratch) {
  int crossings = 0;
  const std::size_t count = scratch.star.triangles.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      crossings += scratch.new_height[i] > 0.0 && scratch.new_height[j] > 0.0 &&
                   new_triangle_meets(surface, scratch, p, i, new_corners(scratch, j));
  const TreeBox all = star_box(scratch);
  scratch.seen.push_back(all);
  visit_patches(surface, scratch, all, [&](std::int32_t, const SurfacePatch& patch) {
    for (const std::int32_t t : patch.triangles) {
      const TreeBox& box = surface.box[idx(t)];
      if (!box.overlaps(all) || is_in_star(scratch, t) || is_removed(scratch, t) ||
          surface.height[idx(t)] <= 0.0)
        continue;
      for (std::size_t i = 0; i < count; ++i)
        crossings += scratch.new_box[i].overlaps(box) && scratch.new_height[i] > 0.0 &&
                     new_triangle_meets(surface, scratch, p, i, surface.mesh.triangles[idx(t)]);
    }
  });
  return crossings;
}

/// The same of the star as it is.
int count_old_crossings(const PatchedSurface& surface, CollapseScratch& scratch) {
  std::vector<std::int32_t> own;
  for (const StarTriangle& t : scratch.star.triangles) own.push_back(t.triangle);
  for (const std::int32_t t : scratch.star.removed)
    if (t >= 0) own.push_back(t);
  std::erase_if(own, [&](std::int32_t t) { return surface.height[idx(t)] <= 0.0; });
  int crossings = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto& triangle = surface.mesh.triangles[idx(own[i])];
    for (std::size_t j = i + 1; j < own.size(); ++j)
      crossings +=
          triangles_meet(surface.mesh.positions, triangle, surface.mesh.triangles[idx(own[j])]);
    const TreeBox& box = surface.box[idx(own[i])];
    scratch.seen.push_back(box);
    visit_patches(surface, scratch, box, [&](std::int32_t, const SurfacePatch& patch) {
      for (const std::int32_t t : patch.triangles) {
        if (is_in_star(scratch, t) || is_removed(scratch, t) || surface.height[idx(t)] <= 0.0)
          continue;
        crossings +=
            surface.box[idx(t)].overlaps(box) &&
            triangles_meet(surface.mesh.positions, triangle, surface.mesh.triangles[idx(t)]);
      }
    });
  }
  return crossings;
}

/// New triangles against the hulls of the other patches.
bool enters_other_hull(const PatchedSurface& surface, const Vec3& p, CollapseScratch& scratch) {
  bool entered = false;
  const TreeBox all = star_box(scratch);
  scratch.tried.push_back(all);
  visit_patches(surface, scratch, all, [&](std::int32_t patch, const SurfacePatch& other) {
    if (entered || scratch.patch_mark[idx(patch)] == scratch.epoch || other.half_spaces.empty())
      return;
    for (std::size_t i = 0; i < scratch.star.triangles.size() && !entered; ++i) {
      if (!scratch.new_box[i].overlaps(other.box) || scratch.new_height[i] <= 0.0) continue;
      const StarTriangle& t = scratch.star.triangles[i];
      entered =
          reaches_into({p, surface.mesh.positions[idx(t.a)], surface.mesh.positions[idx(t.b)]},
                       other.half_spaces);
    }
  });
  return entered;
}

/// A hull that lost the edge and took a vertex it held already has only shrunk: no triangle can
/// have come into it but those of the star.
bool has_shrunk(const PatchedSurface& surface, std::int32_t patch, const Vec3& p) {
  const auto& half_spaces = surface.patches[idx(patch)].half_spaces;
  for (const HalfSpace& h : half_spaces)
    if (h.normal.dot(p) > h.offset + surface.inset) return false;
  return !half_spaces.empty();
}

bool is_hull_entered(const PatchedSurface& surface, const Vec3& p, CollapseScratch& scratch,
                     std::size_t i) {
  const std::int32_t own = scratch.star.patches[i];
  const auto& half_spaces = scratch.half_spaces[i];
  const auto meets = [&](const std::array<Vec3, 3>& corners, const TreeBox& box) {
    return box.overlaps(scratch.patch_box[i]) && reaches_into(corners, half_spaces);
  };
  for (std::size_t j = 0; j < scratch.star.triangles.size(); ++j) {
    const StarTriangle& t = scratch.star.triangles[j];
    if (t.patch != own && scratch.new_height[j] > 0.0 &&
        meets({p, surface.mesh.positions[idx(t.a)], surface.mesh.positions[idx(t.b)]},
              scratch.new_box[j]))
      return true;
  }
  if (has_shrunk(surface, own, p)) return false;
  bool entered = false;
  scratch.seen.push_back(scratch.patch_box[i]);
  visit_patches(
      surface, scratch, scratch.patch_box[i], [&](std::int32_t patch, const SurfacePatch& other) {
        if (entered || patch == own) return;
        for (const std::int32_t t : other.triangles) {
          if (entered || !surface.box[idx(t)].overlaps(scratch.patch_box[i]) ||
              is_in_star(scratch, t) || is_removed(scratch, t) || surface.height[idx(t)] <= 0.0)
            continue;
          entered = reaches_into(corners_of(surface, t), half_spaces);
        }
      });
  return entered;
}

/// Of the hull of patch i of the star with the vertex at p.
void list_new_half_spaces(const PatchedSurface& surface, const Vec3& p, CollapseScratch& scratch,
                          std::size_t i) {
  const std::vector<std::int32_t>& vertices = scratch.patch_vertices[i];
  std::array<Vec3, kMaxHullVertices> points;
  const std::size_t count = std::min(vertices.size(), points.size());
  for (std::size_t k = 0; k < count; ++k)
    points[k] = vertices[k] == scratch.star.tail ? p : surface.mesh.positions[idx(vertices[k])];
  list_half_spaces_of(surface, {points.data(), count}, scratch.hull, scratch.half_spaces[i],
                      scratch.patch_box[i]);
}

bool are_hulls_clear(const PatchedSurface& surface, const Vec3& p, CollapseScratch& scratch) {
  scratch.hulls_at = p;
  scratch.has_all_hulls = false;
  for (std::size_t i = 0; i < scratch.star.patches.size(); ++i) {
    if (scratch.patch_vertices[i].empty()) continue;
    list_new_half_spaces(surface, p, scratch, i);
    if (scratch.half_spaces[i].empty()) continue;
    if (is_hull_entered(surface, p, scratch, i)) return false;
  }
  scratch.has_all_hulls = true;
  return true;
}

}  // namespace

void begin_trials(const PatchedSurface& surface, CollapseScratch& scratch) {
  const std::size_t triangles = scratch.star.triangles.size(),
                    patches = scratch.star.patches.size();
  ++scratch.epoch;
  scratch.mark.resize(surface.mesh.triangles.size(), 0);
  scratch.patch_mark.resize(surface.patches.size(), 0);
  for (const StarTriangle& t : scratch.star.triangles)
    scratch.mark[idx(t.triangle)] = scratch.epoch;
  for (const std::int32_t t : scratch.star.removed)
    if (t >= 0) scratch.mark[idx(t)] = -scratch.epoch;
  for (const std::int32_t p : scratch.star.patches) scratch.patch_mark[idx(p)] = scratch.epoch;
  scratch.new_normal.resize(triangles);
  scratch.new_height.resize(triangles);
  scratch.old_quality.resize(triangles);
  scratch.new_box.resize(triangles);
  if (scratch.patch_vertices.size() < patches) {
    scratch.patch_vertices.resize(patches);
    scratch.half_spaces.resize(patches);
    scratch.patch_box.resize(patches);
  }
  for (std::size_t i = 0; i < patches; ++i)
    list_patch_vertices(surface, scratch.star, scratch.star.patches[i], scratch.patch_vertices[i]);
  scratch.worst_old_quality = 1.0;
  for (std::size_t i = 0; i < triangles; ++i) {
    scratch.old_quality[i] =
        triangle_quality(corners_of(surface, scratch.star.triangles[i].triangle));
    scratch.worst_old_quality = std::min(scratch.worst_old_quality, scratch.old_quality[i]);
  }
  for (const std::int32_t t : scratch.star.removed)
    if (t >= 0)
      scratch.worst_old_quality =
          std::min(scratch.worst_old_quality, triangle_quality(corners_of(surface, t)));
  scratch.old_crossings = scratch.old_folds = -1;
}

bool try_position(const PatchedSurface& surface, const CollapseContext& context, const Vec3& p,
                  CollapseScratch& scratch) {
  scratch.reason = CollapseOutcome::quality;
  if (!has_good_shape(surface, context.params, p, scratch)) return false;
  scratch.reason = CollapseOutcome::convexity;
  if (!are_patches_convex(surface, scratch, p)) return false;
  scratch.reason = CollapseOutcome::deviation;
  if (!is_near_original(surface, context.guard, p, scratch)) return false;
  if (!is_original_near(surface, context.guard, p, scratch)) return false;
  scratch.reason = CollapseOutcome::volume;
  const double change = volume_change(scratch.volume, p);
  scratch.answers.push_back({change, keeps_within(context.volume, change)});
  if (!scratch.answers.back().is_kept) return false;
  scratch.reason = CollapseOutcome::intersection;
  // Not more than before, rather than none: what crosses itself already must stay free to be
  // simplified.
  const int folds = count_new_folds(surface, scratch);
  if (folds > 0 && scratch.old_folds < 0) scratch.old_folds = count_old_folds(surface, scratch);
  if (folds > 0 && folds > scratch.old_folds) return false;
  const int crossings = count_new_crossings(surface, p, scratch);
  if (crossings > 0 && scratch.old_crossings < 0)
    scratch.old_crossings = count_old_crossings(surface, scratch);
  if (crossings > 0 && crossings > scratch.old_crossings) return false;
  scratch.reason = CollapseOutcome::protrusion;
  if (enters_other_hull(surface, p, scratch) || !are_hulls_clear(surface, p, scratch)) return false;
  scratch.reason = CollapseOutcome::collapsed;
  return true;
}

}  // namespace thigma::detail
