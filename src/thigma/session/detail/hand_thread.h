#pragma once
// The thread of a world's hands, and the one that watches it.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <string>

#include "thigma/loop/safety.h"
#include "thigma/session/detail/device_token.h"
#include "thigma/session/histogram.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/world_apart.h"

namespace thigma::detail {

/// What the threads of a world whose hands are apart look at.
struct HandsShared {
  std::atomic<bool> should_stop{false};   // world -> others
  std::atomic<bool> is_held{false};       // world -> hands: paused
  std::atomic<std::uint64_t> singles{0};  // world -> hands: ticks asked for while paused, so far
  std::atomic<std::uint64_t> ticks{0};    // hands -> world: of their clock, so far
  std::atomic<std::uint64_t> missed{0};   // hands -> world: of them, those without a step
  // hands -> world, which makes it 0: of the processor, the longest tick since then
  std::atomic<std::int64_t> longest_ns{0};
  std::atomic<Fault> fault{Fault::none};  // hands -> world

  std::atomic<std::int64_t> last_step_ns{0};  // hands -> watchdog; 0: nothing to watch
  std::atomic<bool> was_stopped{false};       // watchdog -> hands, which makes it false
  std::atomic<std::uint64_t> stops{0};        // watchdog -> world
  DeviceToken token;                          // of all devices
};

/// The hands' thread.
struct HandThread {
  WorldApart& apart;
  HandsShared& shared;
  DeadlineClock clock;
  double period;
  double watchdog;  // a gap that is no longer ridden over without a new ramp [s]
  double now = 0.0;
  std::uint64_t singles = 0;  // made
  DurationHistogram step_cpu{};
  std::string refused{};  // by the system
};

/// Haptic steps of all hands that a late world may leave for later: those of 16 s, 16384 at least.
std::size_t tick_room(double rate, std::size_t hands);

/// Makes a haptic step of all hands at each tick until it is told to stop or one has a fault, then
/// leaves zero force. While paused its time stands still.
/// Thread   [haptic]: what is run on it.
void run_hands(const RtRequest& request, HandThread& hands);

/// Sends zero to all devices while the hands' thread has made no step for so long [s]. A step that
/// hangs in a device keeps its devices: two threads in one driver would be worse than one.
/// Thread   its own, above the hands'.
void watch_hands(double limit, const RtRequest& hands, WorldApart& apart, HandsShared& shared);

}  // namespace thigma::detail
