#pragma once
// A file that may fail without the session that is written into it.

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "thigma/core/error.h"

namespace thigma::app {

/// Where the recording of a session ended before the session did.
struct RecordingFailure {
  std::string why;    // "FILE: what the system says"
  double time = 0.0;  // of the last frame written [s; session clock]
  std::uint64_t frame = 0;

  /// For people.
  std::string line() const { return why + "; the recording ends there, the session goes on"; }
};

/// Writes until the system refuses; then that is told once, and nothing more is written. Thread:
/// write from the thread that has the session's samples, all else while no session runs.
template <class Writer>
class GuardedWriter {
 public:
  /// failed   told of a failure, on the thread that wrote; may be empty
  explicit GuardedWriter(std::function<void(const RecordingFailure&)> failed)
      : failed_(std::move(failed)) {}

  /// null: nothing is written
  void begin(std::unique_ptr<Writer> writer) {
    writer_ = std::move(writer);
    time_ = 0.0;
    frame_ = 0;
  }
  bool is_open() const { return writer_ != nullptr; }

  /// Of a frame, which has a time and a number.
  template <class Frame>
  void write_frame(const Frame& frame) {
    attempt([&](Writer& writer) {
      writer.write(frame);
      time_ = frame.time;
      frame_ = frame.frame;
    });
  }
  /// What belongs to no frame of its own.
  template <class Sample>
  void write(const Sample& sample) {
    attempt([&](Writer& writer) { writer.write(sample); });
  }

  /// Nothing is written any more.
  template <class End>
  void close(const End& end) {
    attempt([&](Writer& writer) { writer.close(end); });
    writer_.reset();
  }

 private:
  // What work(writer) throws of IoError ends the file.
  template <class Work>
  void attempt(Work work) {
    if (!writer_) return;
    try {
      work(*writer_);
    } catch (const IoError& error) {
      writer_.reset();
      if (failed_) failed_({error.what(), time_, frame_});
    }
  }

  std::function<void(const RecordingFailure&)> failed_;
  std::unique_ptr<Writer> writer_;
  double time_ = 0.0;
  std::uint64_t frame_ = 0;
};

}  // namespace thigma::app
