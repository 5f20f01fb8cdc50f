#pragma once
// A world by the clock with its hands on a thread of their own.

#include <span>

#include "thigma/session/rt_thread.h"
#include "thigma/session/world_session.h"

namespace thigma {

/// Runs a world by the clock on two threads: haptic steps at config.rate, whatever a step of the
/// world takes, and in the calling thread the world, a step of 1 / rate for each of them as long as
/// it keeps up. What it is late by is lost to the world, as in run_world_by_clock, and not to the
/// hands. A world that nobody holds has the calling thread alone.
///
/// The bits of the world are those of run_world for the samples in WorldGrip::device, so recordings
/// replay.
///
/// config, devices  and errors as of run_world
/// shell            its sink, stop and between; a world that is live on a page has the one loop
/// haptic_thread    asked for; what the system refuses stands in WorldSummary::refused
/// Thread           [offline]
WorldSummary run_world_on_threads(const WorldSessionConfig& config,
                                  std::span<HapticDevice* const> devices, const WorldShell& shell,
                                  const RtRequest& haptic_thread = {0, -1});

}  // namespace thigma
