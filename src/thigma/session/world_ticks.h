#pragma once
// Haptic steps of a world's hands that are apart from it: how they go, and what it takes to make
// them again.

#include <cstdint>
#include <span>

#include "thigma/core/rt.h"
#include "thigma/device/haptic_device.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/math/pose.h"

namespace thigma {

/// A haptic step of a hand: all that went in, and what it sent.
struct HandTick {
  std::int32_t hand = 0;
  std::uint64_t step = 0;  // counts those of the hand, from 0
  HapticTick tick;
  DeviceState device;      // as read
  std::uint64_t news = 0;  // HandNews::sequence of the newest that it had; 0: none
  Wrench sent;             // [N, N m; device frame]
  double energy = 0.0;     // that the hand has put in at its device since the start [J]
};
static_assert(RtPayload<HandTick>);

/// What a frame of the world knew of a hand.
struct HandSeen {
  std::uint64_t read = 0;  // HandNote::frame of the note that its sample is from; 0: none yet
  std::uint64_t told = 0;  // and of the newest when the news of the frame were made
};

/// The haptic steps by a frame of the world, where they are apart from it.
struct WorldHapticNow {
  std::uint64_t ticks = 0;   // of their clocks so far; 0: their steps are the world's
  std::uint64_t missed = 0;  // of them, those without a step of the hand that made the most
  double step_cpu = 0.0;     // of a step, of the processor: longest since the frame before [s]
  std::span<const Wrench> sent{};    // last, by hand [N, N m; device frame]
  std::span<const HandSeen> seen{};  // by hand
};

}  // namespace thigma
