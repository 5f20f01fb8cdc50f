#include "thigma/clod/clod_asset.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/detail/clod_fields.h"
#include "thigma/convex/decomposition.h"
#include "thigma/core/index.h"
#include "thigma/mesh/topology.h"
#include "thigma/simplify/simplify_surface.h"

namespace thigma {
namespace {

using detail::Dimension;
using detail::Range;

double power(double factor, Dimension dimension) {
  double result = 1.0;
  const int exponent = static_cast<int>(dimension);
  for (int i = 0; i < exponent; ++i) result *= factor;
  for (int i = 0; i > exponent; --i) result /= factor;
  return result;
}

/// Multiplies what it is shown.
struct Scaler {
  double factor;

  template <class T>
  void operator()(const char*, T& field, Dimension dimension = Dimension::none,
                  Range = Range::finite) const {
    scale(field, dimension);
  }
  template <class T>
  void record(const char*, T& item) const {
    detail::visit_fields(item, *this);
  }
  template <class T>
  void records(const char*, std::vector<T>& items) const {
    for (T& item : items) detail::visit_fields(item, *this);
  }
  template <class T, class A>
  void numbers(const char*, std::vector<T, A>& items, Dimension dimension) const {
    if (dimension == Dimension::none) return;
    for (T& item : items) scale(item, dimension);
  }

 private:
  void scale(double& value, Dimension d) const { value *= power(factor, d); }
  // Single precision holds bounds: they are not rounded below what they bound.
  void scale(float& value, Dimension d) const {
    const double exact = static_cast<double>(value) * power(factor, d);
    value = static_cast<float>(exact);
    if (static_cast<double>(value) < exact)
      value = std::nextafterf(value, std::numeric_limits<float>::infinity());
  }
  void scale(Vec3& value, Dimension d) const { value *= power(factor, d); }
  void scale(Mat3& value, Dimension d) const { value *= power(factor, d); }
  void scale(std::array<double, 2>& value, Dimension d) const {
    for (double& x : value) x *= power(factor, d);
  }
  template <class T>
  void scale(T&, Dimension) const {}  // counts and indices
};

// part: node or level patch
template <typename Part>
void refresh_lanes_of(const Part& part, const std::vector<Vec3>& vertices, AlignedFloats& lanes) {
  for (int axis = 0; axis < 3; ++axis)
    for (std::int32_t i = 0; i < part.lane_count; ++i) {
      const Vec3& p = vertices[idx(part.first_vertex + std::min(i, part.vertex_count - 1))];
      lanes[idx(part.first_lane + axis * part.lane_count + i)] =
          static_cast<float>(p[axis] - part.center[axis]);
    }
}

bool is_closed_surface(const TriangleMesh& mesh) {
  const EdgeTable table = build_edge_table(mesh);
  return std::all_of(table.edges.begin(), table.edges.end(),
                     [](const MeshEdge& edge) { return edge.use_count == 2; });
}

ClodOrigin describe_origin(const ClodParams& params, const DecompositionParams& resolved) {
  ClodOrigin origin;
  origin.contact_tolerance = params.contact_tolerance;
  origin.longest_edge = params.simplify.stages[kFine].longest_edge;
  origin.deviation_limit = params.simplify.deviation_limit;
  origin.convexity_tolerance = resolved.convexity_tolerance;
  origin.protrusion_tolerance = resolved.protrusion_tolerance;
  origin.max_vertices = resolved.max_vertices;
  return origin;
}

}  // namespace

namespace detail {

void refresh_lanes(ClodHierarchy& hierarchy) {
  for (const ClodNode& node : hierarchy.nodes)
    refresh_lanes_of(node, hierarchy.vertices, hierarchy.lanes);
  for (const LevelPatch& patch : hierarchy.level_patches)
    refresh_lanes_of(patch, hierarchy.vertices, hierarchy.lanes);
}

}  // namespace detail

ClodAsset build_clod_asset(const TriangleMesh& mesh, const ClodParams& params, ClodReport* report) {
  ClodReport own;
  ClodReport& used = report != nullptr ? *report : own;
  ClodAsset asset;
  asset.hierarchy = build_clod(mesh, params, &used);
  for (SimplifiedLevel& level : used.simplification->levels)
    asset.meshes.push_back(std::move(level.mesh));
  asset.mass.is_closed = is_closed_surface(mesh);
  asset.mass.measure = mass_properties(mesh);
  asset.origin = describe_origin(params, used.decomposition);
  return asset;
}

std::vector<std::int32_t> patches_of_triangles(const ClodAsset& asset, std::int32_t level) {
  const ClodHierarchy& hierarchy = asset.hierarchy;
  std::vector<std::int32_t> result(asset.meshes[idx(level)].triangles.size(), -1);
  const auto add = [&](const ClodPatch& patch, std::size_t index) {
    for (std::int32_t i = 0; i < patch.triangle_count; ++i)
      result[idx(hierarchy.triangle_ids[idx(patch.first_triangle + i)])] =
          static_cast<std::int32_t>(index);
  };
  if (level == 0)
    for (std::size_t p = 0; p < hierarchy.patches.size(); ++p) add(hierarchy.patches[p], p);
  else
    for (std::size_t p = 0; p < hierarchy.level_patches.size(); ++p)
      if (hierarchy.level_patches[p].level == level) add(hierarchy.level_patches[p].patch, p);
  return result;
}

void scale_hierarchy(ClodHierarchy& hierarchy, double factor) {
  if (factor == 1.0) return;
  detail::visit_parts(hierarchy, Scaler{factor});
  detail::refresh_lanes(hierarchy);
}

void scale_asset(ClodAsset& asset, double factor) {
  scale_hierarchy(asset.hierarchy, factor);
  const Scaler scaler{factor};
  for (TriangleMesh& mesh : asset.meshes)
    scaler.numbers("mesh_positions", mesh.positions, Dimension::length);
  scaler.record("mass", asset.mass);
  scaler.record("origin", asset.origin);
}

}  // namespace thigma
