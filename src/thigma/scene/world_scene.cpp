#include "thigma/scene/world_scene.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/device/open_device.h"
#include "thigma/files/file.h"
#include "thigma/math/rotation.h"
#include "thigma/models/make_model.h"
#include "thigma/scene/asset_cache.h"
#include "thigma/scene/detail/object_keys.h"
#include "thigma/scene/detail/toml_table.h"
#include "thigma/scene/detail/world_joints.h"
#include "thigma/scene/scene_file.h"
#include "thigma/scene/start_placement.h"

namespace thigma {
namespace {

namespace fs = std::filesystem;

constexpr int kMostCopies = 1000;  // bodies of one table
constexpr std::size_t kMostJoints = 4000, kMostDevices = 16;

/// Names stand in topics of recordings.
void check_name(const TomlTable& table, const std::string& name) {
  constexpr std::string_view kAlso = " _-.";
  const auto is_plain = [&](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
           kAlso.find(c) != std::string_view::npos;
  };
  if (name.empty() || name.size() > 64 || !std::all_of(name.begin(), name.end(), is_plain))
    table.fail("name", "= '" + name + "' cannot be used",
               "expected 1 to 64 letters, digits, spaces, dots and -_");
}

/// One table: a body, or `copies` of it, each `spacing` from the one before.
void read_body(TomlTable& table, std::optional<BodyKind> kind, const std::string& folder,
               WorldSceneDescription& scene) {
  std::vector<WorldSceneBody>& bodies = scene.bodies;
  const detail::ObjectKeys keys = detail::read_object_keys(table);
  WorldSceneBody body;
  body.kind = kind.value_or(BodyKind::moving);
  if (!kind) {
    const auto word = table.choice("kind", {"moving", "prescribed", "held"});
    if (word == 2) body.kind = BodyKind::held;
    if (word == 1) body.kind = BodyKind::prescribed;
  }
  if (body.kind != BodyKind::fixed) {
    body.mass = table.number("mass", Range::positive);
    body.density = table.number("density", Range::positive);
    body.velocity = table.vector("velocity").value_or(body.velocity);
    body.spin = table.vector("spin").value_or(body.spin);
  }
  if (body.mass && body.density)
    table.fail("density", "stands beside mass", "expected one of the two");
  const int copies = table.whole("copies", 1, kMostCopies).value_or(1);
  const Vec3 spacing = table.vector("spacing").value_or(Vec3::Zero());
  if (copies > 1 && !table.has("spacing"))
    table.fail("copies", "stands without spacing", "expected spacing = [x, y, z] between them");
  table.finish();
  if (keys.texture) table.fail("texture", "is not for bodies that move", "expected a mesh alone");
  if (!body.mass && !body.density && moves_freely(body.kind))
    table.fail_here("no mass", "expected mass or density");
  body.object = detail::resolve_object(table, keys, folder);
  if (!body.object.model) scene.files[*keys.mesh] = body.object.mesh;
  const std::size_t count = bodies.size() + static_cast<std::size_t>(copies);
  if (count > kMostBodies)
    table.fail_here(std::to_string(count) + " bodies",
                    "expected at most " + std::to_string(kMostBodies));
  const std::string name = body.object.name;
  for (int i = 0; i < copies; ++i) {
    if (copies > 1) body.object.name = name + " " + std::to_string(i + 1);
    check_name(table, body.object.name);
    bodies.push_back(body);
    body.object.world_from_mesh.position += spacing;
  }
}

WorldSceneDevice read_device(TomlTable& table, const SafetyLimits& safety) {
  WorldSceneDevice device;
  device.limits = safety;
  device.uri = table.text("uri").value_or(device.uri);
  device.holds = table.text("holds").value_or("");
  device.at = table.vector("at");
  device.approach = table.vector("approach").value_or(device.approach);
  device.clearance = table.number("clearance", Range::positive).value_or(device.clearance);
  const std::optional<double> motion_scale = table.number("motion_scale", Range::positive);
  const std::optional<double> force_scale = table.number("force_scale", Range::positive);
  device.workspace = stiffness_keeping_workspace(table.pose(), motion_scale.value_or(1.0));
  if (force_scale) device.workspace.force_scale = *force_scale;
  SafetyLimits& limits = device.limits;
  limits.max_force = table.number("max_force", Range::positive).value_or(limits.max_force);
  limits.max_torque = table.number("max_torque", Range::positive).value_or(limits.max_torque);
  limits.max_speed = table.number("max_speed", Range::positive).value_or(limits.max_speed);
  if (!(device.approach.squaredNorm() > 0.0))
    table.fail("approach", "has no direction", "expected [x, y, z] of any length above 0");
  table.finish();
  return device;
}

/// [device], or [[device]] with what each holds.
void read_devices(TomlTable& top, bool has_many, WorldSceneDescription& scene) {
  if (!has_many) {
    if (auto table = top.table("device"))
      scene.devices.push_back(read_device(*table, scene.safety));
    return;
  }
  std::vector<TomlTable> tables = top.tables("device");
  for (TomlTable& table : tables) {
    if (!table.has("holds")) table.fail_here("no holds", "expected the name of a held body");
    scene.devices.push_back(read_device(table, scene.safety));
    if (scene.devices.size() > kMostDevices)
      table.fail_here("more than " + std::to_string(kMostDevices) + " devices", "expected fewer");
  }
}

void read_tables(TomlTable& top, const std::string& folder, bool has_many_devices,
                 WorldSceneDescription& scene) {
  std::vector<TomlTable> statics = top.tables("static"), moving = top.tables("body"),
                         joints = top.tables("joint");
  std::optional<TomlTable> object = top.table("object");
  if (auto table = top.table("coupling")) detail::read_coupling(*table, scene.coupling);
  if (auto table = top.table("safety")) {
    detail::read_safety_limits(*table, scene.safety);
    table->finish();
  }
  read_devices(top, has_many_devices, scene);
  if (auto table = top.table("contact")) {
    scene.threshold = table->number("threshold", Range::positive).value_or(scene.threshold);
    table->finish();
  }
  if (auto table = top.table("solver")) {
    const std::optional<double> rate = table->number("rate", Range::positive);
    if (rate && !(*rate >= 50.0 && *rate <= 20000.0))
      table->fail("rate", "is out of range", "expected 50 to 20000 Hz");
    scene.rate = rate.value_or(scene.rate);
    scene.sleeps = table->truth("sleeps").value_or(scene.sleeps);
    table->finish();
  }
  top.finish();
  if (moving.empty()) top.fail_here("no [[body]]", "expected at least one body that moves");
  if (object) read_body(*object, BodyKind::held, folder, scene);
  for (TomlTable& table : statics) read_body(table, BodyKind::fixed, folder, scene);
  for (TomlTable& table : moving) read_body(table, std::nullopt, folder, scene);
  for (TomlTable& table : joints) {
    const std::size_t before = scene.joints.size();
    detail::read_joint(table, scene.joints);
    for (std::size_t i = before; i < scene.joints.size(); ++i)
      check_name(table, scene.joints[i].name);
    if (scene.joints.size() > kMostJoints)
      table.fail_here("more than " + std::to_string(kMostJoints) + " joints", "expected fewer");
  }
}

/// Surface and measure of a mesh, for a density of 1.
struct Surface {
  std::shared_ptr<const ClodHierarchy> hierarchy;
  std::shared_ptr<const TriangleMesh> mesh;
  MassProperties measure;
};

WorldBody world_body(const WorldSceneBody& given, const Surface& surface, const std::string& file) {
  const MassProperties& m = surface.measure;
  WorldBody body;
  body.name = given.object.name;
  body.kind = given.kind;
  body.shape.hierarchy = surface.hierarchy.get();
  body.shape.body_from_mesh.position = -m.center_of_mass;
  const bool has_mass = moves_freely(given.kind);
  if (has_mass && !(m.volume > 0.0))
    throw InputError(file + ": body '" + body.name +
                     "' encloses no volume, expected a closed surface");
  body.mass = given.mass.value_or(given.density.value_or(0.0) * m.volume);
  if (has_mass) body.inertia = m.inertia * (body.mass / m.volume);
  if (given.object.material) {
    body.friction = given.object.material->friction;
    body.restitution = given.object.material->restitution;
  }
  body.start.orientation = given.object.world_from_mesh.orientation;
  body.start.position = transform_point(given.object.world_from_mesh, m.center_of_mass);
  if (given.kind != BodyKind::moving) return body;
  const Mat3 R = rotation_matrix(body.start.orientation);
  body.start.linear_momentum = body.mass * given.velocity;
  body.start.angular_momentum = R * (body.inertia * (R.transpose() * given.spin));
  return body;
}

}  // namespace

bool is_world_scene(const std::string& path) {
  try {
    const std::string text =
        fs::is_regular_file(path) ? read_scene_text(path) : std::string(builtin_scene(path));
    return parse_toml(text, path).contains("body");
  } catch (const std::exception&) {
    return false;  // whoever reads it says what is wrong
  }
}

WorldSceneDescription parse_world_scene(std::string_view text, const std::string& file,
                                        const std::string& folder) {
  toml::table root = parse_toml(text, file);
  TomlTable top(root, file, "");
  WorldSceneDescription scene;
  scene.file = file;
  scene.text = text;
  scene.title = top.text("title").value_or(fs::path(file).stem().string());
  scene.gravity = top.vector("gravity").value_or(scene.gravity);
  read_tables(top, folder, root["device"].is_array_of_tables(), scene);
  return scene;
}

WorldSceneDescription read_world_scene(const std::string& path) {
  if (!fs::is_regular_file(path)) return parse_world_scene(builtin_scene(path), path, "");
  return parse_world_scene(read_scene_text(path), path, fs::path(path).parent_path().string());
}

namespace {

/// Number of the body that a device holds.
std::int32_t held_by(const WorldSceneDescription& scene, const WorldSceneDevice& device) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const WorldSceneBody& body = scene.bodies[i];
    if (body.kind != BodyKind::held) continue;
    if (device.holds.empty() || body.object.name == device.holds)
      return static_cast<std::int32_t>(i);
    names.push_back(body.object.name);
  }
  const std::string nearest = models::nearest_word(device.holds, names);
  throw InputError(scene.file + ": device '" + device.uri + "': holds '" + device.holds +
                   "', expected " +
                   (nearest.empty() ? "a body of kind held" : "'" + nearest + "'?"));
}

Coupling coupling_of(const LoadedWorld& loaded, std::int32_t body) {
  return make_coupling(loaded.description.coupling,
                       default_gains(loaded.hierarchies[idx(body)]->radius),
                       loaded.config.world.rigid[idx(body)]);
}

/// A hand for each device; every held body needs one.
void add_hands(LoadedWorld& loaded) {
  WorldSceneDescription& scene = loaded.description;
  WorldSessionConfig& config = loaded.config;
  const auto is_held = [](const WorldSceneBody& body) { return body.kind == BodyKind::held; };
  const auto held = std::count_if(scene.bodies.begin(), scene.bodies.end(), is_held);
  if (held == 0 && std::all_of(scene.devices.begin(), scene.devices.end(),
                               [](const WorldSceneDevice& d) { return d.holds.empty(); }))
    scene.devices.clear();
  if (held > 0 && scene.devices.empty()) {
    scene.devices.emplace_back();
    scene.devices.back().limits = scene.safety;
  }
  for (const WorldSceneDevice& device : scene.devices) {
    WorldHand hand;
    hand.body = held_by(scene, device);
    hand.coupling = coupling_of(loaded, hand.body);
    hand.at = device.at;
    hand.workspace = device.workspace;
    hand.limits = device.limits;
    config.hands.push_back(hand);
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto holds = [&](const WorldHand& hand) { return idx(hand.body) == i; };
    if (is_held(scene.bodies[i]) && std::none_of(config.hands.begin(), config.hands.end(), holds))
      throw InputError(scene.file + ": body '" + scene.bodies[i].object.name +
                       "': held by no device, expected a [[device]] that holds it");
  }
}

}  // namespace

namespace {

/// A surface, with levels of detail where the scene asks for them; these are kept.
Surface load(const SceneObject& object, bool has_levels, const Log& log) {
  ClodSource source;
  source.name = object.mesh;
  source.role = "mesh";
  source.scale = object.unit_scale;
  Surface surface;
  if (!has_levels) {
    surface.mesh = std::make_shared<const TriangleMesh>(load_surface(source, log));
    surface.hierarchy = std::make_shared<const ClodHierarchy>(build_exact_hierarchy(*surface.mesh));
    surface.measure = mass_properties(*surface.mesh);
    return surface;
  }
  const auto asset = std::make_shared<const ClodAsset>(load_clod_cached(source, {}, log));
  if (asset->meshes.empty())
    throw InputError(object.mesh + ": holds no surface to show, expected a mesh");
  surface.mesh = {asset, &asset->meshes[0]};
  surface.hierarchy = {asset, &asset->hierarchy};
  surface.measure = asset->mass.measure;
  return surface;
}

}  // namespace

LoadedWorld load_world(WorldSceneDescription description, const Log& log) {
  LoadedWorld loaded;
  loaded.description = std::move(description);
  const WorldSceneDescription& scene = loaded.description;
  std::map<std::pair<std::string, double>, Surface> known;
  std::vector<WorldBody> bodies;
  for (const WorldSceneBody& body : scene.bodies) {
    Surface& surface = known[{body.object.mesh, body.object.unit_scale}];
    if (!surface.hierarchy) surface = load(body.object, scene.threshold > 0.0, log);
    loaded.meshes.push_back(surface.mesh);
    loaded.hierarchies.push_back(surface.hierarchy);
    bodies.push_back(world_body(body, surface, scene.file));
  }
  WorldSessionConfig& config = loaded.config;
  try {
    std::vector<WorldJoint> joints = detail::world_joints(scene.joints, bodies);
    config.world = make_world(std::move(bodies), scene.gravity, std::move(joints));
    config.world.sleeps = scene.sleeps;
    config.world.threshold = scene.threshold;
    config.start = start_state(config.world);
    const WorldScratchPtr scratch = reserve_world(config.world, 1);
    require_apart(config.world, config.start, *scratch);
  } catch (const InputError& error) {
    throw InputError(scene.file + ": " + error.what());
  }
  config.rate = scene.rate;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const WorldSceneBody& body = scene.bodies[i];
    const auto number = static_cast<std::int32_t>(i);
    if (body.kind == BodyKind::prescribed)
      config.drives.push_back({number, {body.velocity, body.spin}});
  }
  add_hands(loaded);
  return loaded;
}

WorldHand free_hand(const LoadedWorld& world) {
  WorldHand hand;
  hand.is_free = true;
  hand.limits = world.description.safety;
  const std::vector<WorldBody>& bodies = world.config.world.bodies;
  hand.couplings.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (!moves_freely(bodies[i].kind)) continue;
    const auto body = static_cast<std::int32_t>(i);
    try {
      hand.couplings[i] = coupling_of(world, body);
    } catch (const InputError&) {  // gains of the scene that are for its own hand alone
      hand.couplings[i] = make_coupling({}, default_gains(world.hierarchies[i]->radius),
                                        world.config.world.rigid[i]);
    }
  }
  return hand;
}

namespace {

bool is_simulated(const std::string& uri) {
  const std::string scheme = device_scheme(uri);
  return scheme == "hand" || scheme == "null" || scheme == "script" || scheme == "replay";
}

/// Decided by the address, before anything is opened: a recording may bring one from anywhere.
void refuse_people(const std::string& uri) {
  const bool has_second =
      uri.find("camera=") != std::string::npos || uri.find("rotation=") != std::string::npos;
  if (is_simulated(uri) && !has_second) return;
  throw DeviceUnavailable(device_scheme(uri) + ": " + kNoPersonInLockstep);
}

const std::string& uri_of(const LoadedWorld& world, const std::vector<std::string>& uris,
                          std::size_t i) {
  const bool is_asked = i < uris.size() && !uris[i].empty();
  return is_asked ? uris[i] : world.description.devices[i].uri;
}

}  // namespace

void use_clutches(const std::vector<std::string>& uris, LoadedWorld& world) {
  for (std::size_t i = 0; i < world.config.hands.size(); ++i) {
    WorldHand& hand = world.config.hands[i];
    if (!hand.is_free) hand.has_clutch = !is_simulated(uri_of(world, uris, i));
  }
}

WorldDevices open_world_devices(const LoadedWorld& world, const std::vector<std::string>& uris,
                                std::uint64_t seed, bool has_watchdog) {
  WorldDevices devices;
  for (std::size_t i = 0; i < world.config.hands.size(); ++i) {
    if (world.config.hands[i].is_free) {  // who brings it has its device as well
      devices.list.push_back(nullptr);
      continue;
    }
    const std::string& uri = uri_of(world, uris, i);
    if (!has_watchdog) refuse_people(uri);
    const double radius = world.hierarchies[idx(world.config.hands[i].body)]->radius;
    const WorldSceneDevice& given = world.description.devices[i];
    devices.owned.push_back(open_device(
        uri, device_context(given.workspace, given.approach, given.clearance, radius, seed + i)));
    devices.list.push_back(devices.owned.back().get());
  }
  return devices;
}

}  // namespace thigma
