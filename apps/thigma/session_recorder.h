#pragma once
// A recording that may fail without the session it is of.

#include <functional>
#include <memory>
#include <string>

#include "thigma/recording/recording.h"

namespace thigma::app {

/// Where the recording of a session ended before the session did.
struct RecordingFailure {
  std::string why;    // "FILE: what the system says"
  double time = 0.0;  // of the last frame written [s; session clock]
  std::uint64_t frame = 0;
};

/// Writes a session's samples until the system refuses; then that is told once, and nothing more is
/// written. Thread: write from the thread that drains the session, all else from the program's
/// while no session runs.
class SessionRecorder {
 public:
  /// failed   told of a failure, on the thread that wrote; may be empty
  explicit SessionRecorder(std::function<void(const RecordingFailure&)> failed)
      : failed_(std::move(failed)) {}

  /// null: nothing is written
  void begin(std::unique_ptr<RecordingWriter> writer);
  bool is_open() const { return writer_ != nullptr; }
  void write(const HapticSample& sample);
  void write(const ContactSample& sample);
  void write(const SessionEvent& event);
  void close(const RecordingEnd& end);

 private:
  template <class Work>
  void attempt(Work work);

  std::function<void(const RecordingFailure&)> failed_;
  std::unique_ptr<RecordingWriter> writer_;
  double time_ = 0.0;
  std::uint64_t frame_ = 0;
};

}  // namespace thigma::app
