#pragma once
// From a contact back to where it was found.

#include "thigma/clod/hierarchy.h"
#include "thigma/core/index.h"

namespace thigma {

/// Node of a hierarchy that a contact's patch, numbered as in Contact, stands for; -1 where there
/// is none.
/// Thread    [contact].
inline std::int32_t contact_node(const ClodHierarchy& hierarchy, std::int32_t patch) noexcept {
  if (patch < 0) return -1;
  const std::size_t finest = hierarchy.patches.size();
  if (idx(patch) < finest) return hierarchy.patches[idx(patch)].node;
  const std::size_t contact = idx(patch) - finest;
  return contact < hierarchy.level_patches.size() ? hierarchy.level_patches[contact].patch.node
                                                  : -1;
}

}  // namespace thigma
