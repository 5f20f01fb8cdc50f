#pragma once
// Recordings of worlds as `thigma run` writes them, and the hands of pages when they are replayed.

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "thigma/recording/world_recording.h"
#include "thigma/scene/world_scene.h"
#include "thigma/session/world_replay.h"

namespace thigma::app {

/// What a recording says beside its frames.
struct WorldRecorderInfo {
  std::string scene;                 // as the command line names it
  std::vector<std::string> devices;  // addresses, by hand
  std::uint64_t seed = 1;
  std::optional<double> friction;      // of every body, instead of the scene's
  bool is_apart = false;               // haptic steps are apart from the world's
  std::vector<DeviceLimits> limits{};  // by hand, where they are
};

/// Of all devices that are there, one a hand.
std::vector<DeviceLimits> limits_of(const std::vector<HapticDevice*>& devices);

/// Writes every frame. Thread: one. Members throw IoError.
class WorldRecorder {
 public:
  WorldRecorder(const std::string& path, const LoadedWorld& world, const WorldRecorderInfo& info);
  void write(const WorldFrame& frame);
  void write(std::span<const HandTick> ticks) { writer_.write(ticks); }
  /// Says how many haptic steps there were, so that those left out at the end are known.
  void close(const WorldSummary& summary);

 private:
  WorldRecordingWriter writer_;
  std::vector<RecordedJoint> joints_;
  std::vector<RecordedHand> hands_;
};

/// Gives every body this friction instead of its own.
void use_friction(double friction, WorldSceneDescription& scene);

/// What a recording has of hands that are apart from their world.
RecordedApart apart_of(const WorldRecording& recording);

/// Gives a world the hands that its recording has of pages; the scene knows nothing of them.
void add_recorded_hands(const std::vector<std::string>& devices, LoadedWorld& world);

/// A page's hand as it was: what it said, frame by frame, with the limits of `web:`.
std::unique_ptr<HapticDevice> recorded_hand(const std::vector<RecordedHand>& samples);

}  // namespace thigma::app
