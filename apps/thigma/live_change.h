#pragma once
// What a page asks for, judged and made ready while what runs goes on: only what can be done stops
// it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "live_models.h"
#include "playback.h"
#include "run_options.h"
#include "run_session.h"
#include "viewer/server/live_server.h"

namespace thigma::app {

/// What a granted request changes between two sessions.
struct LiveChange {
  std::unique_ptr<Run> run;            // in place of the one that ran; null: the same
  RunOptions options;                  // of `run`
  std::optional<SceneSession> device;  // for the run that stays
  // of a scene that a page has put together, what its objects are of; empty: of another scene
  std::vector<std::string> sources;
  std::unique_ptr<Playback> playback;  // to be shown; null: a session
  std::string record;                  // file for the session that begins; "" none
  // of that session's device; it goes on from where the object is. 0: none
  live::PageId holder = 0;
};

/// What a request is judged by. All of it stays as it is.
struct LiveNow {
  const Run& run;
  const RunOptions& options;  // of the run
  const DroppedMesh& dropped;
  const SceneDescription& base;   // that compositions begin with: the last that was none
  const SceneDescription& first;  // that the program was started with: no page lifts its limits
  Pose start;                     // of the run, before a device moved it: world_from_body
  std::string record;             // file being written; "" none
  std::uint64_t seed = 1;
  RunHooks hooks;  // progress is there
};

/// Judges a request and makes ready all that it takes: scenes and meshes are loaded, devices
/// opened.
///
/// errors   std::exception, with the reason for people; nothing has changed then
/// Thread   [offline], while a session of now.run may run
LiveChange make_change(const live::LiveRequest& request, const LiveNow& now);

/// Whether a page has sent a recording; else it lies where the user keeps his own.
enum class RecordingFrom { user, page };

/// The same for a recording that is named by its path. One that a page has sent names no file of
/// this machine: it brings its scene, is of the one that runs, or of one of the program.
LiveChange change_to_recording(const std::string& path, RecordingFrom from, const LiveNow& now);

}  // namespace thigma::app
