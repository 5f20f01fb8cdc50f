#pragma once
// Why a driver lost its device, set in a real-time thread and read in any other.

#include <atomic>
#include <cstddef>

#include "thigma/core/rt.h"

namespace thigma::detail {

/// One line: of a loss, which stays as the device has to be opened anew, or the newest warning of
/// what is still so. Two threads write where ticks stay away and come back: the device's own, and
/// the one that took over.
/// Invariant: a text is written once, by who claimed it, before its flag; who reads one that is no
/// longer told still reads it whole.
class TroubleLine {
 public:
  /// The device is lost. `why` is the vendor's own word, or null.
  /// Thread   [haptic], any number of writers.
  void lose(const char* what, const char* why = nullptr) THIGMA_RT { set(loss_, what, why); }

  /// The device goes on, and what it warns of is so from here on; no more by clear.
  ///
  /// what     a constant of the program: two warnings are one where it is the same pointer. The
  ///          first `why` of each stays.
  /// Thread   [haptic], any number of writers.
  void warn(const char* what, const char* why = nullptr) THIGMA_RT {
    for (Line& line : warnings_) {
      if (!line.is_claimed.load(std::memory_order_acquire)) set(line, what, why);
      if (!line.is_set.load(std::memory_order_acquire) || line.what != what) continue;
      warning_.store(&line, std::memory_order_release);
      return;
    }
  }

  /// What was warned of is over.
  /// Thread   [haptic], any number of writers.
  void clear(const char* what) THIGMA_RT {
    const Line* told = warning_.load(std::memory_order_acquire);
    if (told != nullptr && told->what == what)
      warning_.compare_exchange_strong(told, nullptr, std::memory_order_acq_rel);
  }

  /// The one or the other.
  void warn_while(bool is_so, const char* what) THIGMA_RT { is_so ? warn(what) : clear(what); }

  /// Thread   [any].
  bool is_lost() const THIGMA_RT { return loss_.is_claimed.load(std::memory_order_acquire); }

  /// "" where nothing is wrong; lives as long as this.
  /// Thread   [any].
  const char* text() const THIGMA_RT {
    if (loss_.is_set.load(std::memory_order_acquire)) return loss_.text;
    const Line* const warning = warning_.load(std::memory_order_acquire);
    return warning != nullptr ? warning->text : "";
  }

 private:
  static constexpr std::size_t kMost = 160;
  struct Line {
    char text[kMost] = "";
    const char* what = nullptr;  // of a warning
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
    line.what = what;
    line.is_set.store(true, std::memory_order_release);
  }

  static constexpr std::size_t kMostWarnings = 4;  // a driver has less; one more is not told
  Line loss_, warnings_[kMostWarnings];
  std::atomic<const Line*> warning_{nullptr};
};

}  // namespace thigma::detail
