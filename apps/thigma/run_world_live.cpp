#include "run_world_live.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <future>
#include <memory>
#include <optional>
#include <utility>

#include "run_view.h"
#include "viewer/server/live_server.h"
#include "viewer/server/origin.h"
#include "viewer/server/web_files.h"
#include "world_view.h"

#include "thigma/core/index.h"
#include "thigma/device/open_device.h"
#include "thigma/device/web_device.h"
#include "thigma/session/rt_thread.h"

namespace thigma::app {
namespace {

constexpr std::int64_t kPoll = 10'000'000;  // [ns]

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

/// Tells pages what happens in a world, once each. Thread: the world's.
class WorldEvents {
 public:
  WorldEvents(const LoadedWorld& world, live::LiveServer& server)
      : world_(world), server_(server), held_(world.config.hands.size(), -1) {}

  void observe(const WorldFrame& frame) {
    for (std::size_t i = 0; i < held_.size(); ++i) {
      const std::int32_t body = frame.grips[i].body;
      if (body == held_[i]) continue;
      if (held_[i] >= 0) tell(frame, EventKind::released, name(held_[i]), "");
      if (body >= 0) tell(frame, EventKind::grasped, name(body), "");
      held_[i] = body;
    }
    lost_ += static_cast<double>(frame.lost) / world_.config.rate;
    if (frame.time < since_ + kWindow) return;
    const double pace = (frame.time - since_) / (frame.time - since_ + lost_);
    since_ = frame.time;
    lost_ = 0.0;
    if (pace > kSlow) return;
    char text[96];
    std::snprintf(text, sizeof text, "the world goes at %.0f %% of the clock's pace", 100.0 * pace);
    tell(frame, EventKind::late, "", text);
  }

 private:
  static constexpr double kWindow = 2.0;  // in which it is judged [s]
  static constexpr double kSlow = 0.8;    // slower is told
  const std::string& name(std::int32_t body) const {
    return world_.config.world.bodies[idx(body)].name;
  }
  void tell(const WorldFrame& frame, EventKind kind, const std::string& detail,
            const std::string& text) {
    server_.observe(SessionEvent{frame.time, frame.frame, kind, detail, text});
  }

  const LoadedWorld& world_;
  live::LiveServer& server_;
  std::vector<std::int32_t> held_;   // by hand
  double lost_ = 0.0, since_ = 0.0;  // [s]
};

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
        server_(view_of(world_, static_cast<std::int32_t>(page_hand_)), config_,
                config_.world_from_body * config_.contact.body_from_mesh, {"web:"},
                live::web_files(), page_address(*program.options), link_,
                {.may_be_framed = program.options->is_embedded}) {
    facts_.devices = devices_;
  }

  WorldSummary go() {
    if (program_.log) program_.log(page_line(*program_.options, server_.address()));
    WorldSummary summary;
    do {
      summary = session();
    } while (begins_again(summary));
    return summary;
  }

 private:
  bool is_told_to_stop() const { return program_.stop->load(std::memory_order_relaxed); }

  WorldSummary session() {
    WorldDevices devices = open_world_devices(world_, devices_, program_.seed);
    page_ = make_web_device(link_);
    devices.list[page_hand_] = page_.get();
    if (duration_ > 0.0)
      world_.config.duration = std::max(duration_ - seconds_, 1.0 / world_.config.rate);
    SessionConfig config = config_;
    server_.prepare_session(config);
    live::LiveStart start;
    start.device = "web:";
    start.is_web = start.is_simulated = true;
    server_.begin_session(start);
    const WorldSummary summary = run(devices);
    seconds_ += static_cast<double>(summary.frames) / world_.config.rate;
    if (summary.has_fault())
      server_.observe(SessionEvent{static_cast<double>(summary.frames) / world_.config.rate,
                                   summary.frames, EventKind::fault, fault_name(summary.fault),
                                   ""});
    server_.end_session(end_of(summary), 0);
    return summary;
  }

  /// The session on a thread of its own, while this one hears what pages ask for.
  WorldSummary run(const WorldDevices& devices) {
    std::atomic<bool> stop{false};
    WorldEvents events(world_, server_);
    WorldShell shell;
    shell.stop = &stop;
    shell.live = &server_.ports();
    shell.sink = [&](const WorldFrame& frame) {
      server_.observe(frame);
      events.observe(frame);
    };
    std::future<WorldSummary> session = std::async(std::launch::async, [&] {
      const std::int64_t begin = thread_cpu_ns();
      WorldSummary summary = run_world_by_clock(world_.config, devices.list, shell);
      facts_.cpu_seconds = 1e-9 * static_cast<double>(thread_cpu_ns() - begin);
      return summary;
    });
    while (session.wait_for(std::chrono::nanoseconds(kPoll)) != std::future_status::ready)
      if (poll_pages() || is_told_to_stop()) stop = true;
    return session.get();
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
      if (request_->kind == Kind::reset) break;
      const bool is_there = request_->kind == Kind::use_device;
      server_.answer(*request_, is_there ? "" : kNotYet);
      request_.reset();
    }
    return true;
  }

  bool begins_again(const WorldSummary& summary) {
    // Who is looking at a fault may begin again, and may load the page anew.
    constexpr int kPatience = 500;  // polls
    int alone = server_.page_count() > 0 ? 0 : kPatience;
    while (!request_ && summary.has_fault() && alone < kPatience && !is_told_to_stop()) {
      poll_pages();
      alone = server_.page_count() > 0 ? 0 : alone + 1;
      sleep_ns(kPoll);
    }
    if (!request_ || is_told_to_stop()) return false;
    const live::LiveRequest request = *std::exchange(request_, std::nullopt);
    const bool is_over = end_of(summary) == SessionEnd::duration;
    server_.answer(request, is_over ? "the session is over" : "");
    return !is_over;
  }

  static constexpr const char* kNotYet =
      "a world of several bodies begins again, and no more: start the program anew for another "
      "scene";
  const WorldLiveProgram& program_;
  LoadedWorld& world_;
  WorldRunFacts& facts_;
  const double duration_;  // of all sessions [s]; 0: until stopped
  std::vector<std::string> devices_;
  const std::size_t page_hand_;
  WebDeviceChannel link_;
  std::unique_ptr<HapticDevice> page_;
  const SessionConfig config_;
  live::LiveServer server_;
  std::optional<live::LiveRequest> request_;
  double seconds_ = 0.0;  // of all sessions so far
};

}  // namespace

WorldSummary run_world_live(const WorldLiveProgram& program, WorldRunFacts& facts) {
  return WorldLive(program, facts).go();
}

}  // namespace thigma::app
