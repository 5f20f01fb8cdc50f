#include "run_live.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

#include "version.h"
#include "viewer/server/live_room.h"
#include "viewer/server/web_files.h"

#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/runtime/rt_thread.h"

namespace thigma::app {
namespace {

constexpr std::int64_t kPoll = 10'000'000;  // [ns]

live::SceneView view_of(const Run& run) {
  const scenes::SceneDescription& scene = run.scene;
  live::SceneView view;
  view.title = scene.title.empty() ? scene.object.name : scene.title;
  view.name = scene.file;
  view.program = std::string("thigma ") + kVersion;
  view.object = {scene.object.name, &run.object.meshes.at(0), &run.object.hierarchy, {}};
  for (std::size_t i = 0; i < scene.statics.size(); ++i) {
    view.statics.push_back({scene.statics[i].name, &run.statics[i]->meshes.at(0),
                            &run.statics[i]->hierarchy, scene.statics[i].world_from_mesh});
  }
  return view;
}

/// Who may move the object: the device the program was started with, the page, and a hand.
std::vector<std::string> devices_of(const Run& run) {
  std::vector<std::string> devices = {run.device_uri};
  for (const char* other : {"web:", "hand:"}) {
    const bool is_there = std::any_of(devices.begin(), devices.end(), [&](const std::string& uri) {
      return device_scheme(uri) + ":" == other;
    });
    if (!is_there) devices.push_back(other);
  }
  return devices;
}

const char* end_name(SessionEnd end) {
  switch (end) {
    case SessionEnd::duration:
      return "duration";
    case SessionEnd::device_finished:
      return "device_finished";
    case SessionEnd::stopped:
      return "stopped";
    case SessionEnd::fault:
      return "fault";
  }
  return "";
}

/// A name no file has yet, in the folder the program runs in.
std::string free_recording() {
  for (int i = 1; i < 1000; ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "session-%03d.mcap", i);
    const std::string part = std::string(name) + ".part";
    if (!std::filesystem::exists(name) && !std::filesystem::exists(part)) return name;
  }
  throw IoError(
      "session-999.mcap: there is already a file, expected a free name from session-001 on");
}

/// The sessions of one run and what carries over from one to the next.
class LiveRun {
 public:
  explicit LiveRun(const LiveProgram& program)
      : program_(program),
        run_(*program.run),
        start_(run_.config.world_from_body),
        record_(program.options->record),
        room_(view_of(run_), run_.config, start_ * run_.config.contact.body_from_mesh,
              devices_of(run_), live::web_files(), program.options->port.value_or(0),
              *run_.web_link) {}

  SessionSummary go() {
    program_.tell("the page is at " + room_.address() +
                  " - open it in a browser on this machine; Ctrl-C ends it");
    SessionSummary summary;
    do {
      summary = program_.options->is_lockstep ? lockstep() : session();
    } while (begins_again(summary));
    return summary;
  }

 private:
  SessionConfig next_config() {
    SessionConfig config = run_.config;
    config.haptic.device = run_.device->limits();
    config.haptic.resumes_lost_device = device_scheme(run_.device_uri) == "web";
    if (program_.options->duration) {
      const double least = 1.0 / config.rate;
      config.duration = std::max(*program_.options->duration - seconds_, least);
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
    const SessionConfig kept = run_.config;
    run_.config = config;  // what it was tuned to belongs in the file
    recording_ = program_.record(record_);
    run_.config = kept;
  }

  void begin() {
    live::LiveStart start;
    start.device = run_.device_uri;
    start.is_web = device_scheme(run_.device_uri) == "web";
    start.recording = recording_ ? record_ : "";
    start.is_lockstep = program_.options->is_lockstep;
    start.holder = holder_;
    holder_ = 0;
    room_.begin_session(start);
  }

  void end(const SessionSummary& summary) {
    if (recording_)
      recording_->close({summary.frames, summary.state_hash, summary.dropped_samples});
    recording_.reset();
    seconds_ += summary.seconds;
    room_.end_session(end_name(summary.end), summary.dropped_samples);
  }

  SessionSummary lockstep() {
    const SessionConfig config = next_config();
    open_recording(config);
    begin();
    const SessionSummary summary = run_lockstep(config, *run_.device, sinks(), program_.stop);
    end(summary);
    return summary;
  }

  SessionSummary session() {
    const SessionConfig config = next_config();
    open_recording(config);
    Session session(config, *run_.device, sinks());
    session.start();
    begin();
    while (session.is_running()) {
      if (program_.stop->load(std::memory_order_relaxed)) session.request_stop();
      if (!request_) request_ = room_.take_request();
      if (request_) session.request_stop();
      sleep_ns(kPoll);
      if (program_.poll) program_.poll();
    }
    const SessionSummary summary = session.finish();
    for (const std::string& note : summary.notes) program_.tell(note);
    end(summary);
    return summary;
  }

  /// Whether there is another session to run, and sets it up.
  bool begins_again(const SessionSummary& summary) {
    // Who is looking at a fault may begin again, and may load the page anew; without anybody there
    // the program ends.
    constexpr int kPatience = 500;  // polls
    int alone = room_.page_count() > 0 ? 0 : kPatience;
    while (!request_ && summary.end == SessionEnd::fault && alone < kPatience &&
           !program_.stop->load(std::memory_order_relaxed)) {
      request_ = room_.take_request();
      alone = room_.page_count() > 0 ? 0 : alone + 1;
      sleep_ns(kPoll);
    }
    if (!request_ || program_.stop->load(std::memory_order_relaxed)) return false;
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
      if (request.kind == live::LiveRequest::Kind::record) {
        record_ = request.flag ? free_recording() : "";
      } else if (!record_.empty()) {
        record_ = free_recording();  // one file a session
      }
      if (request.kind == live::LiveRequest::Kind::use_device) {
        use_device(request);
        return {};
      }
      run_.config.world_from_body = start_;
      reopen_run_device(*program_.options, program_.seed, run_.device_uri, run_);
      return {};
    } catch (const std::exception& error) {
      record_.clear();
      return error.what();
    }
  }

  void use_device(const live::LiveRequest& request) {
    if (run_.config.haptic.response == ResponseKind::direct)
      throw std::runtime_error(
          "the direct response is set up for its device; start with --device " + request.device);
    const bool is_web = device_scheme(request.device) == "web";
    // A person goes on from where the object is, but for a contact, inside which no force is ever
    // switched on; a hand comes to it from the start.
    run_.config.world_from_body = start_;
    reopen_run_device(*program_.options, program_.seed, request.device, run_);
    if (is_web && last_body_) run_.config.world_from_body = *last_body_;
    if (is_web) holder_ = request.page;
  }

  const LiveProgram& program_;
  Run& run_;
  const Pose start_;  // world_from_body
  std::string record_;
  live::LiveRoom room_;
  std::unique_ptr<RecordingWriter> recording_;
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
