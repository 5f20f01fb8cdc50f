#pragma once
// One contact frame: from the object's pose to the contact model of the haptic thread (Sec. 5.1.2).

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/clustering.h"
#include "thigma/contact/contact.h"
#include "thigma/dynamics/body.h"
#include "thigma/runtime/haptic_step.h"
#include "thigma/runtime/telemetry.h"

namespace thigma {

/// A static object. Does not own its hierarchy.
struct SceneObject {
  const ClodHierarchy* hierarchy = nullptr;
  Pose world_from_mesh;
};

/// Contacts of the grasped object at a pose of its mesh, for scenes that are not meshes; appends to `contacts`, which
/// it must not let grow, and counts what it finds there. Called by the contact thread; must not throw or allocate.
using ContactSource = std::function<void(const Pose& world_from_mesh, double tolerance, ContactSet& contacts)>;

/// What the contact thread knows. Constant while a session runs; hierarchies outlive it.
struct ContactWorld {
  const ClodHierarchy* object = nullptr;
  Pose body_from_mesh;               // mesh frame of the grasped object in its body frame (origin: centre of mass)
  std::vector<SceneObject> scene;
  ContactSource source;              // in addition to `scene`; empty: none
  double tolerance = 0.0;            // d [m]
  int max_clusters = 5;              // K
  double stiffness = 2000.0;         // k of the contact, shared by its clusters [N/m]
  double damping = 0.0;              // b [N s/m]
  std::size_t capacity = 16384;      // contacts a frame; what does not fit is counted
};

/// Working memory of contact_step. Grows while warming up, never after.
struct ContactScratch;

/// Scratch with a front a static object and room for world.capacity contacts. Thread [offline].
std::unique_ptr<ContactScratch, void (*)(ContactScratch*)> make_contact_scratch(const ContactWorld& world);

/// One frame: query every static object, cluster all contacts together, linearise.
///
/// world    constant
/// body     mass properties, for the arms of the terms
/// at       state and time the model is for
/// scratch  read and written; coherence lives here
/// sample   overwritten: the model to publish (its sequence counts from 1) and its statistics; times of CPU use and of
///          publication are the shell's business
/// Thread   [contact]; no failure.
/// Source   Sec. 5.1.2, contact thread; texture refinement comes with textures.
void contact_step(const ContactWorld& world, const RigidBody& body, const StampedBody& at, ContactScratch& scratch,
                  ContactSample& sample) noexcept;

}  // namespace thigma
