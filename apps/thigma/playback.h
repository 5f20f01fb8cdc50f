#pragma once
// A recording as the page shows it: samples in their order and at their pace, from any time on.

#include <cstddef>
#include <string>
#include <vector>

#include "run_options.h"

#include "thigma/files/byte_source.h"
#include "thigma/recording/config_json.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"
#include "thigma/session/session.h"

namespace thigma::app {

/// Where in a recording the page is. Holds some 50 bytes a frame; samples are read from the file
/// when they are sent. Thread: any one.
class Playback {
 public:
  /// errors   InputError for what is no recording, or one without a frame
  explicit Playback(const std::string& path);
  Playback(const Playback&) = delete;  // messages are read from its own source
  Playback& operator=(const Playback&) = delete;

  const std::string& file() const { return file_; }
  const RecordingInfo& recording() const { return recording_; }
  const RecordedConfig& config() const { return config_; }
  double seconds() const;  // time of the last frame [s]
  double time() const;     // of the newest frame that was sent [s]
  /// The largest force on the hand in each of so many equally long parts [N].
  std::vector<float> force_strip(std::size_t parts) const;
  bool is_over() const { return next_ >= frames_.size(); }
  /// The newest frame that was sent; the first before any was.
  const HapticSample& frame() const { return frame_; }

  /// Sends `sinks` everything up to `time`, at most `most` frames.
  void advance_to(double time, std::size_t most, const SessionSinks& sinks);
  /// The same up to `time`, forgetting what was sent: frames of the ten seconds before it, thinned
  /// to what pages take at once, after those in which the object was last taken hold of.
  void jump_to(double time, const SessionSinks& sinks);

 private:
  struct FrameEntry {
    double time;  // [s]
    float force;  // on the hand [N]
    bool is_grasped;
    SamplePlace place;
  };
  struct ContactEntry {
    double time;  // [s]
    SamplePlace place;
  };

  void send_contacts(double time, const SessionSinks& sinks);
  void send_frame(std::size_t index, const SessionSinks& sinks);
  void send_history(std::size_t begin, std::size_t end, const SessionSinks& sinks);
  HapticSample read(std::size_t index);

  std::string file_;
  FileSource source_;
  McapMessages messages_{source_};
  RecordingInfo recording_;
  RecordedConfig config_;
  std::vector<FrameEntry> frames_;
  std::vector<ContactEntry> contacts_;
  HapticSample frame_;
  std::size_t next_ = 0, next_contact_ = 0, next_event_ = 0;
};

/// Names the scene of options.replay where the options name none.
/// Thread [offline]; InputError for what is no recording, or one of two meshes given on the command
/// line.
/// and its response, see use_recorded_response.
void use_recorded_scene(RunOptions& options);

/// Whether contacts are constraints decides what surfaces are loaded: a recording is shown with the
/// response it was made with, where the options name none. The direct one belongs to its device.
void use_recorded_response(ResponseKind recorded, RunOptions& options);

}  // namespace thigma::app
