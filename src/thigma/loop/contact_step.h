#pragma once
// One contact frame: from the object's pose to the contact model of the haptic thread (Sec. 5.1.2).

#include <cstdint>
#include <memory>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/clustering.h"
#include "thigma/contact/contact.h"
#include "thigma/contact/level_changes.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/dynamics/body.h"
#include "thigma/loop/contact_world.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/loop/samples.h"

namespace thigma {

struct ConstraintScratch;
struct PotentialScratch;
struct TextureScratch;

/// Working memory of contact_step. Grows while warming up, never after.
struct ContactScratch {
  std::vector<ContactFront> fronts;  // one a static object
  ContactSet contacts;               // of the last frame
  // the same as clustered, see distribute_contacts; empty: as they are
  std::vector<Contact> spread;
  ContactClusters clusters;  // of the last frame: warm start, persistent ids
  ClusterScratch clustering;
  std::uint64_t sequence = 0;  // models made
  double last_time = 0.0;      // of the last query, for speeds [s]
  double period = 2e-3;        // of models, the longest of the last ones [s]
  LevelHistory levels;         // which contacts changed their level since the last frame
  std::shared_ptr<TextureScratch> textures;        // where the world has textures, else null
  std::shared_ptr<ConstraintScratch> constraints;  // where the world has constraints, else null
  std::shared_ptr<PotentialScratch> potential;     // where the world has a potential, else null
  double looked_ahead = 0.0;                       // tolerance of the last query for rows [m]
  double separation = 0.0;       // of what that query did not report, at least [m]
  double crowded_ahead = 1e300;  // look-ahead that had too many pairs; grows again [m]
  double worth_ahead = 1e300;    // beyond, more rows are needed than fit; grows again [m]
};

/// Room for world.capacity contacts and a front a static object: all that find_contacts needs.
/// Thread    [offline]; throws std::bad_alloc.
void reserve_query(const ContactWorld& world, ContactScratch& scratch);

/// The same, and what make_model needs: a graphics processor is opened here, where the world asks
/// for one.
/// Thread    [offline]; throws std::bad_alloc.
void reserve_contact_scratch(const ContactWorld& world, ContactScratch& scratch);

/// First half of a contact frame: queries every static object into scratch.contacts. With textures
/// the search tolerance grows by the largest displacement.
/// Thread    [contact]; no failure.
void find_contacts(const ContactWorld& world, const StampedBody& body,
                   ContactScratch& scratch) noexcept;

/// Second half: spreads contacts of large patches, clusters all together and linearises them, with
/// depth and gradient from textures where a cluster touches relief.
///
/// world         constant
/// body          state and time the model is for, as given to find_contacts
/// scratch       clusters are carried over
/// sample        overwritten, but for the times of CPU use and of publication, which are the
///               shell's business; sample.model is what to publish, its sequence counts from 1
/// Thread        [contact]; no failure.
void make_model(const ContactWorld& world, const StampedBody& body, ContactScratch& scratch,
                ContactSample& sample) noexcept;

/// One frame: both halves.
/// Source Sec. 5.1.2, contact thread.
void contact_step(const ContactWorld& world, const StampedBody& body, ContactScratch& scratch,
                  ContactSample& sample) noexcept;

}  // namespace thigma
