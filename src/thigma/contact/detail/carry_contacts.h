#pragma once
// How a contact moves along with the bodies, and how long it may.

#include "thigma/contact/detail/query_frame.h"

namespace thigma::detail {

/// Forgets all contacts. Thread [contact].
void forget_carried(ContactFront& front) noexcept;

/// Forgets that of one node.
inline void drop_carried(CarriedContacts& carried, std::int32_t node) noexcept {
  if (carried.place == nullptr || carried.place[node] < 0) return;
  carried.free.push_back(carried.place[node]);
  carried.place[node] = -1;
}

/// Whether place i of the front has one, which may still hold or not.
inline bool has_carried(const CarriedContacts& carried, std::int32_t i) noexcept {
  return carried.place[i] >= 0;
}

/// Whether this query carries contacts: it asks to, there is memory, and what a pair is depends on
/// nothing but the pair and its place. Contacts that were measured for another question are
/// forgotten.
bool is_carrying(QueryFrame& frame) noexcept;

/// What a measured pair says, beyond the pair itself.
struct MeasuredContact {
  PatchPair pair;
  double bound = 0.0, nearest = 0.0;  // as of LevelPair [m]
  LevelDecision decided_by = LevelDecision::finest;
};

/// Keeps a contact for as long as it cannot become of another kind.
///
/// node  of the front, place i
/// a, b  the patches, for what they face
void keep_contact(QueryFrame& frame, std::int32_t i, const HullView& a, const HullView& b,
                  const MeasuredContact& measured) noexcept;

/// The contact of place i where it is now, its bound grown by what the bodies may have moved.
///
/// i        has a contact
/// a, b     the patches
/// returns  whether there is one that still holds
bool carry_contact(const QueryFrame& frame, std::int32_t i, const HullView& a, const HullView& b,
                   MeasuredContact& out) noexcept;

}  // namespace thigma::detail
