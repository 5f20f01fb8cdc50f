#pragma once
// A world by the clock with its hands on a thread of their own.

#include <span>

#include "thigma/session/rt_thread.h"
#include "thigma/session/world_session.h"

namespace thigma {

/// Runs a world by the clock on two threads: haptic steps at config.rate, whatever a step of the
/// world takes, and in the calling thread the world, a step of 1 / rate for each of them as long as
/// it keeps up. What it is late by is lost to the world, as in run_world_by_clock, and not to the
/// hands. A world that nobody holds has the calling thread alone. A third thread sends zero force
/// where the hands' thread makes no step for as long as their watchdog says.
///
/// The bits of the world are those of run_world for the samples in WorldGrip::device; those of the
/// hands as well come again by replay_world_apart, from WorldShell::ticks.
///
/// config, devices  and errors as of run_world
/// shell            its ticks are not asked for: the hands' thread has the clock. While paused both
///                  stand still, and a step that is asked for is one of each
/// haptic_thread    asked for; what the system refuses stands in WorldSummary::refused
/// Thread           [offline]
WorldSummary run_world_on_threads(const WorldSessionConfig& config,
                                  std::span<HapticDevice* const> devices, const WorldShell& shell,
                                  const RtRequest& haptic_thread = {0, -1});

}  // namespace thigma
