#pragma once
// One contact frame: from the object's pose to the contact model of the haptic thread (Sec. 5.1.2).

#include <cstdint>
#include <functional>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/clustering.h"
#include "thigma/contact/contact.h"
#include "thigma/contact/contact_manifold.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/dynamics/body.h"
#include "thigma/response/penalty.h"
#include "thigma/response/texture_contacts.h"
#include "thigma/runtime/haptic_step.h"
#include "thigma/runtime/level_changes.h"
#include "thigma/runtime/telemetry.h"

namespace thigma {

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
  bool is_spread = true;
  PenaltyParams response;        // how clusters push; its tolerance is set to the one above
  std::size_t capacity = 16384;  // contacts a frame; what does not fit is counted
};

/// Working memory of contact_step. Grows while warming up, never after.
struct ContactScratch {
  std::vector<ContactFront> fronts;  // one a static object
  ContactSet contacts;               // of the last frame
  // the same as clustered, see spread_contacts; empty: as they are
  std::vector<Contact> spread;
  ContactClusters clusters;  // of the last frame: warm start, persistent ids
  ClusterScratch clustering;
  std::uint64_t sequence = 0;  // models made
  double last_time = 0.0;      // of the last query, for speeds [s]
  LevelHistory levels;         // which contacts changed their level since the last frame
  TextureScratch textures;
};

/// Room for world.capacity contacts and a front a static object: all that find_contacts needs.
/// Thread    [offline]; throws std::bad_alloc.
void reserve_query(const ContactWorld& world, ContactScratch& scratch);

/// The same, and what make_model needs: a graphics processor is opened here, where the world asks
/// for one.
/// Thread    [offline]; throws std::bad_alloc.
void reserve_contact_scratch(const ContactWorld& world, ContactScratch& scratch);

/// First half of a contact frame: queries every static object into scratch.contacts. Where there is
/// relief, farther than the tolerance by as much.
/// Thread    [contact]; no failure.
void find_contacts(const ContactWorld& world, const StampedBody& at,
                   ContactScratch& scratch) noexcept;

/// Second half: spreads contacts of large patches, clusters all together and linearises them, with
/// depth and gradient from textures where a cluster touches relief.
///
/// world         constant
/// at            state and time the model is for, as given to find_contacts
/// scratch       clusters are carried over
/// sample        overwritten, but for the times of CPU use and of publication, which are the
/// shell's business;
///               sample.model is what to publish, its sequence counts from 1
/// Thread        [contact]; no failure.
void make_model(const ContactWorld& world, const StampedBody& at, ContactScratch& scratch,
                ContactSample& sample) noexcept;

/// One frame: both halves.
/// Source Sec. 5.1.2, contact thread.
void contact_step(const ContactWorld& world, const StampedBody& at, ContactScratch& scratch,
                  ContactSample& sample) noexcept;

}  // namespace thigma
