#pragma once
// Which contacts changed their level of detail from one contact frame to the next.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/contact.h"
#include "thigma/contact/query_contacts.h"

namespace thigma {

/// A pair of nodes in contact, compared by body and nodes.
struct NodePair {
  std::int32_t body = 0, object = -1, scene = -1;
  bool presses = false;

  friend auto operator<=>(const NodePair& x, const NodePair& y) noexcept {
    if (const auto by_body = x.body <=> y.body; by_body != 0) return by_body;
    if (const auto by_object = x.object <=> y.object; by_object != 0) return by_object;
    return x.scene <=> y.scene;
  }
  friend bool operator==(const NodePair& x, const NodePair& y) noexcept { return (x <=> y) == 0; }
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
  std::vector<NodePair> gone, stayed;                      // of last: what now lacks, and has
};

/// How many contacts were refined or coarsened.
struct LevelChanges {
  std::int32_t all = 0;
  std::int32_t pressing = 0;  // that press before or after, where the models are made
};

/// Thread    [offline]; throws std::bad_alloc.
void reserve_level_history(const ClodHierarchy& object, std::span<const SceneBody> scene,
                           std::size_t contacts, LevelHistory& history);

/// Pairs that came or went and stand above or below a pair of the other frame, on either side or
/// both: where a contact was refined or coarsened, once for each of the finer pairs. Contacts that
/// begin or end do not count. Those that press neither before nor after move no force: queries also
/// report what their bounds do not rule out.
///
/// contacts  of this frame; those without nodes are left out
/// tolerance  d: contacts press whose depth is above -d [m]
/// history   of the same object and scene; becomes that of this frame
/// Thread    [contact]; no failure; allocates only when contacts outgrow the history.
LevelChanges count_level_changes(const ClodHierarchy& object, std::span<const SceneBody> scene,
                                 std::span<const Contact> contacts, double tolerance,
                                 LevelHistory& history) noexcept;

/// Original triangles below the contacts of the frame counted last, mean of both sides, summed over
/// the contacts.
/// Thread    [contact]; no failure.
double triangles_below(const LevelHistory& history) noexcept;

}  // namespace thigma
