#include "world_view.h"

#include <map>

#include "version.h"

#include "thigma/core/index.h"

namespace thigma::app {
namespace {

/// The one that stands for the object: in the hand, else the first that moves.
std::size_t object_of(const LoadedWorld& world) {
  for (const WorldHand& hand : world.config.hands)
    if (hand.body >= 0) return idx(hand.body);
  const std::vector<WorldBody>& bodies = world.config.world.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (moves_freely(bodies[i].kind)) return i;
  return 0;
}

}  // namespace

live::SceneView view_of(const LoadedWorld& world, std::int32_t page_hand) {
  const World& w = world.config.world;
  live::SceneView view;
  view.title = world.description.title;
  view.name = world.description.file;
  view.program = std::string("thigma ") + kVersion;
  view.world.page_hand = page_hand;
  view.world.rate = world.config.rate;
  for (const WorldHand& hand : world.config.hands) view.world.workspaces.push_back(hand.workspace);
  std::map<const TriangleMesh*, std::int32_t> numbers;
  const std::size_t object = object_of(world);
  for (std::size_t i = 0; i < w.bodies.size(); ++i) {
    const WorldSceneBody& given = world.description.bodies[i];
    const TriangleMesh* mesh = world.meshes[i].get();
    live::SceneBodyView body;
    body.name = w.bodies[i].name;
    body.meshes = {mesh, 1};
    body.hierarchy = world.hierarchies[i].get();
    body.world_from_mesh = given.object.world_from_mesh;
    body.unit_scale = given.object.unit_scale;
    body.friction = w.bodies[i].friction.kinetic;
    if (moves_freely(w.bodies[i].kind)) body.mass = w.bodies[i].mass;
    body.body = static_cast<std::int32_t>(i);
    body.mesh = numbers.emplace(mesh, static_cast<std::int32_t>(numbers.size())).first->second;
    body.moves = moves_freely(w.bodies[i].kind);
    view.world.body_from_mesh.push_back(w.bodies[i].shape.body_from_mesh);
    if (i == object)
      view.object = std::move(body);
    else
      view.statics.push_back(std::move(body));
  }
  return view;
}

SessionConfig page_config(const LoadedWorld& world, const DeviceLimits& page) {
  SessionConfig config;
  const std::size_t object = object_of(world);
  config.haptic.device = page;
  config.haptic.body = world.config.world.rigid[object];
  config.haptic.response = ResponseKind::constrained;
  config.contact.body_from_mesh = world.config.world.bodies[object].shape.body_from_mesh;
  config.contact.tolerance = 0.01 * world.hierarchies[object]->radius;  // scale of a plot
  config.world_from_body = {world.config.start.bodies[object].position,
                            world.config.start.bodies[object].orientation};
  config.rate = world.config.rate;
  return config;
}

}  // namespace thigma::app
