#pragma once
// The contact query Q(A, B, d): every pair of patches whose triangles come within d, finest or at
// the resolution that is asked.

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
  std::int32_t body = 0;  // written to the contacts
  // where more pairs than this have to be looked at, with Resolution::exact_within where more
  // contacts are found, the tolerance is halved on the way, six times at most, and what is exact
  // becomes at most half of it; ContactFront::tolerance is what is left. 0: as many as there are.
  // Not of other queries with levels
  std::size_t most_pairs = 0;
  double least_tolerance = 0.0;  // never halved to less, however many there are [m]
  // Exact, or with Resolution::exact_within: where no closed form has the distance of two patches
  // whose hulls are apart, the contact has that of the hulls, not of the triangles. It is no
  // farther than they are, so that more may be reported, never less; no such pair counts as
  // through, and its `bound` says nothing. For rows, which look at the features themselves
  bool measures_hulls = false;
  // With measures_hulls and Resolution::carry, exact: of pairs that are certain to be within d
  // those alone are measured that may be the nearest. The others move along like carried contacts,
  // however far the bodies have gone, with a bound that says so: the pairs are the same, and the
  // nearest is as near, as long as all that are within d have room
  bool holds_near = false;
  Resolution resolution{};  // exact unless asked otherwise
};

/// Contacts between the grasped object and one object of the scene, appended to a set.
///
/// object, scene  hierarchies and poses; alive and unchanged while the front is used with them
/// query          tolerance >= 0 [m]
/// front          scratch of this pair of bodies
/// contacts       contacts are appended, ordered by (object_patch, scene_patch). Room is never
///                grown, only none at all to 4096: of more than fit the deepest stay and `dropped`
///                counts the others. Counts are added to stats
/// Thread         [contact]; no failure: a pose that is not finite gives no contact. Allocates when
///                front or set have no memory for them yet, never after. Exact and without
///                keep_directions the contacts, their order and every bit are a function of the two
///                poses.
/// Source         Sec. 3.4.1-3.4.4, Eq. 3.5. Deviates: front tracking by remaining travel
///                (docs/deviations.md).
void query_contacts(const PlacedHierarchy& object, const PlacedHierarchy& scene,
                    const ContactQuery& query, ContactFront& front, ContactSet& contacts) noexcept;

/// Contacts with every body of a scene, in one set, with body indices; the set is emptied first.
/// fronts  one a body, as many as bodies. query.body is ignored. Otherwise as query_contacts.
void query_scene(const PlacedHierarchy& object, std::span<const SceneBody> bodies,
                 const ContactQuery& query, std::span<ContactFront> fronts,
                 ContactSet& contacts) noexcept;

/// How near what the last query did not report may be, at least: the tolerance, and more where its
/// traversal has proven more [m].
///
/// front     as that query left it; infinity before the first
/// Thread    [contact].
double unreported_separation(const ContactFront& front) noexcept;

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
