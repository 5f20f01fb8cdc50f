#include "fuzz/targets/any_mesh.h"

#include "thigma/import/read_texture_coordinates.h"

namespace thigma::fuzz {

void fuzz_obj(Bytes bytes) {
  const std::string text(text_of(bytes));
  read_any_mesh(text);
  MeshFile file;
  if (!is_taken("mesh", [&] { file = parse_mesh(text, "mesh"); })) return;
  if (file.format != MeshFormat::obj) return;
  is_taken("mesh", [&] {
    const auto corners = read_texture_coordinates(text, "mesh");
    require(corners.size() == file.mesh.triangles.size(), "every triangle has its corners");
  });
}

}  // namespace thigma::fuzz
