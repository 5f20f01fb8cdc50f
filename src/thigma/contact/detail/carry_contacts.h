#pragma once
// How a contact moves along with the bodies, and how long it may.

#include "thigma/contact/detail/query_frame.h"

namespace thigma::detail {

/// Forgets all contacts. Thread [contact].
void forget_carried(ContactFront& front) noexcept;

/// Forgets how deep they are, but not how near pairs are whose hulls are apart. Thread [contact].
void forget_depths(ContactFront& front) noexcept;

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

/// That of place i, which has one.
inline const CarriedContact& carried_of(const CarriedContacts& carried, std::int32_t i) noexcept {
  return carried.contacts[static_cast<std::size_t>(carried.place[i])];
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
  bool is_of_search = false;  // depends on what was remembered, by rounding: it is not carried
};

/// Keeps a contact for as long as it cannot become of another kind.
///
/// node  of the front, place i
/// a, b  the patches, for what they face
void keep_contact(QueryFrame& frame, std::int32_t i, const HullView& a, const HullView& b,
                  const MeasuredContact& measured) noexcept;

/// A contact where it is now, its bound grown by what the bodies may have moved.
void move_contact(const QueryFrame& frame, const CarriedContact& contact,
                  MeasuredContact& out) noexcept;

/// The same of the contact of place i, a node of the front.
/// returns  whether there is one that still holds: the bodies have not gone farther than it is
///          carried, and where it penetrates two triangles still pierce each other
bool carry_contact(const QueryFrame& frame, const FrontNode& node, std::int32_t i,
                   MeasuredContact& out) noexcept;

}  // namespace thigma::detail
