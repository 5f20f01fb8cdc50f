#pragma once
// Surfaces for the tests of simplification.

#include <cmath>
#include <numeric>
#include <vector>

#include "thigma/convex/decomposition.h"
#include "thigma/mesh/shapes.h"
#include "thigma/mesh/surface_topology.h"
#include "thigma/simplify/simplify_surface.h"

namespace thigma::test {

/// A ball whose surface waves: reflex and convex everywhere, no symmetry.
inline TriangleMesh wavy_ball(int frequency, double radius = 1.0) {
  TriangleMesh mesh = make_ball(1.0, frequency);
  for (Vec3& p : mesh.positions) {
    const double x = p.x(), y = p.y(), z = p.z();
    const double wave = 5.0 * x * y * z + 3.0 * (x * x - y * y) * (z + 0.3) + 2.0 * y * z * z;
    p *= radius * (1.0 + 0.15 * wave);
  }
  return mesh;
}

/// Limits under which meshes of a few hundred triangles have levels.
inline SimplifyParams generous() {
  SimplifyParams params;
  params.stages = simplify_stages(0.5, 0.25);
  params.deviation_limit = 0.08;
  return params;
}

inline Simplification simplify(const TriangleMesh& mesh, const SimplifyParams& params = generous(),
                               const detail::SimplifyForm& form = {}) {
  return detail::simplify_in_form({mesh, compute_topology(mesh), decompose_surface(mesh)}, params,
                                  form);
}

/// Whether everything a collapse or a flip may change is the same.
inline bool same(const PatchedSurface& a, const PatchedSurface& b) {
  if (a.mesh.triangles != b.mesh.triangles || a.mesh.positions != b.mesh.positions ||
      a.mesh.twin != b.mesh.twin || a.normal != b.normal || a.height != b.height ||
      a.patch_of != b.patch_of || a.patch_count != b.patch_count)
    return false;
  for (std::size_t i = 0; i < a.patches.size(); ++i)
    if (a.patches[i].triangles != b.patches[i].triangles ||
        a.patches[i].vertices != b.patches[i].vertices)
      return false;
  return true;
}

/// A surface with all that its collapses and flips need.
struct SurfaceBench {
  TriangleMesh mesh;
  PatchedSurface surface;
  CollapseContext context;
  std::vector<std::int32_t> successor;

  /// limit     of the deviation, by the radius
  explicit SurfaceBench(TriangleMesh m, double limit = 0.02) : mesh(std::move(m)) {
    surface =
        build_patched_surface({mesh, compute_topology(mesh), decompose_surface(mesh)}, 1e-6, 1e-5);
    context.quadric = vertex_quadrics(surface);
    context.guard = detail::build_deviation_guard(mesh);
    context.scratch.search.limit = limit * surface.radius;
    successor.resize(surface.patches.size());
    std::iota(successor.begin(), successor.end(), 0);
  }
};

}  // namespace thigma::test
