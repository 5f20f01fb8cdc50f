#pragma once
// What the contact thread knows: the surfaces and every number of contact.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "thigma/contact/contact.h"
#include "thigma/contact/resolution.h"
#include "thigma/dynamics/constraint_model.h"
#include "thigma/math/pose.h"
#include "thigma/response/penalty.h"
#include "thigma/response/textured_world.h"

namespace thigma {

struct ConstraintWorld;
struct PotentialWorld;

/// Contacts of the grasped object at a pose of its mesh, for scenes that are not meshes; appends to
/// `contacts`, which it must not let grow, and counts what it finds there. Called by the contact
/// thread; must not throw or allocate.
using ContactSource =
    std::function<void(const Pose& world_from_mesh, double tolerance, ContactSet& contacts)>;

/// What the contact thread knows. Constant while a session runs; hierarchies outlive it.
struct ContactWorld {
  const ClodHierarchy* object = nullptr;
  Pose body_from_mesh;  // mesh frame of the grasped object in its body frame (origin: centre of
                        // mass)
  std::vector<SceneBody> scene;  // static
  ContactSource source;          // in addition to `scene`; empty: none
  double tolerance = 0.0;        // d [m]
  // of the query; exact unless asked otherwise, and with textures over one level
  Resolution resolution;
  TexturedWorld textures;  // relief of the surfaces; empty: none
  int max_clusters = 5;    // K
  // contacts of large patches over the area these share; not with textures
  bool distributes_wide_contacts = true;
  PenaltyParams response;  // how clusters push; its tolerance is set to the one above
  // of the object on each static body, in the order of `scene`; none beyond the end
  std::vector<Friction> friction;
  // what the largest kinetic coefficient is made, the others in proportion, all alike where all
  // are 0; nothing: as they are
  std::optional<double> most_friction;
  // of the constrained response, made by use_constraints: rows instead of clusters; null: none
  std::shared_ptr<const ConstraintWorld> constraints;
  PotentialLaw potential_law;  // of the next
  // of the potential response, made by use_potential: areas instead of clusters; null: none
  std::shared_ptr<const PotentialWorld> potential;
  std::size_t capacity = 16384;  // contacts a frame; what does not fit is counted
};

/// Friction of the object on a static body, as it is tuned.
/// Thread    [contact]; no failure.
inline Friction friction_on(const ContactWorld& world, std::int32_t body) noexcept {
  const auto b = static_cast<std::size_t>(body);
  Friction friction = body >= 0 && b < world.friction.size() ? world.friction[b] : Friction{};
  if (!world.most_friction) return friction;
  double most = 0.0;
  for (const Friction& f : world.friction) most = std::max(most, f.kinetic);
  const double scale = most > 0.0 ? *world.most_friction / most : 0.0;
  friction.kinetic = most > 0.0 ? scale * friction.kinetic : *world.most_friction;
  friction.at_rest = most > 0.0 ? scale * friction.at_rest : *world.most_friction;
  return friction;
}

}  // namespace thigma
