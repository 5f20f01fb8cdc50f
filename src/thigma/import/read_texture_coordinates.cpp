#include "thigma/import/read_texture_coordinates.h"

#include "thigma/files/file.h"
#include "thigma/import/detail/mesh_formats.h"

namespace thigma {

using detail::at_line;
using detail::fail_input;

std::vector<std::array<Vec2, 3>> read_texture_coordinates(std::string_view bytes,
                                                          const std::string& name) {
  detail::ObjTexture texture;
  const detail::RawMesh raw =
      detail::read_obj_texture(without_byte_order_mark(bytes), name, &texture);
  if (raw.triangles.empty())
    fail_input(name, "no texture coordinates", "in the file", "an OBJ with vt");
  const auto count = static_cast<std::int64_t>(texture.coordinates.size());
  std::vector<std::array<Vec2, 3>> found;
  for (std::size_t i = 0; i < raw.triangles.size(); ++i) {
    std::array<Vec3, 3> p;
    std::array<Vec2, 3> t;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::int64_t index = texture.triangles[i][k];
      if (index < 0 || index >= count)
        fail_input(name, "texture coordinates that do not exist", at_line(texture.lines[i]),
                   "1 to " + std::to_string(count));
      p[k] = raw.positions[static_cast<std::size_t>(raw.triangles[i][k])];
      t[k] = texture.coordinates[static_cast<std::size_t>(index)];
    }
    // Bit-equal positions are one vertex: what then repeats an index is no triangle of the mesh.
    if (p[0] != p[1] && p[1] != p[2] && p[2] != p[0]) found.push_back(t);
  }
  return found;
}

}  // namespace thigma
