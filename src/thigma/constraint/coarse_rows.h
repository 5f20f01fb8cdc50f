#pragma once
// Rows of pairs that a query with levels of detail left coarse, far away: planes between all that
// is below them.

#include <span>
#include <vector>

#include "thigma/constraint/feature_rows.h"
#include "thigma/contact/contact.h"

namespace thigma {

/// Whether a contact is not one of two finest patches. Thread: any.
inline bool is_coarse(const Contact& contact) noexcept {
  return contact.object_level > 0 || contact.scene_level > 0;
}

/// A row for every coarse contact that may be met within reach, appended to `rows`.
///
/// object    as the query had it; bodies likewise
/// contacts  of that query; those of two finest patches are passed over
/// reach     how far the rows have to hold
/// rows      without friction, their body -1; scene_plane. Capacity is never grown: room for as
///           many as contacts
/// Thread    [contact]; no failure
/// Source    This project's. Along the normal of the contact the hulls of the two nodes, widened by
///           what may reach outside them, are `gap` apart less what turning may make of the
///           object's about its middle. So the middle kept that far in front of a plane of the
///           scene keeps all triangles below from each other: the gap is never more than their
///           separation.
void find_coarse_rows(const PlacedHierarchy& object, std::span<const SceneBody> bodies,
                      std::span<const Contact> contacts, const RowReach& reach,
                      std::vector<FoundRow>& rows) noexcept;

}  // namespace thigma
