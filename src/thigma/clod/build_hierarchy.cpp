// Sec. 3.3.3 without simplified levels: patches, then pairwise merging ("free" levels). Every inner
// node is bounded by the hull of few well-spread points of its descendants plus h, the distance by
// which the others stand out.

#include "thigma/clod/build_hierarchy.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "thigma/clod/detail/draft_tree.h"
#include "thigma/core/cpu_clock.h"
#include "thigma/core/index.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

void describe_levels(ClodHierarchy& hierarchy) {
  hierarchy.levels.resize(idx(hierarchy.nodes[0].level) + 1);
  hierarchy.levels[0].resolution = std::numeric_limits<double>::infinity();
  for (const ClodNode& node : hierarchy.nodes) {
    ClodLevel& level = hierarchy.levels[idx(node.level)];
    level.is_free = node.level > 0;
    ++level.node_count;
    level.hausdorff_max = std::max(level.hausdorff_max, node.hausdorff);
  }
}

}  // namespace

ClodHierarchy build_exact_hierarchy(const TriangleMesh& mesh, const DecompositionParams& params,
                                    BuildReport* report) {
  const double start = process_cpu_seconds();
  const SurfaceTopology topology = compute_topology(mesh);
  const ConvexDecomposition decomposition = decompose_surface(mesh, topology, params);
  const double middle = process_cpu_seconds();
  ClodHierarchy hierarchy;
  const Ball ball = enclosing_ball(mesh.positions);
  hierarchy.center = ball.center;
  hierarchy.radius = ball.radius;
  hierarchy.triangle_count = static_cast<std::int32_t>(mesh.triangles.size());
  detail::DraftTree tree = detail::draft_leaves(mesh, decomposition);
  std::vector<std::int32_t> leaves(tree.drafts.size());
  std::iota(leaves.begin(), leaves.end(), 0);
  const std::int32_t root = detail::add_free_levels(mesh, leaves, tree);
  detail::place_drafts({mesh, topology, decomposition}, tree, root, hierarchy);
  describe_levels(hierarchy);
  if (report) {
    report->triangles = hierarchy.triangle_count;
    report->patches = static_cast<std::int32_t>(hierarchy.patches.size());
    report->cut_by_self_intersection = decomposition.cut_by_self_intersection;
    report->cut_by_protrusion = decomposition.cut_by_protrusion;
    report->cut_by_size = decomposition.cut_by_size;
    report->decompose_seconds = middle - start;
    report->hierarchy_seconds = process_cpu_seconds() - middle;
  }
  return hierarchy;
}

}  // namespace thigma
