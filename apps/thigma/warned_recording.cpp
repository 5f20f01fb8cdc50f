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

}  // namespace thigma::app
