#pragma once
// Runs scenes of several moving bodies, and replays their recordings.

#include <atomic>
#include <string>

#include "run_options.h"
#include "verbs.h"

namespace thigma::app {

/// `thigma run` of a scene with [[body]]: by the clock, with its page or without, or in lockstep.
/// Returns the exit code.
/// errors  InputError, DeviceAddressError, DeviceUnavailable, IoError, PortUnavailable
int run_world_scene(const RunOptions& options, const Common& common, const std::atomic<bool>& stop);

/// `thigma replay` of a recording of a world: runs its scene again and compares every bit.
int replay_world(const std::string& path, const Common& common);

}  // namespace thigma::app
