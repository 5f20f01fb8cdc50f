#pragma once
// Memory that is read all over.

#include <cstddef>
#include <cstdint>

#include <sys/mman.h>

namespace thigma::detail {

/// Asks for large pages: a height map reads all over the map, and with pages of 4 KiB a lookup of
/// the address costs more than what is read. Where the system has none, nothing changes.
///
/// memory  reserved, not yet written
/// Thread  [offline]; no failure.
inline void ask_for_large_pages(const void* memory, std::size_t bytes) noexcept {
  constexpr std::uintptr_t kLargePage = std::uintptr_t{1} << 21;
  const std::uintptr_t begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + kLargePage - 1) & ~(kLargePage - 1),
                       last = (begin + bytes) & ~(kLargePage - 1);
  if (first < last) madvise(reinterpret_cast<void*>(first), last - first, MADV_HUGEPAGE);
}

}  // namespace thigma::detail
