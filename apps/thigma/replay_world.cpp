#include "replay_world.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "json_out.h"
#include "named_scene.h"
#include "run_world.h"
#include "warned_recording.h"
#include "world_recorder.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/device/web_device.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/replay_session.h"
#include "thigma/recording/world_recording.h"
#include "thigma/scene/packed_scene.h"
#include "thigma/scene/packed_world.h"
#include "thigma/scene/world_scene.h"
#include "thigma/session/world_replay.h"

namespace thigma::app {
namespace {

void check_count(const WorldRecording& recording, std::size_t has, std::size_t recorded,
                 const char* what) {
  if (has == recorded) return;
  throw InputError(recording.scene + ": has " + std::to_string(has) + " " + what +
                   ", expected the " + std::to_string(recorded) + " that were recorded");
}

/// Frames at the end of what was cut off whose haptic steps it may lack: steps are written after
/// their frame, and a frame may have had the note of a step that is written after the next.
constexpr std::size_t kLastFrames = 2;

/// Refuses hands apart whose haptic steps are not there.
void check_haptic_steps(const std::string& path, const WorldRecording& recording,
                        std::size_t frames) {
  for (std::size_t i = 0; i < recording.ticks.size(); ++i) {
    if (!recording.ticks[i].empty()) continue;
    const bool is_cut = !recording.has_end && frames <= kLastFrames;
    const std::string why = is_cut ? ": it was cut off before the first" : "";
    throw InputError(path + ": has no haptic step of hand " + std::to_string(i + 1) + why +
                     ", expected those of hands apart from their world");
  }
}

/// The scene as it was recorded: the one that the recording brings; of older ones by its name.
LoadedWorld load_recorded(const std::string& path, const WorldRecording& recording) {
  WorldSceneDescription scene = has_packed_scene(path) ? read_packed_world(path, scratch_folder())
                                                       : read_world_scene(recording.scene);
  scene.rate = recording.rate;
  if (recording.friction) use_friction(*recording.friction, scene);
  return load_world(std::move(scene));
}

/// Gives it the frames and hands that were recorded.
void prepare(const WorldRecording& recording, LoadedWorld& world) {
  const std::size_t bodies = recording.bodies.size();
  check_count(recording, world.config.world.bodies.size(), bodies, "bodies");
  check_count(recording, world.config.world.joints.size(), recording.joints.size(), "joints");
  const std::size_t frames = recording.states.size() / bodies;
  // A session without a duration would have no end: of no frame it is less than half of one.
  constexpr double kNone = 0.25;
  world.config.duration = (frames > 0 ? static_cast<double>(frames) : kNone) / recording.rate;
  add_recorded_hands(recording.devices, world);
  use_clutches(recording.devices, world);
  check_count(recording, world.config.hands.size(), recording.devices.size(), "hands");
}

/// Where what is made again is no longer what was recorded.
struct Differences {
  const WorldRecording& recording;
  std::int64_t frame = -1;         // of the world, the first; -1: none
  std::int64_t haptic_step = -1;   // likewise, of any hand
  std::uint64_t haptic_steps = 0;  // made again, of all hands

  void compare(const WorldFrame& now) {
    const std::size_t bodies = recording.bodies.size();
    for (std::size_t i = 0; i < bodies && frame < 0; ++i) {
      const std::size_t at = now.frame * bodies + i;
      if (at < recording.states.size() && !same_bits(recording.states[at], now.bodies[i]))
        frame = static_cast<std::int64_t>(now.frame);
    }
  }
  void compare(const HandTick& now) {
    ++haptic_steps;
    const HandTick& then = recording.ticks[static_cast<std::size_t>(now.hand)][now.step];
    const bool is_same = same_bits(then.sent, now.sent);
    if (!is_same && haptic_step < 0) haptic_step = static_cast<std::int64_t>(now.step);
  }
};

/// Aims a page's hand at what it was aimed at before the frame that comes.
void aim_as_recorded(const WorldRecording& recording, std::uint64_t frame, WorldRun& run) {
  for (const std::vector<RecordedHand>& hand : recording.hands)
    if (frame < hand.size() && hand[frame].aimed) run.aim(*hand[frame].aimed);
}

/// The one loop.
WorldSummary run_again(const WorldRecording& recording, const LoadedWorld& world,
                       Differences& found) {
  WorldDevices devices = open_world_devices(world, recording.devices, recording.seed);
  for (std::size_t i = 0; i < devices.list.size(); ++i) {
    if (devices.list[i] != nullptr) continue;
    devices.owned.push_back(recorded_hand(recording.hands[i]));
    devices.list[i] = devices.owned.back().get();
  }
  WorldRun run(world.config, devices.list);
  for (std::uint64_t i = 0;; ++i) {
    aim_as_recorded(recording, i, run);
    const WorldFrame* frame = run.make_frame();
    if (frame == nullptr) break;
    found.compare(*frame);
  }
  return run.end();
}

/// Of the devices that were apart from the world: as recorded, and nothing is opened. Older
/// recordings do not tell, and have none but simulated ones and pages.
std::vector<DeviceLimits> recorded_limits(const WorldRecording& recording,
                                          const LoadedWorld& world) {
  if (!recording.limits.empty()) return recording.limits;
  const WorldDevices devices = open_world_devices(world, recording.devices, recording.seed);
  WebDeviceChannel link;
  const DeviceLimits page = make_web_device(link)->limits();
  std::vector<DeviceLimits> limits;
  for (const HapticDevice* device : devices.list)
    limits.push_back(device != nullptr ? device->limits() : page);
  return limits;
}

/// Hands apart from the world: their steps as well.
WorldSummary run_apart_again(const std::string& path, const WorldRecording& recording,
                             const LoadedWorld& world, Differences& found) {
  const std::vector<DeviceLimits> limits = recorded_limits(recording, world);
  ReplayWatch watch;
  watch.between = [&](std::uint64_t frame, WorldRun& run) {
    aim_as_recorded(recording, frame, run);
  };
  watch.world = [&](const WorldFrame& frame) { found.compare(frame); };
  watch.haptic = [&](const HandTick& tick) { found.compare(tick); };
  try {
    return replay_world_apart(world.config, limits, apart_of(recording), watch);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

/// Haptic steps that were made and are not there. A recording that was cut off does not tell.
std::uint64_t lost_steps(const WorldRecording& recording) {
  std::uint64_t lost = 0;
  for (std::size_t i = 0; i < recording.haptic_steps.size(); ++i)
    lost += recording.haptic_steps[i] -
            std::min<std::uint64_t>(recording.ticks[i].size(), recording.haptic_steps[i]);
  return lost;
}

}  // namespace

ReplayedWorld replay_recorded(const std::string& path, const WorldRecording& recording,
                              LoadedWorld world) {
  prepare(recording, world);
  const std::size_t frames = recording.states.size() / recording.bodies.size();
  ReplayedWorld made;
  made.frames = frames;
  made.is_apart = recording.is_apart && !recording.devices.empty();
  if (made.is_apart && frames > 0) check_haptic_steps(path, recording, frames);
  Differences found{recording};
  made.summary = made.is_apart ? run_apart_again(path, recording, world, found)
                               : run_again(recording, world, found);
  const std::uint64_t again = made.summary.frames;
  const bool is_shorter = made.is_apart && !recording.has_end && again > 0 && again < frames &&
                          frames - again <= kLastFrames;
  if (found.frame < 0 && again != frames && !is_shorter)
    found.frame = static_cast<std::int64_t>(again);
  made.frame = found.frame;
  made.haptic_step = found.haptic_step;
  made.haptic_steps = found.haptic_steps;
  made.lost_steps = lost_steps(recording);
  made.is_same = found.frame < 0 && found.haptic_step < 0 && made.lost_steps == 0 &&
                 (!recording.has_end || made.summary.state_hash == recording.state_hash);
  return made;
}

int replay_world(const std::string& path, const Common& common) {
  const WorldRecording recording = read_world_warned(path, common.quiet);
  const ReplayedWorld made = replay_recorded(path, recording, load_recorded(path, recording));
  nlohmann::ordered_json json;
  json["frames"] = made.summary.frames;
  json["recorded_frames"] = made.frames;
  json["state_hash"] = hex_text(made.summary.state_hash);
  json["recorded_hash"] = nullptr;
  if (recording.has_end) json["recorded_hash"] = hex_text(recording.state_hash);
  json["identical"] = made.is_same;
  json["cut_off"] = nullptr;
  if (!recording.cut_off.empty()) json["cut_off"] = recording.cut_off;
  json["first_difference"] = nullptr;
  if (made.frame >= 0) json["first_difference"] = made.frame;
  json["haptic"] = nullptr;
  if (made.is_apart) {
    json["haptic"] = {
        {"frames", made.haptic_steps}, {"first_difference", nullptr}, {"lost", made.lost_steps}};
    if (made.haptic_step >= 0) json["haptic"]["first_difference"] = made.haptic_step;
  }
  const std::string lost = made.lost_steps == 0 ? ""
                                                : ", " + std::to_string(made.lost_steps) +
                                                      " haptic steps at the end were not recorded";
  if (common.json)
    print_json(json);
  else
    std::printf("%llu frames of %zu recorded, of %zu bodies, state hash %s: %s%s\n",
                static_cast<unsigned long long>(made.summary.frames), made.frames,
                recording.bodies.size(), hex_text(made.summary.state_hash).c_str(),
                made.is_same ? "identical" : "different", lost.c_str());
  return made.is_same ? kDone : kClaimFails;
}

}  // namespace thigma::app
