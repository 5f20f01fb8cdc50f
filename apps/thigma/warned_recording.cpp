#include "warned_recording.h"

#include "verbs.h"

namespace thigma::app {

RecordingInfo stream_recording_warned(const std::string& path, const RecordingSinks& sinks,
                                      bool is_quiet) {
  RecordingInfo recording = stream_recording(path, sinks);
  if (is_quiet) return recording;
  for (const std::string& line : recording_warnings(path, recording)) print_error(line);
  return recording;
}

WorldRecordingPass stream_world_warned(const std::string& path, const WorldRecordingSinks& sinks,
                                       bool is_quiet) {
  WorldRecordingPass pass = stream_world_recording(path, sinks);
  for (const std::string& warning : pass.warnings)
    if (!is_quiet) print_error(path + ": " + warning);
  return pass;
}

}  // namespace thigma::app
