#include "live_models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "mesh_report.h"
#include "named_scene.h"
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/files/growing_file.h"
#include "thigma/import/read_mesh.h"
#include "thigma/scene/scene_file.h"
#include "thigma/texture/texture_file.h"

namespace thigma::app {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostRecordings = 50;

/// Nothing that a path or a message could trip over.
std::string harmless(const std::string& name) {
  std::string safe;
  for (const char c : fs::path(name).filename().string().substr(0, 80)) {
    const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '_';
    safe += is_plain ? c : '_';
  }
  return safe.empty() || safe[0] == '.' ? "mesh" + safe : safe;
}

Bounds scaled(const Bounds& b, double unit) { return {unit * b.min, unit * b.max}; }

/// Bounds of a box after a turn.
Bounds turned(const Bounds& b, const Quat& q) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  Bounds result{Vec3::Constant(kFar), Vec3::Constant(-kFar)};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 at((corner & 1) != 0 ? b.max.x() : b.min.x(),
                  (corner & 2) != 0 ? b.max.y() : b.min.y(),
                  (corner & 4) != 0 ? b.max.z() : b.min.z());
    const Vec3 p = q._transformVector(at);
    result.min = result.min.cwiseMin(p);
    result.max = result.max.cwiseMax(p);
  }
  return result;
}

/// Whether a name is that of a recording without its end: F.mcap.part, or F.mcap.part.N, moved out
/// of its way.
bool is_part_of_recording(const std::string& name) {
  constexpr std::string_view kPart = ".mcap.part";
  const std::size_t at = name.rfind(kPart);
  if (at == std::string::npos || at == 0) return false;
  const std::string rest = name.substr(at + kPart.size());
  const bool is_number = rest.size() > 1 && rest[0] == '.' &&
                         rest.find_first_not_of("0123456789", 1) == std::string::npos;
  return rest.empty() || is_number;
}

/// How a recording without its end stands in the menu.
std::string part_title(const fs::path& path, const std::string& name) {
  const std::string recording = name.substr(0, name.rfind(".part"));
  return recording + (is_growing(path.string()) ? ", being written" : ", cut off");
}

/// Metres per unit that make a mesh most like an object of this radius: millimetres, centimetres,
/// inches or metres. What is usual for its format counts as a factor of two in size: printers' and
/// scanners' files, STL, are in millimetres, and textures in metres alone.
double likely_unit(const std::string& path, double mesh_radius, double radius) {
  constexpr std::array<double, 4> kUnits = {0.001, 0.01, 0.0254, 1.0};
  const std::string format = fs::path(path).extension().string();
  if (format == ".tex") return 1.0;
  if (!(mesh_radius > 0.0)) return kUnits[0];
  const bool is_stl = format == ".stl" || format == ".STL";
  const auto off = [&](double unit) {
    const double usual = is_stl && unit != kUnits[0] ? std::log(2.0) : 0.0;
    return usual + std::abs(std::log(unit * mesh_radius / radius));
  };
  return *std::min_element(kUnits.begin(), kUnits.end(),
                           [&](double a, double b) { return off(a) < off(b); });
}

/// What the user has saved, by path.
void add_kept_scenes(live::OpenMenu& menu) {
  std::vector<live::OpenMenu::Item> kept;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(user_folder("scenes"), ignored)) {
    const fs::path& path = entry.path();
    if (path.extension() == ".toml" || path.extension() == ".mcap")
      kept.push_back({path.string(), path.stem().string()});
  }
  std::sort(kept.begin(), kept.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  menu.scenes.insert(menu.scenes.end(), kept.begin(), kept.end());
}

/// Recordings in a folder, by path; those of the working directory by their names alone.
void add_recordings(const fs::path& folder, bool is_here, live::OpenMenu& menu) {
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!entry.is_regular_file(ignored)) continue;
    const std::string path = is_here ? name : entry.path().string();
    if (entry.path().extension() == ".mcap") menu.recordings.push_back({path, name});
    if (is_part_of_recording(name))
      menu.recordings.push_back({path, part_title(entry.path(), name)});
  }
}

}  // namespace

live::OpenMenu open_menu() {
  live::OpenMenu menu;
  for (const std::string& name : builtin_scene_names())
    menu.scenes.push_back({name, read_scene(name).title});
  add_kept_scenes(menu);
  add_recordings(".", true, menu);
  const std::string own = user_folder("recordings");
  std::error_code none;
  if (!own.empty() && !fs::equivalent(own, ".", none)) add_recordings(own, false, menu);
  std::sort(menu.recordings.begin(), menu.recordings.end(),
            [](const auto& a, const auto& b) { return a.name < b.name; });
  if (menu.recordings.size() > kMostRecordings)
    menu.recordings.erase(menu.recordings.begin(),
                          menu.recordings.end() - static_cast<std::ptrdiff_t>(kMostRecordings));
  return menu;
}

DroppedMesh::~DroppedMesh() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

std::string DroppedMesh::new_place() {
  std::error_code error;
  if (folder_.empty()) {
    std::string made = (fs::temp_directory_path(error) / "thigma-XXXXXX").string();
    if (error || mkdtemp(made.data()) == nullptr)
      throw IoError(made + ": no folder could be made there for a dropped mesh");
    folder_ = made;
  }
  const fs::path place = fs::path(folder_) / std::to_string(++count_);
  fs::create_directory(place, error);
  return place.string();
}

std::string DroppedMesh::keep_recording(const std::string& name, const std::string& bytes) {
  const fs::path place = new_place();
  const std::string path = (place / harmless(name)).string();
  std::error_code ignored;
  try {
    write_file(path, bytes);
  } catch (const IoError&) {
    fs::remove_all(place, ignored);
    throw;
  }
  // The one before may still be shown: its open file outlives its name.
  if (!recording_.empty()) fs::remove_all(fs::path(recording_).parent_path(), ignored);
  recording_ = path;
  return path;
}

const MeshReport& DroppedMesh::keep(const std::string& name, const std::string& bytes) {
  const fs::path place = new_place();
  std::error_code error;
  const std::string path = (place / harmless(name)).string();
  MeshReport report;
  try {
    write_file(path, bytes);
    const bool is_texture = fs::path(path).extension() == ".tex";
    report = is_texture ? inspect_mesh(read_texture(path).texture.coarse)
                        : inspect_mesh(read_mesh(path), path);
  } catch (const std::exception& wrong) {
    fs::remove_all(place, error);
    // People know the file by its name, not by where it is kept meanwhile.
    std::string text = wrong.what();
    if (text.starts_with(path)) text.replace(0, path.size(), harmless(name));
    throw InputError(text);
  }
  report_ = std::move(report);
  kept_.push_back(path);
  path_ = path;
  name_ = harmless(name);
  return report_;
}

std::string DroppedMesh::path_of(int number) const {
  const std::string place = (fs::path(folder_) / std::to_string(number)).string();
  for (const std::string& path : kept_)
    if (fs::path(path).parent_path() == place) return path;
  return "";
}

void DroppedMesh::tidy(const SceneDescription& now) {
  // That a scene may be made of. From the oldest on what is too much goes, of files and of bytes.
  constexpr std::size_t kMostFiles = 32;
  constexpr std::uintmax_t kMostBytes = 512u << 20;
  std::error_code unknown;
  const auto size_of = [&](const std::string& path) {
    const std::uintmax_t size = fs::file_size(path, unknown);
    return unknown ? 0 : size;
  };
  std::size_t files = kept_.size();
  std::uintmax_t bytes = 0;
  for (const std::string& path : kept_) bytes += size_of(path);
  std::erase_if(kept_, [&](const std::string& path) {
    const std::uintmax_t size = size_of(path);
    const bool is_newest = files-- == 1;
    const bool is_too_much = files >= kMostFiles || bytes > kMostBytes;
    bytes -= size;
    if (is_newest || !is_too_much) return false;
    const auto is_it = [&](const SceneObject& o) { return o.mesh == path; };
    const bool is_used =
        is_it(now.object) || std::any_of(now.statics.begin(), now.statics.end(), is_it);
    if (is_used) return false;
    std::error_code ignored;
    fs::remove_all(fs::path(path).parent_path(), ignored);
    return true;
  });
}

std::string model_message(std::int64_t id, const DroppedMesh& mesh, double radius) {
  nlohmann::ordered_json json = {{"type", "model"}, {"id", id}, {"name", mesh.name()}};
  json["report"] = mesh_report_json(mesh.report());
  json["report"]["file"] = mesh.name();
  json["number"] = mesh.number();
  json["unit"] = likely_unit(mesh.path(), mesh.report().radius, radius);
  json["object_radius"] = radius;
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

SceneDescription scene_with(const SceneDescription& now, const DroppedMesh& mesh, bool is_held,
                            double unit, const Bounds& other) {
  if (is_held && now.statics.empty())
    throw InputError(mesh.name() + ": nothing stands still in this scene to hold it against");
  SceneObject dropped;
  dropped.name = mesh.name();
  dropped.mesh = mesh.path();
  dropped.unit_scale = unit;
  SceneDescription scene;
  scene.object = is_held ? dropped : now.object;
  scene.statics.push_back(is_held ? now.statics.front() : dropped);
  scene.title = scene.object.name + " against " + scene.statics[0].name;
  scene.file = scene.title;
  scene.rate = now.rate;
  scene.device.uri = now.device.uri;
  scene.safety = now.safety;  // the hand and its device are the same
  scene.is_passive = now.is_passive;
  scene.is_strict = now.is_strict;

  const Bounds own = scaled(mesh.report().bounds, unit);
  Pose& held = scene.object.world_from_mesh;
  const Pose& standing = scene.statics[0].world_from_mesh;
  const Bounds above = turned(is_held ? own : other, held.orientation);
  const Bounds below = turned(is_held ? other : own, standing.orientation);
  const double gap = 0.05 * (above.max - above.min).norm();
  held.position = standing.position + 0.5 * (below.min + below.max - above.min - above.max);
  held.position.z() = standing.position.z() + below.max.z() - above.min.z() + gap;
  return scene;
}

}  // namespace thigma::app
