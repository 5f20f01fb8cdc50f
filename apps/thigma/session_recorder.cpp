#include "session_recorder.h"

#include <utility>

#include "thigma/core/error.h"

namespace thigma::app {

void SessionRecorder::begin(std::unique_ptr<RecordingWriter> writer) {
  writer_ = std::move(writer);
  time_ = 0.0;
  frame_ = 0;
}

template <class Work>
void SessionRecorder::attempt(Work work) {
  if (!writer_) return;
  try {
    work(*writer_);
  } catch (const IoError& error) {
    writer_.reset();
    if (failed_) failed_({error.what(), time_, frame_});
  }
}

void SessionRecorder::write(const HapticSample& sample) {
  attempt([&](RecordingWriter& writer) {
    writer.write(sample);
    time_ = sample.time;
    frame_ = sample.frame;
  });
}

void SessionRecorder::write(const ContactSample& sample) {
  attempt([&](RecordingWriter& writer) { writer.write(sample); });
}

void SessionRecorder::write(const SessionEvent& event) {
  attempt([&](RecordingWriter& writer) { writer.write(event); });
}

void SessionRecorder::close(const RecordingEnd& end) {
  attempt([&](RecordingWriter& writer) { writer.close(end); });
  writer_.reset();
}

}  // namespace thigma::app
