#pragma once
// The faults of `--fault`, for tests and demonstrations.

#include <memory>
#include <string_view>
#include <vector>

#include "thigma/device/haptic_device.h"

namespace thigma {

enum class InjectedFault : std::uint8_t {
  unplug,  // the device is lost from then on
  stall,   // the contact thread does nothing for a while
  nan,     // the device answers not-a-number once
  hang,    // the haptic thread does not step for a while
};

struct FaultEvent {
  InjectedFault kind = InjectedFault::unplug;
  double time = 0.0;      // session clock [s]
  double duration = 0.0;  // of stall and hang [s]
};

/// Parses "unplug@2,stall=0.05@3,nan@4,hang=0.03@5". Throws InputError naming what is wrong. Thread
/// [offline].
std::vector<FaultEvent> parse_faults(std::string_view text);

/// Event of this kind that is on at `now`, or null. Thread [haptic].
const FaultEvent* active_fault(const std::vector<FaultEvent>& events, InjectedFault kind,
                               double now) THIGMA_RT;

/// A device with faults: passes through to `inner` until an event says otherwise. inner outlives
/// it. Thread [offline].
std::unique_ptr<HapticDevice> make_faulty_device(HapticDevice& inner,
                                                 const std::vector<FaultEvent>& events);

}  // namespace thigma
