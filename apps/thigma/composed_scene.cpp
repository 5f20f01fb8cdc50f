#include "composed_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "named_scene.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/scene/packed_scene.h"

namespace thigma::app {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::json;

/// An object as the page has it, and what messages call it.
struct Given {
  const Json& json;
  std::string name;

  [[noreturn]] void fail(const std::string& what, const std::string& expected) const {
    throw InputError(name + ": " + what + ", expected " + expected);
  }
  double number(const Json& value, const char* key) const {
    if (!value.is_number() || !std::isfinite(value.get<double>()))
      fail(std::string(key) + " is no number", "one");
    return value.get<double>();
  }
  /// Nothing where it is left out or null.
  std::optional<double> number(const char* key) const {
    const auto found = json.find(key);
    if (found == json.end() || found->is_null()) return std::nullopt;
    return number(*found, key);
  }
  template <int N>
  Eigen::Matrix<double, N, 1> numbers(const char* key) const {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_array() || found->size() != N)
      fail(std::string(key) + " is wrong", std::to_string(N) + " numbers");
    Eigen::Matrix<double, N, 1> v;
    for (int i = 0; i < N; ++i) v[i] = number((*found)[static_cast<std::size_t>(i)], key);
    return v;
  }
};

std::string text_of(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found != json.end() && found->is_string() ? found->get<std::string>() : "";
}

/// The object that "scene:K" (0 the one in the hand) or "file:N" names.
SceneObject source_of(const Given& given, const SceneDescription& now, const DroppedMesh& dropped) {
  const std::string source = text_of(given.json, "source");
  const std::size_t colon = source.find(':');
  const std::string kind = source.substr(0, colon);
  const std::string digits = colon == std::string::npos ? "" : source.substr(colon + 1);
  const bool is_number = !digits.empty() && digits.size() <= 6 &&
                         digits.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t number = is_number ? std::stoul(digits) : 0;
  if (is_number && kind == "scene" && number <= now.statics.size())
    return number == 0 ? now.object : now.statics[number - 1];
  const std::string path =
      is_number && kind == "file" ? dropped.path_of(static_cast<int>(number)) : "";
  if (path.empty()) given.fail("there is no '" + source + "' here any more", "it dropped again");
  SceneObject object;
  object.mesh = path;
  object.is_textured = fs::path(path).extension() == ".tex";
  object.name = fs::path(path).stem().string();
  return object;
}

SceneObject object_of(const Given& given, const SceneDescription& now, const DroppedMesh& dropped) {
  SceneObject object = source_of(given, now, dropped);
  if (const std::string name = text_of(given.json, "name"); !name.empty())
    object.name = name.substr(0, 80);
  if (const auto unit = given.number("unit"); unit && !object.textured_model) {
    if (!(*unit > 0.0 && *unit < 1e6)) given.fail("unit is no length", "one above 0");
    object.unit_scale = *unit;
  }
  object.world_from_mesh.position = given.numbers<3>("position");
  constexpr double kFarthest = 1e6;  // [m]
  if (!(object.world_from_mesh.position.cwiseAbs().maxCoeff() < kFarthest))
    given.fail("position is too far away", "less than 1000 km");
  const Eigen::Vector4d q = given.numbers<4>("quat_xyzw");
  if (std::abs(q.norm() - 1.0) > 1e-3) given.fail("quat_xyzw is not unit", "a length of 1");
  object.world_from_mesh.orientation = Quat(q[3], q[0], q[1], q[2]).normalized();
  if (const auto friction = given.number("friction")) {
    if (!(*friction >= 0.0 && *friction <= 10.0)) given.fail("friction is wrong", "0 to 10");
    Material material = object.material.value_or(Material{});
    material.friction = {*friction, std::max(*friction, 0.0)};
    object.material = material;
  }
  return object;
}

/// What a scene of another object keeps of the one before.
SceneDescription fresh_scene(const SceneDescription& now) {
  SceneDescription scene;
  scene.rate = now.rate;
  scene.device.uri = now.device.uri;
  scene.safety = now.safety;
  scene.is_passive = now.is_passive;
  scene.is_strict = now.is_strict;
  scene.contact.friction = now.contact.friction;
  return scene;
}

bool is_same_surface(const SceneObject& a, const SceneObject& b) {
  return a.mesh == b.mesh && a.unit_scale == b.unit_scale && a.is_textured == b.is_textured;
}

/// FOLDER/NAME.toml, or "NAME 2", ... where something has that name: nothing is written over.
std::string free_path(const std::string& folder, const std::string& name, bool is_one_file) {
  std::error_code unknown;
  for (int i = 1; i < 1000; ++i) {
    const fs::path path = fs::path(folder) / (i == 1 ? name : name + " " + std::to_string(i));
    const std::string full = path.string() + (is_one_file ? ".mcap" : ".toml");
    const bool has_folder = !is_one_file && fs::exists(path, unknown);
    if (!fs::exists(full, unknown) && !has_folder) return full;
  }
  throw IoError(name + ": saved 999 times, expected another name");
}

}  // namespace

SceneDescription composed_scene(const std::string& title, const std::string& objects,
                                const SceneDescription& now, const DroppedMesh& dropped) {
  const Json list = Json::parse(objects, nullptr, false);
  if (!list.is_array() || list.empty())
    throw InputError("a scene without objects, expected one in the hand at least");
  std::vector<SceneObject> made;
  for (const Json& json : list) {
    const std::string name = text_of(json, "name");
    made.push_back(object_of({json, name.empty() ? "an object" : name}, now, dropped));
  }
  const bool is_kept = is_same_surface(made[0], now.object);
  SceneDescription scene = is_kept ? now : fresh_scene(now);
  const Given held{list[0], made[0].name};
  scene.mass = held.number("mass");
  scene.density = held.number("density");
  if (scene.mass && scene.density) held.fail("density stands beside mass", "one of the two");
  if ((scene.mass && !(*scene.mass > 0.0)) || (scene.density && !(*scene.density > 0.0)))
    held.fail("mass or density is wrong", "a number above 0");
  scene.simulation.reset();  // somebody holds it
  // The page has said what is repaired.
  const auto is_dropped = [](const Json& json) {
    return text_of(json, "source").starts_with("file:");
  };
  scene.repairs = now.repairs || std::any_of(list.begin(), list.end(), is_dropped);
  scene.object = made[0];
  scene.statics.assign(made.begin() + 1, made.end());
  scene.title = title.empty() ? scene.object.name : title;
  scene.file = scene.title;
  return scene;
}

std::vector<std::string> sources_of(const std::string& objects) {
  std::vector<std::string> sources;
  for (const Json& json : Json::parse(objects, nullptr, false))
    sources.push_back(text_of(json, "source"));
  return sources;
}

std::string save_scene(const SceneDescription& scene, const std::string& name, bool is_one_file) {
  const auto is_fine = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ' ' ||
           c == '-' || c == '_' || c == '.';
  };
  if (name.empty() || name.size() > 80 || name[0] == '.' || name[0] == ' ' ||
      !std::all_of(name.begin(), name.end(), is_fine))
    throw InputError("'" + name.substr(0, 80) +
                     "' is no name for a scene, expected letters, digits, spaces, '-', '_', '.'");
  const std::string folder = user_folder("scenes");
  if (folder.empty()) throw IoError("no folder for scenes: neither XDG_DATA_HOME nor HOME is set");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw IoError(folder + ": " + error.message());
  const std::string path = free_path(folder, name, is_one_file);
  if (is_one_file) {
    write_packed_scene(path, scene);
  } else {
    write_scene_folder(path, scene);
  }
  return path;
}

}  // namespace thigma::app
