#pragma once
// A recording of a world made again.

#include <cstddef>
#include <cstdint>
#include <string>

#include "thigma/recording/world_recording.h"
#include "thigma/scene/world_scene.h"
#include "thigma/session/world_session.h"

namespace thigma::app {

/// What came of it, and where it is no longer what was recorded.
struct ReplayedWorld {
  WorldSummary summary;
  std::size_t frames = 0;          // recorded
  bool is_apart = false;           // haptic steps apart from the world were made again as well
  std::int64_t frame = -1;         // of the world, the first that differs; -1: none
  std::int64_t haptic_step = -1;   // likewise, of any hand
  std::uint64_t haptic_steps = 0;  // made again, of all hands
  std::uint64_t lost_steps = 0;    // that were made, after the last that was recorded
  bool is_same = false;
};

/// Makes a recording again and compares every bit.
///
/// path     names it in errors
/// world    its scene as it was, without hands of pages
/// errors   InputError where it is of another scene, or its haptic steps cannot be;
///          DeviceAddressError, DeviceUnavailable
/// Thread   [offline]
ReplayedWorld replay_recorded(const std::string& path, const WorldRecording& recording,
                              LoadedWorld world);

}  // namespace thigma::app
