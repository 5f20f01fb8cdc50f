#include "thigma/scene/packed_scene.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "thigma/core/error.h"
#include "thigma/files/byte_source.h"
#include "thigma/files/file.h"
#include "thigma/scene/scene_file.h"
#include "thigma/scene/write_scene.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kScene = "scene.toml";
constexpr std::string_view kAssets = "assets/";
constexpr std::size_t kLongestName = 100;

/// Letters that no file system, shell or archive stumbles over.
bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '-' || c == '_';
}

bool is_plain_name(std::string_view name) {
  return !name.empty() && name.size() <= kLongestName && name[0] != '.' &&
         std::all_of(name.begin(), name.end(), is_plain);
}

/// A plain name like that of a file that nothing else has yet.
std::string free_name(const std::string& path, const std::set<std::string>& taken) {
  std::string name;
  for (const char c : fs::path(path).filename().string()) name += is_plain(c) ? c : '_';
  const std::size_t most = kLongestName - 8;
  if (name.size() > most) name = name.substr(name.size() - most);  // its ending tells its kind
  if (name.empty() || name[0] == '.') name = "file" + name;
  std::string free = name;
  for (int i = 2; taken.count(free) != 0; ++i) free = std::to_string(i) + "-" + name;
  return free;
}

std::vector<McapAttachment> attachments_of(const std::string& path) {
  constexpr std::uint64_t kLongest = std::uint64_t{1} << 32;
  FileSource source(path, std::size_t{1} << 16, kLongest);
  return read_attachments(source, path);
}

bool has_scene(const std::vector<McapAttachment>& files) {
  return std::any_of(files.begin(), files.end(),
                     [](const McapAttachment& file) { return file.name == kScene; });
}

void unpack(const std::vector<McapAttachment>& files, const std::string& path,
            const std::string& folder) {
  std::error_code ignored;
  fs::create_directory(fs::path(folder) / "assets", ignored);
  std::set<std::string> names;
  for (const McapAttachment& file : files) {
    const std::string_view name = file.name;
    const bool is_asset = name.starts_with(kAssets) && is_plain_name(name.substr(kAssets.size()));
    if (name != kScene && !is_asset) {
      throw InputError(path + ": an attachment '" + file.name.substr(0, kLongestName) +
                       "', expected scene.toml and assets/NAME of letters, digits, '.', '-', '_'");
    }
    if (!names.insert(file.name).second)
      throw InputError(path + ": two attachments '" + file.name + "', expected one of each name");
    write_file((fs::path(folder) / file.name).string(), file.data);
  }
}

/// A scene from elsewhere names its own files alone, and moves nothing by itself.
void confine(SceneDescription& scene, const std::string& path, const std::string& folder) {
  const fs::path assets = fs::path(folder) / "assets";
  with_files(scene, [&](const std::string& file) {
    const fs::path named(file);
    if (named.parent_path() != assets || !is_plain_name(named.filename().string())) {
      throw InputError(path + ": its scene names the file '" + file +
                       "', expected one that it brings, assets/NAME");
    }
    return file;
  });
  const std::string scheme = scene.device.uri.substr(0, scene.device.uri.find(':'));
  if (scheme != "web" && scheme != "null") scene.device.uri = "hand:";
}

}  // namespace

std::vector<McapAttachment> pack_scene(const SceneDescription& scene, const std::string& folder) {
  std::vector<McapAttachment> files(1);
  std::map<std::string, std::string> packed;  // by path
  std::set<std::string> names;
  const SceneDescription sent = with_files(scene, [&](const std::string& path) {
    const auto found = packed.find(path);
    if (found != packed.end()) return found->second;
    const std::string name = free_name(path, names);
    names.insert(name);
    files.push_back({folder + "/" + name, "application/octet-stream", read_file(path)});
    return packed[path] = files.back().name;
  });
  files[0] = {std::string(kScene), "application/toml", write_scene(sent)};
  return files;
}

void write_packed_scene(const std::string& path, const SceneDescription& scene) {
  const std::vector<McapAttachment> files = pack_scene(scene);
  McapWriter writer(path);
  try {
    for (const McapAttachment& file : files) writer.attach(file);
    writer.close();
  } catch (...) {
    writer.discard();
    throw;
  }
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
    return has_scene(attachments_of(path));
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
  const std::vector<McapAttachment> files = attachments_of(path);
  if (!has_scene(files))
    throw InputError(path + ": no scene in it, expected an attachment scene.toml");
  unpack(files, path, folder);
  const std::string text = read_file((fs::path(folder) / kScene).string());
  SceneDescription scene = parse_scene(text, path, folder);
  confine(scene, path, folder);
  scene.repairs = true;
  return scene;
}

}  // namespace thigma
