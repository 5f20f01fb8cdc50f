#include "thigma/scene/simulated_body.h"

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/scene/detail/toml_table.h"
#include "thigma/session/session.h"
#include "thigma/simulation/simulate.h"

namespace thigma {

std::optional<SimulatedBody> parse_simulated_body(std::string_view text, const std::string& file) {
  const toml::table root = parse_toml(text, file);
  TomlTable top(root, file, "");
  std::optional<TomlTable> keys = top.table("simulation");
  if (!keys) return std::nullopt;
  SimulatedBody body;
  body.law.restitution =
      keys->number("restitution", Range::not_negative).value_or(body.law.restitution);
  if (!(body.law.restitution <= 1.0))
    keys->fail("restitution", "is out of range", "expected 0 to 1");
  body.law.friction = keys->number("friction", Range::not_negative).value_or(body.law.friction);
  body.law.rolling = keys->number("rolling", Range::not_negative).value_or(body.law.rolling);
  body.velocity = keys->vector("velocity").value_or(body.velocity);
  body.spin = keys->vector("spin").value_or(body.spin);
  body.scatter = keys->number("scatter", Range::not_negative).value_or(body.scatter);
  keys->finish();
  if (std::optional<TomlTable> contact = top.table("contact"))
    body.has_tolerance = contact->has("tolerance");
  return body;
}

SimulationWorld simulation_world(const SimulatedBody& body, const SessionConfig& config) {
  SimulationWorld world;
  world.body = config.haptic.body;
  world.object = config.contact.object;
  world.body_from_mesh = config.contact.body_from_mesh;
  world.scene = config.contact.scene;
  world.law = body.law;
  world.tolerance = config.contact.tolerance;
  world.resolution = config.contact.resolution;
  return world;
}

SimulationState simulation_start(const SimulatedBody& body, const SessionConfig& config,
                                 std::uint64_t seed) {
  Random random(seed);
  SimulationState start;
  const Vec3 shift = random.in_cube(body.scatter);
  const Vec3 turn = random.in_cube(body.scatter / config.contact.object->radius);
  start.body.position = config.world_from_body.position + shift;
  start.body.orientation =
      (rotation_from_vector(turn) * config.world_from_body.orientation).normalized();
  const Mat3 R = rotation_matrix(start.body.orientation);
  start.body.linear_momentum = config.haptic.body.mass * body.velocity;
  start.body.angular_momentum = R * (config.haptic.body.inertia * (R.transpose() * body.spin));
  return start;
}

}  // namespace thigma
