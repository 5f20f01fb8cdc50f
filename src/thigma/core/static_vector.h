#pragma once
// A vector with fixed capacity that never allocates.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>

#include "thigma/core/rt.h"

namespace thigma {

/// Up to N values of a default-constructible T, in place.
/// Invariant: size() <= N; elements beyond size() are unspecified, and not copied.
/// Thread: as its elements; every member is [haptic].
template <class T, std::size_t N>
class StaticVector {
 public:
  using value_type = T;
  StaticVector() THIGMA_RT {}
  StaticVector(const StaticVector& other) THIGMA_RT { *this = other; }
  StaticVector& operator=(const StaticVector& other) THIGMA_RT {
    std::copy_n(other.items_.begin(), other.size_, items_.begin());
    size_ = other.size_;
    return *this;
  }
  static constexpr std::size_t capacity() THIGMA_RT { return N; }
  std::size_t size() const THIGMA_RT { return size_; }
  bool empty() const THIGMA_RT { return size_ == 0; }
  bool full() const THIGMA_RT { return size_ == N; }
  void clear() THIGMA_RT { size_ = 0; }

  /// Appends; false, and nothing changes, when full.
  bool push_back(const T& value) THIGMA_RT {
    if (size_ == N) return false;
    items_[size_++] = value;
    return true;
  }
  void pop_back() THIGMA_RT {
    assert(size_ > 0);
    --size_;
  }
  T& operator[](std::size_t i) THIGMA_RT { return items_[i]; }
  const T& operator[](std::size_t i) const THIGMA_RT { return items_[i]; }
  T* begin() THIGMA_RT { return items_.data(); }
  T* end() THIGMA_RT { return items_.data() + size_; }
  const T* begin() const THIGMA_RT { return items_.data(); }
  const T* end() const THIGMA_RT { return items_.data() + size_; }
  T& back() THIGMA_RT { return items_[size_ - 1]; }
  const T& back() const THIGMA_RT { return items_[size_ - 1]; }

 private:
  std::array<T, N> items_;
  std::size_t size_ = 0;
};

}  // namespace thigma
