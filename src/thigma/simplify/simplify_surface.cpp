// Deviates from Algorithm 3.3.1 where the text leaves the decision open: when to stop, and what
// becomes of patches that vanish.

#include "thigma/simplify/simplify_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/core/index.h"
#include "thigma/mesh/measure.h"
#include "thigma/simplify/detail/collapse_queue.h"
#include "thigma/simplify/edge_flip.h"
#include "thigma/simplify/level_spacing.h"
#include "thigma/simplify/resolution.h"

namespace thigma {
namespace {

struct Loop {
  PatchedSurface surface;
  CollapseContext context;
  const SimplifyParams& params;
  Simplification result;
  detail::CollapseQueue queue;
  std::vector<Vec3> vertex_normal = {};       // sum of the unit normals around it
  std::vector<std::int32_t> successor = {};   // of each patch: itself while it lives
  std::vector<std::int32_t> last_level = {};  // patches of the level kept last, by their number now
  std::vector<std::int32_t> first_patches = {};
  std::vector<std::array<double, 2>> support = {};
  double longest_tried = 0.0;  // projected edge that may be tried [m]
  double longest = 0.0;        // projected edge collapsed so far [m]
  std::int32_t kept = 0;       // patches of the level kept last
  std::int32_t kept_triangles = 0;
  double shown_progress = 0.0;
};

/// A stage, and whether its levels are drafts for space_levels to choose from. Others run only
/// while more than `coarsest_share` of the patches is left.
struct Stage {
  SimplifyStage limits;
  bool is_draft = false;
};

/// A level is kept for each of these shares of the patches before: of drafts, and of others.
constexpr double kDraftShare = 0.84, kLevelShare = 0.5;
constexpr int kFlipRounds = 8;
constexpr int kOctaves = 5;  // of projected length below the fine stage's, each a pass of its own

std::int32_t find_live(std::vector<std::int32_t>& successor, std::int32_t patch) {
  while (successor[idx(patch)] != patch) {
    std::int32_t& up = successor[idx(patch)];
    up = successor[idx(up)];
    patch = up;
  }
  return patch;
}

void update_normal(Loop& loop, std::int32_t v) {
  Vec3 sum = Vec3::Zero();
  visit_fan(loop.surface.mesh, v, [&](std::int32_t h) { sum += loop.surface.normal[idx(h / 3)]; });
  loop.vertex_normal[idx(v)] = sum;
}

void push(Loop& loop, std::int32_t a, std::int32_t b) {
  const auto& m = loop.surface.mesh;
  if (m.is_locked[idx(a)] || m.is_locked[idx(b)]) return;
  const double length = projected_length(m.positions[idx(b)] - m.positions[idx(a)],
                                         loop.vertex_normal[idx(a)] + loop.vertex_normal[idx(b)]);
  if (length > loop.longest_tried) return;
  detail::push(loop.queue, length, a, b);
}

void push_all(Loop& loop) {
  const auto& m = loop.surface.mesh;
  for (std::int32_t h = 0; h < static_cast<std::int32_t>(m.twin.size()); ++h)
    if (m.twin[idx(h)] < h && loop.surface.patch_of[idx(h / 3)] >= 0)
      push(loop, tail_of(m, h), head_of(m, h));
}

/// Resolutions around the new vertex have changed, and edges refused before may now be taken: all
/// edges of its ring's vertices are new candidates.
void renew_candidates(Loop& loop, std::int32_t v) {
  const auto& m = loop.surface.mesh;
  std::vector<std::int32_t> ring;
  visit_fan(m, v, [&](std::int32_t h) {
    ring.push_back(head_of(m, h));
    const std::int32_t last = previous_halfedge(h);
    if (m.twin[idx(last)] < 0) ring.push_back(tail_of(m, last));
  });
  update_normal(loop, v);
  ++loop.queue.version[idx(v)];
  for (const std::int32_t w : ring) {
    update_normal(loop, w);
    ++loop.queue.version[idx(w)];
  }
  const auto push_once = [&](std::int32_t w, std::int32_t other) {  // not from both ends
    if (other > w || std::find(ring.begin(), ring.end(), other) == ring.end()) push(loop, w, other);
  };
  const auto push_around = [&](std::int32_t w) {
    visit_fan(m, w, [&](std::int32_t h) {
      push_once(w, head_of(m, h));
      const std::int32_t last = previous_halfedge(h);
      if (m.twin[idx(last)] < 0) push_once(w, tail_of(m, last));
    });
  };
  for (const std::int32_t w : ring) push_around(w);
}

bool has_area(const PatchedSurface& surface, std::int32_t t) {
  return surface.height[idx(t)] > 0.0;
}

/// Place of the patch, or of the nearest over edges that has one; the first where none is
/// connected.
std::int32_t nearest_place(const PatchedSurface& surface, const std::vector<std::int32_t>& place,
                           std::int32_t patch) {
  if (place[idx(patch)] >= 0) return place[idx(patch)];
  std::vector<std::int32_t> reached = surface.patches[idx(patch)].triangles;
  std::vector<bool> is_reached(surface.mesh.triangles.size(), false);
  for (const std::int32_t t : reached) is_reached[idx(t)] = true;
  for (std::size_t i = 0; i < reached.size(); ++i)
    for (std::int32_t k = 0; k < 3; ++k) {
      const std::int32_t beside = surface.mesh.twin[idx(3 * reached[i] + k)];
      if (beside < 0 || is_reached[idx(beside / 3)]) continue;
      const std::int32_t other = surface.patch_of[idx(beside / 3)];
      if (other >= 0 && place[idx(other)] >= 0) return place[idx(other)];
      is_reached[idx(beside / 3)] = true;
      reached.push_back(beside / 3);
    }
  return 0;
}

/// As in the original, triangles without an area are in no patch: they have no normal to be felt
/// by. A patch of which nothing else is left is none, and what it stood for goes with its
/// neighbour.
void keep_level(Loop& loop) {
  const PatchedSurface& surface = loop.surface;
  std::vector<std::int32_t> place(surface.patches.size(), -1), live;
  for (std::size_t i = 0; i < surface.patches.size(); ++i) {
    const auto& own = surface.patches[i].triangles;
    if (std::none_of(own.begin(), own.end(), [&](std::int32_t t) { return has_area(surface, t); }))
      continue;
    place[i] = static_cast<std::int32_t>(live.size());
    live.push_back(static_cast<std::int32_t>(i));
  }
  if (live.empty()) return;
  auto& before = loop.result.levels.back();
  for (const std::int32_t patch : loop.last_level)
    before.parent.push_back(nearest_place(surface, place, find_live(loop.successor, patch)));
  CompactMesh small = compact(surface.mesh);
  SimplifiedLevel level;
  level.mesh = std::move(small.mesh);
  level.attributes = std::move(small.attributes);
  for (const std::int32_t t : small.triangles)
    level.patch_of_triangle.push_back(has_area(surface, t) ? place[idx(surface.patch_of[idx(t)])]
                                                           : -1);
  if (!loop.support.empty())
    for (const std::int32_t v : small.vertices) level.support.push_back(loop.support[idx(v)]);
  level.patch_count = static_cast<std::int32_t>(live.size());
  level.resolution = edge_resolution(Vec3(loop.longest, 0, 0), Vec3::Zero(), Vec3::Zero());
  loop.kept = level.patch_count;
  loop.result.levels.push_back(std::move(level));
  loop.last_level = std::move(live);
  loop.kept_triangles = surface.mesh.triangle_count;
}

/// Short edges may deviate by a share of their length alone, so that a level is as near the
/// original as it is fine: what they are refused is tried again once longer ones have collapsed.
/// `length` is of the edge to collapse [m].
detail::DeviationLimit deviation_limit(const Loop& loop, const Stage& stage, double length) {
  const SimplifyParams& p = loop.params;
  const double radius = loop.surface.radius;
  const double early = p.deviation_early * std::max(length, loop.longest);
  return {std::min(p.deviation_limit * radius, early), stage.limits.deviation_share,
          p.farthest_deviation * radius};
}

/// Collapses the edge of a candidate, and merges the patches around it that can be.
void collapse(Loop& loop, const detail::Candidate& candidate) {
  PatchedSurface& surface = loop.surface;
  const detail::EdgeStar& star = loop.context.scratch.star;
  const std::int32_t patches = surface.patch_count;
  detail::SurfaceChange change;
  add_star(surface, star, change);
  commit_collapse(surface, loop.context, loop.successor);
  loop.longest = std::max(loop.longest, candidate.length);
  loop.result.vanished += patches - surface.patch_count;
  if (!loop.support.empty()) {
    auto& kept = loop.support[idx(star.tail)];
    const auto& gone = loop.support[idx(star.head)];
    kept = {std::min(kept[0], gone[0]), std::min(kept[1], gone[1])};
  }
  ++loop.queue.version[idx(star.head)];
  renew_candidates(loop, star.tail);
  for (const std::int32_t patch : star.patches)
    if (!surface.patches[idx(patch)].triangles.empty())
      loop.result.merges += merge_patch(surface, patch, loop.context.scratch.hull, loop.successor);
  add_star(surface, star, change);
  note_change(loop.queue, surface, change);
}

/// Every collapse takes about the same time: the share of the triangles gone, by hundredths.
void report_progress(Loop& loop) {
  if (!loop.params.progress) return;
  const auto all = static_cast<double>(loop.result.levels[0].mesh.triangles.size());
  const double share = 1.0 - loop.surface.mesh.triangle_count / all;
  if (share < loop.shown_progress + 0.01) return;
  loop.shown_progress = share;
  loop.params.progress(share);
}

SimplifiedLevel first_level(const TriangleMesh& mesh, const ConvexDecomposition& decomposition,
                            const std::vector<std::array<double, 2>>& support,
                            const CornerAttributes& attributes) {
  SimplifiedLevel level;
  level.mesh = mesh;
  level.patch_of_triangle = decomposition.patch_of_triangle;
  level.patch_count = static_cast<std::int32_t>(decomposition.patches.size());
  level.resolution = std::numeric_limits<double>::infinity();
  level.support = support;
  level.attributes = attributes;
  return level;
}

/// Whether the levels are still to become coarser: neither the last kept nor one that could be kept
/// now has few enough.
bool has_many_patches(const Loop& loop) {
  const double few = loop.params.coarsest_share * loop.result.levels[0].patch_count;
  return loop.kept > few &&
         loop.surface.patch_count > std::min(few, loop.params.last_level_share * loop.kept);
}

/// Collapses what the stage allows; a level is kept whenever few enough of the patches of the last
/// are left.
void run_stage(Loop& loop, const Stage& stage) {
  const double share = stage.is_draft ? kDraftShare : kLevelShare;
  loop.longest_tried = stage.limits.longest_edge * loop.surface.radius;
  push_all(loop);
  const detail::LimitOfLength limit_of = [&](double length) {
    return deviation_limit(loop, stage, length).of(length);
  };
  while (stage.is_draft || has_many_patches(loop)) {
    const auto candidate = take_attempt(loop.queue, loop.surface, loop.context, limit_of);
    if (!candidate) break;
    const CollapseOutcome outcome = loop.context.scratch.outcome;
    ++loop.result.outcomes[static_cast<std::size_t>(outcome)];
    if (outcome == CollapseOutcome::collapsed) collapse(loop, *candidate);
    report_progress(loop);
    if (loop.surface.patch_count <= share * loop.kept ||
        (stage.is_draft && loop.surface.mesh.triangle_count <= share * loop.kept_triangles))
      keep_level(loop);
  }
  clear(loop.queue);
}

/// Where nothing more can collapse, flips edges and tries again, as long as that changes something.
void flip_and_go_on(Loop& loop, const Stage& stage) {
  PatchedSurface& surface = loop.surface;
  for (int round = 0; loop.context.form.flips_edges && round < kFlipRounds; ++round) {
    const std::int32_t before = surface.patch_count;
    const std::int64_t flipped =
        flip_reflex_edges(surface, loop.context, deviation_limit(loop, stage, loop.longest),
                          loop.successor, loop.result.flips);
    loop.result.merges += before - surface.patch_count;
    if (flipped == 0) return;
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(loop.queue.version.size()); ++v)
      if (surface.mesh.outgoing[idx(v)] >= 0) {
        update_normal(loop, v);
        ++loop.queue.version[idx(v)];
      }
    run_stage(loop, stage);
  }
}

void run_stages(Loop& loop) {
  const SimplifyStages& stages = loop.params.stages;
  // Every octave of length anew: what was too far from the original among shorter edges may now be
  // near enough.
  for (int octave = kOctaves; octave >= 0; --octave) {
    SimplifyStage shorter = stages[kFine];
    shorter.longest_edge = std::ldexp(shorter.longest_edge, -octave);
    run_stage(loop, {shorter, true});
  }
  const Stage far{stages[kFineFar], true};
  run_stage(loop, far);
  flip_and_go_on(loop, far);
  auto& levels = loop.result.levels;
  if (loop.surface.patch_count < loop.kept) keep_level(loop);
  space_levels(levels);
  loop.kept = levels.back().patch_count;
  if (levels.size() == 1) loop.last_level = loop.first_patches;
  run_stage(loop, {stages[kCoarse]});
  for (const SimplifyStageName name : {kCoarseFar, kLast}) {
    const Stage stage{stages[name]};
    run_stage(loop, stage);
    if (has_many_patches(loop)) flip_and_go_on(loop, stage);
  }
  if (loop.surface.patch_count <= loop.params.last_level_share * loop.kept) keep_level(loop);
  drop_equal_resolutions(levels);
}

/// The volume of an open surface depends on where it is measured from by its vector area: guarded
/// is one that is closed but for holes too small to matter.
VolumeGuard guard_volume(const TriangleMesh& mesh, double radius, double limit) {
  const auto& x = mesh.positions;
  Vec3 vector_area = Vec3::Zero();
  for (const auto& t : mesh.triangles)
    vector_area += 0.5 * (x[idx(t[1])] - x[idx(t[0])]).cross(x[idx(t[2])] - x[idx(t[0])]);
  const double volume = mass_properties(mesh).volume, largest = limit * std::fabs(volume);
  if (vector_area.norm() * radius > largest) return {};
  return {volume, volume, largest};
}

}  // namespace

namespace detail {

Simplification simplify_in_form(const DecomposedSurface& decomposed, const SimplifyParams& params,
                                const SimplifyForm& form,
                                std::vector<std::array<double, 2>> support,
                                CornerAttributes attributes) {
  const TriangleMesh& mesh = decomposed.mesh;
  Loop loop{build_patched_surface(decomposed, params.convexity_tolerance,
                                  params.protrusion_tolerance, attributes),
            {},
            params,
            {},
            detail::CollapseQueue(params.threads)};
  PatchedSurface& surface = loop.surface;
  loop.result.levels.push_back(first_level(mesh, decomposed.patches, support, attributes));
  loop.result.convexity_tolerance = surface.flat;
  loop.result.protrusion_tolerance = surface.inset;
  loop.context.params = params.collapse;
  loop.context.form = form;
  loop.context.quadric = vertex_quadrics(surface);
  loop.context.guard = build_deviation_guard(mesh);
  loop.context.volume = guard_volume(mesh, surface.radius, params.volume_limit);
  loop.support = std::move(support);
  loop.queue.version.assign(mesh.positions.size(), 0);
  loop.vertex_normal.resize(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v)
    if (surface.mesh.outgoing[v] >= 0) update_normal(loop, static_cast<std::int32_t>(v));
  for (std::size_t i = 0; i < surface.patches.size(); ++i)
    loop.successor.push_back(static_cast<std::int32_t>(i));
  loop.kept = loop.result.levels[0].patch_count;
  loop.kept_triangles = surface.mesh.triangle_count;
  loop.first_patches.assign(loop.successor.begin(), loop.successor.begin() + loop.kept);
  loop.last_level = loop.first_patches;
  run_stages(loop);
  if (params.progress) params.progress(1.0);
  return std::move(loop.result);
}

}  // namespace detail

Simplification simplify_surface(const DecomposedSurface& decomposed, const SimplifyParams& params,
                                std::vector<std::array<double, 2>> support,
                                CornerAttributes attributes) {
  return detail::simplify_in_form(decomposed, params, {}, std::move(support),
                                  std::move(attributes));
}

}  // namespace thigma
