#pragma once
// Bounded queue from a real-time thread to an ordinary one.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "thigma/core/rt.h"

namespace thigma {

/// Queue of one writer and one reader. Never blocks: what does not fit is dropped and counted.
/// Invariant: tail <= head <= tail + capacity, both only grow.
/// Thread: construction [offline]; push from one thread [haptic]; pop from one other [haptic];
/// dropped from any.
template <RtPayload T>
class SpscRing {
 public:
  /// Room for at least `capacity` values, >= 1. Touches all its memory, so that no first use faults
  /// a page in.
  explicit SpscRing(std::size_t capacity)
      : slots_(power_of_two(capacity)), mask_(slots_.size() - 1) {}

  /// False, and counted, when full.
  bool push(const T& value) THIGMA_RT {
    const std::uint64_t head = head_.load(std::memory_order_relaxed);
    if (head - tail_.load(std::memory_order_acquire) >= slots_.size()) {
      dropped_.fetch_add(1, std::memory_order_relaxed);
      return false;
    }
    slots_[head & mask_] = value;
    head_.store(head + 1, std::memory_order_release);
    return true;
  }

  /// The oldest value, or null when empty; valid until pop().
  const T* front() const THIGMA_RT {
    const std::uint64_t tail = tail_.load(std::memory_order_relaxed);
    if (tail == head_.load(std::memory_order_acquire)) return nullptr;
    return &slots_[tail & mask_];
  }
  /// Removes the oldest value; only after front() gave one.
  void pop() THIGMA_RT {
    tail_.store(tail_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
  }

  std::size_t capacity() const THIGMA_RT { return slots_.size(); }
  std::uint64_t dropped() const THIGMA_RT { return dropped_.load(std::memory_order_relaxed); }

 private:
  static std::size_t power_of_two(std::size_t n) {
    std::size_t p = 1;
    while (p < n) p *= 2;
    return p;
  }

  std::vector<T> slots_;
  std::size_t mask_;
  alignas(64) std::atomic<std::uint64_t> head_{0};
  alignas(64) std::atomic<std::uint64_t> tail_{0};
  alignas(64) std::atomic<std::uint64_t> dropped_{0};
};

}  // namespace thigma
