#pragma once
// Recordings as the verbs read them.

#include <string>

#include "thigma/recording/recording.h"
#include "thigma/recording/world_frames.h"

namespace thigma::app {

/// Goes through a recording and prints what is wrong with it on standard error, a line each, unless
/// quiet.
/// Thread   [offline]; as stream_recording.
RecordingInfo stream_recording_warned(const std::string& path, const RecordingSinks& sinks,
                                      bool is_quiet);

/// The same of a world's, frame by frame or all of it.
WorldRecordingPass stream_world_warned(const std::string& path, const WorldRecordingSinks& sinks,
                                       bool is_quiet);
WorldRecording read_world_warned(const std::string& path, bool is_quiet);

}  // namespace thigma::app
