#pragma once
// Hands apart from their world, made again from what their steps had.

#include <functional>
#include <span>
#include <vector>

#include "thigma/session/world_session.h"
#include "thigma/session/world_ticks.h"

namespace thigma {

/// What was recorded of hands apart from their world.
struct RecordedApart {
  std::vector<std::vector<HandTick>> ticks;  // by hand; none: nobody held it
  std::vector<std::vector<HandSeen>> seen;   // by hand, one a frame of the world
};

/// What is looked at while they are made again; each may be empty.
struct ReplayWatch {
  std::function<void(std::uint64_t frame, WorldRun&)> between{};  // before a frame of the world
  std::function<void(const WorldFrame&)> world{};
  std::function<void(const HandTick&)> haptic{};  // as made now
};

/// Makes a session of run_world_on_threads again, in one thread: each haptic step with the sample
/// and the news that it had, each step of the world with the notes that it had. The same bits, of
/// the world and of what was sent to each device. It ends where a frame had notes beyond the last
/// haptic step: so far was recorded.
///
/// config    constant; its duration is that of the frames of the world
/// limits    of the devices, by hand
/// recorded  outlives the call
/// errors    InputError where a step has what was not there yet, or a hand has too few frames; also
///           as of run_world
/// Thread    [offline]
WorldSummary replay_world_apart(const WorldSessionConfig& config,
                                std::span<const DeviceLimits> limits, const RecordedApart& recorded,
                                const ReplayWatch& watch = {});

}  // namespace thigma
