#pragma once
// Recordings of a scene's sessions.

#include <atomic>
#include <string>

#include "thigma/scene/load_scene.h"

namespace thigma {

class RecordingWriter;
struct RecordedConfig;

/// Room for contact models between the threads of a session that is recorded, as its
/// telemetry_models: two seconds at 1 kHz, for a disk that stalls.
inline constexpr std::size_t kRecordedModels = 2048;

/// What a recording says of its session, so that it can be run again.
///
/// is_lockstep  false: on threads
/// Thread       [offline]
RecordedConfig recorded_config(const SceneSession& session, bool is_lockstep);

/// Surfaces of the object and the scene for the pictures of a recording, before its first sample:
/// each at the finest level of at most 20,000 triangles, the coarsest where all have more.
/// Thread  [offline]; IoError.
void record_surfaces(const ContactWorld& world, RecordingWriter& writer);

/// Sinks that write every sample and event. What they throw ends the session.
///
/// writer  outlives the session
SessionSinks recording_sinks(RecordingWriter& writer);

/// run_lockstep into a recording.
///
/// path     of the .mcap file; replaced when the session is over
/// stop     null, or looked at every frame
/// errors   IoError where the file cannot be written
/// Thread   [offline]
SessionSummary record_lockstep(SceneSession& session, const std::string& path,
                               const std::atomic<bool>* stop = nullptr);

}  // namespace thigma
