#pragma once
// Newest-value exchange between two threads.

#include <array>
#include <atomic>
#include <cstdint>
#include <utility>

#include "thigma/core/rt.h"

namespace thigma {

/// Hands the newest value of one writer to one reader; older ones are overwritten unseen. Wait-free
/// on both sides. Four slots: the writer owns one, the reader two, the value it has and one that it
/// may look at first; the fourth changes hands by one atomic exchange. Invariant: the four slot
/// numbers are a permutation of 0..3. Thread: publish from one thread, all else from one other; all
/// [haptic].
template <RtPayload T>
class Latest {
 public:
  /// Slot to be filled in place before publish(); holds an old value.
  T& draft() THIGMA_RT { return slots_[writer_]; }

  /// Makes the draft the newest value.
  void publish() THIGMA_RT {
    writer_ = middle_.exchange(writer_ | kFresh, std::memory_order_acq_rel) & kSlot;
  }
  void publish(const T& value) THIGMA_RT {
    slots_[writer_] = value;
    publish();
  }

  /// The newest value that has not been taken, or null. It is offered until it is taken or a newer
  /// one comes.
  const T* offered() THIGMA_RT {
    if ((middle_.load(std::memory_order_relaxed) & kFresh) != 0) {
      spare_ = middle_.exchange(spare_, std::memory_order_acq_rel) & kSlot;
      is_offered_ = true;
    }
    return is_offered_ ? &slots_[spare_] : nullptr;
  }

  /// Makes what is offered the value.
  void take() THIGMA_RT {
    std::swap(reader_, spare_);
    is_offered_ = false;
  }

  /// Takes the newest value if there is one the reader has not seen; returns whether value()
  /// changed.
  bool fetch() THIGMA_RT {
    if (offered() == nullptr) return false;
    take();
    return true;
  }

  /// The value taken last; T{} before the first.
  const T& value() const THIGMA_RT { return slots_[reader_]; }

 private:
  static constexpr std::uint32_t kSlot = 3, kFresh = 4;
  std::array<T, 4> slots_{};
  // Own cache lines: neither side's bookkeeping slows the other.
  alignas(64) std::uint32_t writer_ = 0;
  alignas(64) std::atomic<std::uint32_t> middle_{1};
  alignas(64) std::uint32_t reader_ = 2;
  std::uint32_t spare_ = 3;
  bool is_offered_ = false;
};

}  // namespace thigma
