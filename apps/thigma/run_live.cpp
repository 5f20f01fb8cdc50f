#include "run_live.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <optional>
#include <thread>

#include "live_models.h"
#include "live_playback.h"
#include "run_view.h"
#include "scenes/scene_file.h"
#include "viewer/server/live_room.h"
#include "viewer/server/web_files.h"

#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/runtime/rt_thread.h"

namespace thigma::app {
namespace {

constexpr std::int64_t kPoll = 10'000'000;  // [ns]

using Kind = live::LiveRequest::Kind;

/// The sessions of one run and what carries over from one to the next.
class LiveRun {
 public:
  explicit LiveRun(const LiveProgram& program)
      : program_(program),
        options_(*program.options),
        run_(*program.run),
        start_(run_->config.world_from_body),
        record_(program.options->record),
        room_(view_of(*run_), run_->config, start_ * run_->config.contact.body_from_mesh,
              devices_of(*run_), live::web_files(), program.options->port.value_or(0),
              *program.web_link) {}

  SessionSummary go() {
    room_.offer(open_menu());
    if (!options_.replay.empty()) show_recording(options_.replay);
    program_.tell("the page is at " + room_.address() +
                  " - open it in a browser on this machine; Ctrl-C ends it");
    SessionSummary summary;
    do {
      summary = playback_ ? playback() : options_.is_lockstep ? lockstep() : session();
    } while (begins_again(summary));
    return summary;
  }

 private:
  SessionConfig next_config() {
    SessionConfig config = run_->config;
    config.haptic.device = run_->device->limits();
    config.haptic.resumes_lost_device = device_scheme(run_->device_uri) == "web";
    if (options_.duration) {
      const double least = 1.0 / config.rate;
      config.duration = std::max(*options_.duration - seconds_, least);
    }
    room_.prepare_session(config);
    return config;
  }

  SessionSinks sinks() {
    return {[this](const HapticSample& sample) {
              if (recording_) recording_->write(sample);
              if (program_.look_at_haptic) program_.look_at_haptic(sample);
              last_body_.reset();
              if (sample.touching == 0)
                last_body_ = Pose{sample.body.position, sample.body.orientation};
              room_.look_at(sample);
            },
            [this](const ContactSample& sample) {
              if (recording_) recording_->write(sample);
              if (program_.look_at_contact) program_.look_at_contact(sample);
              room_.look_at(sample);
            },
            [this](const SessionEvent& event) {
              if (recording_) recording_->write(event);
              room_.look_at(event);
            }};
  }

  /// The recording of the session with this configuration, if one is wanted.
  void open_recording(const SessionConfig& config) {
    recording_.reset();
    if (record_.empty()) return;
    const SessionConfig kept = run_->config;
    run_->config = config;  // what it was tuned to belongs in the file
    recording_ = program_.record(record_);
    run_->config = kept;
  }

  void begin() {
    live::LiveStart start;
    start.device = run_->device_uri;
    start.is_web = device_scheme(run_->device_uri) == "web";
    start.recording = recording_ ? record_ : "";
    start.is_lockstep = options_.is_lockstep;
    start.holder = holder_;
    start.gains = gains_of(*run_);
    start.choices = choices_of(*run_);
    holder_ = 0;
    room_.begin_session(start);
  }

  void end(const SessionSummary& summary) {
    const bool was_recorded = recording_ != nullptr;
    if (recording_)
      recording_->close({summary.frames, summary.state_hash, summary.dropped_samples});
    recording_.reset();
    seconds_ += summary.seconds;
    room_.end_session(end_name(summary.end), summary.dropped_samples);
    if (was_recorded) room_.offer(open_menu());
  }

  SessionSummary lockstep() {
    const SessionConfig config = next_config();
    open_recording(config);
    begin();
    const SessionSummary summary =
        run_->simulation ? simulate_run(*run_, config, false, sinks(), program_.stop)
                         : run_lockstep(config, *run_->device, sinks(), program_.stop);
    end(summary);
    return summary;
  }

  /// A simulation at the pace of the clock, in a thread of its own.
  SessionSummary simulation() {
    const SessionConfig config = next_config();
    open_recording(config);
    std::atomic<bool> stops{false}, is_over{false};
    std::exception_ptr error;
    SessionSummary summary;
    begin();
    std::thread worker([&] {
      try {
        summary = simulate_run(*run_, config, true, sinks(), &stops);
      } catch (...) {
        error = std::current_exception();
      }
      is_over = true;
    });
    while (!is_over) {
      if (poll_pages() || is_told_to_stop()) stops = true;
      sleep_ns(kPoll);
      if (program_.poll) program_.poll();
    }
    worker.join();
    if (error) std::rethrow_exception(error);
    end(summary);
    return summary;
  }

  SessionSummary session() {
    if (run_->simulation) return simulation();
    const SessionConfig config = next_config();
    open_recording(config);
    Session session(config, *run_->device, sinks());
    session.start();
    begin();
    while (session.is_running()) {
      if (poll_pages() || is_told_to_stop()) session.request_stop();
      sleep_ns(kPoll);
      if (program_.poll) program_.poll();
    }
    const SessionSummary summary = session.finish();
    for (const std::string& note : summary.notes) program_.tell(note);
    end(summary);
    return summary;
  }

  bool is_told_to_stop() const { return program_.stop->load(std::memory_order_relaxed); }

  SessionSummary playback() {
    show_playback({room_, *playback_, recorded_config(run_->config, playback_->config()),
                   [this]() -> std::optional<live::LiveRequest>& { return poll_pages(); },
                   [this] { return is_told_to_stop(); }});
    SessionSummary summary;
    summary.end = SessionEnd::stopped;
    return summary;
  }

  /// What a page asks for that the session has to end for, once there is such a request; meshes are looked at meanwhile.
  std::optional<live::LiveRequest>& poll_pages() {
    if (!request_) request_ = room_.take_request();
    if (request_ && request_->kind == Kind::inspect) look_at_dropped();
    return request_;
  }

  /// Whether there is another session to run, and sets it up.
  bool begins_again(const SessionSummary& summary) {
    // Who is looking at a fault may begin again, and may load the page anew; without anybody there
    // the program ends.
    constexpr int kPatience = 500;  // polls
    int alone = room_.page_count() > 0 ? 0 : kPatience;
    while (!request_ && summary.end == SessionEnd::fault && alone < kPatience &&
           !is_told_to_stop()) {
      poll_pages();
      alone = room_.page_count() > 0 ? 0 : alone + 1;
      sleep_ns(kPoll);
    }
    if (!request_ || is_told_to_stop()) return false;
    const live::LiveRequest request = *request_;
    request_.reset();
    if (summary.end == SessionEnd::duration || summary.end == SessionEnd::device_finished) {
      room_.answer(request, "the session is over");
      return false;
    }
    room_.answer(request, set_up(request));
    return true;
  }

  /// What a request changes; "" or why it cannot be. A session begins again in any case.
  std::string set_up(const live::LiveRequest& request) {
    try {
      leave_recording(request);
      if (request.kind == Kind::record) {
        record_ = request.flag ? free_recording() : "";
      } else if (!record_.empty()) {
        record_ = free_recording();  // one file a session
      }
      switch (request.kind) {
        case Kind::use_device:
          use_device(request);
          return {};
        case Kind::choose:
          choose(request);
          return {};
        case Kind::open:
          open(request.text);
          return {};
        case Kind::place:
          place_dropped(request);
          return {};
        default:
          break;
      }
      run_->config.world_from_body = start_;
      reopen_run_device(options_, program_.seed, run_->device_uri, *run_);
      return {};
    } catch (const std::exception& error) {
      record_.clear();
      room_.tell_progress("", 1.0);
      return error.what();
    }
  }

  void use_device(const live::LiveRequest& request) {
    if (run_->config.haptic.response == ResponseKind::direct)
      throw std::runtime_error(
          "the direct response is set up for its device; choose the coupled response first");
    const bool is_web = device_scheme(request.text) == "web";
    // A person goes on from where the object is, but for a contact, inside which no force is ever
    // switched on; a hand comes to it from the start.
    run_->config.world_from_body = start_;
    reopen_run_device(options_, program_.seed, request.text, *run_);
    if (is_web && last_body_) run_->config.world_from_body = *last_body_;
    if (is_web) holder_ = request.page;
  }

  /// Response and texture decide the contact tolerance and how surfaces are loaded: the run is prepared anew.
  void choose(const live::LiveRequest& request) {
    RunOptions options = options_;
    if (request.text == "response") options.response = request.number == 0.0 ? "coupled" : "direct";
    if (request.text == "texture") options.texture = request.number == 0.0 ? "on" : "off";
    prepare(run_->scene, options);
  }

  void open(const std::string& what) {
    const live::OpenMenu menu = open_menu();
    const auto has = [&](const std::vector<live::OpenMenu::Item>& items) {
      return std::any_of(items.begin(), items.end(),
                         [&](const live::OpenMenu::Item& item) { return item.name == what; });
    };
    if (has(menu.recordings)) return show_recording(what);
    if (!has(menu.scenes)) throw std::runtime_error("there is no '" + what + "' to open here");
    prepare(scenes::read_scene(what), scene_options());
  }

  /// What of the options is not about the scene that ran.
  RunOptions scene_options() const {
    RunOptions options = options_;
    options.scene = options.object = options.against = options.pose_text = options.response =
        options.texture = "";
    options.scale.reset();
    options.is_repair = false;
    return options;
  }

  /// Prepares another run and shows it; what fails leaves everything as it was.
  void prepare(scenes::SceneDescription scene, RunOptions options) {
    // Who moves the object goes on doing so, where they can.
    const std::string scheme = device_scheme(run_->device_uri);
    options.device = scheme == "web" || scheme == "hand" ? run_->device_uri : "web:";
    RunHooks hooks;
    hooks.tell = [this](const std::string& line) { program_.tell(line); };
    hooks.progress = [this](const std::string& what, double share) {
      if (is_told_to_stop()) throw std::runtime_error("told to stop");
      room_.tell_progress(what, share);
    };
    hooks.web_link = program_.web_link;
    room_.tell_progress("preparing " + scene.title, 0.0);
    std::unique_ptr<Run> next = prepare_run(std::move(scene), options, program_.seed, hooks);
    room_.show(view_of(*next), next->config,
               next->config.world_from_body * next->config.contact.body_from_mesh);
    room_.tell_progress("", 1.0);
    run_ = std::move(next);
    options_ = options;
    start_ = run_->config.world_from_body;
    last_body_.reset();
    record_.clear();
  }

  void show_recording(const std::string& path) {
    auto next = std::make_unique<Playback>(path);
    const std::string& scene = next->config().scene;
    const bool is_other = scene != run_->scene.file && options_.replay != path;
    if (is_other) prepare(scenes::read_scene(scene), scene_options());
    playback_ = std::move(next);
    const SessionConfig config = recorded_config(run_->config, playback_->config());
    room_.show(view_of(*run_), config, start_ * config.contact.body_from_mesh);
    record_.clear();
  }

  /// Anything but moving about in it ends a recording; the scene stays, for a session.
  void leave_recording(const live::LiveRequest&) {
    if (!playback_) return;
    playback_.reset();
    room_.show(view_of(*run_), run_->config, start_ * run_->config.contact.body_from_mesh);
  }

  /// Answers a request to look at a mesh; a session goes on meanwhile.
  void look_at_dropped() {
    const live::LiveRequest request = std::move(*request_);
    request_.reset();
    try {
      dropped_.keep(request.text, request.data);
      room_.tell(request.page, model_message(request.id, dropped_, run_->object_radius));
      room_.answer(request, "");
    } catch (const std::exception& error) {
      room_.answer(request, error.what());
    }
  }

  void place_dropped(const live::LiveRequest& request) {
    if (!dropped_.is_there()) throw std::runtime_error("no mesh has been dropped on the page");
    if (request.text != "hold" && request.text != "touch")
      throw std::runtime_error("a mesh can be held or touched");
    if (!(request.number > 0.0 && request.number < 1e6))
      throw std::runtime_error("a unit has to be a length above 0");
    const bool is_held = request.text == "hold";
    if (is_held && run_->statics.empty())
      throw std::runtime_error("nothing stands still here to hold it against");
    const ClodAsset& other = is_held ? *run_->statics.front() : run_->object;
    RunOptions options = scene_options();
    options.is_repair = request.flag;
    prepare(scene_with(run_->scene, dropped_, is_held, request.number,
                       bounds_of(other.meshes.front().positions)),
            options);
  }

  const LiveProgram& program_;
  RunOptions options_;  // of the run that is prepared
  std::unique_ptr<Run>& run_;
  Pose start_;  // world_from_body
  std::string record_;
  DroppedMesh dropped_;
  live::LiveRoom room_;
  std::unique_ptr<RecordingWriter> recording_;
  std::unique_ptr<Playback> playback_;  // null: sessions
  std::optional<live::LiveRequest> request_;
  std::optional<Pose>
      last_body_;            // world_from_body of the last frame, unless it touched something;
                             // the draining thread's while a session runs
  live::PageId holder_ = 0;  // of the next session's device
  double seconds_ = 0.0;     // of all sessions so far
};

}  // namespace

SessionSummary run_live(const LiveProgram& program) { return LiveRun(program).go(); }

}  // namespace thigma::app
