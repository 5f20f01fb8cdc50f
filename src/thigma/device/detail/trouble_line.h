#pragma once
// Why a driver lost its device, set in a real-time thread and read in any other.

#include <atomic>
#include <cstddef>

#include "thigma/core/rt.h"

namespace thigma::detail {

/// One line; the first of each kind stays, and a loss takes the place of a warning. Two threads
/// write where ticks stay away and come back: the device's own, and the one that took over.
/// Invariant: a text is written once, by who claimed it, before its flag.
class TroubleLine {
 public:
  /// The device is lost. `why` is the vendor's own word, or null.
  /// Thread   [haptic], any number of writers.
  void lose(const char* what, const char* why = nullptr) THIGMA_RT { set(loss_, what, why); }

  /// The device goes on.
  /// Thread   [haptic], any number of writers.
  void warn(const char* what, const char* why = nullptr) THIGMA_RT { set(warning_, what, why); }

  /// Thread   [any].
  bool is_lost() const THIGMA_RT { return loss_.is_claimed.load(std::memory_order_acquire); }

  /// "" where nothing is wrong; lives as long as this.
  /// Thread   [any].
  const char* text() const THIGMA_RT {
    if (loss_.is_set.load(std::memory_order_acquire)) return loss_.text;
    return warning_.is_set.load(std::memory_order_acquire) ? warning_.text : "";
  }

 private:
  static constexpr std::size_t kMost = 160;
  struct Line {
    char text[kMost] = "";
    std::atomic<bool> is_claimed{false}, is_set{false};
  };

  static void set(Line& line, const char* what, const char* why) THIGMA_RT {
    if (line.is_claimed.exchange(true, std::memory_order_acq_rel)) return;
    std::size_t length = 0;
    const auto add = [&](const char* text) {
      for (; text != nullptr && *text != '\0' && length + 1 < kMost; ++text) {
        const bool is_plain = static_cast<unsigned char>(*text) >= ' ';
        line.text[length++] = is_plain ? *text : ' ';
      }
    };
    add(what);
    if (why != nullptr && *why != '\0') add(": ");
    add(why);
    line.text[length] = '\0';
    line.is_set.store(true, std::memory_order_release);
  }

  Line loss_, warning_;
};

}  // namespace thigma::detail
