#include "thigma/response/detail/patch_level.h"

#include "thigma/core/index.h"

namespace thigma::detail {
namespace {

const ClodContactPatch* contact_patch(const ClodHierarchy& h, std::int32_t patch) noexcept {
  const std::size_t i = at(patch) - h.patches.size();
  return patch >= 0 && at(patch) >= h.patches.size() && i < h.contact_patches.size()
             ? &h.contact_patches[i]
             : nullptr;
}

}  // namespace

std::int32_t level_of(const ClodHierarchy& h, std::int32_t patch) noexcept {
  const ClodContactPatch* const coarse = contact_patch(h, patch);
  return coarse != nullptr ? coarse->level : 0;
}

const ClodPatch* patch_at_level(const TexturedBody& body, std::int32_t patch,
                                std::int32_t level) noexcept {
  const ClodHierarchy& h = *body.hierarchy;
  const ClodContactPatch* const coarse = contact_patch(h, patch);
  if (coarse == nullptr && (patch < 0 || at(patch) >= h.patches.size())) return nullptr;
  const ClodPatch& own = coarse != nullptr ? coarse->patch : h.patches[at(patch)];
  if (level_of(h, patch) == level) return &own;
  std::int32_t node = own.node;
  while (node >= 0 && h.nodes[at(node)].level < level) node = body.parent[at(node)];
  if (node < 0 || h.nodes[at(node)].contact < 0) return nullptr;
  return &h.contact_patches[at(h.nodes[at(node)].contact)].patch;
}

}  // namespace thigma::detail
