#pragma once
// Recordings: what a session did, frame by frame, in an MCAP file; bit for bit, so that it can be
// run again.

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "thigma/loop/samples.h"
#include "thigma/session/session.h"

namespace thigma {

class ByteSource;
class FileWriter;
class McapMessages;
class McapWriter;
struct SamplePlace;  // mcap_place.h
struct McapAttachment;

/// What the end of a session states about itself.
struct RecordingEnd {
  std::uint64_t frames = 0;
  std::uint64_t state_hash = 0;
  // samples that did not fit in the telemetry ring: the recording has gaps
  std::uint64_t dropped = 0;
};

/// A surface as the 3D panel of Foxglove shows it.
struct RecordedSurface {
  std::string id;                                      // a name without quotes, "static 0"
  bool is_object = false;                              // in the frame of the object; else the world
  std::vector<Vec3> positions;                         // [m] (n)
  std::vector<std::array<std::int32_t, 3>> triangles;  // (m)
};

/// Writes a recording. Topics and fields: docs/formats.md.
/// Invariant: PATH appears when close() returns, whole; before that there is PATH.part, locked,
/// which read_recording reads as far as it was flushed: all but the last half second of session
/// time, or less. Thread: one thread, never a real-time one.
/// errors  IoError when the system refuses, once: the file is then closed as well as it can be, the
///         error says where it is and how far it goes, and everything after it does nothing.
class RecordingWriter {
 public:
  /// config: one JSON object, everything needed to run the session again, in the message of
  /// /config.
  RecordingWriter(const std::string& path, const std::string& config);
  // without close(): what was written is kept, without its end; removed without a frame
  ~RecordingWriter();
  RecordingWriter(const RecordingWriter&) = delete;
  RecordingWriter& operator=(const RecordingWriter&) = delete;

  void attach(const McapAttachment& file);     // a file that travels with it
  void write(const RecordedSurface& surface);  // before any sample
  void write(const HapticSample& sample);
  void write(const ContactSample& sample);
  void write(const SessionEvent& event);  // kind and detail are names, without quotes
  void close(const RecordingEnd& end);

  /// Where a recording of this name that a killed session left has been moved, "" without one.
  const std::string& moved() const;

 private:
  template <class Work>
  void attempt(Work work);
  std::string keep_early();
  bool has_frames() const;
  bool is_next_picture(double time, double& last) const;

  std::unique_ptr<McapWriter> file_;
  bool is_open_ = true;
  std::uint16_t config_, device_, command_, body_, timing_, model_, frame_, events_;
  std::uint16_t transforms_, scene_;
  std::uint64_t preface_ = 1;  // messages before the first sample
  std::uint32_t contact_count_ = 0, event_count_ = 0, picture_count_ = 0;
  double radius_ = 0.05;  // of the object, for pictures [m]
  // of the last pictures, of the frames and of the contacts [s]
  double last_picture_ = -1.0, last_contacts_ = -1.0;
  double last_time_ = 0.0;
  std::string text_;
};

/// What a recording says beside its samples.
struct RecordingInfo {
  std::string config;                // the JSON of /config
  std::vector<SessionEvent> events;  // without the end
  RecordingEnd end;
  bool has_end = false;  // false: the session went on
  std::string cut_off;   // where and why the file ends before it should; "" for a whole one
  std::vector<std::string> warnings;                 // cut_off among them
  std::uint64_t frame_count = 0, contact_count = 0;  // samples in it
  double last_time = 0.0;                            // of the last frame [s]
};

/// A recording in memory.
struct Recording : RecordingInfo {
  std::vector<HapticSample> frames;  // with the digests as recorded
  std::vector<ContactSample> contacts;
};

/// What samples are told to while a recording is read; any may be empty.
struct RecordingSinks {
  /// The JSON of /config, before anything else of what a session writes; false: no more is wanted.
  std::function<bool(const std::string& config)> config{};
  std::function<void(const HapticSample&, const SamplePlace&)> frame{};
  std::function<void(const ContactSample&, const SamplePlace&)> contact{};
};

/// Goes through a recording of any size once, in little memory. One that a kill, a power cut or a
/// full disk cut off is read up to its last whole frame.
/// Thread [offline]; throws InputError "FILE: what, where, what was expected" for anything that is
/// not one, maybe after some samples were told.
RecordingInfo stream_recording(const std::string& path, const RecordingSinks& sinks);
RecordingInfo stream_recording(ByteSource& source, const std::string& path,
                               const RecordingSinks& sinks);

/// What is wrong with a recording, a line each, for people.
std::vector<std::string> recording_warnings(const std::string& path, const RecordingInfo& info);

/// The same into memory: a small recording.
Recording read_recording(const std::string& path);
Recording read_recording(ByteSource& source, const std::string& path);

/// A sample once more, from where a pass over the source of `messages` found it.
/// Thread [offline]; throws InputError, or an exception of the JSON parser, where the file has
/// changed.
HapticSample read_frame_at(McapMessages& messages, const SamplePlace& place);
ContactSample read_contact_at(McapMessages& messages, const SamplePlace& place);

/// Hashes and digests as they stand in files and summaries: 16 hexadecimal digits.
std::string hex_text(std::uint64_t bits);

/// Writes a recording as CSV, one row a haptic frame, units in the header.
/// Thread [offline]; throws IoError; the file is whole or absent.
void export_csv(const Recording& recording, const std::string& path);

/// The same frame by frame.
class CsvExport {
 public:
  explicit CsvExport(const std::string& path);
  ~CsvExport();
  CsvExport(const CsvExport&) = delete;
  CsvExport& operator=(const CsvExport&) = delete;
  void add(const HapticSample& sample);
  void keep();  // without it nothing is left

 private:
  std::unique_ptr<FileWriter> file_;
  std::string rows_;
};

}  // namespace thigma
