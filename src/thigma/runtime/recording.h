#pragma once
// Recordings: what a session did, frame by frame, in an MCAP file; bit for bit, so that it can be run again.

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "thigma/runtime/mcap_file.h"
#include "thigma/runtime/session.h"
#include "thigma/runtime/telemetry.h"

namespace thigma {

/// What the end of a session states about itself.
struct RecordingEnd {
  std::uint64_t frames = 0;
  std::uint64_t state_hash = 0;
  std::uint64_t dropped =
      0;  // samples that did not fit in the telemetry ring: the recording has gaps
};

/// Writes a recording. Topics and fields: docs/formats.md.
/// Invariant: PATH appears when close() returns, whole; before that there is PATH.part.
/// Thread: one thread, never a real-time one. Members throw IoError when the system refuses.
class RecordingWriter {
 public:
  /// config: one JSON object, everything needed to run the session again, in the message of /config.
  RecordingWriter(const std::string& path, const std::string& config);

  void write(const HapticSample& sample);
  void write(const ContactSample& sample);
  void write(const SessionEvent& event);  // kind and detail are names, without quotes
  void close(const RecordingEnd& end);

 private:
  McapWriter file_;
  std::uint16_t config_, device_, command_, body_, timing_, model_, frame_, events_;
  std::uint32_t contact_count_ = 0, event_count_ = 0;
  double last_time_ = 0.0;
  std::string text_;
};

/// A recording in memory.
struct Recording {
  std::string config;                // the JSON of /config
  std::vector<HapticSample> frames;  // with the digests as recorded
  std::vector<ContactSample> contacts;
  std::vector<SessionEvent> events;  // without the end
  RecordingEnd end;
  bool has_end = false;  // false: the session was cut off
  std::vector<std::string> warnings;
};

/// Reads a recording.
/// Thread [offline]; throws InputError "FILE: what, where, what was expected" for anything that is not one.
Recording read_recording(const std::string& path);

/// Hashes and digests as they stand in files and summaries: 16 hexadecimal digits.
std::string hex_text(std::uint64_t bits);

/// Writes a recording as CSV, one row a haptic frame, units in the header.
/// Thread [offline]; throws IoError; the file is whole or absent.
void export_csv(const Recording& recording, const std::string& path);

}  // namespace thigma
