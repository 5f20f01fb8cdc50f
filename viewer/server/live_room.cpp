#include "viewer/server/live_room.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>

#include "viewer/server/feed.h"
#include "viewer/server/protocol.h"
#include "viewer/server/timing_window.h"
#include "viewer/server/tuning.h"

namespace thigma::live {
namespace {

constexpr std::size_t kMostRows = 250;     // of a batch
constexpr std::uint64_t kIdleTicks = 15;   // a snapshot four times a second where nothing moves
constexpr std::uint64_t kStateTicks = 60;  // `state` once a second
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

double wall_seconds() { return 1e-9 * static_cast<double>(monotonic_ns()); }

const char* lockstep_sentence() { return "a session in lockstep is the same every time"; }
const char* recording_sentence() {
  return "a recording is being written, and could not be replayed if this changed: stop it first";
}
const char* restart_sentence() { return "the session is just beginning anew"; }

}  // namespace

struct LiveRoom::Impl {
  Impl(SceneView scene_in, const SessionConfig& config_in, const Pose& start_in,
       std::vector<std::string> devices, std::vector<WebFile> files, std::uint16_t port,
       WebLink& link_in, const WebLimits& limits_in)
      : scene(std::move(scene_in)),
        body_from_mesh(config_in.contact.body_from_mesh),
        grasp_point(config_in.haptic.grasp_point),
        limits(limits_in),
        ports(std::make_unique<LivePorts>()),
        link(link_in),
        feed(config_in.haptic.workspace),
        tuner(config_in),
        rate(config_in.rate),
        server(port, std::move(files), limits_in) {
    config.haptic.workspace = config_in.haptic.workspace;
    config.contact.tolerance = config_in.contact.tolerance;
    config.rate = config_in.rate;
    start_pose = start_in;
    state.devices = std::move(devices);
    state.run = "paused";
    meshes.push_back(encode_mesh(0, *scene.object.mesh, scene.object.hierarchy));
    for (std::size_t i = 0; i < scene.statics.size(); ++i) {
      meshes.push_back(encode_mesh(static_cast<std::uint32_t>(i + 1), *scene.statics[i].mesh,
                                   scene.statics[i].hierarchy));
    }
  }

  // On the server's thread.
  void opened(PageId page);
  void closed(PageId page);
  Refusal received(PageId page, std::string_view message, bool is_binary);
  Refusal take_samples(PageId page, std::string_view message);
  void take_command(PageId page, const Command& command);
  std::string hold(PageId page, bool wanted);
  std::string pause(bool wanted);
  std::string step(double frames);
  std::string change(const Command& command);
  void ask_program(PageId page, const Command& command);
  void tick();
  void collect_rows();
  void show();
  void send_events();
  void tell_state();
  void tell_state_to(PageId page);
  void tell_parameters();
  void tell_all(const std::string& text);
  Snapshot snapshot_now(const HapticNow& now);
  void began(const LiveStart& start);
  void ended(const std::string& reason, std::uint64_t dropped_samples);

  // Constant.
  const SceneView scene;
  SessionConfig config;  // what `scene` tells of it
  const Pose body_from_mesh;
  const Vec3 grasp_point;
  const WebLimits limits;
  Pose start_pose;
  std::vector<std::string> meshes;

  // Between threads.
  std::unique_ptr<LivePorts> ports;
  WebLink& link;
  LiveFeed feed;
  std::atomic<std::size_t> open_pages{0};
  mutable std::mutex mutex;  // of what follows; never held for longer than a copy takes
  Tuner tuner;
  bool is_restarting = true;
  std::deque<LiveRequest> requests;

  // The server's thread only.
  RunState state;
  LiveStart now_running;
  PageId holder = 0;
  double last_sample = -std::numeric_limits<double>::infinity();  // of the holder's clock
  Timing timing{kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, 0};
  TimingWindow window;
  std::vector<ChannelRow> rows;
  std::vector<double> query_times;
  std::vector<SessionEvent> events;
  std::vector<ViewedCluster> clusters;
  std::uint64_t ticks = 0, left_out = 0, dropped_samples = 0;
  Fault last_fault = Fault::none;
  double rate;

  WebServer server;  // last: its thread uses all of the above
};

void LiveRoom::Impl::opened(PageId page) {
  server.send(page, hello_message(scene, page, WebMotionParams{}.lost_after, limits.message_bytes),
              false);
  server.send(page, scene_message(scene, config, start_pose), false);
  for (const std::string& mesh : meshes) server.send(page, mesh, true);
  {
    const std::lock_guard lock(mutex);
    server.send(page, parameters_message(tuner.list()), false);
  }
  open_pages = server.pages().size();
  tell_state();
}

void LiveRoom::Impl::closed(PageId page) {
  open_pages = server.pages().size();
  if (page == holder) {
    holder = 0;
    link.lose();
  }
  tell_state();
}

Refusal LiveRoom::Impl::received(PageId page, std::string_view message, bool is_binary) {
  if (is_binary) return take_samples(page, message);
  ParsedCommand parsed = parse_command(message);
  if (parsed.refusal.code == 0) take_command(page, parsed.command);
  return parsed.refusal;
}

Refusal LiveRoom::Impl::take_samples(PageId page, std::string_view message) {
  const DeviceMessage device = decode_device(message);
  if (!device.problem.empty()) return {kPolicy, device.problem};
  if (page != holder) return {};  // it may not have heard yet that it has lost the device
  for (const WebSample& sample : device.samples) {
    if (sample.time < last_sample) return {kPolicy, "the browser's clock runs backwards"};
    last_sample = sample.time;
    link.push(sample);
  }
  return {};
}

std::string LiveRoom::Impl::hold(PageId page, bool wanted) {
  if (!wanted) {
    if (page != holder) return "this page does not hold the device";
    holder = 0;
    link.release();
    return {};
  }
  if (!now_running.is_web)
    return "the object is moved by " + now_running.device + "; choose web: first";
  if (holder != 0 && holder != page) return "another page holds the device";
  holder = page;
  last_sample = -std::numeric_limits<double>::infinity();
  link.begin();
  return {};
}

std::string LiveRoom::Impl::pause(bool wanted) {
  if (now_running.is_lockstep) return lockstep_sentence();
  if (state.run == "ended") return "the session has ended; begin again";
  if (!now_running.is_simulated)
    return "a device with motors cannot be paused: it would keep its force";
  ports->is_paused = wanted;
  ports->steps = 0;
  state.run = wanted ? "paused" : "running";
  return {};
}

std::string LiveRoom::Impl::step(double frames) {
  if (state.run != "paused") return "only a paused session goes step by step";
  if (!(frames >= 1.0 && frames <= 1000.0) || frames != std::floor(frames))
    return "1 to 1000 frames at a time";
  ports->steps.fetch_add(static_cast<int>(frames));
  return {};
}

std::string LiveRoom::Impl::change(const Command& command) {
  const std::lock_guard lock(mutex);
  if (is_restarting) return restart_sentence();
  std::string why = tuner.set(command.text, command.number);
  if (!why.empty()) return why;
  ports->haptic_tuning.publish(tuner.haptic());
  ports->contact_tuning.publish(tuner.contact());
  return {};
}

void LiveRoom::Impl::ask_program(PageId page, const Command& command) {
  LiveRequest request{LiveRequest::Kind::reset, page, command.id, command.text, command.flag};
  if (command.kind == Command::Kind::use_device) request.kind = LiveRequest::Kind::use_device;
  if (command.kind == Command::Kind::record) request.kind = LiveRequest::Kind::record;
  std::string why;
  if (now_running.is_lockstep) why = lockstep_sentence();
  if (request.kind == LiveRequest::Kind::use_device &&
      std::find(state.devices.begin(), state.devices.end(), command.text) == state.devices.end())
    why = "there is no device '" + command.text + "' here";
  if (request.kind == LiveRequest::Kind::use_device && holder != 0 && holder != page)
    why = "another page holds the device";
  if (request.kind == LiveRequest::Kind::record && command.flag && !now_running.recording.empty())
    why = "a recording is being written already";
  if (request.kind == LiveRequest::Kind::record && !command.flag && now_running.recording.empty())
    why = "no recording is being written";
  if (why.empty()) {
    const std::lock_guard lock(mutex);
    constexpr std::size_t kMostRequests = 32;
    if (requests.size() < kMostRequests) {
      requests.push_back(std::move(request));
      return;
    }
    why = restart_sentence();
  }
  server.send(page, ack_message(command.id, why), false);
}

void LiveRoom::Impl::take_command(PageId page, const Command& command) {
  std::string why;
  std::optional<double> value;
  switch (command.kind) {
    case Command::Kind::hold:
      why = hold(page, command.flag);
      break;
    case Command::Kind::pause:
      why = pause(command.flag);
      break;
    case Command::Kind::step:
      why = step(command.number);
      break;
    case Command::Kind::set:
      why = change(command);
      if (why.empty()) value = command.number;
      break;
    case Command::Kind::use_device:
    case Command::Kind::reset:
    case Command::Kind::record:
      ask_program(page, command);
      return;
  }
  server.send(page, ack_message(command.id, why, value), false);
  if (!why.empty()) return;
  if (command.kind == Command::Kind::set) {
    tell_parameters();
  } else if (command.kind != Command::Kind::step) {
    tell_state();
  }
}

void LiveRoom::Impl::collect_rows() {
  rows.clear();
  query_times.clear();
  feed.take_rows(rows);
  feed.take_query_times(query_times);
  add(rows, query_times, window);
  if (rows.size() <= kMostRows) return;
  left_out += rows.size() - kMostRows;
  rows.erase(rows.begin(), rows.end() - static_cast<std::ptrdiff_t>(kMostRows));
}

Snapshot LiveRoom::Impl::snapshot_now(const HapticNow& now) {
  RigidBody body;
  {
    const std::lock_guard lock(mutex);
    body = tuner.haptic().body;
  }
  Snapshot s = make_snapshot(now, feed.contact(), body, config.haptic.workspace, body_from_mesh,
                             grasp_point, clusters);
  if (state.run == "paused") s.bits |= kPaused;
  if (state.run == "ended") s.bits |= kEnded;
  s.haptic_hz = timing.haptic_hz;
  s.contact_hz = timing.contact_hz;
  s.newton_length = 0.4 * scene.object.hierarchy->radius;
  ports->contacts.fetch();
  const ContactView& view = ports->contacts.value();
  s.found = view.found;
  s.dropped = view.dropped;
  s.front = view.front;
  s.contacts = {view.contacts.begin(), view.contacts.size()};
  return s;
}

void LiveRoom::Impl::show() {
  const HapticNow* now = feed.haptic();
  if (now == nullptr) return;
  if (now->sample.fault != last_fault) {
    last_fault = now->sample.fault;
    if (state.run != "ended") {
      state.reason = last_fault == Fault::none ? "" : fault_name(last_fault);
      tell_state();
    }
  }
  const std::vector<PageId> pages = server.pages();
  if (pages.empty() || (rows.empty() && ticks % kIdleTicks != 0)) return;
  std::vector<std::string> messages;
  if (!rows.empty()) messages.push_back(encode_channels(rows));
  messages.push_back(encode_snapshot(snapshot_now(*now)));
  for (const PageId page : pages) server.offer(page, messages);
}

void LiveRoom::Impl::send_events() {
  events.clear();
  feed.take_events(events);
  for (const SessionEvent& event : events) tell_all(event_message(event));
}

void LiveRoom::Impl::tick() {
  ++ticks;
  collect_rows();
  show();
  send_events();
  if (ticks % kStateTicks != 0) return;
  const HapticNow* now = feed.haptic();
  const std::uint64_t frame = now != nullptr ? now->sample.frame : 0;
  timing = close(wall_seconds(), now != nullptr, frame, feed.contact_updates(), window);
  if (now != nullptr) {
    // Session time counts every tick, frames only those that were made.
    const double due = std::floor(now->sample.time * rate + 0.5);
    timing.missed = static_cast<std::uint64_t>(std::max(0.0, due - static_cast<double>(frame)));
  }
  tell_state();
}

void LiveRoom::Impl::tell_state_to(PageId page) {
  const char* holds = holder == 0 ? "none" : holder == page ? "you" : "other";
  server.send(page,
              state_message(state, timing, holds, server.dropped(page),
                            left_out + feed.dropped_rows(), dropped_samples),
              false);
}

void LiveRoom::Impl::tell_state() {
  const std::vector<PageId> pages = server.pages();
  const HapticNow* now = feed.haptic();
  state.time = now != nullptr ? now->sample.time : 0.0;
  state.pages = pages.size();
  for (const PageId page : pages) tell_state_to(page);
}

void LiveRoom::Impl::tell_parameters() {
  std::string text;
  {
    const std::lock_guard lock(mutex);
    text = parameters_message(tuner.list());
  }
  tell_all(text);
}

void LiveRoom::Impl::tell_all(const std::string& text) {
  for (const PageId page : server.pages()) server.send(page, text, false);
}

void LiveRoom::Impl::began(const LiveStart& start) {
  now_running = start;
  state.session += 1;
  state.run = "running";
  state.reason = "";
  state.device = start.device;
  state.recording = start.recording;
  state.is_simulated = start.is_simulated;
  last_fault = Fault::none;
  if (!start.is_web && holder != 0) {
    holder = 0;
    link.release();
  }
  if (start.is_web && start.holder != 0) {
    const std::vector<PageId> pages = server.pages();
    if (std::find(pages.begin(), pages.end(), start.holder) != pages.end())
      hold(start.holder, true);
  }
  {
    const std::lock_guard lock(mutex);
    is_restarting = false;
    tuner.lock(start.recording.empty() ? "" : recording_sentence(),
               start.is_lockstep ? lockstep_sentence() : "");
  }
  tell_parameters();
  tell_state();
}

void LiveRoom::Impl::ended(const std::string& reason, std::uint64_t dropped) {
  state.run = "ended";
  state.reason = reason;
  dropped_samples += dropped;
  state.recording = now_running.recording = "";
  tell_state();
}

LiveRoom::LiveRoom(SceneView scene, const SessionConfig& config, const Pose& start,
                   std::vector<std::string> devices, std::vector<WebFile> files, std::uint16_t port,
                   WebLink& link, const WebLimits& limits)
    : impl_(std::make_unique<Impl>(std::move(scene), config, start, std::move(devices),
                                   std::move(files), port, link, limits)) {
  Impl* room = impl_.get();
  room->server.start({[room](PageId page) { room->opened(page); },
                      [room](PageId page) { room->closed(page); },
                      [room](PageId page, std::string_view message, bool is_binary) {
                        return room->received(page, message, is_binary);
                      },
                      [room] { room->tick(); }});
}

LiveRoom::~LiveRoom() { impl_->server.stop(); }

std::string LiveRoom::address() const { return impl_->server.address(); }
std::uint16_t LiveRoom::port() const { return impl_->server.port(); }
LivePorts& LiveRoom::ports() { return *impl_->ports; }
void LiveRoom::look_at(const HapticSample& sample) { impl_->feed.look_at(sample); }
void LiveRoom::look_at(const ContactSample& sample) { impl_->feed.look_at(sample); }
void LiveRoom::look_at(const SessionEvent& event) { impl_->feed.look_at(event); }

void LiveRoom::prepare_session(SessionConfig& config) {
  const std::lock_guard lock(impl_->mutex);
  impl_->is_restarting = true;
  impl_->tuner.apply_to(config);
  impl_->ports->is_paused = false;
  impl_->ports->steps = 0;
  impl_->feed.begin_session();
  config.live = impl_->ports.get();
}

void LiveRoom::begin_session(const LiveStart& start) {
  impl_->server.post([room = impl_.get(), start] { room->began(start); });
}

void LiveRoom::end_session(const std::string& reason, std::uint64_t dropped_samples) {
  impl_->server.post(
      [room = impl_.get(), reason, dropped_samples] { room->ended(reason, dropped_samples); });
}

std::optional<LiveRequest> LiveRoom::take_request() {
  const std::lock_guard lock(impl_->mutex);
  if (impl_->requests.empty()) return std::nullopt;
  LiveRequest request = std::move(impl_->requests.front());
  impl_->requests.pop_front();
  return request;
}

void LiveRoom::answer(const LiveRequest& request, const std::string& reason) {
  impl_->server.post([room = impl_.get(), request, reason] {
    room->server.send(request.page, ack_message(request.id, reason), false);
  });
}

std::size_t LiveRoom::page_count() const { return impl_->open_pages; }

}  // namespace thigma::live
