#include "thigma/scene/world_change.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>

#include "thigma/core/error.h"
#include "thigma/core/index.h"

namespace thigma {
namespace {

/// NAME without the number of a copy, then the first number that is free.
std::string next_name(const std::string& like, const std::vector<WorldBody>& bodies) {
  const std::size_t end = like.find_last_not_of("0123456789");
  const bool is_copy = end != std::string::npos && end + 1 < like.size() && like[end] == ' ';
  const std::string stem = is_copy ? like.substr(0, end) : like;
  for (std::size_t number = 2;; ++number) {
    std::string name = stem + " " + std::to_string(number);
    const auto has_it = [&](const WorldBody& body) { return body.name == name; };
    if (std::none_of(bodies.begin(), bodies.end(), has_it)) return name;
  }
}

/// Above all that is there, the place of its start otherwise.
Vec3 free_place(const LoadedWorld& world, std::int32_t like, const WorldState& state) {
  const World& w = world.config.world;
  const auto reach = [&](std::size_t i) { return w.boxes[idx(w.shape[i])].reach; };
  Vec3 center = w.bodies[idx(like)].start.position;
  double top = center.z();
  for (std::size_t i = 0; i < w.bodies.size(); ++i)
    if (moves_freely(w.bodies[i].kind))
      top = std::max(top, state.bodies[i].position.z() + reach(i));
  constexpr double kSpare = 0.1;  // of its reach
  center.z() = top + (1.0 + kSpare) * reach(idx(like));
  return center;
}

/// Far beyond all that is there, positions have no digits left for contacts.
void require_near(const LoadedWorld& world, const std::string& name, const Vec3& center,
                  const WorldState& state) {
  const World& w = world.config.world;
  const Vec3& middle = w.bodies[0].start.position;
  double extent = 0.0;
  for (std::size_t i = 0; i < w.bodies.size(); ++i)
    extent = std::max(extent,
                      (state.bodies[i].position - middle).norm() + w.boxes[idx(w.shape[i])].reach);
  constexpr double kMostExtents = 1e4;
  if ((center - middle).norm() <= kMostExtents * extent) return;
  char text[160];
  std::snprintf(text, sizeof text,
                "': position [%g, %g, %g] m, expected one within %.4g m of what is there",
                center.x(), center.y(), center.z(), kMostExtents * extent);
  throw InputError("body '" + name + text);
}

/// What is numbered by body follows `was`; the world is made anew of the bodies.
void finish(const LoadedWorld& before, std::vector<WorldBody> bodies, WorldChange& change) {
  std::vector<std::int32_t> now(before.config.world.bodies.size(), -1);
  for (std::size_t i = 0; i < change.was.size(); ++i)
    if (change.was[i] >= 0) now[idx(change.was[i])] = static_cast<std::int32_t>(i);
  const auto renumber = [&](std::int32_t& body) {
    if (body >= 0) body = now[idx(body)];
  };
  std::vector<WorldJoint> joints = before.config.world.joints;
  for (WorldJoint& joint : joints) {
    renumber(joint.a);
    renumber(joint.b);
  }
  WorldSessionConfig& config = change.world.config;
  const bool sleeps = before.config.world.sleeps;
  const double threshold = before.config.world.threshold;
  config = {};
  config.world = make_world(std::move(bodies), before.config.world.gravity, std::move(joints));
  config.world.sleeps = sleeps;
  config.world.threshold = threshold;
  config.start = start_state(config.world);
  config.rate = before.config.rate;
  config.duration = before.config.duration;
  config.drives = before.config.drives;
  for (BodyDrive& drive : config.drives) renumber(drive.body);
  config.hands = before.config.hands;
  for (WorldHand& hand : config.hands) {
    renumber(hand.body);
    if (hand.is_free) hand.couplings = free_hand(change.world).couplings;
  }
}

template <class T>
void keep(const std::vector<std::int32_t>& was, std::vector<T>& list) {
  std::vector<T> kept;
  for (const std::int32_t body : was)
    if (body >= 0) kept.push_back(list[idx(body)]);
  list = std::move(kept);
}

}  // namespace

WorldChange with_another(const LoadedWorld& world, std::int32_t like,
                         const std::optional<Vec3>& center, const WorldState& state) {
  const std::vector<WorldBody>& known = world.config.world.bodies;
  const WorldBody& model = known[idx(like)];
  if (!moves_freely(model.kind))
    throw InputError("body '" + model.name + "': stands still or goes its own way, expected one " +
                     "that moves");
  if (known.size() >= kMostBodies)
    throw InputError("body '" + model.name + "': another, expected at most " +
                     std::to_string(kMostBodies) + " bodies");
  WorldChange change;
  change.world.description = world.description;
  change.world.hierarchies = world.hierarchies;
  change.world.meshes = world.meshes;
  for (std::size_t i = 0; i < known.size(); ++i) change.was.push_back(static_cast<std::int32_t>(i));
  change.was.push_back(-1);

  std::vector<WorldBody> bodies = known;
  WorldBody body = model;
  body.name = next_name(model.name, known);
  body.kind = BodyKind::moving;
  if (center) require_near(world, body.name, *center, state);
  body.start.position = center.value_or(free_place(world, like, state));
  body.start.linear_momentum = body.start.angular_momentum = Vec3::Zero();
  WorldSceneBody given = world.description.bodies[idx(like)];
  given.object.name = body.name;
  given.kind = BodyKind::moving;
  given.velocity = given.spin = Vec3::Zero();
  given.object.world_from_mesh =
      Pose{body.start.position, body.start.orientation} * body.shape.body_from_mesh;
  bodies.push_back(std::move(body));
  change.world.description.bodies.push_back(std::move(given));
  change.world.hierarchies.push_back(world.hierarchies[idx(like)]);
  change.world.meshes.push_back(world.meshes[idx(like)]);
  finish(world, std::move(bodies), change);
  return change;
}

WorldChange without(const LoadedWorld& world, std::int32_t body) {
  const std::vector<WorldBody>& known = world.config.world.bodies;
  const std::string name = "body '" + known[idx(body)].name + "': ";
  if (!moves_freely(known[idx(body)].kind))
    throw InputError(name + "stands still or goes its own way, expected one that moves");
  for (const WorldJoint& joint : world.config.world.joints)
    if (joint.a == body || joint.b == body)
      throw InputError(name + "tied by joint '" + joint.name + "', expected a free one");
  for (const WorldHand& hand : world.config.hands)
    if (!hand.is_free && hand.body == body)
      throw InputError(name + "held by a device of the scene, expected a free one");
  const auto moves = [](const WorldBody& one) { return moves_freely(one.kind); };
  if (std::count_if(known.begin(), known.end(), moves) == 1)
    throw InputError(name + "the last that moves, expected another one beside it");
  WorldChange change;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (i != idx(body)) change.was.push_back(static_cast<std::int32_t>(i));
  change.world.description = world.description;
  change.world.hierarchies = world.hierarchies;
  change.world.meshes = world.meshes;
  std::vector<WorldBody> bodies = known;
  keep(change.was, bodies);
  keep(change.was, change.world.description.bodies);
  keep(change.was, change.world.hierarchies);
  keep(change.was, change.world.meshes);
  finish(world, std::move(bodies), change);
  return change;
}

WorldState carried_state(const WorldChange& change, const WorldState& before) {
  const World& world = change.world.config.world;
  WorldState state = change.world.config.start;
  state.time = before.time;
  for (std::size_t i = 0; i < change.was.size(); ++i)
    if (change.was[i] >= 0) state.bodies[i] = before.bodies[idx(change.was[i])];
  const WorldScratchPtr scratch = reserve_world(world, 1);
  require_apart(world, state, *scratch);
  return state;
}

}  // namespace thigma
