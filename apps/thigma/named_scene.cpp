#include "named_scene.h"

#include <cstdlib>
#include <filesystem>
#include <mutex>

#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/scene/packed_scene.h"
#include "thigma/scene/packed_world.h"
#include "thigma/scene/scene_file.h"

namespace thigma::app {
namespace fs = std::filesystem;
namespace {

/// A folder for the program's time.
class Scratch {
 public:
  Scratch() = default;
  ~Scratch() {
    std::error_code ignored;
    if (!root_.empty()) fs::remove_all(root_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string next() {
    const std::lock_guard lock(mutex_);
    std::error_code error;
    if (root_.empty()) {
      std::string made = (fs::temp_directory_path(error) / "thigma-XXXXXX").string();
      if (error || mkdtemp(made.data()) == nullptr)
        throw IoError(made + ": no folder could be made there");
      root_ = made;
    }
    const fs::path place = fs::path(root_) / std::to_string(++count_);
    if (!fs::create_directory(place, error) || error)
      throw IoError(place.string() + ": no folder could be made there");
    return place.string();
  }

 private:
  std::mutex mutex_;
  std::string root_;
  int count_ = 0;
};

}  // namespace

std::string scratch_folder() {
  static Scratch scratch;
  return scratch.next();
}

namespace {

bool is_packed(const std::string& name) { return fs::path(name).extension() == ".mcap"; }

}  // namespace

bool is_named_world(const std::string& name) {
  return is_packed(name) ? has_packed_world(name) : is_world_scene(name);
}

WorldSceneDescription read_named_world(const std::string& name) {
  return is_packed(name) ? read_packed_world(name, scratch_folder()) : read_world_scene(name);
}

SceneDescription read_named_scene(const std::string& name) {
  return is_packed(name) ? read_packed_scene(name, scratch_folder()) : read_scene(name);
}

std::string user_folder(const std::string& kind) {
  const char* data = std::getenv("XDG_DATA_HOME");
  if (data != nullptr && data[0] == '/') return (fs::path(data) / "thigma" / kind).string();
  const char* home = std::getenv("HOME");
  if (home == nullptr || home[0] == '\0') return "";
  return (fs::path(home) / ".local" / "share" / "thigma" / kind).string();
}

}  // namespace thigma::app
