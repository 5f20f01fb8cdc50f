#pragma once
// Recordings of worlds frame by frame, in little memory, and as tables.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "thigma/recording/world_recording.h"

namespace thigma {

class FileWriter;

/// A frame of a world as its recording has it. What it does not have is not a number, or absent.
struct RecordedWorldFrame {
  std::uint64_t frame = 0;
  double time = 0.0;  // at its end [s]
  std::vector<BodyState> bodies;
  std::vector<std::optional<bool>> is_asleep;      // by body
  std::vector<RecordedJoint> joints;               // by joint
  std::vector<Wrench> commands;                    // sent, by device [N, N m; device frame]
  std::vector<std::optional<RecordedHand>> hands;  // by device
};

/// What a pass over a recording of a world has found beside its frames.
struct WorldRecordingPass {
  WorldRecordingInfo info;
  std::uint64_t frame_count = 0, tick_count = 0;
  double last_time = 0.0;             // of the last frame [s]
  std::string cut_off;                // where and why it ends before it should; "" for a whole one
  std::vector<std::string> warnings;  // cut_off among them
};

/// What is told while a recording of a world is read; each may be empty.
struct WorldRecordingSinks {
  std::function<void(const WorldRecordingInfo&)> info{};  // first; without an end
  std::function<void(const RecordedWorldFrame&)> frame{};
  std::function<void(const HandTick&)> tick{};  // of each hand in order
};

/// Goes through a recording of any size once. One that a kill, a power cut or a full disk cut off
/// is read up to its last whole frame.
/// Thread [offline]; throws InputError "FILE: what, where, what was expected", maybe after some
/// frames were told.
WorldRecordingPass stream_world_recording(const std::string& path,
                                          const WorldRecordingSinks& sinks);

/// Writes frames of a world as CSV, one a row, names of bodies in the header, units as well; what
/// was not recorded is empty. Names that CSV cannot take as they are stand in quotes.
/// Thread: one, [offline]; members throw IoError; the file is whole or absent.
class WorldCsvExport {
 public:
  WorldCsvExport(const std::string& path, const WorldRecordingInfo& info);
  ~WorldCsvExport();
  WorldCsvExport(const WorldCsvExport&) = delete;
  WorldCsvExport& operator=(const WorldCsvExport&) = delete;
  void add(const RecordedWorldFrame& frame);
  void keep();  // without it nothing is left

 private:
  std::unique_ptr<FileWriter> file_;
  WorldRecordingInfo info_;
  std::string rows_;
};

/// The same of haptic steps of hands that are apart from their world: a row each, with the number
/// of its device.
class HapticCsvExport {
 public:
  explicit HapticCsvExport(const std::string& path);
  ~HapticCsvExport();
  HapticCsvExport(const HapticCsvExport&) = delete;
  HapticCsvExport& operator=(const HapticCsvExport&) = delete;
  void add(const HandTick& tick);
  void keep();  // without it nothing is left

 private:
  std::unique_ptr<FileWriter> file_;
  std::string rows_;
};

}  // namespace thigma
