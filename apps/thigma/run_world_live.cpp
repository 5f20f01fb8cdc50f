#include "run_world_live.h"

#include <algorithm>
#include <chrono>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>

#include "guarded_writer.h"
#include "live_life.h"
#include "run_view.h"
#include "run_world.h"
#include "viewer/server/live_server.h"
#include "viewer/server/origin.h"
#include "viewer/server/protocol.h"
#include "viewer/server/web_files.h"
#include "world_events.h"
#include "world_recorder.h"
#include "world_view.h"

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/device/open_device.h"
#include "thigma/device/web_device.h"
#include "thigma/multibody/world_rows.h"
#include "thigma/scene/world_change.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/world_threads.h"

namespace thigma::app {
namespace {

using Kind = live::LiveRequest::Kind;

/// Makes the hand of web: the page's, or adds one; its number.
std::size_t add_page_hand(LoadedWorld& world, std::vector<std::string>& devices) {
  std::vector<WorldHand>& hands = world.config.hands;
  for (std::size_t i = 0; i < hands.size(); ++i) {
    if (device_scheme(devices[i]) != "web") continue;
    hands[i] = free_hand(world);
    return i;
  }
  hands.push_back(free_hand(world));
  devices.emplace_back("web:");
  return hands.size() - 1;
}

/// The sessions of one run.
class WorldLive {
 public:
  WorldLive(const WorldLiveProgram& program, WorldRunFacts& facts)
      : program_(program),
        world_(*program.world),
        facts_(facts),
        duration_(world_.config.duration),
        devices_(program.devices),
        page_hand_(add_page_hand(world_, devices_)),
        page_(make_web_device(link_)),
        config_(page_config(world_, page_->limits())),
        recorder_([this](const RecordingFailure& failure) { recording_failed(failure); }),
        server_(view(world_), config_, config_.world_from_body * config_.contact.body_from_mesh,
                {"web:"}, live::web_files(), page_address(*program.options), link_,
                {.may_be_framed = program.options->is_embedded}) {
    facts_.devices = devices_;
    use_clutches(devices_, world_);
    record_ = program.options->record;
  }

  WorldSummary go() {
    if (program_.log) program_.log(page_line(*program_.options, server_.address()));
    WorldSummary summary;
    do {
      summary = session();
    } while (begins_again(summary));
    if (changed_) world_ = std::move(changed_->world);  // the one that has ended
    return summary;
  }

 private:
  bool is_told_to_stop() const { return program_.stop->load(std::memory_order_relaxed); }

  /// Of a session that a page asks for the device may be gone: that is told there.
  WorldSummary session() {
    WorldDevices devices;
    std::string why;
    try {
      devices = open_world_devices(world_, devices_, program_.seed, true);
    } catch (const DeviceUnavailable& error) {
      if (!has_run_) throw;
      why = error.what();
    }
    page_ = make_web_device(link_);
    if (why.empty()) devices.list[page_hand_] = page_.get();
    if (duration_ > 0.0)
      world_.config.duration = std::max(duration_ - seconds_, 1.0 / world_.config.rate);
    SessionConfig config = config_;
    open_recording(devices);
    server_.prepare_session(config);
    live::LiveStart start;
    start.device = "web:";
    start.is_web = true;
    start.is_simulated = std::none_of(devices.list.begin(), devices.list.end(),
                                      [](const auto* d) { return d->limits().holds_person; });
    start.recording = recorder_.is_open() ? record_ : "";
    server_.begin_session(start);
    WorldSummary summary;
    if (why.empty()) {
      if (!has_run_) prepare_for_people(devices, devices_, world_.config.rate, program_.log);
      summary = run(devices);
      why = fault_reason(summary, devices_);
    } else {
      summary.fault = Fault::device_lost;
      if (program_.log) program_.log(why);
    }
    recorder_.close(summary);
    seconds_ += static_cast<double>(summary.frames) / world_.config.rate;
    if (summary.has_fault())
      server_.observe(SessionEvent{static_cast<double>(summary.frames) / world_.config.rate,
                                   summary.frames, EventKind::fault, fault_name(summary.fault),
                                   why});
    server_.end_session(end_of(summary), 0);
    has_run_ = true;
    return summary;
  }

  /// The first is of the command line: without it there is no session. Of those that pages ask for
  /// they are told what is wrong.
  void open_recording(const WorldDevices& devices) {
    recorder_.begin(nullptr);
    if (record_.empty() || devices.list.empty()) return;
    const WorldRecorderInfo info{program_.options->scene,    devices_, program_.seed,
                                 program_.options->friction, true,     limits_of(devices.list)};
    try {
      recorder_.begin(std::make_unique<WorldRecorder>(record_, world_, info));
    } catch (const IoError& error) {
      if (!has_run_) throw;
      recording_failed({error.what(), 0.0, 0});
    }
  }

  void recording_failed(const RecordingFailure& failure) {
    const std::string line = tell_lost_recording(server_, record_, failure);
    if (program_.log) program_.log(line);
  }

  live::SceneView view(const LoadedWorld& world) const {
    return view_of(world, static_cast<std::int32_t>(page_hand_));
  }

  /// With the bodies where they are.
  live::SceneView view_at(const LoadedWorld& world, const WorldState& state) const {
    live::SceneView scene = view(world);
    const auto put = [&](live::SceneBodyView& body) {
      const BodyState& y = state.bodies[idx(body.body)];
      body.world_from_mesh =
          Pose{y.position, y.orientation} * scene.world.body_from_mesh[idx(body.body)];
    };
    put(scene.object);
    for (live::SceneBodyView& body : scene.statics) put(body);
    return scene;
  }

  /// The session on a thread of its own, while this one hears what pages ask for.
  WorldSummary run(const WorldDevices& devices) {
    std::atomic<bool> stop{false};
    WorldEvents events(world_, server_);
    WorldShell shell;
    shell.stop = &stop;
    shell.live = &server_.ports();
    shell.sink = [&](const WorldFrame& frame) {
      count_step(frame, facts_);
      recorder_.write_frame(frame);
      server_.observe(frame);
      events.observe(frame);
    };
    if (recorder_.is_open())
      shell.ticks = [&](std::span<const HandTick> ticks) { recorder_.write(ticks); };
    shell.between = [&](WorldRun& run) {
      show_rows(run);
      if (has_asked_.load(std::memory_order_acquire)) change_bodies(run, events);
    };
    is_running_ = true;
    std::future<WorldSummary> session = std::async(std::launch::async, [&] {
      const std::int64_t begin = thread_cpu_ns();
      WorldSummary summary = run_world_on_threads(world_.config, devices.list, shell, RtRequest{});
      facts_.cpu_seconds = 1e-9 * static_cast<double>(thread_cpu_ns() - begin);
      return summary;
    });
    // Every way out of here, an exception too, ends the session: the future waits for it.
    const std::unique_ptr<std::atomic<bool>, void (*)(std::atomic<bool>*)> end(
        &stop, [](std::atomic<bool>* flag) { *flag = true; });
    while (session.wait_for(std::chrono::nanoseconds(kPagePoll)) != std::future_status::ready)
      if (poll_pages() || is_told_to_stop()) stop = true;
    is_running_ = false;
    for (const live::LiveRequest& request : take_asked()) server_.answer(request, kIsOver);
    return session.get();
  }

  std::vector<live::LiveRequest> take_asked() {
    const std::lock_guard lock(mutex_);
    has_asked_.store(false, std::memory_order_relaxed);
    return std::exchange(asked_, {});
  }

  /// What keeps bodies apart, as often as a picture of it is made. Thread: the world's.
  void show_rows(const WorldRun& run) {
    constexpr double kPictures = 30.0;  // a second
    const auto every = static_cast<std::uint64_t>(std::max(1.0, world_.config.rate / kPictures));
    if (frames_++ % every != 0) return;
    const std::size_t near =
        read_rows(run.state(), run.scratch(), 1.0 / world_.config.rate, live::kViewedRows, rows_);
    server_.observe(rows_, near);
  }

  /// What pages asked for between two frames. Thread: the world's.
  void change_bodies(WorldRun& run, WorldEvents& events) {
    for (const live::LiveRequest& request : take_asked()) {
      std::string why;
      try {
        if (recorder_.is_open())
          throw InputError("a recording is being written, with these bodies: stop it");
        change_bodies(request, run, events);
      } catch (const InputError& error) {
        why = error.what();
      }
      server_.answer(request, why);
    }
  }

  void change_bodies(const live::LiveRequest& request, WorldRun& run, WorldEvents& events) {
    const LoadedWorld& now = changed_ ? changed_->world : world_;
    const std::vector<WorldBody>& bodies = now.config.world.bodies;
    const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const WorldBody& body) {
      return body.name == request.text;
    });
    if (found == bodies.end()) throw InputError("there is no body '" + request.text + "' here");
    const auto body = static_cast<std::int32_t>(found - bodies.begin());
    auto next = std::make_unique<WorldChange>(
        request.kind == Kind::add ? with_another(now, body, request.point, run.state())
                                  : without(now, body));
    const WorldState state = carried_state(*next, run.state());
    live::SceneView scene = view_at(next->world, state);
    run.go_on(next->world.config, state, next->was);
    changed_.swap(next);  // the run has it from here on; pages see the one before a while yet
    scene.world.changes = run.changes();
    server_.change_world(std::move(scene), changed_->was);
    events.use(changed_->world);
  }

  static SessionEnd end_of(const WorldSummary& summary) {
    if (summary.has_fault()) return SessionEnd::fault;
    return summary.was_stopped ? SessionEnd::stopped : SessionEnd::duration;
  }

  /// Whether a page wants the session to begin again. All else is answered here and stops nothing.
  bool poll_pages() {
    while (!request_) {
      request_ = server_.take_request();
      if (!request_) return false;
      if (request_->kind == Kind::reset || prepare_recording()) break;
      if (!request_) continue;
      if (request_->kind == Kind::add || request_->kind == Kind::remove) {
        ask_world(*std::exchange(request_, std::nullopt));
        continue;
      }
      const bool is_there = request_->kind == Kind::use_device;
      server_.answer(*request_, is_there ? "" : kNotYet);
      request_.reset();
    }
    return true;
  }

  /// Whether the request is for another session, with a recording or without one.
  bool prepare_recording() {
    if (request_->kind != Kind::record) return false;
    try {
      next_record_ = request_->flag ? next_recording() : "";
      return true;
    } catch (const IoError& error) {
      server_.answer(*std::exchange(request_, std::nullopt), error.what());
      return false;
    }
  }

  /// Left to the world's thread, between two of its frames.
  void ask_world(live::LiveRequest request) {
    if (!is_running_) return server_.answer(request, kIsOver);
    const std::lock_guard lock(mutex_);
    asked_.push_back(std::move(request));
    has_asked_.store(true, std::memory_order_release);
  }

  bool begins_again(const WorldSummary& summary) {
    if (summary.has_fault())
      wait_at_fault(server_, [this] { return poll_pages() || is_told_to_stop(); });
    if (!request_ || is_told_to_stop()) return false;
    const live::LiveRequest request = *std::exchange(request_, std::nullopt);
    const bool is_over = end_of(summary) == SessionEnd::duration;
    server_.answer(request, is_over ? kIsOver : "");
    if (is_over) return false;
    record_ = request.kind == Kind::record ? next_record_ : "";
    if (changed_) server_.change_world(view(world_), {});  // with the bodies of the scene again
    changed_.reset();
    return true;
  }

  static constexpr const char* kIsOver = "the session is over";
  static constexpr const char* kNotYet =
      "a world of several bodies begins again or is recorded, and no more: start the program anew "
      "for another scene";
  const WorldLiveProgram& program_;
  LoadedWorld& world_;
  WorldRunFacts& facts_;
  const double duration_;  // of all sessions [s]; 0: until stopped
  std::vector<std::string> devices_;
  const std::size_t page_hand_;
  WebDeviceChannel link_;
  std::unique_ptr<HapticDevice> page_;
  const SessionConfig config_;
  GuardedWriter<WorldRecorder> recorder_;  // the world's thread's while a session runs
  live::LiveServer server_;
  std::optional<live::LiveRequest> request_;
  double seconds_ = 0.0;              // of all sessions so far
  std::string record_, next_record_;  // files; "" none
  bool has_run_ = false;              // some session
  bool is_running_ = false;           // a session
  std::uint64_t frames_ = 0;          // the world's thread's, as the next
  std::vector<WorldRow> rows_;
  std::mutex mutex_;                      // of what follows
  std::vector<live::LiveRequest> asked_;  // of bodies, for the world's thread
  std::atomic<bool> has_asked_{false};
  // The world that runs, where it is no more that of the scene: the world's thread's while a
  // session runs.
  std::unique_ptr<WorldChange> changed_;
};

}  // namespace

WorldSummary run_world_live(const WorldLiveProgram& program, WorldRunFacts& facts) {
  return WorldLive(program, facts).go();
}

}  // namespace thigma::app
