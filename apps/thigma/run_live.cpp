#include "run_live.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "composed_scene.h"
#include "guarded_writer.h"
#include "live_change.h"
#include "live_life.h"
#include "live_models.h"
#include "live_playback.h"
#include "run_view.h"
#include "viewer/server/live_server.h"
#include "viewer/server/web_files.h"

#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/scene/record_session.h"
#include "thigma/session/rt_thread.h"

namespace thigma::app {
namespace {

using Kind = live::LiveRequest::Kind;

/// The sessions of one run and what carries over from one to the next.
class LiveRun {
 public:
  explicit LiveRun(const LiveProgram& program)
      : program_(program),
        options_(*program.options),
        run_(*program.run),
        base_(run_->given),
        first_(run_->given),
        start_(run_->session.config.world_from_body),
        record_(program.options->record),
        recorder_([this](const RecordingFailure& failure) { recording_failed(failure); }),
        server_(view(), run_->session.config, start_ * run_->session.config.contact.body_from_mesh,
                devices_of(*run_), live::web_files(), page_address(*program.options),
                *program.web_channel, {.may_be_framed = program.options->is_embedded}) {}

  /// Levels that are being built tell this of it until they have ended.
  ~LiveRun() { run_->levels.reset(); }
  LiveRun(const LiveRun&) = delete;
  LiveRun& operator=(const LiveRun&) = delete;

  SessionSummary go() {
    server_.offer(open_menu());
    if (!options_.replay.empty())
      commit(change_to_recording(options_.replay, RecordingFrom::user, now()));
    program_.log(page_line(options_, server_.address()));
    SessionSummary summary;
    do {
      summary = playback_ ? playback() : session();
    } while (begins_again(summary));
    return summary;
  }

 private:
  /// What compositions call the objects of the scene that runs.
  live::SceneView with_sources(live::SceneView view) const {
    const auto source = [&](std::size_t i) {
      return i < sources_.size() ? sources_[i] : "scene:" + std::to_string(i);
    };
    view.object.source = source(0);
    for (std::size_t i = 0; i < view.statics.size(); ++i) view.statics[i].source = source(i + 1);
    return view;
  }
  live::SceneView view() const { return with_sources(view_of(*run_)); }

  SessionConfig next_config() {
    SessionConfig config = run_->session.config;
    config.haptic.device = run_->session.device->limits();
    config.haptic.resumes_lost_device = device_scheme(run_->session.device_uri) == "web";
    if (options_.duration) {
      const double least = 1.0 / config.rate;
      config.duration = std::max(*options_.duration - seconds_, least);
    }
    server_.prepare_session(config);
    return config;
  }

  SessionSinks sinks() {
    return {[this](const HapticSample& sample) {
              recorder_.write_frame(sample);
              where_.observe(sample);
              if (program_.observe_haptic) program_.observe_haptic(sample);
              last_body_.reset();
              if (sample.touching == 0)
                last_body_ = Pose{sample.body.position, sample.body.orientation};
              server_.observe(sample);
            },
            [this](const ContactSample& sample) {
              recorder_.write(sample);
              if (program_.observe_contact) program_.observe_contact(sample);
              server_.observe(sample);
            },
            [this](const SessionEvent& event) {
              recorder_.write(event);
              server_.observe(event);
            }};
  }

  /// The recording of the session with this configuration, if one is wanted. The first is of the
  /// command line: without it there is no session; those that pages ask for have been tried before.
  void open_recording(const SessionConfig& config) {
    recorder_.begin(nullptr);
    has_lost_recording_ = false;
    if (record_.empty()) return;
    const SessionConfig kept = run_->session.config;
    run_->session.config = config;  // what it was tuned to belongs in the file
    try {
      recorder_.begin(program_.record(record_));
    } catch (const IoError& error) {
      if (seconds_ == 0.0 && record_ == program_.options->record) throw;
      recording_failed({error.what(), 0.0, 0});
    }
    run_->session.config = kept;
  }

  /// On the thread that drains the session: the session goes on, pages and people are told once.
  void recording_failed(const RecordingFailure& failure) {
    has_lost_recording_ = true;
    program_.print_trouble(tell_lost_recording(server_, record_, failure));
  }

  void begin() {
    live::LiveStart start;
    start.device = run_->session.device_uri;
    start.is_web = device_scheme(run_->session.device_uri) == "web";
    start.is_simulated = !run_->session.device->limits().holds_person;
    start.recording = recorder_.is_open() ? record_ : "";
    start.is_lockstep = options_.is_lockstep;
    start.holder = holder_;
    start.gains = gains_of(*run_);
    start.choices = choices_of(*run_);
    holder_ = 0;
    server_.begin_session(start);
    if (recorder_.is_open()) server_.offer(open_menu());
  }

  void end(const SessionSummary& summary) {
    const bool was_recorded = recorder_.is_open();
    recorder_.close(RecordingEnd{summary.frames, summary.state_hash, summary.dropped_samples});
    seconds_ += summary.seconds;
    server_.end_session(summary.end, summary.dropped_samples);
    if (was_recorded) server_.offer(open_menu());
  }

  SessionSummary session() {
    SessionConfig config = next_config();
    open_recording(config);
    if (recorder_.is_open()) config.telemetry_models = kRecordedModels;
    const RunControl control{.is_lockstep = options_.is_lockstep,
                             .stop = program_.stop,
                             .begun = [this] { begin(); },
                             .poll =
                                 [&] {
                                   if (program_.poll) program_.poll();
                                   bring_levels(config);
                                   return poll_pages().has_value();
                                 }};
    const SessionSummary summary = run_session(*run_, config, control, sinks());
    if (!options_.is_lockstep)
      for (const std::string& note : summary.notes) program_.log(note);
    end(summary);
    return summary;
  }

  /// Levels that have been built meanwhile come into the running session; what simulates itself has
  /// them when it begins again.
  void bring_levels(const SessionConfig& config) {
    std::erase_if(given_up_, [](const auto& levels) { return levels->is_over(); });
    const bool is_read = given_up_change_.valid();  // the run, by what was given up
    if (is_read && given_up_change_.wait_for(std::chrono::seconds(0)) != std::future_status::ready)
      return;
    if (run_->session.simulation || !take_levels(*run_, config, where_.state(), program_.log))
      return;
    server_.refine(view_of(*run_));  // before the first contact that names their nodes
    server_.ports().replacement.store(run_->replacement.get(), std::memory_order_release);
  }

  bool is_told_to_stop() const { return program_.stop->load(std::memory_order_relaxed); }

  SessionSummary playback() {
    show_playback({server_, *playback_, recorded_config(run_->session.config, playback_->config()),
                   [this]() -> std::optional<live::LiveRequest>& { return poll_pages(); },
                   [this] { return is_told_to_stop(); }});
    SessionSummary summary;
    summary.end = SessionEnd::stopped;
    return summary;
  }

  /// What a page asks for that the session has to end for, once there is such a request and all it
  /// takes is ready. What is refused is answered here and stops nothing; meshes are looked at
  /// meanwhile.
  std::optional<live::LiveRequest>& poll_pages() {
    if (request_) return request_;
    request_ = server_.take_request();
    if (!request_) return request_;
    if (request_->kind == Kind::inspect && !live::is_recording_name(request_->text)) {
      look_at_dropped();
    } else if (request_->kind == Kind::save) {
      save();
    } else if (!moves_within_recording(*request_)) {
      judge();
    }
    return request_;
  }

  bool moves_within_recording(const live::LiveRequest& request) const {
    return playback_ && (request.kind == Kind::seek || request.kind == Kind::reset);
  }

  void judge() {
    std::string why;
    server_.set_preparing(true);
    wait_for_given_up();
    if (run_->session.simulation && take_levels(*run_, {}, BodyState{}, program_.log))
      has_new_levels_ = true;
    cancelled_ = std::make_shared<std::atomic<bool>>(false);
    try {
      std::future<LiveChange> made =
          std::async(std::launch::async, [this, request = *request_, now = now()] {
            // A recording that was dropped on the page is kept and shown.
            if (request.kind == Kind::inspect)
              return change_to_recording(dropped_.keep_recording(request.text, request.data),
                                         RecordingFrom::page, now);
            return make_change(request, now);
          });
      while (made.wait_for(std::chrono::nanoseconds(kPagePoll)) != std::future_status::ready)
        if (server_.is_cancelled() || is_told_to_stop()) give_up(std::move(made));
      change_ = made.get();
    } catch (const std::exception& error) {
      why = error.what();
    }
    server_.set_preparing(false);
    if (has_progress_.exchange(false)) server_.show_progress("", 1.0);
    if (why.empty()) return;
    server_.answer(*request_, why);
    request_.reset();
  }

  /// What was asked for ends by itself, at its next step; nobody waits for it. Throws with why.
  [[noreturn]] void give_up(std::future<LiveChange> made) {
    {
      const std::lock_guard lock(progress_mutex_);  // nothing is shown of it any more
      *cancelled_ = true;
    }
    given_up_change_ = std::move(made);
    throw std::runtime_error(is_told_to_stop() ? "told to stop" : "cancelled");
  }

  /// What was given up reads what comes next changes.
  void wait_for_given_up() {
    if (given_up_change_.valid()) given_up_change_.wait();
    given_up_change_ = {};
  }

  /// Whether there is another session to run, and sets it up.
  bool begins_again(const SessionSummary& summary) {
    if (summary.end == SessionEnd::fault)
      wait_at_fault(server_, [this] { return poll_pages().has_value() || is_told_to_stop(); });
    if (!request_ || is_told_to_stop()) return false;
    const live::LiveRequest request = *request_;
    request_.reset();
    if (summary.end == SessionEnd::duration || summary.end == SessionEnd::device_finished) {
      server_.answer(request, "the session is over");
      return false;
    }
    commit(std::move(change_));
    server_.answer(request, "");
    return true;
  }

  LiveNow now() {
    RunHooks hooks;
    hooks.log = [this](const std::string& line) { program_.log(line); };
    hooks.progress = [this, cancelled = cancelled_](const std::string& what, double share) {
      const std::lock_guard lock(progress_mutex_);
      if (cancelled != nullptr && *cancelled) throw std::runtime_error("cancelled");
      has_progress_ = true;
      server_.show_progress(what, share);
    };
    hooks.web_channel = program_.web_channel;
    const bool is_recorded = !playback_ && !has_lost_recording_;
    return {
        *run_,         options_,        dropped_, base_, first_, start_, is_recorded ? record_ : "",
        program_.seed, std::move(hooks)};
  }

  /// Puts a change into effect, between two sessions; nothing of it can fail.
  void commit(LiveChange change) {
    const bool was_replay = playback_ != nullptr;
    playback_ = std::move(change.playback);
    if (change.run) {
      const SessionConfig& config = change.run->session.config;
      sources_ = std::move(change.sources);
      if (sources_.empty()) base_ = change.run->given;
      server_.show(with_sources(view_of(*change.run)), config,
                   config.world_from_body * config.contact.body_from_mesh);
      if (run_->levels) {
        run_->levels->give_up();
        given_up_.push_back(std::move(run_->levels));
      }
      run_ = std::move(change.run);
      options_ = std::move(change.options);
      start_ = run_->session.config.world_from_body;
      last_body_.reset();
      dropped_.tidy(run_->scene.description);
    }
    if (playback_) {
      const SessionConfig config = recorded_config(run_->session.config, playback_->config());
      server_.show(view(), config, start_ * config.contact.body_from_mesh);
    } else if (was_replay) {
      server_.show(view(), run_->session.config,
                   start_ * run_->session.config.contact.body_from_mesh);
    }
    if (std::exchange(has_new_levels_, false) && !change.run) server_.refine(view_of(*run_));
    if (change.device) run_->session = std::move(*change.device);
    holder_ = change.holder;
    // A person goes on from where the object is, but for a contact, inside which no force is ever
    // switched on; a hand comes to it from the start.
    if (holder_ != 0 && last_body_) run_->session.config.world_from_body = *last_body_;
    record_ = change.record;
  }

  /// Saves the scene that runs; a session goes on meanwhile.
  void save() {
    const live::LiveRequest request = std::move(*request_);
    request_.reset();
    try {
      const std::string path = save_scene(run_->given, request.text, request.flag);
      server_.send(request.page, live::saved_message(request.id, path));
      server_.answer(request, "");
      server_.offer(open_menu());
    } catch (const std::exception& error) {
      server_.answer(request, error.what());
    }
  }

  /// Answers a request to look at a mesh; a session goes on meanwhile.
  void look_at_dropped() {
    const live::LiveRequest request = std::move(*request_);
    request_.reset();
    wait_for_given_up();
    try {
      // Large meshes take minutes to look at; whoever is to stop must not wait for that.
      look_ = std::async(std::launch::async,
                         [this, request] { dropped_.keep(request.text, request.data); });
      while (look_.wait_for(std::chrono::nanoseconds(kPagePoll)) != std::future_status::ready)
        if (is_told_to_stop()) return;
      look_.get();
      dropped_.tidy(run_->scene.description);
      server_.send(request.page,
                   model_message(request.id, dropped_, run_->scene.object->hierarchy.radius));
      server_.answer(request, "");
    } catch (const std::exception& error) {
      server_.answer(request, error.what());
    }
  }

  const LiveProgram& program_;
  RunOptions options_;  // of the run that is prepared
  std::unique_ptr<Run>& run_;
  SceneDescription base_;             // that compositions begin with
  const SceneDescription first_;      // which the user chose
  std::vector<std::string> sources_;  // of the scene that runs; empty: it is base_
  Pose start_;                        // world_from_body
  std::string record_;
  std::atomic<bool> has_lost_recording_{false};  // it ended before its session
  GuardedWriter<RecordingWriter> recorder_;
  DroppedMesh dropped_;
  live::LiveServer server_;
  LastBody where_;
  std::vector<std::unique_ptr<LevelBuild>> given_up_;  // that have yet to end
  std::unique_ptr<Playback> playback_;                 // null: sessions
  std::optional<live::LiveRequest> request_;
  LiveChange change_;            // what request_ takes
  bool has_new_levels_ = false;  // of a simulation, from where it begins again
  std::mutex progress_mutex_;
  std::atomic<bool> has_progress_{false};           // pages have been told of some
  std::shared_ptr<std::atomic<bool>> cancelled_{};  // of what request_ takes
  // world_from_body of the last frame, unless it touched something; the draining thread's while a
  // session runs
  std::optional<Pose> last_body_;
  live::PageId holder_ = 0;                  // of the next session's device
  double seconds_ = 0.0;                     // of all sessions so far
  std::future<void> look_;                   // at a dropped mesh
  std::future<LiveChange> given_up_change_;  // these last: they use all of the above until they end
};

}  // namespace

SessionSummary run_live(const LiveProgram& program) { return LiveRun(program).go(); }

}  // namespace thigma::app
