#include "thigma/simplify/detail/trial.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/mesh/triangles_meet.h"
#include "thigma/simplify/detail/triangle_trial.h"

namespace thigma::detail {
namespace {

bool is_in_star(const CollapseScratch& k, std::int32_t t) { return k.mark[at(t)] == k.epoch; }
bool is_removed(const CollapseScratch& k, std::int32_t t) { return k.mark[at(t)] == -k.epoch; }

std::array<std::int32_t, 3> new_corners(const CollapseScratch& k, std::size_t i) {
  return {k.star.tail, k.star.triangles[i].a, k.star.triangles[i].b};
}

/// Shape of the new triangles; fills what the later tests need of them.
bool has_good_shape(const PatchedSurface& s, CollapseContext& context, const Vec3& p) {
  CollapseScratch& k = context.scratch;
  const double least = std::min(context.params.least_quality, k.worst_old_quality);
  for (std::size_t i = 0; i < k.star.triangles.size(); ++i) {
    const StarTriangle& t = k.star.triangles[i];
    const Vec3 &a = s.mesh.positions[at(t.a)], &b = s.mesh.positions[at(t.b)];
    const Vec3 cross = (a - p).cross(b - p);
    const double area2 = cross.norm();
    const double pa = (a - p).squaredNorm(), pb = (b - p).squaredNorm(), ab = (b - a).squaredNorm();
    if (!(2.0 * std::sqrt(3.0) * area2 >= least * (pa + pb + ab))) return false;
    const double longest2 = std::max({pa, pb, ab});
    const bool has_area = area2 > 1e-15 * longest2;
    k.new_normal[i] = has_area ? Vec3(cross / area2) : Vec3(Vec3::Zero());
    k.new_height[i] = has_area ? area2 / std::sqrt(longest2) : 0.0;
    k.new_box[i] = box_of({p, a, b});
    if (k.old_quality[i] >= context.params.sliver_quality &&
        k.new_normal[i].dot(s.normal[at(t.triangle)]) < 0.1)
      return false;
  }
  return true;
}

int count_new_folds(const PatchedSurface& s, const CollapseScratch& k) {
  int folds = 0;
  for (std::size_t i = 0; i < k.star.triangles.size(); ++i) {
    const StarTriangle& t = k.star.triangles[i];
    if (t.beyond >= 0) folds += k.new_normal[i].dot(s.normal[at(t.beyond)]) < kFoldCosine;
    if (t.following >= 0) folds += k.new_normal[i].dot(k.new_normal[at(t.following)]) < kFoldCosine;
  }
  return folds;
}

int count_old_folds(const PatchedSurface& s, const CollapseScratch& k) {
  int folds = 0;
  const auto count = [&](std::int32_t t) {
    for (std::int32_t side = 0; side < 3; ++side) {
      const std::int32_t h = 3 * t + side, other = s.mesh.twin[at(h)];
      if (other < 0) continue;
      const bool is_inside = is_in_star(k, other / 3) || is_removed(k, other / 3);
      if (is_inside && other < h) continue;
      folds += s.normal[at(t)].dot(s.normal[at(other / 3)]) < kFoldCosine;
    }
  };
  for (const StarTriangle& t : k.star.triangles) count(t.triangle);
  for (const std::int32_t t : k.star.removed)
    if (t >= 0) count(t);
  return folds;
}

bool is_near_original(const PatchedSurface& s, CollapseContext& context, const Vec3& p) {
  const EdgeStar& star = context.scratch.star;
  if (find_within_limit(context.guard, p, {star.tail, star.head, star.tail}) < 0) return false;
  return std::all_of(star.triangles.begin(), star.triangles.end(), [&](const StarTriangle& t) {
    return is_within_limit(context.guard, {p, s.mesh.positions[at(t.a)], s.mesh.positions[at(t.b)]},
                           {star.tail, t.a, t.b});
  });
}

/// Vertices of the original that the star stands for, to the new triangles.
bool is_original_near(const PatchedSurface& s, const CollapseContext& context, const Vec3& p) {
  const CollapseScratch& k = context.scratch;
  const DeviationGuard& guard = context.guard;
  const auto distance = [&](const Vec3& x, const StarTriangle& t) {
    return point_triangle_distance(x, p, s.mesh.positions[at(t.a)], s.mesh.positions[at(t.b)]);
  };
  const auto are_near = [&](std::int32_t triangle, const StarTriangle* own) {
    for (std::int32_t v = guard.first_sample[at(triangle)]; v >= 0; v = guard.next_sample[at(v)]) {
      const Vec3& x = guard.original->positions[at(v)];
      if (own && distance(x, *own) <= guard.limit) continue;
      if (std::none_of(k.star.triangles.begin(), k.star.triangles.end(),
                       [&](const StarTriangle& t) { return distance(x, t) <= guard.limit; }))
        return false;
    }
    return true;
  };
  for (const StarTriangle& t : k.star.triangles)
    if (!are_near(t.triangle, &t)) return false;
  for (const std::int32_t t : k.star.removed)
    if (t >= 0 && !are_near(t, nullptr)) return false;
  return true;
}

bool are_patches_convex(const PatchedSurface& s, const CollapseScratch& k, const Vec3& p) {
  for (std::size_t i = 0; i < k.star.patches.size(); ++i) {
    const std::int32_t patch = k.star.patches[i];
    bool has_vertex = false;
    for (std::size_t j = 0; j < k.star.triangles.size(); ++j) {
      if (k.star.triangles[j].patch != patch) continue;
      has_vertex = true;
      if (!(k.new_height[j] > s.flat)) continue;
      for (const std::int32_t v : k.patch_vertices[i])
        if (k.new_normal[j].dot(s.mesh.positions[at(v)] - p) > s.flat) return false;
    }
    if (!has_vertex) continue;
    for (const std::int32_t t : s.patches[at(patch)].triangles)
      if (!is_in_star(k, t) && !is_removed(k, t) && has_plane(s, t) &&
          height_over(s, t, p) > s.flat)
        return false;
  }
  return true;
}

TreeBox star_box(const CollapseScratch& k) {
  TreeBox box = k.new_box[0];
  for (std::size_t i = 1; i < k.star.triangles.size(); ++i) {
    box.min = box.min.cwiseMin(k.new_box[i].min);
    box.max = box.max.cwiseMax(k.new_box[i].max);
  }
  return box;
}

/// Calls visit(patch) for the patches of the star's shell that the box meets.
template <class Visit>
void visit_patches(const PatchedSurface& s, const CollapseScratch& k, const TreeBox& box,
                   Visit visit) {
  const std::int32_t shell = s.patches[at(k.star.patches[0])].shell;
  s.tree.visit(box, [&](std::int32_t patch) {
    const SurfacePatch& p = s.patches[at(patch)];
    if (p.shell == shell && p.box.overlaps(box)) visit(patch, p);
  });
}

int count_new_crossings(const PatchedSurface& s, const CollapseScratch& k) {
  int crossings = 0;
  const std::span<const Vec3> positions = s.mesh.positions;
  const std::size_t count = k.star.triangles.size();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = i + 1; j < count; ++j)
      crossings += k.new_height[i] > 0.0 && k.new_height[j] > 0.0 &&
                   triangles_meet(positions, new_corners(k, i), new_corners(k, j));
  const TreeBox all = star_box(k);
  visit_patches(s, k, all, [&](std::int32_t, const SurfacePatch& patch) {
    for (const std::int32_t t : patch.triangles) {
      if (is_in_star(k, t) || is_removed(k, t) || s.height[at(t)] <= 0.0) continue;
      const TreeBox box = box_of(corners_of(s, t));
      if (!box.overlaps(all)) continue;
      for (std::size_t i = 0; i < count; ++i)
        crossings += k.new_box[i].overlaps(box) && k.new_height[i] > 0.0 &&
                     triangles_meet(positions, new_corners(k, i), s.mesh.triangles[at(t)]);
    }
  });
  return crossings;
}

/// The same of the star as it is; to be called with the positions as they were.
int count_old_crossings(const PatchedSurface& s, const CollapseScratch& k) {
  std::vector<std::int32_t> own;
  for (const StarTriangle& t : k.star.triangles) own.push_back(t.triangle);
  for (const std::int32_t t : k.star.removed)
    if (t >= 0) own.push_back(t);
  std::erase_if(own, [&](std::int32_t t) { return s.height[at(t)] <= 0.0; });
  int crossings = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const auto& triangle = s.mesh.triangles[at(own[i])];
    for (std::size_t j = i + 1; j < own.size(); ++j)
      crossings += triangles_meet(s.mesh.positions, triangle, s.mesh.triangles[at(own[j])]);
    const TreeBox box = box_of(corners_of(s, own[i]));
    visit_patches(s, k, box, [&](std::int32_t, const SurfacePatch& patch) {
      for (const std::int32_t t : patch.triangles) {
        if (is_in_star(k, t) || is_removed(k, t) || s.height[at(t)] <= 0.0) continue;
        crossings += box_of(corners_of(s, t)).overlaps(box) &&
                     triangles_meet(s.mesh.positions, triangle, s.mesh.triangles[at(t)]);
      }
    });
  }
  return crossings;
}

/// New triangles against the hulls of the other patches.
bool enters_other_hull(const PatchedSurface& s, const CollapseScratch& k, const Vec3& p) {
  bool entered = false;
  visit_patches(s, k, star_box(k), [&](std::int32_t patch, const SurfacePatch& other) {
    if (entered || k.patch_mark[at(patch)] == k.epoch || other.half_spaces.empty()) return;
    for (std::size_t i = 0; i < k.star.triangles.size() && !entered; ++i) {
      if (!k.new_box[i].overlaps(other.box) || k.new_height[i] <= 0.0) continue;
      const StarTriangle& t = k.star.triangles[i];
      entered = reaches_into({p, s.mesh.positions[at(t.a)], s.mesh.positions[at(t.b)]},
                             other.half_spaces);
    }
  });
  return entered;
}

/// A hull that lost the edge and took a vertex it held already has only shrunk: no triangle can
/// have come into it but those of the star.
bool has_shrunk(const PatchedSurface& s, std::int32_t patch, const Vec3& p) {
  const auto& half_spaces = s.patches[at(patch)].half_spaces;
  for (const HalfSpace& h : half_spaces)
    if (h.normal.dot(p) > h.offset + s.inset) return false;
  return !half_spaces.empty();
}

bool is_hull_entered(const PatchedSurface& s, const CollapseScratch& k, std::size_t i,
                     bool only_by_star) {
  const std::int32_t own = k.star.patches[i];
  const auto& half_spaces = k.half_spaces[i];
  const auto meets = [&](const std::array<Vec3, 3>& corners, const TreeBox& box) {
    return box.overlaps(k.patch_box[i]) && reaches_into(corners, half_spaces);
  };
  const Vec3& p = s.mesh.positions[at(k.star.tail)];
  for (std::size_t j = 0; j < k.star.triangles.size(); ++j) {
    const StarTriangle& t = k.star.triangles[j];
    if (t.patch != own && k.new_height[j] > 0.0 &&
        meets({p, s.mesh.positions[at(t.a)], s.mesh.positions[at(t.b)]}, k.new_box[j]))
      return true;
  }
  if (only_by_star) return false;
  bool entered = false;
  visit_patches(s, k, k.patch_box[i], [&](std::int32_t patch, const SurfacePatch& other) {
    if (entered || patch == own) return;
    for (const std::int32_t t : other.triangles) {
      if (entered || is_in_star(k, t) || is_removed(k, t) || s.height[at(t)] <= 0.0) continue;
      const std::array<Vec3, 3> corners = corners_of(s, t);
      entered = meets(corners, box_of(corners));
    }
  });
  return entered;
}

bool are_hulls_clear(const PatchedSurface& s, CollapseScratch& k, const Vec3& p) {
  k.hulls_at = p;
  k.has_all_hulls = false;
  for (std::size_t i = 0; i < k.star.patches.size(); ++i) {
    if (k.patch_vertices[i].empty()) continue;
    list_patch_half_spaces(s, k.patch_vertices[i], k.hull, k.half_spaces[i], k.patch_box[i]);
    if (k.half_spaces[i].empty()) continue;
    if (is_hull_entered(s, k, i, has_shrunk(s, k.star.patches[i], p))) return false;
  }
  k.has_all_hulls = true;
  return true;
}

}  // namespace

void begin_trials(const PatchedSurface& s, CollapseContext& context) {
  CollapseScratch& k = context.scratch;
  const std::size_t triangles = k.star.triangles.size(), patches = k.star.patches.size();
  ++k.epoch;
  k.mark.resize(s.mesh.triangles.size(), 0);
  k.patch_mark.resize(s.patches.size(), 0);
  for (const StarTriangle& t : k.star.triangles) k.mark[at(t.triangle)] = k.epoch;
  for (const std::int32_t t : k.star.removed)
    if (t >= 0) k.mark[at(t)] = -k.epoch;
  for (const std::int32_t p : k.star.patches) k.patch_mark[at(p)] = k.epoch;
  k.new_normal.resize(triangles);
  k.new_height.resize(triangles);
  k.old_quality.resize(triangles);
  k.new_box.resize(triangles);
  if (k.patch_vertices.size() < patches) {
    k.patch_vertices.resize(patches);
    k.half_spaces.resize(patches);
    k.patch_box.resize(patches);
  }
  for (std::size_t i = 0; i < patches; ++i)
    list_patch_vertices(s, k.star, k.star.patches[i], k.patch_vertices[i]);
  k.worst_old_quality = 1.0;
  for (std::size_t i = 0; i < triangles; ++i) {
    k.old_quality[i] = triangle_quality(corners_of(s, k.star.triangles[i].triangle));
    k.worst_old_quality = std::min(k.worst_old_quality, k.old_quality[i]);
  }
  for (const std::int32_t t : k.star.removed)
    if (t >= 0)
      k.worst_old_quality = std::min(k.worst_old_quality, triangle_quality(corners_of(s, t)));
  k.old_crossings = k.old_folds = -1;
}

bool try_position(PatchedSurface& s, CollapseContext& context, const Vec3& p) {
  CollapseScratch& k = context.scratch;
  k.reason = CollapseOutcome::quality;
  if (!has_good_shape(s, context, p)) return false;
  Vec3 &tail = s.mesh.positions[at(k.star.tail)], &head = s.mesh.positions[at(k.star.head)];
  const Vec3 old_tail = tail, old_head = head;
  const auto with_both_at_p = [&](auto test) {
    tail = head = p;
    const auto result = test();
    tail = old_tail;
    head = old_head;
    return result;
  };
  k.reason = CollapseOutcome::convexity;
  if (!with_both_at_p([&] { return are_patches_convex(s, k, p); })) return false;
  k.reason = CollapseOutcome::deviation;
  if (!with_both_at_p([&] { return is_near_original(s, context, p); })) return false;
  if (context.params.guards_original && !is_original_near(s, context, p)) return false;
  k.reason = CollapseOutcome::volume;
  if (!keeps_within(context.volume, volume_change(k.volume, p))) return false;
  k.reason = CollapseOutcome::intersection;
  // Not more than before, rather than none: what crosses itself already must stay free to be
  // simplified.
  const int folds = with_both_at_p([&] { return count_new_folds(s, k); });
  if (folds > 0 && k.old_folds < 0) k.old_folds = count_old_folds(s, k);
  if (folds > 0 && folds > k.old_folds) return false;
  const int crossings = with_both_at_p([&] { return count_new_crossings(s, k); });
  if (crossings > 0 && k.old_crossings < 0) k.old_crossings = count_old_crossings(s, k);
  if (crossings > 0 && crossings > k.old_crossings) return false;
  k.reason = CollapseOutcome::protrusion;
  const bool is_clear =
      with_both_at_p([&] { return !enters_other_hull(s, k, p) && are_hulls_clear(s, k, p); });
  if (is_clear) k.reason = CollapseOutcome::collapsed;
  return is_clear;
}

}  // namespace thigma::detail
