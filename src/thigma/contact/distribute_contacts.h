#pragma once
// Contacts of large patches, spread over the area in which the two surfaces are within the
// tolerance.

#include <span>
#include <vector>

#include "thigma/contact/contact.h"
#include "thigma/contact/query_contacts.h"

namespace thigma {

/// A contact is divided where the area its pair shares is wider than this many tolerances, root
/// mean square, entirely from twice that on: a point that jumps within less moves the torque by
/// little.
inline constexpr double kSpreadFrom = 4.0;

/// One contact a pair says how deep, not where: between two faces that come to lie parallel the
/// nearest point jumps from one edge to the other. This divides each contact of two large patches
/// among four points whose mean and second moments are those of the area in which, seen along its
/// normal, one surface lies within the tolerance of the other, each place weighing depth + d. Depth
/// and normal stay those of the pair. So the force stays, where it acts moves gradually while faces
/// tilt and slide, and it turns against a rotation as the area does.
///
/// object, scene  as queried
/// contacts       of the query, all bodies
/// tolerance      d of the query [m]
/// spread         overwritten; ordered as contacts. Never grown: where the room does not suffice
///                contacts stay as they are
/// Thread         [contact]; no failure, no allocation. A function of its arguments, bit for bit.
/// Source         none; Sec. 5.4.1 has one contact a pair (docs/deviations.md, D35).
void distribute_contacts(const PlacedHierarchy& object, std::span<const SceneBody> scene,
                         std::span<const Contact> contacts, double tolerance,
                         std::vector<Contact>& spread) noexcept;

}  // namespace thigma
