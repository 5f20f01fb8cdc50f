#pragma once
// Recordings of worlds of several bodies: poses and momenta of all, bit for bit.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "thigma/dynamics/body.h"
#include "thigma/math/pose.h"

namespace thigma {

class McapWriter;

/// What a recording of a world says of its session.
struct WorldRecordingInfo {
  std::string scene;                 // file or built-in name
  std::vector<std::string> devices;  // addresses
  std::uint64_t seed = 1;
  double rate = 1000.0;             // [Hz]
  std::optional<double> friction;   // of every body, where the scene's own was not used
  std::vector<std::string> bodies;  // names
  std::vector<std::string> joints;  // likewise
  std::uint64_t frames = 0;         // at the end
  std::uint64_t state_hash = 0;     // likewise
  bool has_end = false;
};

/// What a recording says of a joint in a frame.
struct RecordedJoint {
  double coordinate = 0.0;                        // [m, rad]
  double spring = 0.0, motor = 0.0, limit = 0.0;  // along it [N, N m]
};

/// Writes one. Topics: /config, /body/NAME/state for each body, /joint/NAME/state for each joint,
/// /device/command of the first device, /device/2/command and so on of others, /events.
/// Thread: one, [offline]. Members throw IoError.
class WorldRecordingWriter {
 public:
  WorldRecordingWriter(const std::string& path, const WorldRecordingInfo& info);
  ~WorldRecordingWriter();
  WorldRecordingWriter(const WorldRecordingWriter&) = delete;
  WorldRecordingWriter& operator=(const WorldRecordingWriter&) = delete;

  /// bodies   as many as names
  /// joints   likewise
  /// commands sent to the devices, likewise
  void write(std::uint64_t frame, double time, std::span<const BodyState> bodies,
             std::span<const RecordedJoint> joints, std::span<const Wrench> commands);
  void close(std::uint64_t frames, std::uint64_t state_hash);

 private:
  std::unique_ptr<McapWriter> file_;
  std::vector<std::uint16_t> bodies_, joints_, commands_;
  std::uint16_t events_ = 0;
  std::string text_;
};

/// A recording in memory: all bodies of a frame one after the other.
struct WorldRecording : WorldRecordingInfo {
  std::vector<BodyState> states;  // frames x bodies
};

/// Whether a file is a recording of a world. False for what cannot be read.
/// Thread [offline].
bool is_world_recording(const std::string& path);

/// Reads one.
/// Thread [offline]; throws InputError "FILE: what, where, what was expected".
WorldRecording read_world_recording(const std::string& path);

}  // namespace thigma
