#include "fuzz/targets/any_mesh.h"

#include "thigma/import/inspect.h"
#include "thigma/import/repair.h"
#include "thigma/import/write_mesh.h"

namespace thigma::fuzz {
namespace {

void check_mesh(const TriangleMesh& mesh) {
  const auto count = static_cast<std::int32_t>(mesh.positions.size());
  for (const Vec3& p : mesh.positions)
    require(p.cwiseAbs().maxCoeff() <= kMaxCoordinate, "positions are in range");
  for (const auto& t : mesh.triangles) {
    for (const std::int32_t v : t) require(v >= 0 && v < count, "indices are in range");
    require(t[0] != t[1] && t[1] != t[2] && t[2] != t[0], "no triangle repeats an index");
  }
}

/// Text formats keep every bit.
void check_round_trip(const TriangleMesh& mesh, MeshFormat format) {
  const MeshFile again = parse_mesh(format_mesh(mesh, format, "again"), "again");
  require(again.mesh.positions == mesh.positions, "positions survive writing");
  require(again.mesh.triangles == mesh.triangles, "triangles survive writing");
}

}  // namespace

void read_any_mesh(const std::string& bytes) {
  MeshFile file;
  if (!is_taken("mesh", [&] { file = parse_mesh(bytes, "mesh"); })) return;
  check_mesh(file.mesh);
  require(file.mesh.triangles.size() <= bytes.size(), "memory is bounded by the file");
  constexpr std::size_t kFew = 16;
  if (file.mesh.triangles.empty() || file.mesh.triangles.size() > kFew) return;
  for (const MeshFormat format : {MeshFormat::obj, MeshFormat::off, MeshFormat::ply_little})
    check_round_trip(file.mesh, format);
  const MeshReport report = inspect_mesh(file, "mesh");
  if (report.verdict != MeshVerdict::repairable) return;
  RepairResult repaired;
  if (is_taken("mesh", [&] { repaired = repair_mesh(file.mesh, "mesh"); }))
    check_mesh(repaired.mesh);
}

}  // namespace thigma::fuzz
