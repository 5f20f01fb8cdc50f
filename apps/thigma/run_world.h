#pragma once
// Runs scenes of several moving bodies, and replays their recordings.

#include <atomic>
#include <string>
#include <vector>

#include "run_options.h"
#include "verbs.h"

#include "thigma/scene/world_scene.h"

namespace thigma::app {

/// `thigma run` of a scene with [[body]]: by the clock, with its page or without, or in lockstep.
/// Returns the exit code.
/// errors  InputError, DeviceAddressError, DeviceUnavailable, IoError, PortUnavailable
int run_world_scene(const RunOptions& options, const Common& common, const std::atomic<bool>& stop);

/// Where a device of a session by the clock holds a person: locks the memory of the process, says
/// what the system refuses and which devices are slow.
/// uris   addresses, by hand
/// log    for people; may be empty
void prepare_for_people(const WorldDevices& devices, const std::vector<std::string>& uris,
                        double rate, const Log& log);

/// `thigma replay` of a recording of a world: runs its scene again and compares every bit.
int replay_world(const std::string& path, const Common& common);

}  // namespace thigma::app
