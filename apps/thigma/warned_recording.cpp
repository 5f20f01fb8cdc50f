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

namespace {

void warn(const std::string& path, const std::vector<std::string>& warnings, bool is_quiet) {
  for (const std::string& warning : warnings)
    if (!is_quiet) print_error(path + ": " + warning);
}

}  // namespace

WorldRecordingPass stream_world_warned(const std::string& path, const WorldRecordingSinks& sinks,
                                       bool is_quiet) {
  WorldRecordingPass pass = stream_world_recording(path, sinks);
  warn(path, pass.warnings, is_quiet);
  return pass;
}

WorldRecording read_world_warned(const std::string& path, bool is_quiet) {
  WorldRecording recording = read_world_recording(path);
  warn(path, recording.warnings, is_quiet);
  return recording;
}

}  // namespace thigma::app
