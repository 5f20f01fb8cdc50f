#pragma once
// What the contact thread knows: the surfaces and every number of contact.

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "thigma/contact/contact.h"
#include "thigma/contact/resolution.h"
#include "thigma/math/pose.h"
#include "thigma/response/penalty.h"
#include "thigma/response/textured_world.h"

namespace thigma {

struct ConstraintWorld;

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
  // of the constrained response, made by use_constraints: rows instead of clusters; null: none
  std::shared_ptr<const ConstraintWorld> constraints;
  std::size_t capacity = 16384;  // contacts a frame; what does not fit is counted
};

}  // namespace thigma
