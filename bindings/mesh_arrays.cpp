#include "mesh_arrays.h"

#include "thigma/core/error.h"
#include "thigma/import/load_mesh.h"
#include "thigma/import/repair.h"
#include "thigma/models/make_model.h"

namespace thigma::bindings {
namespace {

TriangleMesh copied(const MeshArrays& arrays) {
  TriangleMesh mesh;
  mesh.positions.reserve(static_cast<std::size_t>(arrays.vertex_count));
  for (std::int64_t i = 0; i < arrays.vertex_count; ++i) {
    const double* v = arrays.vertices + 3 * i;
    mesh.positions.emplace_back(v[0], v[1], v[2]);
  }
  mesh.triangles.reserve(static_cast<std::size_t>(arrays.triangle_count));
  for (std::int64_t i = 0; i < arrays.triangle_count; ++i) {
    const std::int32_t* t = arrays.triangles + 3 * i;
    mesh.triangles.push_back({t[0], t[1], t[2]});
  }
  return mesh;
}

void refuse_wild(const TriangleMesh& mesh) {
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3& v = mesh.positions[i];
    if (v.allFinite() && v.cwiseAbs().maxCoeff() <= kMaxCoordinate) continue;
    throw InputError("mesh: a coordinate that is not finite or above 1e50, vertex " +
                     std::to_string(i) + ", expected finite numbers");
  }
  const auto count = static_cast<std::int64_t>(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::int32_t index : mesh.triangles[i]) {
      if (index >= 0 && index < count) continue;
      throw InputError("mesh: vertex " + std::to_string(index) + ", triangle " + std::to_string(i) +
                       ", expected 0 to " + std::to_string(count - 1));
    }
}

}  // namespace

TriangleMesh usable_mesh(const MeshArrays& arrays, const MeshOptions& options) {
  TriangleMesh given = copied(arrays);
  refuse_wild(given);
  MeshFile file = merge_equal_positions(std::move(given));
  scale_mesh(file.mesh, options.scale, "mesh");
  const MeshReport report = inspect_mesh(file, "mesh", {.self_intersections = false});
  if (report.verdict == MeshVerdict::usable) return std::move(file.mesh);
  if (report.verdict == MeshVerdict::rejected || !options.repairs) {
    throw InputError(
        "mesh: " + report.reasons.front() + ", in the mesh as a whole, expected a usable mesh" +
        (report.verdict == MeshVerdict::repairable ? "; repair takes it repaired" : ""));
  }
  RepairResult repaired = repair_mesh(file.mesh, "mesh");
  if (options.repaired != nullptr) *options.repaired = std::move(repaired.repairs);
  return std::move(repaired.mesh);
}

TriangleMesh usable_mesh(const std::string& path, const MeshOptions& options) {
  if (!models::is_model_uri(path))
    return load_usable_mesh(path, options.scale, options.repairs, nullptr, options.repaired);
  TriangleMesh mesh = models::make_model(models::parse_model_uri(path, "mesh"));
  scale_mesh(mesh, options.scale, path);
  return mesh;
}

}  // namespace thigma::bindings
