// Convex surface decomposition (Sec. 3.3.1, after Ehmann and Lin 2001). A patch grows from its
// first triangle over its edges, breadth first; a triangle joins when the patch stays convex, keeps
// to its number of vertices, and no triangle of the same shell reaches into the new hull. The cheap
// tests come first. Deviates from the sources: the last test clips instead of sampling, because
// samples miss almost every protrusion (docs/deviations.md).

#include "thigma/convex/decomposition.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "thigma/convex/clip.h"
#include "thigma/convex/count_patches.h"
#include "thigma/convex/quickhull.h"
#include "thigma/convex/visit_triangles.h"
#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/surface_topology.h"

namespace thigma {
namespace {

/// Everything one patch after the other is grown with.
struct Growth {
  const TriangleMesh& mesh;
  const SurfaceTopology& surface;
  const TriangleTree& tree;
  double flat = 0.0;   // height that counts as none [m]
  double inset = 0.0;  // of the hull planes before the clip test [m]
  int max_vertices = 0;
  std::vector<std::int32_t> patch_of = {};       // of each triangle, -1 free
  std::vector<std::int32_t> refused_by = {};     // last patch that refused the triangle
  std::vector<std::int32_t> last_patch_at = {};  // last patch that has the position as a vertex
  std::int32_t patch = 0;                        // the growing one
  std::vector<std::int32_t> triangles = {}, vertices = {};
  std::vector<Vec3> points = {};  // of the vertices
  bool met_crossing = false, met_protrusion = false, met_size = false;
  Quickhull hull = {};  // scratch from here
  std::vector<HalfSpace> half_spaces = {};
  std::vector<std::int32_t> intruders = {};
};

std::array<Vec3, 3> corners(const TriangleMesh& mesh, std::int32_t t) {
  const auto& v = mesh.triangles[idx(t)];
  return {mesh.positions[idx(v[0])], mesh.positions[idx(v[1])], mesh.positions[idx(v[2])]};
}

/// A triangle thinner than the tolerance has no plane worth the name: it lies on its neighbours'
/// planes.
bool has_plane(const Growth& growth, std::int32_t t) {
  return growth.surface.height[idx(t)] > growth.flat;
}

double height_over(const Growth& growth, std::int32_t t, const Vec3& p) {
  return growth.surface.normal[idx(t)].dot(
      p - growth.mesh.positions[idx(growth.mesh.triangles[idx(t)][0])]);
}

bool stays_convex(const Growth& growth, std::int32_t candidate, const Vec3* added) {
  if (has_plane(growth, candidate))
    for (const Vec3& p : growth.points)
      if (height_over(growth, candidate, p) > growth.flat) return false;
  if (added)
    for (const std::int32_t t : growth.triangles)
      if (has_plane(growth, t) && height_over(growth, t, *added) > growth.flat) return false;
  return true;
}

/// Lists the triangles of the shell that reach into the hull of the patch's points.
void list_intruders(Growth& growth, std::int32_t candidate) {
  growth.intruders.clear();
  TreeBox box{growth.points[0], growth.points[0]};
  for (const Vec3& p : growth.points) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  const double extent = (box.max - box.min).norm();
  start_hull(growth.hull, growth.points, std::max(1e-10, growth.flat / extent));
  if (growth.hull.dimension < 3) return;
  complete_hull(growth.hull);
  list_half_spaces(growth.hull, growth.inset, growth.half_spaces);
  const std::int32_t shell = growth.surface.shell[idx(candidate)];
  visit_triangles(growth.tree, box, [&](std::int32_t t) {
    if (t == candidate || growth.patch_of[idx(t)] == growth.patch ||
        growth.surface.shell[idx(t)] != shell)
      return;
    if (growth.surface.height[idx(t)] <= 0.0) return;
    std::array<Vec3, 3> triangle = corners(growth.mesh, t);
    for (Vec3& p : triangle) p = (p - growth.hull.origin) * growth.hull.scale;
    if (reaches_into(triangle, growth.half_spaces)) growth.intruders.push_back(t);
  });
}

bool crosses_patch(const Growth& growth, std::int32_t intruder, std::int32_t candidate) {
  const std::array<Vec3, 3> other = corners(growth.mesh, intruder);
  if (triangles_cross(corners(growth.mesh, candidate), other)) return true;
  for (const std::int32_t t : growth.triangles)
    if (triangles_cross(corners(growth.mesh, t), other)) return true;
  return false;
}

/// Adds the triangle if the patch stays a patch.
bool try_to_join(Growth& growth, std::int32_t candidate) {
  std::array<std::int32_t, 3> added{};
  std::size_t count = 0;
  for (const std::int32_t v : growth.mesh.triangles[idx(candidate)])
    if (growth.last_patch_at[idx(v)] != growth.patch) added[count++] = v;
  // A neighbour over an edge brings one vertex at most.
  const Vec3* point = count > 0 ? &growth.mesh.positions[idx(added[0])] : nullptr;
  if (!stays_convex(growth, candidate, point)) return false;
  if (point) {
    if (static_cast<int>(growth.vertices.size()) >= growth.max_vertices) {
      growth.met_size = true;
      return false;
    }
    growth.points.push_back(*point);
    list_intruders(growth, candidate);
    if (!growth.intruders.empty()) {
      growth.points.pop_back();
      const bool crossing =
          std::any_of(growth.intruders.begin(), growth.intruders.end(),
                      [&](std::int32_t t) { return crosses_patch(growth, t, candidate); });
      (crossing ? growth.met_crossing : growth.met_protrusion) = true;
      return false;
    }
    growth.vertices.push_back(added[0]);
    growth.last_patch_at[idx(added[0])] = growth.patch;
  }
  growth.triangles.push_back(candidate);
  growth.patch_of[idx(candidate)] = growth.patch;
  return true;
}

void grow_patch(Growth& growth, std::int32_t seed) {
  growth.triangles.assign(1, seed);
  growth.patch_of[idx(seed)] = growth.patch;
  growth.vertices.clear();
  growth.points.clear();
  growth.met_crossing = growth.met_protrusion = growth.met_size = false;
  for (const std::int32_t v : growth.mesh.triangles[idx(seed)]) {
    growth.vertices.push_back(v);
    growth.points.push_back(growth.mesh.positions[idx(v)]);
    growth.last_patch_at[idx(v)] = growth.patch;
  }
  for (std::size_t i = 0; i < growth.triangles.size(); ++i)
    for (const std::int32_t t : growth.surface.neighbor[idx(growth.triangles[i])]) {
      if (t < 0 || growth.patch_of[idx(t)] >= 0 || growth.refused_by[idx(t)] == growth.patch)
        continue;
      if (growth.surface.height[idx(t)] <= 0.0) continue;
      if (!try_to_join(growth, t)) growth.refused_by[idx(t)] = growth.patch;
    }
}

/// Half of the mesh's extent: the smallest ball to within a factor that no tolerance feels.
double half_extent(const TriangleMesh& mesh) { return enclosing_ball(mesh.positions).radius; }

/// Ninety-five percent of the heights that rounding alone gives to flat edges, or 0 where flat
/// edges are rare or exact. Scale free, so it finds single precision behind a scale factor too.
double rounding_height(const TriangleMesh& mesh, const SurfaceTopology& surface, double radius) {
  std::vector<double> heights;
  std::size_t edges = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (const std::int32_t other : surface.neighbor[t]) {
      if (other < static_cast<std::int32_t>(t) || surface.height[t] < 1e-3 * radius * 1e-2)
        continue;
      ++edges;
      double height = 0.0;
      for (const std::int32_t v : mesh.triangles[idx(other)])
        height = std::max(
            height, std::fabs(surface.normal[t].dot(mesh.positions[idx(v)] -
                                                    mesh.positions[idx(mesh.triangles[t][0])])));
      if (height < 1e-6 * radius && height > 1e-13 * radius) heights.push_back(height);
    }
  }
  if (heights.size() * 100 < edges || heights.empty()) return 0.0;
  const auto rank = heights.begin() + static_cast<std::ptrdiff_t>(heights.size() * 95 / 100);
  std::nth_element(heights.begin(), rank, heights.end());
  return *rank;
}

DecompositionParams resolved(const TriangleMesh& mesh, const SurfaceTopology& surface,
                             double radius, DecompositionParams params) {
  params.max_vertices = std::clamp(params.max_vertices, 3, kMaxHullVertices);
  if (params.convexity_tolerance < 0.0)
    params.convexity_tolerance =
        std::clamp(4.0 * rounding_height(mesh, surface, radius) / radius, 1e-9, 1e-6);
  if (params.protrusion_tolerance < 0.0)
    params.protrusion_tolerance = std::max(1e-7, 10.0 * params.convexity_tolerance);
  return params;
}

}  // namespace

DecompositionParams resolve_tolerances(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                       const DecompositionParams& params) {
  return resolved(mesh, topology, half_extent(mesh), params);
}

namespace {

ConvexDecomposition decompose(const TriangleMesh& mesh, const SurfaceTopology& surface,
                              double radius, const DecompositionParams& params) {
  ConvexDecomposition result;
  result.params = params;
  std::vector<std::int32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  const TriangleTree tree = build_triangle_tree(mesh, std::move(all));
  Growth growth{mesh, surface, tree};
  growth.flat = result.params.convexity_tolerance * radius;
  growth.inset = result.params.protrusion_tolerance * radius;
  growth.max_vertices = result.params.max_vertices;
  growth.patch_of.assign(mesh.triangles.size(), -1);
  growth.refused_by.assign(mesh.triangles.size(), -1);
  growth.last_patch_at.assign(mesh.positions.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (growth.patch_of[t] >= 0 || surface.height[t] <= 0.0) continue;
    growth.patch = static_cast<std::int32_t>(result.patches.size());
    grow_patch(growth, static_cast<std::int32_t>(t));
    std::sort(growth.triangles.begin(), growth.triangles.end());
    std::sort(growth.vertices.begin(), growth.vertices.end());
    result.patches.push_back(growth.triangles);
    result.vertices.push_back(growth.vertices);
    result.cut_by_self_intersection += growth.met_crossing;
    result.cut_by_protrusion += growth.met_protrusion && !growth.met_crossing;
    result.cut_by_size += growth.met_size && !growth.met_crossing && !growth.met_protrusion;
  }
  result.patch_of_triangle = std::move(growth.patch_of);
  return result;
}

void require_area(const SurfaceTopology& topology) {
  const std::vector<double>& height = topology.height;
  if (std::none_of(height.begin(), height.end(), [](double h) { return h > 0.0; }))
    throw InputError("convex decomposition: no triangle has an area, expected at least one");
}

}  // namespace

ConvexDecomposition decompose_surface(const TriangleMesh& mesh, const SurfaceTopology& topology,
                                      const DecompositionParams& params) {
  require_area(topology);
  const double radius = half_extent(mesh);
  return decompose(mesh, topology, radius, resolved(mesh, topology, radius, params));
}

ConvexDecomposition decompose_surface(const TriangleMesh& mesh, const DecompositionParams& params) {
  return decompose_surface(mesh, compute_topology(mesh), params);
}

std::int32_t count_convex_patches(const TriangleMesh& mesh) {
  const SurfaceTopology topology = compute_topology(mesh);
  require_area(topology);
  const double radius = half_extent(mesh);
  DecompositionParams params = resolved(mesh, topology, radius, {});
  params.max_vertices = std::numeric_limits<int>::max();
  return static_cast<std::int32_t>(decompose(mesh, topology, radius, params).patches.size());
}

}  // namespace thigma
