#include "thigma/scene/detail/packed_files.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "thigma/core/error.h"
#include "thigma/files/byte_source.h"
#include "thigma/files/file.h"

namespace thigma::detail {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

std::string PackedFiles::add(const std::string& path) {
  const auto found = packed_.find(path);
  if (found != packed_.end()) return found->second;
  const std::string name = free_name(path, names_);
  names_.insert(name);
  files_.push_back({folder_ + "/" + name, "application/octet-stream", read_file(path)});
  return packed_[path] = files_.back().name;
}

std::vector<McapAttachment> PackedFiles::with_scene(std::string toml) {
  files_[0] = {std::string(kSceneFile), "application/toml", std::move(toml)};
  return std::move(files_);
}

void write_packed_files(const std::string& path, const std::vector<McapAttachment>& files) {
  McapWriter writer(path);
  try {
    for (const McapAttachment& file : files) writer.attach(file);
    writer.close();
  } catch (...) {
    writer.discard();
    throw;
  }
}

std::vector<McapAttachment> packed_files_of(const std::string& path) {
  constexpr std::uint64_t kLongest = std::uint64_t{1} << 32;
  FileSource source(path, std::size_t{1} << 16, kLongest);
  return read_attachments(source, path);
}

bool has_scene(const std::vector<McapAttachment>& files) {
  return std::any_of(files.begin(), files.end(),
                     [](const McapAttachment& file) { return file.name == kSceneFile; });
}

std::string unpack_scene(const std::string& path, const std::string& folder) {
  const std::vector<McapAttachment> files = packed_files_of(path);
  if (!has_scene(files))
    throw InputError(path + ": no scene in it, expected an attachment scene.toml");
  std::error_code ignored;
  fs::create_directory(fs::path(folder) / "assets", ignored);
  std::set<std::string> names;
  for (const McapAttachment& file : files) {
    const std::string_view name = file.name;
    const bool is_asset = name.starts_with(kAssets) && is_plain_name(name.substr(kAssets.size()));
    if (name != kSceneFile && !is_asset) {
      throw InputError(path + ": an attachment '" + file.name.substr(0, kLongestName) +
                       "', expected scene.toml and assets/NAME of letters, digits, '.', '-', '_'");
    }
    if (!names.insert(file.name).second)
      throw InputError(path + ": two attachments '" + file.name + "', expected one of each name");
    write_file((fs::path(folder) / file.name).string(), file.data);
  }
  return read_file((fs::path(folder) / kSceneFile).string());
}

void check_brought(const std::string& file, const std::string& path, const std::string& folder) {
  const fs::path named(file);
  if (named.parent_path() == fs::path(folder) / "assets" &&
      is_plain_name(named.filename().string()))
    return;
  throw InputError(path + ": its scene names the file '" + file +
                   "', expected one that it brings, assets/NAME");
}

std::string confined_device(const std::string& uri) {
  const std::string scheme = uri.substr(0, uri.find(':'));
  // Without its options: `camera` and `rotation` would open another device.
  return scheme == "web" || scheme == "null" ? scheme + ":" : "hand:";
}

}  // namespace thigma::detail
