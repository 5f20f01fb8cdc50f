// Mesh files of any format: the reader finds out which.

#include "fuzz/fuzz_target.h"

#include "thigma/import/detail/mesh_formats.h"
#include "thigma/import/inspect.h"
#include "thigma/import/read_texture_coordinates.h"
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

/// Exact formats keep every bit.
void check_round_trip(const TriangleMesh& mesh, MeshFormat format) {
  const MeshFile again = parse_mesh(format_mesh(mesh, format, "again"), "again");
  require(again.format == format, "what is written is recognised");
  require(again.mesh.positions == mesh.positions, "positions survive writing");
  require(again.mesh.triangles == mesh.triangles, "triangles survive writing");
}

void check_texture_coordinates(const std::string& bytes, const MeshFile& file) {
  is_taken("mesh", [&] {
    const auto corners = read_texture_coordinates(bytes, "mesh");
    require(corners.size() == file.mesh.triangles.size(), "every triangle has its corners");
  });
}

}  // namespace

/// Reads a mesh, checks what read_mesh promises, and of some small ones looks at them as `inspect`
/// does, and writes and reads them again.
void fuzz_mesh(Bytes input) {
  const std::string bytes(text_of(input));
  MeshFile file;
  if (!is_taken("mesh", [&] { file = parse_mesh(bytes, "mesh"); })) return;
  check_mesh(file.mesh);
  if (file.format == MeshFormat::obj) check_texture_coordinates(bytes, file);
  require(file.mesh.triangles.size() <= bytes.size(), "memory is bounded by the file");
  constexpr std::size_t kFew = 16;
  if (file.mesh.triangles.empty() || file.mesh.triangles.size() > kFew) return;
  if (!is_one_of(64, input)) return;  // writing, looking and repairing take fifty times as long
  for (const detail::MeshFormatRow& row : detail::kMeshFormats)
    if (row.is_exact && row.write != nullptr) check_round_trip(file.mesh, row.format);
  const MeshReport report = inspect_mesh(file, "mesh");
  if (report.verdict != MeshVerdict::repairable) return;
  RepairResult repaired;
  if (is_taken("mesh", [&] { repaired = repair_mesh(file.mesh, "mesh"); }))
    check_mesh(repaired.mesh);
}

}  // namespace thigma::fuzz
