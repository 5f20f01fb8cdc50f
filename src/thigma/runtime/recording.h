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
/// Invariant: PATH appears when close() returns, whole; before that there is PATH.part, locked, which read_recording
/// reads as far as it was flushed: all but the last half second of session time, or less.
/// Thread: one thread, never a real-time one.
/// errors  IoError when the system refuses, once: the file is then closed as well as it can be, the error says where
/// it is and how far it goes, and everything after it does nothing.
class RecordingWriter {
 public:
  /// config: one JSON object, everything needed to run the session again, in the message of /config.
  RecordingWriter(const std::string& path, const std::string& config);
  ~RecordingWriter();  // without close(): what was written is kept, without its end; removed without a frame
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  void write(const HapticSample& sample);
  void write(const ContactSample& sample);
  void write(const SessionEvent& event);  // kind and detail are names, without quotes
  void close(const RecordingEnd& end);

  /// Where a recording of this name that a killed session left has been moved, "" without one.
  const std::string& moved() const { return file_.moved(); }

 private:
  template <class Work>
  void attempt(Work work);
  std::string keep_early();
  bool has_frames() const;

  McapWriter file_;
  bool is_open_ = true;
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
  bool has_end = false;  // false: the session went on
  std::string cut_off;   // where and why the file ends before it should; "" for a whole one
  std::vector<std::string> warnings;  // cut_off among them
};

/// Reads a recording. One that a kill, a power cut or a full disk cut off is read up to its last whole frame.
/// Thread [offline]; throws InputError "FILE: what, where, what was expected" for anything that is not one.
Recording read_recording(const std::string& path);

/// Hashes and digests as they stand in files and summaries: 16 hexadecimal digits.
std::string hex_text(std::uint64_t bits);

/// Writes a recording as CSV, one row a haptic frame, units in the header.
/// Thread [offline]; throws IoError; the file is whole or absent.
void export_csv(const Recording& recording, const std::string& path);

}  // namespace thigma
