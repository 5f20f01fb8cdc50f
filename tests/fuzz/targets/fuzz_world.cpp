// Recordings of worlds of several bodies: the reader, and all that replay does with what it read.

#include <algorithm>
#include <cmath>

#include "fuzz/fuzz_target.h"
#include "fuzz/small_world.h"
#include "replay_world.h"

#include "thigma/recording/world_recording.h"

namespace thigma::fuzz {
namespace {

void check(const WorldRecording& recording) {
  require(!recording.bodies.empty(), "it has bodies");
  require(recording.states.size() % recording.bodies.size() == 0, "frames are whole");
  require(recording.rate >= 50.0 && recording.rate <= 20000.0, "the rate is in range");
  const std::size_t devices = recording.devices.size();
  require(recording.hands.size() == devices && recording.ticks.size() == devices,
          "each device has a hand");
  require(recording.haptic_steps.empty() || recording.haptic_steps.size() == devices,
          "haptic steps are those of each device");
  for (std::size_t i = 0; i < devices; ++i) {
    const std::vector<HandTick>& ticks = recording.ticks[i];
    for (std::size_t n = 0; n < ticks.size(); ++n) {
      require(ticks[n].hand == static_cast<std::int32_t>(i) && ticks[n].step == n,
              "haptic steps are in order");
      require(std::isfinite(ticks[n].tick.now) && ticks[n].tick.elapsed >= 0.0, "times are times");
      require(n == 0 || ticks[n].tick.now >= ticks[n - 1].tick.now, "time does not go back");
    }
  }
}

/// Addresses open what they name: of what was made up only simulated hands and pages.
bool may_open(const WorldRecording& recording) {
  constexpr const char* kMay[] = {"hand:", "hand:?path=press", "null:", "web:"};
  return std::all_of(recording.devices.begin(), recording.devices.end(), [&](const auto& address) {
    return std::find(std::begin(kMay), std::end(kMay), address) != std::end(kMay);
  });
}

}  // namespace

void fuzz_world(Bytes bytes) {
  WorldRecording recording;
  if (!is_taken("file",
                [&] { recording = parse_world_recording(std::string(text_of(bytes)), "file"); }))
    return;
  check(recording);
  constexpr std::size_t kFew = 20;     // frames
  constexpr std::uint32_t kShare = 4;  // to replay takes several times what reading does
  const std::size_t frames = recording.states.size() / recording.bodies.size();
  if (!may_open(recording) || frames > kFew || !is_one_of(kShare, bytes)) return;
  app::ReplayedWorld made;
  recording.scene = "file";  // refusals of another scene name it
  const bool is_made = is_taken("file", [&] {
    made = app::replay_recorded("file", recording, small_world(recording.rate, recording.friction));
  });
  if (!is_made) return;
  require(made.summary.frames <= frames, "no more frames than were recorded are made");
  require(!made.is_same || (made.frame < 0 && made.haptic_step < 0 && made.lost_steps == 0),
          "what differs is not the same");
  for (std::size_t i = 0; i < recording.haptic_steps.size(); ++i)
    require(!made.is_same || recording.haptic_steps[i] <= recording.ticks[i].size(),
            "what lacks haptic steps is not the same");
}

}  // namespace thigma::fuzz
