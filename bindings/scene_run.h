#pragma once
// Sessions for callers that are no C++ program: in lockstep a frame at a call, or on threads that
// never wait for the caller. Nothing of the caller runs in a session's threads.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "thigma/thigma.h"

namespace thigma::bindings {

/// What a caller tells a step of the handle, instead of the device's own motion.
struct Handle {
  Pose pose;                     // [m; device frame]
  std::optional<Twist> twist{};  // otherwise from the handle before [device frame]
  std::uint32_t buttons = kClutchButton;
};

/// The last frame of a run, and figures of the contact frame before it.
struct RunSample {
  HapticSample haptic;
  std::int64_t contacts = 0;
  double contact_depth = 0.0;  // as ContactSample::depth_max [m]
  double query_cpu = 0.0;      // [s]
};

/// Called now and then while a call waits; what it throws comes out of the call.
using Poll = std::function<void()>;

/// Sinks of a run: the last sample, its events and its recording. Thread: any.
class RunLog {
 public:
  /// recording  path of an .mcap file; empty: none
  RunLog(const SceneSession& session, const std::string& recording, bool is_lockstep);
  ~RunLog();

  SessionSinks sinks(std::function<void()> after_frame = {});
  std::optional<RunSample> last() const;
  std::vector<SessionEvent> events() const;
  /// Completes the recording. Throws IoError.
  void close(const SessionSummary& summary);

 private:
  mutable std::mutex mutex_;
  RunSample sample_;
  bool has_sample_ = false;
  std::vector<SessionEvent> events_;
  std::unique_ptr<RecordingWriter> writer_;
};

/// A lockstep session that makes frames when it is asked to: bit for bit run_lockstep.
/// Thread: every member from one thread at a time.
class SteppedRun {
 public:
  /// errors  of open_session, IoError of the recording
  SteppedRun(std::shared_ptr<const Scene> scene, const SessionOptions& options,
             const std::string& recording);
  ~SteppedRun();  // ends the session, zero force
  SteppedRun(const SteppedRun&) = delete;
  SteppedRun& operator=(const SteppedRun&) = delete;

  /// Makes frames until so many are done or the session has ended.
  ///
  /// frames   >= 1
  /// handle   held for these frames; nothing: the device's
  /// returns  whether all of them were made; false: the session has ended
  /// errors   what the session threw; InputError for a handle of a simulation
  bool step(std::uint64_t frames, const std::optional<Handle>& handle, const Poll& poll = {});

  /// Ends the session where it is, and completes the recording; again: the same summary.
  const SessionSummary& finish();

  bool is_over() const;
  const RunLog& log() const { return log_; }
  const SceneSession& session() const { return session_; }

 private:
  class Device;
  void work() noexcept;
  void wait_for_frame();

  std::shared_ptr<const Scene> scene_;
  SceneSession session_;
  Device* device_ = nullptr;  // of session_
  RunLog log_;
  std::atomic<bool> should_stop_{false};
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::uint64_t wanted_ = 0;  // frames that may still be made
  bool is_waiting_ = false, is_over_ = false, is_closed_ = false;
  std::exception_ptr error_;
  SessionSummary summary_;
  std::thread worker_;
};

/// A session on threads, at the pace of the clock.
/// Thread: every member from one thread at a time.
class ThreadedRun {
 public:
  /// errors  of open_session, IoError of the recording; InputError for a simulation
  ThreadedRun(std::shared_ptr<const Scene> scene, const SessionOptions& options,
              const std::string& recording);
  ~ThreadedRun();  // ends the session, zero force

  void start();
  bool is_running() const;
  /// Waits for the end. What `poll` throws stops the session first.
  const SessionSummary& wait(const Poll& poll = {});
  /// Ends the session, and completes the recording; again: the same summary.
  const SessionSummary& finish();

  const RunLog& log() const { return log_; }
  const SceneSession& session() const { return session_; }

 private:
  std::shared_ptr<const Scene> scene_;
  SceneSession session_;
  RunLog log_;
  std::unique_ptr<Session> threads_;
  bool is_started_ = false, is_closed_ = false;
  std::exception_ptr error_;  // of the run
  SessionSummary summary_;
};

}  // namespace thigma::bindings
