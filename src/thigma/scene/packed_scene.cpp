#include "thigma/scene/packed_scene.h"

#include <filesystem>

#include "thigma/core/error.h"
#include "thigma/files/byte_source.h"
#include "thigma/files/file.h"
#include "thigma/scene/detail/packed_files.h"
#include "thigma/scene/scene_file.h"
#include "thigma/scene/write_scene.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

/// A scene from elsewhere names its own files alone, and moves nothing by itself.
void confine(SceneDescription& scene, const std::string& path, const std::string& folder) {
  with_files(scene, [&](const std::string& file) {
    detail::check_brought(file, path, folder);
    return file;
  });
  scene.device.uri = detail::confined_device(scene.device.uri);
}

}  // namespace

std::vector<McapAttachment> pack_scene(const SceneDescription& scene, const std::string& folder) {
  detail::PackedFiles files(folder);
  const SceneDescription sent =
      with_files(scene, [&](const std::string& path) { return files.add(path); });
  return files.with_scene(write_scene(sent));
}

void write_packed_scene(const std::string& path, const SceneDescription& scene) {
  detail::write_packed_files(path, pack_scene(scene));
}

void write_scene_folder(const std::string& path, const SceneDescription& scene) {
  const fs::path place(path);
  const std::string name = place.stem().string();
  const std::vector<McapAttachment> files = pack_scene(scene, name);
  std::error_code error;
  if (files.size() > 1) fs::create_directories(place.parent_path() / name, error);
  for (std::size_t i = 1; i < files.size(); ++i)
    write_file((place.parent_path() / files[i].name).string(), files[i].data);
  write_file(path, files[0].data);  // last: what it names is there
}

bool has_packed_scene(const std::string& path) {
  try {
    return detail::has_scene(detail::packed_files_of(path));
  } catch (const InputError&) {
    return false;
  }
}

bool is_packed_scene(const std::string& path) {
  if (!has_packed_scene(path)) return false;
  try {
    bool is_alone = true;
    FileSource source(path);
    scan_mcap(source, path, [&](const McapScan&, const McapMessage&) { return is_alone = false; });
    return is_alone;
  } catch (const InputError&) {
    return false;
  }
}

SceneDescription read_packed_scene(const std::string& path, const std::string& folder) {
  SceneDescription scene = parse_scene(detail::unpack_scene(path, folder), path, folder);
  confine(scene, path, folder);
  scene.repairs = true;
  return scene;
}

}  // namespace thigma
