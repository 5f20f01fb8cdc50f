#pragma once
// A recording on the page, in place of a session: shown again at its own pace, with a slider.

#include <functional>
#include <optional>

#include "playback.h"
#include "viewer/server/live_server.h"

#include "thigma/session/session.h"

namespace thigma::app {

/// What shows a recording, and who may end that.
struct LivePlayback {
  live::LiveServer& server;
  Playback& playback;
  SessionConfig config;  // what the recording was made with, on the scene as it is loaded here
  // What pages have asked for and nobody has answered yet; asked about every 10 ms.
  std::function<std::optional<live::LiveRequest>&()> poll;
  std::function<bool()> is_told_to_stop;
};

/// The scene's configuration with what the recording was made with.
SessionConfig recorded_config(const SessionConfig& scene, const RecordedConfig& recorded);

/// Shows the recording until a page asks for something other than moving about in it (the request
/// is left where `poll` has it), or the program is told to stop.
///
/// Thread   [offline]
void show_playback(LivePlayback show);

}  // namespace thigma::app
