#include "thigma/scene/scene_description.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "thigma/clod/hierarchy.h"
#include "thigma/core/error.h"
#include "thigma/import/load_mesh.h"
#include "thigma/models/make_model.h"
#include "thigma/models/textured_model.h"
#include "thigma/scene/gain_task.h"
#include "thigma/texture/texture_file.h"

namespace thigma {
namespace {

constexpr double kSmallestHeld = 0.025;  // radius below which motion is scaled down [m]
constexpr double kLargestHeld = 0.10;    // and above which it is scaled up [m]
constexpr double kHeldPress = 1.25;      // presses below leave the surfaces apart [N; device]

/// Unit-density mass properties of a solid to hold, or of its enclosing ball's share where there is
/// no volume.
struct Solid {
  double volume = 0.0;
  Vec3 center_of_mass = Vec3::Zero();
  Mat3 inertia = Mat3::Identity();
  bool is_closed = true;
};

/// An open surface has no volume: it is held as a ball of its radius would be.
Solid solid_of(const ObjectMeasure& object) {
  const double r = object.ball.radius;
  const double ball_volume = 4.0 / 3.0 * 3.14159265358979323846 * r * r * r;
  if (object.measure.volume > 1e-9 * ball_volume) {
    return {object.measure.volume, object.measure.center_of_mass, object.measure.inertia, true};
  }
  return {ball_volume, object.ball.center, Mat3::Identity() * (0.4 * ball_volume * r * r), false};
}

double object_mass(const SceneDescription& scene, const Solid& solid) {
  if (!scene.density) return scene.mass.value_or(kDefaultMass);
  if (!solid.is_closed) {
    throw InputError(scene.file + ": density for " + scene.object.name +
                     ", whose surface encloses no volume, expected mass");
  }
  return *scene.density * solid.volume;
}

bool is_texture_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  char first[8] = {};
  file.read(first, sizeof first);
  return file.gcount() == sizeof first && is_texture(std::string_view(first, sizeof first));
}

SceneObject object_from(const std::string& mesh, double scale, const char* option) {
  SceneObject object;
  object.mesh = mesh;
  object.unit_scale = scale;
  if (models::is_model_uri(mesh)) {
    object.model = models::parse_model_uri(mesh, option);
    object.name = object.model->name;
    return object;
  }
  std::error_code error;
  if (!std::filesystem::exists(mesh, error)) {
    throw InputError(mesh + ": no such file, " + option + " expected a mesh or procedural:NAME");
  }
  object.name = std::filesystem::path(mesh).stem().string();
  object.is_textured = is_texture_file(mesh);
  return object;
}

double combined(double a, double b, CombineRule rule) {
  switch (rule) {
    case CombineRule::geometric:
      return std::sqrt(a) * std::sqrt(b);  // a b may be out of range
    case CombineRule::average:
      return 0.5 * a + 0.5 * b;
    case CombineRule::minimum:
      return std::min(a, b);
    case CombineRule::maximum:
      break;
  }
  return std::max(a, b);
}

/// Rows ask contacts which patches are near, no more: they say the same where contacts are carried.
double carried_share(const ContactGains& contact) {
  constexpr double kForRows = 0.1;
  const double asked = contact.resolution.carry;
  const bool has_rows = contact.response == ResponseKind::constrained;
  return contact.carry.value_or(has_rows && asked == 0.0 ? kForRows : asked);
}

}  // namespace

Friction combined(const Friction& a, const Friction& b, CombineRule rule) {
  if (a == b) return a;  // to the last bit
  Friction both{};
  for (const FrictionNumber& f : kFrictionNumbers)
    both.*f.number = combined(a.*f.number, b.*f.number, rule);
  return both;
}

std::vector<Friction> pair_friction(const SceneDescription& scene) {
  const ContactGains& contact = scene.contact;
  const auto of = [&](const SceneObject& object) {
    const Friction f = object.material ? object.material->friction : contact.friction;
    if (!is_valid(f)) {
      throw InputError(scene.file + ": friction " + std::to_string(f.kinetic) + ", at rest " +
                       std::to_string(f.at_rest) + " of " + object.name +
                       ", expected numbers of 0 or more, at rest no less");
    }
    return f;
  };
  std::vector<Friction> pairs;
  const Friction held = of(scene.object);
  for (const SceneObject& other : scene.statics)
    pairs.push_back(combined(held, of(other), contact.combine));
  return pairs;
}

std::vector<ImpactPair> pair_impacts(const SceneDescription& scene) {
  const auto of = [&](const SceneObject& object) {
    ImpactPair own{0.0, scene.taps.usual};
    if (object.material) {
      const Material& m = *object.material;
      own.restitution = m.restitution;
      own.tap = {m.tap_amplitude.value_or(own.tap.amplitude),
                 m.tap_frequency.value_or(own.tap.frequency), m.tap_decay.value_or(own.tap.decay)};
    }
    if (!is_valid(own)) {
      throw InputError(scene.file + ": restitution or tap of " + object.name +
                       " out of range, expected 0 to 1, an amplitude of 0 or more, frequency and "
                       "decay above 0");
    }
    if (!scene.taps.is_on) own.tap = Tap{};
    return own;
  };
  const auto mean = [](double a, double b) {
    return a == b ? a : combined(a, b, CombineRule::geometric);
  };
  std::vector<ImpactPair> pairs;
  bool is_any = false;
  const ImpactPair held = of(scene.object);
  for (const SceneObject& object : scene.statics) {
    const ImpactPair other = of(object);
    const Tap &a = held.tap, &b = other.tap;
    pairs.push_back(
        {std::max(held.restitution, other.restitution),
         {mean(a.amplitude, b.amplitude), mean(a.frequency, b.frequency), mean(a.decay, b.decay)}});
    is_any = is_any || pairs.back().restitution > 0.0 || pairs.back().tap.amplitude > 0.0;
  }
  if (!is_any) pairs.clear();
  return pairs;
}

bool has_relief(const SceneDescription& scene) {
  const auto is_so = [](const SceneObject& o) { return o.has_relief(); };
  return is_so(scene.object) || std::any_of(scene.statics.begin(), scene.statics.end(), is_so);
}

ResponseKind default_response(const SceneDescription& scene, bool uses_relief) {
  const bool is_smooth = !uses_relief || !has_relief(scene);
  return is_smooth && !scene.simulation ? ResponseKind::constrained : ResponseKind::coupled;
}

HapticTexture load_texture(const SceneObject& object) {
  if (!object.textured_model) return read_texture(object.mesh, object.unit_scale).texture;
  return models::make_textured_model(*object.textured_model);
}

LoadedObject load_object(const SceneObject& object, bool repair) {
  LoadedObject loaded;
  if (object.is_textured) {
    loaded.mesh = load_texture(object).coarse;
  } else if (object.model) {
    loaded.mesh = models::make_model(*object.model);
    scale_mesh(loaded.mesh, object.unit_scale, object.mesh);
  } else {
    loaded.mesh = load_usable_mesh(object.mesh, object.unit_scale, repair);
  }
  loaded.measure = mass_properties(loaded.mesh);
  loaded.ball = enclosing_ball(loaded.mesh.positions);
  return loaded;
}

DefaultGains default_gains(double radius) {
  DefaultGains gains;
  gains.motion_scale = radius > kLargestHeld    ? radius / kLargestHeld
                       : radius < kSmallestHeld ? radius / kSmallestHeld
                                                : 1.0;
  const double s = gains.motion_scale;
  gains.tolerance = 0.01 * radius;
  gains.contact_area = 0.0625 * radius * radius;
  gains.contact_stiffness = std::clamp(kHeldPress * s / gains.tolerance, 2000.0, 5000.0);
  gains.angular_stiffness = std::min(0.3 * gains.linear_stiffness * radius * radius, 0.6 * s * s);
  gains.max_force *= s;
  gains.max_torque *= s * s;
  return gains;
}

Coupling make_coupling(const CouplingGains& given, const DefaultGains& gains,
                       const RigidBody& body) {
  Coupling coupling;
  coupling.linear_stiffness = given.linear_stiffness.value_or(gains.linear_stiffness);
  coupling.angular_stiffness = given.angular_stiffness.value_or(gains.angular_stiffness);
  const double ratio = given.damping_ratio.value_or(gains.damping_ratio);
  const double inertia = body.inertia.trace() / 3.0;
  coupling.linear_damping =
      given.linear_damping.value_or(2.0 * ratio * std::sqrt(coupling.linear_stiffness * body.mass));
  coupling.angular_damping =
      given.angular_damping.value_or(2.0 * ratio * std::sqrt(coupling.angular_stiffness * inertia));
  if (given.is_saturated) {
    // Linear up to half of the greatest force, then levelling off (Fig. 5.4).
    const auto level_off = [](double stiffness, double greatest) {
      return make_saturation(stiffness, 0.5 * greatest / stiffness, greatest);
    };
    coupling.linear_saturation =
        level_off(coupling.linear_stiffness, given.max_force.value_or(gains.max_force));
    coupling.angular_saturation =
        level_off(coupling.angular_stiffness, given.max_torque.value_or(gains.max_torque));
  }
  return coupling;
}

std::optional<ResponseKind> response_of(const std::string& name) {
  for (const ResponseName& known : kResponseNames)
    if (name == known.name) return known.kind;
  return std::nullopt;
}

SessionConfig make_session_config(const SceneDescription& given, const ObjectMeasure& object) {
  const Solid solid = solid_of(object);
  const DefaultGains gains = default_gains(object.ball.radius);
  const double mass = object_mass(given, solid);
  SessionConfig config;
  config.haptic.body = make_body(mass, solid.inertia * (mass / solid.volume), given.gravity);
  const double motion_scale = given.device.motion_scale.value_or(gains.motion_scale);
  config.haptic.workspace = {given.device.world_from_device, motion_scale,
                             given.device.force_scale.value_or(1.0 / motion_scale)};
  SceneDescription scene = given;
  if (scene.has_auto_gains) {
    fill_gains(propose_gains(gain_task(describe_device(scene.device.uri), config.haptic.body,
                                       config.haptic.workspace, scene.rate,
                                       scene.contact.response.value_or(ResponseKind::coupled))),
               scene);
  }
  config.haptic.coupling = make_coupling(scene.coupling, gains, config.haptic.body);
  config.haptic.coupling.is_grasped = false;
  config.haptic.safety = scene.safety;
  config.haptic.response = scene.contact.response.value_or(ResponseKind::coupled);
  config.haptic.grasp_place = scene.device.grasp_place;
  config.haptic.grasp_point =
      scene.grasp_point.value_or(solid.center_of_mass) - solid.center_of_mass;
  config.haptic.turn_rate = scene.device.turn_rate;
  config.haptic.impacts = pair_impacts(scene);

  config.contact.body_from_mesh.position = -solid.center_of_mass;
  config.contact.tolerance = scene.contact.tolerance.value_or(gains.tolerance);
  config.contact.max_clusters = scene.contact.max_clusters;
  config.contact.response.stiffness = scene.contact.stiffness.value_or(gains.contact_stiffness);
  config.contact.response.tolerance = config.contact.tolerance;
  config.contact.potential_law.exponent =
      scene.contact.exponent.value_or(config.contact.potential_law.exponent);
  config.contact.potential_law.area = scene.contact.area.value_or(gains.contact_area);
  config.contact.response.is_divided_among_clusters = scene.contact.is_divided_among_clusters;
  config.contact.distributes_wide_contacts = scene.contact.distributes_wide_contacts;
  config.contact.resolution = scene.contact.resolution;
  config.contact.resolution.carry = carried_share(scene.contact);
  config.contact.friction = pair_friction(scene);
  config.contact.textures.params = scene.contact.texture;
  const double ratio = scene.contact.damping_ratio.value_or(gains.contact_damping_ratio);
  config.contact.response.damping = scene.contact.damping.value_or(
      2.0 * ratio * std::sqrt(config.contact.response.stiffness * mass));

  config.world_from_body = scene.object.world_from_mesh * inverse(config.contact.body_from_mesh);
  config.rate = scene.rate;
  config.contact_every = scene.contact_every;
  config.contact_latency = scene.contact_latency;
  return config;
}

SessionConfig make_session_config(const SceneDescription& scene, const ObjectMeasure& object,
                                  const ClodHierarchy& hierarchy, std::vector<SceneBody> statics) {
  SessionConfig config = make_session_config(scene, object);
  config.contact.object = &hierarchy;
  config.contact.scene = std::move(statics);
  return config;
}

SceneDescription scene_from_pair(const std::string& object, const std::string& against,
                                 double scale, const Pose& pose) {
  if (!(scale > 0.0) || !std::isfinite(scale)) {
    throw InputError("--scale: " + std::to_string(scale) + ", expected a number above 0");
  }
  SceneDescription scene;
  scene.object = object_from(object, scale, "--object");
  scene.object.world_from_mesh = pose;
  scene.statics.push_back(object_from(against, scale, "--against"));
  scene.title = scene.object.name + " against " + scene.statics[0].name;
  scene.file = scene.title;
  return scene;
}

}  // namespace thigma
