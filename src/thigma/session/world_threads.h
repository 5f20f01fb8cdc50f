#pragma once
// A world by the clock with its hands on threads of their own.

#include <span>

#include "thigma/session/rt_thread.h"
#include "thigma/session/world_session.h"

namespace thigma {

/// Runs a world by the clock: haptic steps at config.rate on a thread for each hand, whatever a
/// step of the world or another hand's device takes, and in the calling thread the world, a step of
/// 1 / rate for each of them as long as it keeps up. What it is late by is lost to the world, as in
/// run_world_by_clock, and not to the hands. A world that nobody holds has the calling thread
/// alone. A further thread sends zero force where a hand's makes no step for as long as its
/// watchdog says.
///
/// Devices may hold a person: all of docs/safety.md holds for each. A device that owns the clock
/// has its steps in its own thread. A fault of one hand leaves zero force on all.
///
/// The bits of the world are those of run_world for the samples in WorldGrip::device; those of the
/// hands as well come again by replay_world_apart, from WorldShell::ticks.
///
/// config, devices  and errors as of run_world, but for devices that hold a person; also as of
///                  HapticDevice::start_ticks
/// shell            its ticks are not asked for: the hands' threads have the clock. While paused
///                  all stand still, and a step that is asked for is one of each; nothing is paused
///                  where a device holds a person
/// haptic_thread    asked for; what the system refuses stands in WorldSummary::refused
/// Thread           [offline]
WorldSummary run_world_on_threads(const WorldSessionConfig& config,
                                  std::span<HapticDevice* const> devices, const WorldShell& shell,
                                  const RtRequest& haptic_thread = {0, -1});

}  // namespace thigma
