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
  const auto& v = mesh.triangles[at(t)];
  return {mesh.positions[at(v[0])], mesh.positions[at(v[1])], mesh.positions[at(v[2])]};
}

/// A triangle thinner than the tolerance has no plane worth the name: it lies on its neighbours'
/// planes.
bool has_plane(const Growth& g, std::int32_t t) { return g.surface.height[at(t)] > g.flat; }

double height_over(const Growth& g, std::int32_t t, const Vec3& p) {
  return g.surface.normal[at(t)].dot(p - g.mesh.positions[at(g.mesh.triangles[at(t)][0])]);
}

bool stays_convex(const Growth& g, std::int32_t candidate, const Vec3* added) {
  if (has_plane(g, candidate))
    for (const Vec3& p : g.points)
      if (height_over(g, candidate, p) > g.flat) return false;
  if (added)
    for (const std::int32_t t : g.triangles)
      if (has_plane(g, t) && height_over(g, t, *added) > g.flat) return false;
  return true;
}

/// Lists the triangles of the shell that reach into the hull of the patch's points.
void list_intruders(Growth& g, std::int32_t candidate) {
  g.intruders.clear();
  TreeBox box{g.points[0], g.points[0]};
  for (const Vec3& p : g.points) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
  }
  const double extent = (box.max - box.min).norm();
  start_hull(g.hull, g.points, std::max(1e-10, g.flat / extent));
  if (g.hull.dimension < 3) return;
  complete_hull(g.hull);
  list_half_spaces(g.hull, g.inset, g.half_spaces);
  const std::int32_t shell = g.surface.shell[at(candidate)];
  visit_triangles(g.tree, box, [&](std::int32_t t) {
    if (t == candidate || g.patch_of[at(t)] == g.patch || g.surface.shell[at(t)] != shell) return;
    if (g.surface.height[at(t)] <= 0.0) return;
    std::array<Vec3, 3> triangle = corners(g.mesh, t);
    for (Vec3& p : triangle) p = (p - g.hull.origin) * g.hull.scale;
    if (reaches_into(triangle, g.half_spaces)) g.intruders.push_back(t);
  });
}

bool crosses_patch(const Growth& g, std::int32_t intruder, std::int32_t candidate) {
  const std::array<Vec3, 3> other = corners(g.mesh, intruder);
  if (triangles_cross(corners(g.mesh, candidate), other)) return true;
  for (const std::int32_t t : g.triangles)
    if (triangles_cross(corners(g.mesh, t), other)) return true;
  return false;
}

/// Adds the triangle if the patch stays a patch.
bool try_to_join(Growth& g, std::int32_t candidate) {
  std::array<std::int32_t, 3> added{};
  std::size_t count = 0;
  for (const std::int32_t v : g.mesh.triangles[at(candidate)])
    if (g.last_patch_at[at(v)] != g.patch) added[count++] = v;
  // A neighbour over an edge brings one vertex at most.
  const Vec3* point = count > 0 ? &g.mesh.positions[at(added[0])] : nullptr;
  if (!stays_convex(g, candidate, point)) return false;
  if (point) {
    if (static_cast<int>(g.vertices.size()) >= g.max_vertices) {
      g.met_size = true;
      return false;
    }
    g.points.push_back(*point);
    list_intruders(g, candidate);
    if (!g.intruders.empty()) {
      g.points.pop_back();
      const bool crossing =
          std::any_of(g.intruders.begin(), g.intruders.end(),
                      [&](std::int32_t t) { return crosses_patch(g, t, candidate); });
      (crossing ? g.met_crossing : g.met_protrusion) = true;
      return false;
    }
    g.vertices.push_back(added[0]);
    g.last_patch_at[at(added[0])] = g.patch;
  }
  g.triangles.push_back(candidate);
  g.patch_of[at(candidate)] = g.patch;
  return true;
}

void grow_patch(Growth& g, std::int32_t seed) {
  g.triangles.assign(1, seed);
  g.patch_of[at(seed)] = g.patch;
  g.vertices.clear();
  g.points.clear();
  g.met_crossing = g.met_protrusion = g.met_size = false;
  for (const std::int32_t v : g.mesh.triangles[at(seed)]) {
    g.vertices.push_back(v);
    g.points.push_back(g.mesh.positions[at(v)]);
    g.last_patch_at[at(v)] = g.patch;
  }
  for (std::size_t i = 0; i < g.triangles.size(); ++i)
    for (const std::int32_t t : g.surface.neighbor[at(g.triangles[i])]) {
      if (t < 0 || g.patch_of[at(t)] >= 0 || g.refused_by[at(t)] == g.patch) continue;
      if (g.surface.height[at(t)] <= 0.0) continue;
      if (!try_to_join(g, t)) g.refused_by[at(t)] = g.patch;
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
      for (const std::int32_t v : mesh.triangles[at(other)])
        height = std::max(
            height, std::fabs(surface.normal[t].dot(mesh.positions[at(v)] -
                                                    mesh.positions[at(mesh.triangles[t][0])])));
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
  Growth g{mesh, surface, tree};
  g.flat = result.params.convexity_tolerance * radius;
  g.inset = result.params.protrusion_tolerance * radius;
  g.max_vertices = result.params.max_vertices;
  g.patch_of.assign(mesh.triangles.size(), -1);
  g.refused_by.assign(mesh.triangles.size(), -1);
  g.last_patch_at.assign(mesh.positions.size(), -1);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (g.patch_of[t] >= 0 || surface.height[t] <= 0.0) continue;
    g.patch = static_cast<std::int32_t>(result.patches.size());
    grow_patch(g, static_cast<std::int32_t>(t));
    std::sort(g.triangles.begin(), g.triangles.end());
    std::sort(g.vertices.begin(), g.vertices.end());
    result.patches.push_back(g.triangles);
    result.vertices.push_back(g.vertices);
    result.cut_by_self_intersection += g.met_crossing;
    result.cut_by_protrusion += g.met_protrusion && !g.met_crossing;
    result.cut_by_size += g.met_size && !g.met_crossing && !g.met_protrusion;
  }
  result.patch_of_triangle = std::move(g.patch_of);
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
