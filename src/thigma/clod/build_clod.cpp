// Sec. 3.3: levels by simplification, and a tree over all their patches. Deviates: D of both
// readings, parents by geometry, nodes bounded by hulls of the finest surface (docs/deviations.md).

#include "thigma/clod/build_clod.h"

#include <algorithm>
#include <limits>

#include "thigma/clod/detail/build_levels.h"
#include "thigma/clod/detail/draft_tree.h"
#include "thigma/clod/detail/level_bounds.h"
#include "thigma/clod/detail/level_patches.h"
#include "thigma/clod/detail/parents.h"
#include "thigma/clod/support_area.h"
#include "thigma/core/cpu_clock.h"
#include "thigma/core/index.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

// Of the time of a build, about: the loop of simplification, and all up to the finished tree.
constexpr double kShareOfLoop = 0.6, kShareOfTree = 0.75;

/// The simplified levels of the tree. returns the nodes without a parent.
std::vector<std::int32_t> draft_levels(const TriangleMesh& mesh,
                                       const Simplification& simplification,
                                       const std::vector<detail::LevelPatches>& patches,
                                       bool is_reparented, int threads, detail::DraftTree& tree) {
  std::vector<std::int32_t> draft_of_patch(tree.drafts.size());
  for (std::size_t i = 0; i < draft_of_patch.size(); ++i)
    draft_of_patch[i] = static_cast<std::int32_t>(i);
  std::int32_t first_contact = 0;
  for (std::size_t k = 1; k < simplification.levels.size(); ++k) {
    const std::vector<std::int32_t> parent =
        is_reparented
            ? detail::nearest_parents(tree, draft_of_patch, simplification.levels[k - 1].parent,
                                      simplification.levels[k].mesh, patches[k], threads)
            : simplification.levels[k - 1].parent;
    std::vector<std::vector<std::int32_t>> children(idx(simplification.levels[k].patch_count));
    for (std::size_t i = 0; i < parent.size(); ++i)
      if (draft_of_patch[i] >= 0) children[idx(parent[i])].push_back(draft_of_patch[i]);
    draft_of_patch.assign(children.size(), -1);
    for (std::size_t p = 0; p < children.size(); ++p) {
      if (children[p].empty()) continue;
      draft_of_patch[p] =
          detail::add_inner(mesh, std::move(children[p]), static_cast<std::int32_t>(k), tree);
      tree.drafts.back().contact = first_contact + static_cast<std::int32_t>(p);
    }
    first_contact += simplification.levels[k].patch_count;
  }
  std::erase(draft_of_patch, -1);
  return draft_of_patch;
}

void describe_levels(const Simplification& simplification, ClodHierarchy& hierarchy) {
  hierarchy.levels.assign(std::max(simplification.levels.size(), idx(hierarchy.nodes[0].level) + 1),
                          {});
  for (std::size_t k = 0; k < hierarchy.levels.size(); ++k) {
    ClodLevel& level = hierarchy.levels[k];
    level.is_free = k >= simplification.levels.size();
    if (level.is_free) continue;
    level.triangle_count =
        static_cast<std::int32_t>(simplification.levels[k].mesh.triangles.size());
    level.patch_count = simplification.levels[k].patch_count;
    level.resolution = simplification.levels[k].resolution;
  }
  for (const ClodNode& node : hierarchy.nodes) {
    ClodLevel& level = hierarchy.levels[idx(node.level)];
    ++level.node_count;
    level.hausdorff_max = std::max(level.hausdorff_max, node.hausdorff);
  }
  for (const LevelPatch& patch : hierarchy.level_patches) {
    ClodLevel& level = hierarchy.levels[idx(patch.level)];
    level.deviation_max = std::max(level.deviation_max, patch.deviation);
    level.contact_hausdorff_max = std::max(level.contact_hausdorff_max, patch.hausdorff);
  }
}

}  // namespace

namespace detail {

ClodHierarchy build_levels(const TriangleMesh& mesh, const ClodParams& params, const TreeForm& form,
                           ClodReport* report) {
  ClodHierarchy hierarchy;
  const Ball ball = enclosing_ball(mesh.positions);
  hierarchy.center = ball.center;
  hierarchy.radius = ball.radius;
  hierarchy.triangle_count = static_cast<std::int32_t>(mesh.triangles.size());
  const double start = process_cpu_seconds();
  const SurfaceTopology topology = compute_topology(mesh);
  const ConvexDecomposition decomposition = decompose_surface(mesh, topology, params.decomposition);
  const DecomposedSurface surface{mesh, topology, decomposition};
  const double decomposed = process_cpu_seconds();
  auto support = support_areas(
      mesh, topology, {.tolerance = params.contact_tolerance * hierarchy.radius}, params.threads);
  const double supported = process_cpu_seconds();
  SimplifyParams simplify = params.simplify;
  simplify.threads = params.threads;
  const auto& progress = params.simplify.progress;
  if (progress) simplify.progress = [&](double share) { progress(kShareOfLoop * share); };
  Simplification simplification = simplify_surface(surface, simplify, std::move(support));
  const double simplified = process_cpu_seconds();
  const std::vector<LevelPatches> patches = list_level_patches(simplification);
  DraftTree tree = draft_leaves(mesh, decomposition);
  std::vector<std::int32_t> tops =
      draft_levels(mesh, simplification, patches, form.is_reparented, params.threads, tree);
  const std::int32_t root = add_even_levels(mesh, tops, tree);
  place_drafts(surface, tree, root, hierarchy);
  append_contact_patches(simplification, patches, hierarchy);
  measure_hausdorff(params.threads, hierarchy);
  if (!form.has_culling_hulls) bound_by_contact_patches(hierarchy);
  const double placed = process_cpu_seconds();
  if (progress) progress(kShareOfTree);
  measure_deviation(mesh, decomposition, simplification, params.threads, hierarchy);
  measure_level_bounds(params.threads, hierarchy);
  fill_support(decomposition, patches, simplification, hierarchy);
  describe_levels(simplification, hierarchy);
  if (progress) progress(1.0);
  if (!report) return hierarchy;
  report->decompose_seconds = decomposed - start;
  report->simplify_seconds = simplified - supported;
  report->tree_seconds = placed - simplified;
  report->parameter_seconds = process_cpu_seconds() - placed + supported - decomposed;
  report->childless = std::count_if(hierarchy.level_patches.begin(), hierarchy.level_patches.end(),
                                    [](const LevelPatch& p) { return p.patch.node < 0; });
  report->simplification = std::make_shared<Simplification>(std::move(simplification));
  report->decomposition = decomposition.params;
  return hierarchy;
}

}  // namespace detail

ClodHierarchy build_clod(const TriangleMesh& mesh, const ClodParams& params, ClodReport* report) {
  return detail::build_levels(mesh, params, {}, report);
}

}  // namespace thigma
