#include "scene_run.h"

#include <chrono>
#include <limits>

#include "thigma/math/rotation.h"
#include "thigma/recording/config_json.h"
#include "thigma/scene/record_session.h"

namespace thigma::bindings {
namespace {

constexpr auto kPollPeriod = std::chrono::milliseconds(50);

/// Motion from one handle to the next.
Twist twist_between(const Pose& before, const Pose& after, double rate) {
  const Quat turn = after.orientation * before.orientation.conjugate();
  return {rate * (after.position - before.position), rate * vector_from_rotation(turn)};
}

}  // namespace

// ---- what a run tells
// ------------------------------------------------------------

RunLog::RunLog(const SceneSession& session, const std::string& recording, bool is_lockstep) {
  if (recording.empty()) return;
  writer_ = std::make_unique<RecordingWriter>(recording,
                                              write_config(recorded_config(session, is_lockstep)));
  record_surfaces(session.config.contact, *writer_);
}

RunLog::~RunLog() = default;

SessionSinks RunLog::sinks(std::function<void()> after_frame) {
  SessionSinks sinks;
  sinks.haptic = [this, after = std::move(after_frame)](const HapticSample& sample) {
    if (writer_) writer_->write(sample);
    {
      const std::lock_guard lock(mutex_);
      sample_.haptic = sample;
      has_sample_ = true;
    }
    if (after) after();
  };
  sinks.contact = [this](const ContactSample& sample) {
    if (writer_) writer_->write(sample);
    const std::lock_guard lock(mutex_);
    sample_.contacts = sample.contacts;
    sample_.contact_depth = sample.depth_max;
    sample_.query_cpu = sample.query_cpu;
  };
  sinks.event = [this](const SessionEvent& event) {
    if (writer_) writer_->write(event);
    const std::lock_guard lock(mutex_);
    events_.push_back(event);
  };
  return sinks;
}

std::optional<RunSample> RunLog::last() const {
  const std::lock_guard lock(mutex_);
  return has_sample_ ? std::optional(sample_) : std::nullopt;
}

std::vector<SessionEvent> RunLog::events() const {
  const std::lock_guard lock(mutex_);
  return events_;
}

void RunLog::close(const SessionSummary& summary) {
  if (writer_) writer_->close({summary.frames, summary.state_hash, summary.dropped_samples});
}

// ---- in lockstep
// ------------------------------------------------------------

/// The scene's device, whose handle the caller may move.
class SteppedRun::Device final : public HapticDevice {
 public:
  Device(std::unique_ptr<HapticDevice> device, double rate)
      : device_(std::move(device)), rate_(rate) {}

  const DeviceLimits& limits() const override { return device_->limits(); }
  std::string name() const override { return device_->name(); }
  DeviceState read(double now) noexcept override {
    DeviceState state = device_->read(now);
    if (!handle_) return state;
    state.motion = {handle_->pose, handle_->twist.value_or(twist_)};
    state.buttons = handle_->buttons;
    state.status = DeviceStatus::ok;
    state.has_true_handle = false;
    twist_ = {};  // at rest where it stays for more frames
    return state;
  }
  void write(const Wrench& wrench) noexcept override { device_->write(wrench); }

  /// Thread: while no frame is made.
  void move(const std::optional<Handle>& handle) {
    twist_ = {};
    if (handle && handle_) twist_ = twist_between(handle_->pose, handle->pose, rate_);
    handle_ = handle;
  }

 private:
  std::unique_ptr<HapticDevice> device_;
  double rate_;
  std::optional<Handle> handle_;
  Twist twist_;  // of the next frame
};

SteppedRun::SteppedRun(std::shared_ptr<const Scene> scene, const SessionOptions& options,
                       const std::string& recording)
    : scene_(std::move(scene)),
      session_(open_session(*scene_, options)),
      log_(session_, recording, true) {
  auto device = std::make_unique<Device>(std::move(session_.device), session_.config.rate);
  device_ = device.get();
  session_.device = std::move(device);
  worker_ = std::thread([this] { work(); });
}

SteppedRun::~SteppedRun() {
  try {
    finish();
  } catch (...) {
    // of a session that is given up; the file says how far it goes
  }
}

void SteppedRun::work() noexcept {
  try {
    wait_for_frame();
    summary_ = run_lockstep(session_, log_.sinks([this] { wait_for_frame(); }), &should_stop_);
  } catch (...) {
    error_ = std::current_exception();
  }
  const std::lock_guard lock(mutex_);
  is_over_ = true;
  changed_.notify_all();
}

void SteppedRun::wait_for_frame() {
  std::unique_lock lock(mutex_);
  if (wanted_ == 0) {
    is_waiting_ = true;
    changed_.notify_all();
    changed_.wait(lock, [this] { return wanted_ > 0 || should_stop_; });
    is_waiting_ = false;
  }
  if (wanted_ > 0) --wanted_;
}

bool SteppedRun::step(std::uint64_t frames, const std::optional<Handle>& handle, const Poll& poll) {
  if (is_closed_) throw std::logic_error("session: is closed");
  if (handle && session_.simulation)
    throw InputError("session: nobody holds the object of a [simulation], expected no handle");
  std::unique_lock lock(mutex_);
  const auto is_done = [this] { return is_over_ || (is_waiting_ && wanted_ == 0); };
  changed_.wait(lock, is_done);
  if (!is_over_) {
    device_->move(handle);
    wanted_ = frames;
    is_waiting_ = false;
    changed_.notify_all();
    while (!changed_.wait_for(lock, kPollPeriod, is_done)) {
      if (!poll) continue;
      lock.unlock();
      try {
        poll();
      } catch (...) {
        lock.lock();
        wanted_ = 0;
        throw;
      }
      lock.lock();
    }
  }
  if (error_) std::rethrow_exception(error_);
  return !is_over_;
}

const SessionSummary& SteppedRun::finish() {
  if (!is_closed_) {
    {
      const std::lock_guard lock(mutex_);
      should_stop_ = true;
      wanted_ = 0;
      changed_.notify_all();
    }
    worker_.join();
    is_closed_ = true;
    if (!error_) log_.close(summary_);
  }
  if (error_) std::rethrow_exception(error_);  // each time: it has not run
  return summary_;
}

bool SteppedRun::is_over() const {
  const std::lock_guard lock(mutex_);
  return is_over_;
}

// ---- on threads
// ------------------------------------------------------------

ThreadedRun::ThreadedRun(std::shared_ptr<const Scene> scene, const SessionOptions& options,
                         const std::string& recording)
    : scene_(std::move(scene)),
      session_(open_session(*scene_, options)),
      log_(session_, recording, false) {
  if (session_.simulation)
    throw InputError("session: a [simulation] runs in lockstep, expected no threads");
  if (!recording.empty()) session_.config.telemetry_models = kRecordedModels;
  threads_ = std::make_unique<Session>(session_.config, *session_.device, log_.sinks());
}

ThreadedRun::~ThreadedRun() {
  try {
    finish();
  } catch (...) {
    // as of SteppedRun
  }
}

void ThreadedRun::start() {
  if (is_closed_) throw std::logic_error("session: is closed");
  threads_->start();
  is_started_ = true;
}

bool ThreadedRun::is_running() const { return !is_closed_ && threads_->is_running(); }

const SessionSummary& ThreadedRun::wait(const Poll& poll) {
  if (!is_started_ && !is_closed_) start();
  while (is_running()) {
    std::this_thread::sleep_for(kPollPeriod);
    if (!poll) continue;
    try {
      poll();
    } catch (...) {
      finish();
      throw;
    }
  }
  return finish();
}

const SessionSummary& ThreadedRun::finish() {
  if (error_) std::rethrow_exception(error_);  // each time, as of SteppedRun
  if (is_closed_) return summary_;
  is_closed_ = true;
  if (!is_started_) return summary_;
  threads_->request_stop();
  try {
    summary_ = threads_->finish();
  } catch (...) {
    error_ = std::current_exception();
    throw;
  }
  log_.close(summary_);
  return summary_;
}

}  // namespace thigma::bindings
