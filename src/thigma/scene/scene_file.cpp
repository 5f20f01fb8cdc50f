#include "thigma/scene/scene_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

#include "thigma/contact/clustering.h"
#include "thigma/core/error.h"
#include "thigma/depth/depth_gradient.h"
#include "thigma/files/file.h"
#include "thigma/import/read_mesh.h"
#include "thigma/loop/safety_fields.h"
#include "thigma/models/make_model.h"
#include "thigma/models/textured_model.h"
#include "thigma/scene/detail/object_keys.h"
#include "thigma/scene/detail/toml_table.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

using detail::ObjectKeys;
using detail::read_coupling;
using detail::read_object_keys;
using detail::resolve_object;

/// The numbers of friction of a table, nothing where it has none; what is left out is zero, but
/// static_friction friction.
std::optional<Friction> read_friction(TomlTable& table) {
  const bool has_kinetic = table.has("friction"), has_at_rest = table.has("static_friction");
  Friction friction{};
  for (const FrictionNumber& f : kFrictionNumbers)
    friction.*f.number = table.number(f.key, Range::not_negative).value_or(0.0);
  if (!has_kinetic && has_at_rest)
    table.fail("static_friction", "stands without friction", "expected friction beside it");
  if (!has_kinetic) return std::nullopt;
  if (!has_at_rest) friction.at_rest = friction.kinetic;
  if (!is_valid(friction))
    table.fail("static_friction", "is below friction", "expected friction or more");
  return friction;
}

std::optional<Material> read_material(TomlTable& object) {
  std::optional<TomlTable> table = object.table("material");
  if (!table) return std::nullopt;
  const std::optional<Friction> friction = read_friction(*table);
  const double restitution = table->number("restitution", Range::not_negative).value_or(0.0);
  if (restitution > 1.0) table->fail("restitution", "is above 1", "expected 0 to 1");
  const Material material{friction.value_or(Friction{}), restitution,
                          table->number("tap_amplitude", Range::not_negative),
                          table->number("tap_frequency", Range::positive),
                          table->number("tap_decay", Range::positive)};
  table->finish();
  if (!friction) table->fail_here("no friction", "expected friction = Coulomb's coefficient");
  return material;
}

}  // namespace

namespace detail {

ObjectKeys read_object_keys(TomlTable& table) {
  return {table.text("mesh"), table.text("texture"),
          table.text("name"), table.number("unit_scale", Range::positive),
          table.pose(),       read_material(table)};
}

}  // namespace detail

namespace {

/// A procedural surface, with or without relief.
void resolve_model(const TomlTable& table, const char* key, const std::string& uri,
                   SceneObject& object) {
  try {
    if (object.is_textured) {
      object.textured_model = models::parse_textured_uri(uri, key);
      object.name = object.textured_model->name;
    } else {
      object.model = models::parse_model_uri(uri, key);
      object.name = object.model->name;
    }
  } catch (const InputError& error) {
    // "mesh: what, expected": the line goes in between.
    const std::string text = error.what();
    const std::size_t split = text.rfind(", expected"), start = std::string(key).size();
    table.fail(key, "is wrong" + text.substr(start, split - start), text.substr(split + 2));
  }
  object.mesh = uri;
}

/// A file the scene names, relative to it.
std::string resolve_file(const TomlTable& table, const char* key, const std::string& given,
                         const std::string& folder) {
  const fs::path named(given);
  const fs::path path = named.is_absolute() || folder.empty() ? named : fs::path(folder) / named;
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    table.fail(key, "= '" + given + "' is not there",
               std::string("expected a ") + key + " file (relative to the scene)");
  }
  return path.string();
}

}  // namespace

namespace detail {

SceneObject resolve_object(const TomlTable& table, const ObjectKeys& keys,
                           const std::string& folder) {
  SceneObject object;
  if (!keys.mesh && !keys.texture)
    table.fail_here("no mesh", "expected mesh = \"FILE\" or \"procedural:NAME\", or a texture");
  if (keys.mesh && keys.texture) {
    if (models::is_model_uri(*keys.texture))
      table.fail("texture", "stands beside mesh",
                 "expected a .tex file of its levels there, or one of the two");
    object.level_textures = resolve_file(table, "texture", *keys.texture, folder);
  }
  object.is_textured = !keys.mesh;
  const char* const key = object.is_textured ? "texture" : "mesh";
  const std::string& given = object.is_textured ? *keys.texture : *keys.mesh;
  if (models::is_model_uri(given)) {
    if (object.is_textured && keys.unit_scale)
      table.fail("unit_scale", "stands beside a procedural texture", "expected its own size");
    resolve_model(table, key, given, object);
  } else {
    if (!keys.unit_scale) {
      table.fail(key, "has no unit_scale", "expected unit_scale = metres per unit of the mesh");
    }
    object.mesh = resolve_file(table, key, given, folder);
    object.name = fs::path(object.mesh).stem().string();
  }
  object.unit_scale = keys.unit_scale.value_or(1.0);
  object.name = keys.name.value_or(object.name);
  object.world_from_mesh = keys.pose;
  object.material = keys.material;
  return object;
}

}  // namespace detail

namespace {

void read_grasped(TomlTable& table, const std::string& folder, SceneDescription& scene) {
  const ObjectKeys keys = read_object_keys(table);
  scene.mass = table.number("mass", Range::positive);
  scene.density = table.number("density", Range::positive);
  if (scene.mass && scene.density)
    table.fail("density", "stands beside mass", "expected one of the two");
  scene.grasp_point = table.vector("grasp_point");
  table.finish();
  scene.object = resolve_object(table, keys, folder);
}

void read_texture_keys(TomlTable table, TextureParams& texture) {
  constexpr std::array kSearches = {DepthSearch::grid, DepthSearch::branch, DepthSearch::gpu};
  if (const auto search = table.choice("depth", {"grid", "branch", "gpu"}))
    texture.search = kSearches[static_cast<std::size_t>(*search)];
  texture.resolution = table.whole("resolution", 2, 4096).value_or(texture.resolution);
  texture.max_nodes = table.whole("nodes", 1, 1'000'000'000).value_or(texture.max_nodes);
  const std::vector<std::string> kinds = {"central_differences", "envelope", "smoothed_envelope"};
  if (const auto kind = table.choice("gradient", kinds))
    gradient_kind(kinds[static_cast<std::size_t>(*kind)], texture.gradient);
  texture.smoothing = table.number("smoothing", Range::positive).value_or(texture.smoothing);
  table.finish();
}

/// Keys of levels of detail: what is left out stays as in `resolution`.
void read_resolution(TomlTable& table, Resolution& resolution) {
  resolution.is_exact = table.truth("exact").value_or(resolution.is_exact);
  resolution.metric.haptic =
      table.number("threshold", Range::not_negative).value_or(resolution.metric.haptic);
  resolution.metric.velocity =
      table.number("velocity_metric", Range::not_negative).value_or(resolution.metric.velocity);
  if (const std::optional<Vec3> eye = table.vector("eye")) {
    resolution.metric.has_eye = true;
    resolution.metric.eye = *eye;
  }
  const std::optional<double> cap = table.number("deviation_cap", Range::positive);
  const std::optional<bool> is_capped = table.truth("capped");
  resolution.deviation_cap = cap.value_or(resolution.deviation_cap);
  if (is_capped && !*is_capped) resolution.deviation_cap = kNoCap;
  resolution.interpolates = table.truth("interpolated").value_or(resolution.interpolates);
  if (const auto reading = table.choice("support", {"one_ring", "flood", "patch"}))
    resolution.reading = static_cast<SupportReading>(*reading);
  const std::optional<double> budget_us = table.number("budget_us", Range::not_negative);
  resolution.budget_cpu = budget_us ? 1e-6 * *budget_us : resolution.budget_cpu;
  resolution.budget_tests = table.whole("budget_tests", 0, 1'000'000'000)
                                .value_or(static_cast<int>(resolution.budget_tests));
}

void read_contact(TomlTable table, ContactGains& contact) {
  contact.stiffness = table.number("stiffness", Range::positive);
  contact.damping = table.number("damping", Range::not_negative);
  contact.damping_ratio = table.number("damping_ratio", Range::not_negative);
  contact.tolerance = table.number("tolerance", Range::not_negative);
  contact.max_clusters =
      table.whole("clusters", 1, kMaxContactClusters).value_or(contact.max_clusters);
  contact.is_divided_among_clusters =
      table.truth("shared").value_or(contact.is_divided_among_clusters);
  contact.distributes_wide_contacts =
      table.truth("spread").value_or(contact.distributes_wide_contacts);
  read_resolution(table, contact.resolution);
  contact.carry = table.number("carry", Range::not_negative);
  std::vector<std::string> responses;
  for (const ResponseName& known : kResponseNames) responses.emplace_back(known.name);
  if (const auto response = table.choice("response", responses))
    contact.response = kResponseNames[*response].kind;
  contact.has_levels_far = contact.response == ResponseKind::constrained &&
                           table.has("threshold") && !contact.resolution.is_exact;
  contact.friction = read_friction(table).value_or(contact.friction);
  if (const auto rule = table.choice("combine", {"geometric", "average", "minimum", "maximum"}))
    contact.combine = static_cast<CombineRule>(*rule);
  if (contact.damping && contact.damping_ratio) {
    table.fail("damping_ratio", "stands beside damping", "expected one of the two");
  }
  contact.exponent = table.whole("exponent", 2, 4);
  if (contact.exponent == 3) table.fail("exponent", "is 3", "expected 2 or 4");
  contact.area = table.number("area", Range::positive);
  table.finish();
}

}  // namespace

namespace detail {

void read_coupling(TomlTable table, CouplingGains& coupling) {
  coupling.linear_stiffness = table.number("linear_stiffness", Range::positive);
  coupling.linear_damping = table.number("linear_damping", Range::not_negative);
  coupling.angular_stiffness = table.number("angular_stiffness", Range::positive);
  coupling.angular_damping = table.number("angular_damping", Range::not_negative);
  coupling.damping_ratio = table.number("damping_ratio", Range::not_negative);
  coupling.max_force = table.number("max_force", Range::positive);
  coupling.max_torque = table.number("max_torque", Range::positive);
  coupling.is_saturated = table.truth("saturated").value_or(coupling.is_saturated);
  if (coupling.damping_ratio && coupling.linear_damping && coupling.angular_damping) {
    table.fail("damping_ratio", "stands beside both dampings", "expected no more than it needs");
  }
  table.finish();
}

}  // namespace detail

namespace {

void read_device(TomlTable table, DeviceChoice& device) {
  device.uri = table.text("uri").value_or(device.uri);
  device.motion_scale = table.number("motion_scale", Range::positive);
  device.force_scale = table.number("force_scale", Range::positive);
  device.world_from_device = table.pose();
  device.approach = table.vector("approach");
  if (device.approach && !(device.approach->squaredNorm() > 0.0)) {
    table.fail("approach", "has no direction", "expected [x, y, z] of any length above 0");
  }
  if (const auto place = table.choice("grasp_at", {"grasp_point", "handle"})) {
    device.grasp_place = *place == 0 ? GraspPlace::grasp_point : GraspPlace::handle;
  }
  device.turn_rate = table.number("turn_rate", Range::positive).value_or(device.turn_rate);
  table.finish();
}

void require_fade(const TomlTable& table, const char* full, const char* stale, bool has_time) {
  if (has_time) return;
  table.fail(table.has(full) ? full : stale, "leaves no time to fade",
             std::string("expected ") + full + " below " + stale);
}

}  // namespace

namespace detail {

void read_safety_limits(TomlTable& table, SafetyLimits& safety) {
  visit_safety_limits(safety, [&](const char* key, double& value) {
    value = table.number(key, Range::positive).value_or(value);
  });
  require_fade(table, "model_full_age", "model_stale_age",
               safety.model_full_age < safety.model_stale_age);
  require_fade(table, "rows_full_age", "rows_stale_age",
               safety.rows_full_age < safety.rows_stale_age);
}

}  // namespace detail

namespace {

void read_safety(TomlTable table, SceneDescription& scene) {
  scene.is_passive = table.truth("passivity").value_or(scene.is_passive);
  scene.is_strict = table.truth("strict").value_or(scene.is_strict);
  detail::read_safety_limits(table, scene.safety);
  table.finish();
}

void read_solver(TomlTable table, SceneDescription& scene) {
  table.choice("integrator", {"implicit"});
  const std::optional<double> rate = table.number("rate", Range::positive);
  if (rate && !(*rate >= 50.0 && *rate <= 20000.0))
    table.fail("rate", "is out of range", "expected 50 to 20000 Hz");
  scene.rate = rate.value_or(scene.rate);
  scene.contact_every = table.whole("contact_every", 1, 1000).value_or(scene.contact_every);
  scene.contact_latency = table.whole("contact_latency", 1, 1000).value_or(scene.contact_latency);
  table.finish();
}

void read_taps(TomlTable table, TapChoice& taps) {
  taps.is_on = table.truth("enabled").value_or(taps.is_on);
  Tap& usual = taps.usual;
  usual.amplitude = table.number("amplitude", Range::not_negative).value_or(usual.amplitude);
  usual.frequency = table.number("frequency", Range::positive).value_or(usual.frequency);
  usual.decay = table.number("decay", Range::positive).value_or(usual.decay);
  table.finish();
}

}  // namespace

SceneDescription parse_scene(std::string_view text, const std::string& file,
                             const std::string& folder) {
  const toml::table root = parse_toml(text, file);
  TomlTable top(root, file, "");
  SceneDescription scene;
  scene.file = file;
  scene.text = text;
  scene.title = top.text("title").value_or(fs::path(file).stem().string());
  scene.repairs = top.truth("repair").value_or(scene.repairs);
  scene.gravity = top.vector("gravity").value_or(scene.gravity);
  scene.has_auto_gains = top.choice("gains", {"size", "auto"}).value_or(0) == 1;
  if (top.has("body"))
    top.fail("body", "moves by itself",
             "expected a scene of one [object]; thigma run and replay take worlds");
  std::optional<TomlTable> object = top.table("object");
  std::vector<TomlTable> statics = top.tables("static");
  if (auto table = top.table("contact")) read_contact(*table, scene.contact);
  if (auto table = top.table("texture")) read_texture_keys(*table, scene.contact.texture);
  if (auto table = top.table("coupling")) read_coupling(*table, scene.coupling);
  if (auto table = top.table("device")) read_device(*table, scene.device);
  if (auto table = top.table("taps")) read_taps(*table, scene.taps);
  if (auto table = top.table("safety")) read_safety(*table, scene);
  if (auto table = top.table("solver")) read_solver(*table, scene);
  top.table("simulation");  // its keys are read below
  top.finish();             // before what is missing: a misspelt [object] is named as such
  if (!object) top.fail_here("no [object]", "expected the grasped object as a table [object]");
  read_grasped(*object, folder, scene);
  for (TomlTable& table : statics) {
    const ObjectKeys keys = read_object_keys(table);
    table.finish();
    scene.statics.push_back(resolve_object(table, keys, folder));
  }
  scene.simulation = parse_simulated_body(text, file);
  return scene;
}

namespace {

/// A mesh where a scene belongs: the parser would only complain of its first line.
void refuse_mesh(const std::string& path) {
  std::string ending = fs::path(path).extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const MeshKind& kind : mesh_kinds()) {
    if (ending != kind.ending) continue;
    throw InputError(path + ": a mesh, expected a scene; two meshes run by --object " + path +
                     " --against OTHER");
  }
}

}  // namespace

SceneDescription read_scene(const std::string& path) {
  std::error_code error;
  const std::vector<std::string> names = builtin_scene_names();
  if (!fs::exists(path, error) || fs::is_directory(path, error)) {
    if (std::find(names.begin(), names.end(), path) != names.end()) {
      return parse_scene(builtin_scene(path), path, "");
    }
    std::string all;
    for (const std::string& name : names) all += " " + name;
    const std::string nearest = models::nearest_word(path, names);
    throw InputError(path + (fs::is_directory(path, error) ? ": a folder" : ": no such file") +
                     (nearest.empty() ? "" : ", nearest is '" + nearest + "'") +
                     ", expected a scene file or one of" + all);
  }
  refuse_mesh(path);
  return parse_scene(read_scene_text(path), path, fs::path(path).parent_path().string());
}

}  // namespace thigma
