#pragma once
// Recordings of worlds of several bodies: poses and momenta of all, bit for bit.

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "thigma/device/haptic_device.h"
#include "thigma/dynamics/body.h"
#include "thigma/math/pose.h"
#include "thigma/session/live_ports.h"
#include "thigma/session/world_ticks.h"

namespace thigma {

class McapWriter;
struct McapAttachment;

/// What a recording of a world says of its session.
struct WorldRecordingInfo {
  std::string scene;                 // file or built-in name
  std::vector<std::string> devices;  // addresses
  std::uint64_t seed = 1;
  double rate = 1000.0;             // [Hz]
  std::optional<double> friction;   // of every body, where the scene's own was not used
  std::vector<std::string> bodies;  // names
  std::vector<std::string> joints;  // likewise
  bool is_apart = false;  // haptic steps are apart from the world's, and are recorded by themselves
  // of the devices, where they are apart: what they are replayed with, so that none is opened.
  // Older recordings have none.
  std::vector<DeviceLimits> limits{};
  std::uint64_t frames = 0;      // at the end
  std::uint64_t state_hash = 0;  // likewise
  // likewise, where they are apart: made by each device's hand; empty: it does not say
  std::vector<std::uint64_t> haptic_steps{};
  bool has_end = false;
};

/// What a recording says of a joint in a frame.
struct RecordedJoint {
  double coordinate = 0.0;                        // [m, rad]
  double spring = 0.0, motor = 0.0, limit = 0.0;  // along it [N, N m]
};

/// What the world read of a hand, and what it was aimed at before that, if anew. It has to come
/// again of a page's, which no address can open, and of any that is apart from its world.
struct RecordedHand {
  DeviceState device;
  std::optional<WorldAim> aimed;
  HandSeen seen{};  // of one that is apart
  // that it has put into the world since the start; not a number: not recorded [J]
  double energy = std::numeric_limits<double>::quiet_NaN();
};

/// Whether a device of a recording is a page's hand, whose samples it has always. Thread: any.
bool is_page_hand(const std::string& address);

/// Writes one. Topics: /config, /body/NAME/state for each body, /joint/NAME/state for each joint,
/// /device/command of the first device, /device/2/command and so on of others, beside it /sample
/// and, of those that are apart, /haptic with each step; /events.
/// Thread: one, [offline]. Members throw IoError.
class WorldRecordingWriter {
 public:
  WorldRecordingWriter(const std::string& path, const WorldRecordingInfo& info);
  ~WorldRecordingWriter();
  WorldRecordingWriter(const WorldRecordingWriter&) = delete;
  WorldRecordingWriter& operator=(const WorldRecordingWriter&) = delete;

  void attach(const McapAttachment& file);  // a file that travels with it, before any frame
  /// bodies     as many as names
  /// joints     likewise
  /// commands   sent to the devices, likewise
  /// hands      by device; none: nothing is written of them, which a page's has to have
  /// is_asleep  by body; none: likewise
  void write(std::uint64_t frame, double time, std::span<const BodyState> bodies,
             std::span<const RecordedJoint> joints, std::span<const Wrench> commands,
             std::span<const RecordedHand> hands = {},
             std::span<const std::uint8_t> is_asleep = {});
  /// Steps of hands that are apart, those of each in order. IoError where one is missing.
  void write(std::span<const HandTick> ticks);
  /// haptic_steps  made by each hand that is apart, recorded or not
  void close(std::uint64_t frames, std::uint64_t state_hash,
             std::span<const std::uint64_t> haptic_steps = {});

 private:
  /// A message of one JSON object with a number.
  template <class Fill>
  void put(std::uint16_t channel, std::uint64_t number, std::uint64_t time_ns, const Fill& fill);

  std::unique_ptr<McapWriter> file_;
  std::vector<std::uint16_t> bodies_, joints_, commands_, samples_;
  std::vector<std::uint16_t> haptic_;  // by device, where they are apart
  std::vector<std::uint64_t> steps_;   // likewise: written
  std::string path_;
  std::uint16_t events_ = 0;
  std::string text_;
};

/// A recording in memory: all bodies of a frame one after the other.
struct WorldRecording : WorldRecordingInfo {
  std::vector<BodyState> states;  // frames x bodies
  // by device: one a frame; older recordings have those of pages and of hands that are apart
  std::vector<std::vector<RecordedHand>> hands;
  std::vector<std::vector<HandTick>> ticks;  // by device: steps of those that are apart
  std::string cut_off;                // where and why it ends before it should; "" for a whole one
  std::vector<std::string> warnings;  // cut_off among them
};

/// Whether a file is a recording of a world. False for what cannot be read.
/// Thread [offline].
bool is_world_recording(const std::string& path);

/// Reads one.
/// Thread [offline]; throws InputError "FILE: what, where, what was expected".
WorldRecording read_world_recording(const std::string& path);
/// The same of bytes that are there; `path` names them in errors.
WorldRecording parse_world_recording(std::string bytes, const std::string& path);

}  // namespace thigma
