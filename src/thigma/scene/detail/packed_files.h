#pragma once
// The files of a scene in one file: what scenes of one object and worlds have in common.

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "thigma/recording/mcap_file.h"

namespace thigma::detail {

inline constexpr std::string_view kSceneFile = "scene.toml";

/// Collects the files of a scene, each once under a plain name. Thread: one, [offline].
class PackedFiles {
 public:
  explicit PackedFiles(std::string folder) : files_(1), folder_(std::move(folder)) {}
  /// The name to write for a file. InputError where it cannot be read.
  std::string add(const std::string& path);
  /// All of them behind the scene, which names them. Once.
  std::vector<McapAttachment> with_scene(std::string toml);

 private:
  std::vector<McapAttachment> files_;
  std::string folder_;
  std::map<std::string, std::string> packed_;  // by path
  std::set<std::string> names_;
};

/// Writes them alone. Thread [offline]; IoError, and nothing is left.
void write_packed_files(const std::string& path, const std::vector<McapAttachment>& files);

/// What a file carries. Thread [offline]; InputError.
std::vector<McapAttachment> packed_files_of(const std::string& path);
bool has_scene(const std::vector<McapAttachment>& files);

/// Writes what a file carries to a folder, and returns the text of its scene. Thread [offline];
/// InputError where it has none, and for names that lead out of the folder.
std::string unpack_scene(const std::string& path, const std::string& folder);

/// InputError where a scene from elsewhere names a file that it does not bring.
void check_brought(const std::string& file, const std::string& path, const std::string& folder);

/// The device of a scene from elsewhere: it moves nothing by itself.
std::string confined_device(const std::string& uri);

}  // namespace thigma::detail
