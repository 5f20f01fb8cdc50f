#include "thigma/scene/packed_world.h"

#include <sstream>

#include "thigma/core/error.h"
#include "thigma/scene/detail/packed_files.h"
#include "thigma/scene/detail/toml_table.h"

namespace thigma {
namespace {

/// The mesh of a body's table, where it is a file.
void rename_mesh(const WorldSceneDescription& scene, detail::PackedFiles& files,
                 toml::table* table) {
  if (table == nullptr) return;
  const std::string given = (*table)["mesh"].value_or(std::string());
  const auto found = scene.files.find(given);
  if (found != scene.files.end()) table->insert_or_assign("mesh", files.add(found->second));
}

}  // namespace

std::vector<McapAttachment> pack_world(const WorldSceneDescription& scene) {
  toml::table root = parse_toml(scene.text, scene.file);
  detail::PackedFiles files("assets");
  rename_mesh(scene, files, root["object"].as_table());
  for (const char* key : {"static", "body"})
    if (toml::array* tables = root[key].as_array())
      for (toml::node& table : *tables) rename_mesh(scene, files, table.as_table());
  std::ostringstream text;
  text << toml::toml_formatter(root) << '\n';
  return files.with_scene(text.str());
}

void write_packed_world(const std::string& path, const WorldSceneDescription& scene) {
  detail::write_packed_files(path, pack_world(scene));
}

bool has_packed_world(const std::string& path) {
  try {
    for (const McapAttachment& file : detail::packed_files_of(path))
      if (file.name == detail::kSceneFile) return parse_toml(file.data, path).contains("body");
  } catch (const InputError&) {
    return false;  // whoever reads it says what is wrong
  }
  return false;
}

WorldSceneDescription read_packed_world(const std::string& path, const std::string& folder) {
  WorldSceneDescription scene = parse_world_scene(detail::unpack_scene(path, folder), path, folder);
  for (const auto& [given, file] : scene.files) detail::check_brought(file, path, folder);
  for (WorldSceneDevice& device : scene.devices) device.uri = detail::confined_device(device.uri);
  return scene;
}

}  // namespace thigma
