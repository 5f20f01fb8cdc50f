#include "told_recording.h"

#include "verbs.h"

namespace thigma::app {

std::vector<std::string> recording_warnings(const std::string& path, const Recording& recording) {
  std::vector<std::string> lines;
  for (const std::string& warning : recording.warnings) lines.push_back(path + ": " + warning);
  return lines;
}

Recording read_recording_told(const std::string& path, bool is_quiet) {
  Recording recording = read_recording(path);
  if (is_quiet) return recording;
  for (const std::string& line : recording_warnings(path, recording)) tell_error(line);
  return recording;
}

}  // namespace thigma::app
