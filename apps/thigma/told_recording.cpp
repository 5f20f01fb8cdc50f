#include "told_recording.h"

#include "verbs.h"

namespace thigma::app {

std::vector<std::string> recording_warnings(const std::string& path,
                                            const RecordingInfo& recording) {
  std::vector<std::string> lines;
  for (const std::string& warning : recording.warnings) lines.push_back(path + ": " + warning);
  return lines;
}

RecordingInfo stream_recording_told(const std::string& path, const RecordingSinks& sinks,
                                    bool is_quiet) {
  RecordingInfo recording = stream_recording(path, sinks);
  if (is_quiet) return recording;
  for (const std::string& line : recording_warnings(path, recording)) tell_error(line);
  return recording;
}

}  // namespace thigma::app
