#pragma once
// The threads of a world's hands, each on its own clock, and the one that watches them.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "thigma/loop/safety.h"
#include "thigma/session/detail/device_token.h"
#include "thigma/session/histogram.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/world_apart.h"

namespace thigma::detail {

/// What all threads of a world whose hands are apart look at.
struct HandsShared {
  std::atomic<bool> should_stop{false};   // world -> others
  std::atomic<bool> is_held{false};       // world -> hands: paused
  std::atomic<std::uint64_t> singles{0};  // world -> hands: ticks asked for while paused, so far
  std::atomic<Fault> fault{Fault::none};  // hands, watchdog -> all: the first; it ends all
};

/// The thread of a hand, or the ticks of its device where that owns the clock. Not moved.
struct HandThread {
  /// apart    with a device of that hand; outlives this, as shared does
  /// limits   of the hand; no watchdog waits for less than three periods
  HandThread(std::size_t hand, const SafetyLimits& limits, WorldApart& apart, HandsShared& shared);
  ~HandThread();  // no tick of its device comes from here on
  HandThread(const HandThread&) = delete;
  HandThread& operator=(const HandThread&) = delete;

  const std::size_t hand;
  WorldApart& apart;
  HandsShared& shared;
  HapticDevice& device;
  const double period;
  const double watchdog;  // a gap longer than this is late [s]
  const bool holds_person;
  const bool is_device_paced;

  // The hand's own, while it runs: of a device that owns the clock within the token.
  DeadlineClock clock;
  std::uint64_t singles = 0;  // made
  DurationHistogram step_cpu{};
  std::string refused{};  // by the system
  bool is_over = false;   // zero force is all that is sent from here on
  bool has_ticked = false;

  std::atomic<std::uint64_t> ticks{0};  // hand -> world: of its clock, so far
  std::atomic<std::uint64_t> steps{0};  // hand -> world: made
  // hand -> world, which makes it 0: of the processor, the longest step since then
  std::atomic<std::int64_t> longest_ns{0};
  std::atomic<std::int64_t> last_step_ns{0};  // hand -> watchdog; 0: nothing to watch
  std::atomic<bool> was_stopped{false};       // watchdog -> hand, which makes it false
  std::atomic<std::uint64_t> stops{0};        // watchdog -> world
  std::atomic<std::int64_t> hung_ns{0};       // likewise: the hang that ended the session
  DeviceToken token;                          // of its device
};

/// By hand; null where there is no device.
using HandThreads = std::span<const std::unique_ptr<HandThread>>;

/// Haptic steps of a hand that a late world may leave for later: those of 16 s, 16384 at least.
std::size_t tick_room(double rate);

/// Makes a haptic step of a hand at each tick of its clock until it is told to stop or any hand has
/// a fault, then leaves zero force; after a fault that is sent for 20 ms. While paused its time
/// stands still. Clocks of all hands tick together.
/// Thread   [haptic]: what is run on it; beside a device that owns the clock an ordinary one.
void run_hand(const RtRequest& request, HandThread& hand);

/// Lets a device that owns the clock make the steps of its hand: before run_hand.
/// errors   as HapticDevice::start_ticks
/// Thread   [offline].
void start_hand(HandThread& hand);

/// Sends zero to the device of each hand that has made no step for as long as its watchdog says. A
/// step that hangs in a device keeps it: two threads in one driver would be worse than one. Where
/// it holds a person that is a fault, which ends all hands.
/// Thread   its own, above the hands'.
void watch_hands(HandThreads hands, const RtRequest& request, HandsShared& shared);

}  // namespace thigma::detail
