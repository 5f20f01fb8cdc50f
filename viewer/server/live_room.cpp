#include "viewer/server/live_room.h"

#include <algorithm>
#include <future>
#include <utility>

#include "viewer/server/detail/live_room_state.h"

namespace thigma::live {

LiveRoom::Impl::Impl(SceneView scene_in, const SessionConfig& config_in, const Pose& start_in,
                     std::vector<std::string> devices, std::vector<WebFile> files,
                     std::uint16_t port, WebDeviceChannel& link_in, const WebLimits& limits_in)
    : limits(limits_in),
      ports(std::make_unique<LivePorts>()),
      link(link_in),
      feed(config_in.haptic.workspace),
      tuner(config_in),
      rate(config_in.rate),
      server(port, std::move(files), limits_in) {
  state.devices = std::move(devices);
  state.run = "paused";
  show_scene(std::move(scene_in), config_in, start_in);
}

void LiveRoom::Impl::show_scene(SceneView view, const SessionConfig& shown, const Pose& start) {
  scene = std::move(view);
  body_from_mesh = shown.contact.body_from_mesh;
  grasp_point = shown.haptic.grasp_point;
  config.haptic.workspace = shown.haptic.workspace;
  config.contact.tolerance = shown.contact.tolerance;
  config.rate = rate = shown.rate;
  start_pose = start;
  meshes.clear();
  meshes.push_back(encode_mesh(0, scene.object.meshes.front(), scene.object.hierarchy));
  for (std::size_t i = 0; i < scene.statics.size(); ++i) {
    meshes.push_back(encode_mesh(static_cast<std::uint32_t>(i + 1), scene.statics[i].meshes.front(),
                                 scene.statics[i].hierarchy));
  }
}

void LiveRoom::Impl::opened(PageId page) {
  server.send(page, hello_message(scene, page, WebMotionParams{}.lost_after, limits.message_bytes),
              false);
  tell_scene(page);
  server.send(page, parameters_message(parameters()), false);
  server.send(page, menu_message(menu), false);
  open_pages = server.pages().size();
  tell_state();
}

void LiveRoom::Impl::tell_scene(PageId page) {
  server.send(page, scene_message(scene, config, start_pose), false);
  for (const std::string& mesh : meshes) server.send(page, mesh, true);
}

std::vector<LiveParameter> LiveRoom::Impl::parameters() {
  std::vector<LiveParameter> all;
  {
    const std::lock_guard lock(mutex);
    all = tuner.list();
  }
  all.insert(all.end(), now_running.choices.begin(), now_running.choices.end());
  return all;
}

void LiveRoom::Impl::closed(PageId page) {
  uploads.erase(page);
  open_pages = server.pages().size();
  if (page == holder) {
    holder = 0;
    link.lose();
  }
  tell_state();
}

void LiveRoom::Impl::began(const LiveStart& start) {
  now_running = start;
  send_events();  // nothing of the session before is told as of this one
  state.session += 1;
  state.run = "running";
  state.reason = "";
  state.device = start.device;
  state.recording = start.recording;
  state.is_simulated = start.is_simulated;
  state.replay = start.replay;
  state.replay_seconds = start.replay_seconds;
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
    lock_tuner();
    tuner.judge_for(start.gains);
  }
  tell_parameters();
  tell_state();
}

void LiveRoom::Impl::forget_troubles() {
  state.fault = state.late = {};
  state.lates = 0;
}

void LiveRoom::Impl::lock_tuner() {
  const LiveStart& start = now_running;
  tuner.lock(start.recording.empty() ? "" : kIsRecording, start.is_lockstep       ? kIsLockstep
                                                          : !start.replay.empty() ? kIsReplay
                                                                                  : "");
}

void LiveRoom::Impl::lost_recording() {
  state.recording = now_running.recording = "";
  {
    const std::lock_guard lock(mutex);
    lock_tuner();
  }
  tell_parameters();
  tell_state();
}

void LiveRoom::Impl::ended(const std::string& reason, std::uint64_t dropped) {
  send_events();  // what ended it first
  state.run = "ended";
  state.reason = reason;
  dropped_samples += dropped;
  state.recording = now_running.recording = "";
  tell_state();
}

LiveRoom::LiveRoom(SceneView scene, const SessionConfig& config, const Pose& start,
                   std::vector<std::string> devices, std::vector<WebFile> files, std::uint16_t port,
                   WebDeviceChannel& link, const WebLimits& limits)
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
void LiveRoom::observe(const HapticSample& sample) { impl_->feed.observe(sample); }
void LiveRoom::observe(const ContactSample& sample) { impl_->feed.observe(sample); }
void LiveRoom::observe(const SessionEvent& event) { impl_->feed.observe(event); }

void LiveRoom::prepare_session(SessionConfig& config) {
  const std::lock_guard lock(impl_->mutex);
  impl_->is_restarting = true;
  impl_->tuner.apply_to(config);
  impl_->ports->is_paused = false;
  impl_->ports->steps = 0;
  impl_->feed.begin_session(config.haptic.workspace);
  SessionEvent began;
  began.kind = EventKind::began;  // what comes after it is of this session
  impl_->feed.observe(began);
  config.live = impl_->ports.get();
}

void LiveRoom::show(SceneView scene, const SessionConfig& config, const Pose& start) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->is_restarting = true;
    impl_->tuner = Tuner(config);
  }
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> shown = done->get_future();
  impl_->server.post([room = impl_.get(), done, view = std::move(scene), config, start] {
    room->show_scene(view, config, start);
    room->feed.forget();  // else the forces of the scene before would be drawn into this one
    for (const PageId page : room->server.pages()) room->tell_scene(page);
    room->tell_parameters();
    done->set_value();
  });
  done.reset();
  shown.wait();  // a server that has stopped drops what is posted, which also ends the wait
}

void LiveRoom::offer(const OpenMenu& menu) {
  impl_->server.post([room = impl_.get(), menu] {
    room->menu = menu;
    room->tell_all(menu_message(menu));
  });
}

void LiveRoom::tell_progress(const std::string& what, double share) {
  impl_->server.post(
      [room = impl_.get(), what, share] { room->tell_all(progress_message(what, share)); });
}

void LiveRoom::tell(PageId page, const std::string& message) {
  impl_->server.post(
      [room = impl_.get(), page, message] { room->server.send(page, message, false); });
}

void LiveRoom::rewind() {
  impl_->feed.begin_session(impl_->config.haptic.workspace);
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> rewound = done->get_future();
  impl_->server.post([room = impl_.get(), done] {
    room->collect_rows();  // of the time before
    room->rows.clear();
    room->state.session += 1;
    room->tell_state();
    done->set_value();
  });
  done.reset();
  rewound.wait();  // else rows of the time that comes would go with those before
}

void LiveRoom::begin_session(const LiveStart& start) {
  impl_->server.post([room = impl_.get(), start] { room->began(start); });
}

void LiveRoom::lose_recording() {
  impl_->server.post([room = impl_.get()] { room->lost_recording(); });
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
