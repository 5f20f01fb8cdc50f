#include "thigma/scene/write_scene.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include "thigma/core/error.h"
#include "thigma/core/utf8.h"
#include "thigma/files/file.h"
#include "thigma/loop/safety_fields.h"
#include "thigma/scene/detail/toml_table.h"

namespace thigma {
namespace {

/// A name as a scene may have it: what a file name brought along and TOML does not take is '?'.
std::string plain(std::string_view name) {
  std::string text;
  for (std::size_t at = 0; at < name.size();) {
    const std::size_t length = utf8_length(name, at);
    const bool is_control = length == 1 && (name[at] < ' ' || name[at] == 127);
    text += length == 0 || is_control ? "?" : std::string(name.substr(at, length));
    at += std::max<std::size_t>(length, 1);
  }
  return text;
}

toml::array array_of(const Vec3& v) { return toml::array{v.x(), v.y(), v.z()}; }
toml::array array_of(const Quat& q) { return toml::array{q.x(), q.y(), q.z(), q.w()}; }

void put_friction(const Friction& friction, toml::table& table) {
  for (const FrictionNumber& f : kFrictionNumbers)
    table.insert_or_assign(f.key, friction.*f.number);
}

/// The orientation as it stands in the table that it was read from, where it is the same: a
/// quaternion that is normalised twice has other bits.
toml::array orientation_of(const SceneObject& object, const toml::table* from) {
  const Quat& q = object.world_from_mesh.orientation;
  if (const toml::array* given = from ? (*from)["quat_xyzw"].as_array() : nullptr) {
    const auto at = [&](std::size_t i) { return (*given)[i].value_or(0.0); };
    const bool is_whole = given->size() == 4;
    if (is_whole && Quat(at(3), at(0), at(1), at(2)).normalized().coeffs() == q.coeffs())
      return *given;
  }
  return array_of(q);
}

/// from   the table it was read from; null: none
toml::table object_table(const SceneObject& object, const toml::table* from) {
  toml::table table;
  table.insert("name", plain(object.name));
  table.insert(object.is_textured ? "texture" : "mesh", object.mesh);
  if (!object.level_textures.empty()) table.insert("texture", object.level_textures);
  if (!object.textured_model) table.insert("unit_scale", object.unit_scale);
  table.insert("position", array_of(object.world_from_mesh.position));
  table.insert("quat_xyzw", orientation_of(object, from));
  if (!object.material) return table;
  toml::table material;
  put_friction(object.material->friction, material);
  material.insert("restitution", object.material->restitution);
  if (object.material->tap_amplitude)
    material.insert("tap_amplitude", *object.material->tap_amplitude);
  if (object.material->tap_frequency)
    material.insert("tap_frequency", *object.material->tap_frequency);
  if (object.material->tap_decay) material.insert("tap_decay", *object.material->tap_decay);
  table.insert("material", std::move(material));
  return table;
}

/// What a scene made in code has beside its objects, where it is not the default.
toml::table other_tables(const SceneDescription& scene) {
  toml::table root, safety, contact;
  if (!scene.gravity.isZero(0.0)) root.insert("gravity", array_of(scene.gravity));
  for (const ResponseName& known : kResponseNames)
    if (scene.contact.response == known.kind) contact.insert_or_assign("response", known.name);
  if (scene.contact.friction.at_rest > 0.0) put_friction(scene.contact.friction, contact);
  if (!contact.empty()) root.insert("contact", std::move(contact));
  SafetyLimits limits = scene.safety;
  std::vector<double> usual;
  SafetyLimits defaults;
  visit_safety_limits(defaults, [&](const char*, double& value) { usual.push_back(value); });
  std::size_t i = 0;
  visit_safety_limits(limits, [&](const char* key, double& value) {
    if (value != usual[i++]) safety.insert(key, value);
  });
  if (scene.is_passive) safety.insert("passivity", true);
  if (scene.is_strict) safety.insert("strict", true);
  if (!safety.empty()) root.insert("safety", std::move(safety));
  root.insert("device", toml::table{{"uri", scene.device.uri}});
  root.insert("solver", toml::table{{"rate", scene.rate}});
  return root;
}

}  // namespace

std::string write_scene(const SceneDescription& scene) {
  toml::table root = scene.text.empty() ? other_tables(scene) : parse_toml(scene.text, scene.file);
  root.insert_or_assign("title", plain(scene.title));
  if (scene.repairs) root.insert_or_assign("repair", true);
  toml::table object = object_table(scene.object, root["object"].as_table());
  if (scene.mass) object.insert("mass", *scene.mass);
  if (scene.density) object.insert("density", *scene.density);
  if (scene.grasp_point) object.insert("grasp_point", array_of(*scene.grasp_point));
  root.insert_or_assign("object", std::move(object));
  toml::array statics;
  const toml::array* read = root["static"].as_array();
  for (std::size_t i = 0; i < scene.statics.size(); ++i) {
    const bool has_table = read != nullptr && i < read->size();
    statics.push_back(object_table(scene.statics[i], has_table ? (*read)[i].as_table() : nullptr));
  }
  root.erase("static");
  if (!statics.empty()) root.insert("static", std::move(statics));
  if (!scene.simulation) root.erase("simulation");
  std::ostringstream text;
  text << toml::toml_formatter(root) << '\n';
  return text.str();
}

}  // namespace thigma
