#include "thigma/import/load_mesh.h"

#include <cmath>

#include "thigma/core/error.h"
#include "thigma/import/read_mesh.h"
#include "thigma/import/repair.h"
#include "thigma/import/shell.h"

namespace thigma {

void scale_mesh(TriangleMesh& mesh, double scale, const std::string& name) {
  if (!(scale > 0.0) || !std::isfinite(scale)) {
    throw InputError(name + ": the scale is " + std::to_string(scale) +
                     ", as given, expected a positive number of metres per unit");
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] *= scale;
    if (mesh.positions[i].cwiseAbs().maxCoeff() <= kMaxCoordinate) continue;
    throw InputError(name + ": scaled out of range, vertex " + std::to_string(i) +
                     ", expected at most 1e50 m");
  }
}

TriangleMesh load_usable_mesh(const std::string& path, double scale, bool repair,
                              MeshReport* report, std::vector<std::string>* repairs) {
  MeshFile file = read_mesh(path);
  scale_mesh(file.mesh, scale, path);
  const InspectOptions options{.self_intersections = report != nullptr};
  MeshReport found = inspect_mesh(file, path, options);
  if (found.verdict == MeshVerdict::rejected) {
    throw InputError(path + ": " + found.reasons.front() +
                     ", in the mesh as a whole, expected a usable mesh" +
                     (can_wrap(found) ? "; `thigma repair --shell` makes one of it" : ""));
  }
  if (found.verdict == MeshVerdict::repairable) {
    if (!repair) {
      throw InputError(
          path + ": " + found.reasons.front() +
          ", in the mesh as a whole, expected a usable mesh; --repair takes it repaired");
    }
    RepairResult repaired = repair_mesh(file.mesh, path);
    file.mesh = std::move(repaired.mesh);
    if (repairs != nullptr) *repairs = std::move(repaired.repairs);
    if (report != nullptr) {
      const std::string format = found.format;
      found = inspect_mesh(file.mesh, options);
      found.file = path;
      found.format = format;
    }
  }
  if (report != nullptr) *report = std::move(found);
  return std::move(file.mesh);
}

}  // namespace thigma
