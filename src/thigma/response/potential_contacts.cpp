#include "thigma/response/potential_contacts.h"

#include <algorithm>
#include <map>

#include "thigma/math/rotation.h"

namespace thigma {

namespace {

SolidSurface surface_of(const ClodHierarchy& hierarchy, const TexturedBody* textured) {
  return textured != nullptr && textured->has_relief ? make_solid_surface(*textured->textures[0])
                                                     : make_solid_surface(hierarchy);
}

}  // namespace

PotentialWorld make_potential_world(const ClodHierarchy& object, const Pose& body_from_mesh,
                                    std::span<const SceneBody> bodies,
                                    const TexturedWorld& textures) {
  const bool has_textures = !textures.is_empty();
  PotentialWorld world;
  world.object = surface_of(object, has_textures ? &textures.object : nullptr);
  world.body_from_mesh = body_from_mesh;
  std::map<const ClodHierarchy*, std::shared_ptr<const SolidSurface>> known;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const TexturedBody* textured = has_textures ? &textures.scene[i] : nullptr;
    std::shared_ptr<const SolidSurface> surface;
    if (!textured || !textured->has_relief) surface = known[bodies[i].hierarchy];
    if (!surface)
      surface = std::make_shared<const SolidSurface>(surface_of(*bodies[i].hierarchy, textured));
    if (!textured || !textured->has_relief) known[bodies[i].hierarchy] = surface;
    world.bodies.push_back(bodies[i]);
    world.scene.push_back(surface);
  }
  for (const Vec3& p : world.object.mesh.positions)
    world.reach = std::max(world.reach, transform_point(body_from_mesh, p).norm());
  return world;
}

void reserve_potential(const PotentialWorld& world, PotentialScratch& scratch) {
  reserve_overlap(world.object, scratch.object);
  scratch.scene.resize(world.scene.size());
  for (std::size_t i = 0; i < world.scene.size(); ++i)
    reserve_overlap(*world.scene[i], scratch.scene[i]);
}

namespace {

void count(const OverlapStats& stats, PotentialContact& contact) noexcept {
  contact.stats.points += stats.points;
  contact.stats.cells += stats.cells;
}

}  // namespace

PotentialContact measure_potential(const PotentialWorld& world, const BodyState& state,
                                   const PotentialLaw& law, double tolerance,
                                   PotentialScratch& scratch) noexcept {
  PotentialContact contact;
  const Pose object = Pose{state.position, state.orientation} * world.body_from_mesh;
  double most = 0.0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const SolidSurface& other = *world.scene[i];
    const Pose& body = world.bodies[i].world_from_body;
    const auto task = [&](bool is_object) {
      return OverlapTask{is_object ? world.object : other,
                         is_object ? other : world.object,
                         is_object ? object : body,
                         is_object ? body : object,
                         state.position,
                         is_object,
                         tolerance,
                         law.exponent,
                         0.5,
                         world.reach};
    };
    PotentialMoments here;
    count(add_overlap(task(true), scratch.object, here), contact);
    // Where nothing of the object is within reach, the scene may still stick into a face of it.
    count(add_overlap(task(false), scratch.scene[i], here), contact);
    const double pressing = here.sum.col(0).segment<3>(1).norm();
    if (pressing > most) {
      most = pressing;
      contact.body = static_cast<std::int32_t>(i);
    }
    add_moments(here, contact.moments);
  }
  return contact;
}

LinearContactModel potential_model(const PotentialContact& contact, const PenaltyParams& penalty,
                                   const PotentialLaw& law, const ModelStamp& stamp) noexcept {
  LinearContactModel model;
  model.state = stamp.state;
  model.time = stamp.time;
  model.sequence = stamp.sequence;
  add_springs(contact.moments, penalty, law, rotation_matrix(stamp.state.orientation).transpose(),
              model.depths);
  // What only turns the object has no normal for friction to lie across.
  constexpr double kPush = 1e-9;
  for (DepthTerm& term : model.depths) term.body = term.linear.norm() > kPush ? contact.body : -1;
  return model;
}

}  // namespace thigma
