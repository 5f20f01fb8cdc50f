#pragma once
// The exact contact query Q(A, B, d): every pair of finest patches whose triangles come within d.

#include <cstdint>
#include <span>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/contact.h"
#include "thigma/contact/front.h"
#include "thigma/contact/resolution.h"
#include "thigma/math/pose.h"

namespace thigma {

struct ContactQuery {
  double tolerance = 0.0;  // d: contacts have depth >= -tolerance [m]
  // penetration: among near-equal directions keep last frame's, and follow a pair through
  // (hysteresis for a simulation; off, a result depends on the pose alone)
  bool keep_directions = false;
  std::int32_t body = 0;    // written to the contacts
  Resolution resolution{};  // exact unless asked otherwise
};

/// Exact contacts between the grasped object and one object of the scene, appended to a set.
///
/// object, scene       hierarchies; alive and unchanged while the front is used with them
/// world_from_object   pose, |orientation| = 1 to 1e-9
/// world_from_scene    the same of the scene's body
/// query               tolerance >= 0 [m]
/// front               scratch of this pair of bodies
/// contacts            contacts are appended, ordered by (object_patch, scene_patch). Capacity is
///                     never grown: of more contacts than fit the deepest stay and `dropped` counts
///                     the others. Counts are added to stats
/// Thread              [contact]; no failure: a pose that is not finite gives no contact. Allocates
///                     when the front has no memory for these hierarchies yet, never after. Without
///                     keep_directions the contacts, their order and every bit are a function of
///                     the two poses.
/// Source              Sec. 3.4.1-3.4.2, Eq. 3.5. Deviates: front tracking by remaining travel
///                     (docs/deviations.md).
void query_contacts(const ClodHierarchy& object, const Pose& world_from_object,
                    const ClodHierarchy& scene, const Pose& world_from_scene,
                    const ContactQuery& query, ContactFront& front, ContactSet& contacts) noexcept;

/// The traversal alone: brings the front to these poses and measures no contact. query_contacts
/// does so itself; this is for those who want to know or time the two parts apart. returns counts
/// of this call.
QueryStats track_front(const ClodHierarchy& object, const Pose& world_from_object,
                       const ClodHierarchy& scene, const Pose& world_from_scene,
                       const ContactQuery& query, ContactFront& front) noexcept;

/// Contacts with every body of a scene, in one set, with body indices; the set is emptied first.
/// fronts  one a body, as many as bodies. query.body is ignored. Otherwise as query_contacts.
void query_scene(const ClodHierarchy& object, const Pose& world_from_object,
                 std::span<const SceneBody> bodies, const ContactQuery& query,
                 std::span<ContactFront> fronts, ContactSet& contacts) noexcept;

/// Empties a set, keeping its capacity.
/// Thread    [contact].
inline void clear(ContactSet& contacts) noexcept {
  contacts.contacts.clear();
  contacts.dropped = 0;
  contacts.stats = {};
}

/// -max(depth), or infinity for an empty set [m].
double least_distance(const ContactSet& contacts) noexcept;

}  // namespace thigma
