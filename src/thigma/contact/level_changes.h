#pragma once
// Which contacts changed their level of detail from one contact frame to the next.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/contact.h"
#include "thigma/contact/query_contacts.h"

namespace thigma {

/// A pair of nodes in contact.
struct NodePair {
  std::int32_t body = 0, object = -1, scene = -1;
  friend auto operator<=>(const NodePair&, const NodePair&) = default;
};

/// The pairs of the last frame, and the trees they stand in.
/// Any content is valid once reserved. Grows with the largest frame; reserve_level_history ahead of
/// time.
struct LevelHistory {
  std::vector<std::int32_t> object_parents;                // of each node, -1: the root
  std::vector<std::vector<std::int32_t>> scene_parents;    // by body
  std::vector<std::int32_t> object_triangles;              // of the original below each node
  std::vector<std::vector<std::int32_t>> scene_triangles;  // by body
  std::vector<NodePair> last, now;                         // sorted
  std::vector<NodePair> gone;                              // of last, what now lacks
};

/// Thread    [offline]; throws std::bad_alloc.
void reserve_level_history(const ClodHierarchy& object, std::span<const SceneBody> scene,
                           std::size_t contacts, LevelHistory& history);

/// Pairs that came or went and stand above or below a pair of the other frame, on either side or
/// both: where a contact was refined or coarsened. Contacts that begin or end do not count.
///
/// contacts  of this frame; those without nodes are left out
/// history   of the same object and scene; becomes that of this frame
/// Thread    [contact]; no failure; allocates only when contacts outgrow the history.
std::int32_t count_level_changes(const ClodHierarchy& object, std::span<const SceneBody> scene,
                                 std::span<const Contact> contacts, LevelHistory& history) noexcept;

/// Original triangles below the contacts of the frame counted last, mean of both sides, summed over
/// the contacts.
/// Thread    [contact]; no failure.
double triangles_below(const LevelHistory& history) noexcept;

}  // namespace thigma
