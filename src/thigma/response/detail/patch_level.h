#pragma once
// Patches of contacts and of the levels above them.

#include "thigma/response/texture_contacts.h"

namespace thigma::detail {

/// Of a patch as contacts name it; 0 the finest.
/// Thread [contact]; no failure.
std::int32_t level_of(const ClodHierarchy& h, std::int32_t patch) noexcept;

/// A patch as contacts name it, or the one of a coarser level that it lies below; null without one.
/// Thread [contact]; no failure.
const ClodPatch* patch_at_level(const TexturedBody& body, std::int32_t patch,
                                std::int32_t level) noexcept;

}  // namespace thigma::detail
