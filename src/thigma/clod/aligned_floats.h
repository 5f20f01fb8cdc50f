#pragma once
// Floats that start where 256-bit loads want them.

#include <cstddef>
#include <new>
#include <vector>

namespace thigma {

/// Allocates on 32-byte boundaries. std::vector alone promises 16.
template <class T>
struct Aligned32 {
  using value_type = T;
  Aligned32() = default;
  template <class U>
  Aligned32(const Aligned32<U>&) noexcept {}  // NOLINT: converting, as every allocator
  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{32}));
  }
  void deallocate(T* p, std::size_t n) noexcept {
    ::operator delete (p, n * sizeof(T), std::align_val_t{32});
  }
  friend bool operator==(const Aligned32&, const Aligned32&) noexcept { return true; }
};

using AlignedFloats = std::vector<float, Aligned32<float>>;

}  // namespace thigma
