#include "viewer/server/live_server.h"

#include <algorithm>
#include <future>
#include <set>
#include <utility>

#include "viewer/server/detail/live_server_state.h"
#include "viewer/server/relief.h"

namespace thigma::live {

LiveServer::Impl::Impl(SceneView scene_in, const SessionConfig& config_in, const Pose& start_in,
                       std::vector<std::string> devices, std::vector<WebFile> files,
                       const WebAddress& address, WebDeviceChannel& link_in,
                       const WebLimits& limits_in)
    : limits(limits_in),
      ports(std::make_unique<LivePorts>()),
      link(link_in),
      feed(config_in.haptic.workspace),
      tuner(config_in),
      rate(config_in.rate),
      server(address, std::move(files), limits_in) {
  state.devices = std::move(devices);
  state.run = RunPhase::paused;
  show_scene(std::move(scene_in), config_in, start_in);
}

void LiveServer::Impl::show_scene(SceneView view, const SessionConfig& shown, const Pose& start) {
  scene = std::move(view);
  body_from_mesh = shown.contact.body_from_mesh;
  grasp_point = shown.haptic.grasp_point;
  config.haptic.workspace = shown.haptic.workspace;
  config.contact.tolerance = shown.contact.tolerance;
  config.rate = rate = shown.rate;
  start_pose = start;
  is_refined = false;
  encode_meshes();
}

/// Bodies have other numbers, and are where the scene says.
void LiveServer::Impl::carry_world(std::span<const std::int32_t> was) {
  if (was.empty()) return world_feed.forget();
  std::vector<Pose> poses(was.size());
  const auto put = [&](const SceneBodyView& body) {
    poses[static_cast<std::size_t>(body.body)] = body.world_from_mesh;
  };
  put(scene.object);
  for (const SceneBodyView& body : scene.statics) put(body);
  world_feed.carry(std::move(poses), was);
}

/// Each mesh once, however many bodies have it.
void LiveServer::Impl::encode_world_meshes() {
  std::set<std::int32_t> known;
  const auto add = [&](const SceneBodyView& body) {
    if (!known.insert(body.mesh).second) return;
    meshes.push_back(
        encode_mesh(static_cast<std::uint32_t>(body.mesh), body.meshes.front(), body.hierarchy));
  };
  add(scene.object);
  for (const SceneBodyView& body : scene.statics) add(body);
}

void LiveServer::Impl::encode_meshes() {
  meshes.clear();
  if (scene.world.is_world()) return encode_world_meshes();
  meshes.push_back(encode_mesh(0, scene.object.meshes.front(), scene.object.hierarchy));
  for (std::size_t i = 0; i < scene.statics.size(); ++i) {
    meshes.push_back(encode_mesh(static_cast<std::uint32_t>(i + 1), scene.statics[i].meshes.front(),
                                 scene.statics[i].hierarchy));
  }
  const auto add_relief = [this](std::size_t number, const SceneBodyView& body) {
    if (body.relief == nullptr) return;
    meshes.push_back(
        encode_relief(static_cast<std::uint32_t>(number), *body.relief, *body.hierarchy));
  };
  add_relief(0, scene.object);
  for (std::size_t i = 0; i < scene.statics.size(); ++i) add_relief(i + 1, scene.statics[i]);
}

void LiveServer::Impl::opened(PageId page) {
  server.send(page,
              hello_message(scene, {page, server.may_control(page)}, WebMotionParams{}.lost_after,
                            limits.message_bytes),
              false);
  send_scene(page);
  server.send(page, parameters_message(parameters()), false);
  server.send(page, menu_message(menu), false);
  if (!now_running.replay.empty())
    server.send(page, strip_message(now_running.replay_seconds, now_running.replay_force), false);
  open_pages = server.pages().size();
  send_state();
}

void LiveServer::Impl::send_scene(PageId page) {
  server.send(page, scene_message(scene, config, start_pose, is_refined), false);
  for (const std::string& mesh : meshes) server.send(page, mesh, true);
}

std::vector<LiveParameter> LiveServer::Impl::parameters() {
  std::vector<LiveParameter> all;
  if (!scene.world.is_world()) {
    const std::lock_guard lock(mutex);
    all = tuner.list();
  }
  all.insert(all.end(), now_running.choices.begin(), now_running.choices.end());
  return all;
}

void LiveServer::Impl::closed(PageId page) {
  uploads.erase(page);
  told_cameras.erase(page);
  owed.erase(page);
  open_pages = server.pages().size();
  if (page == holder) {
    holder = 0;
    link.lose();
  }
  send_state();
}

void LiveServer::Impl::began(const LiveStart& start) {
  now_running = start;
  is_rewound = false;
  owed.clear();
  send_events();  // nothing of the session before is told as of this one
  state.session += 1;
  state.run = RunPhase::running;
  state.reason = "";
  state.device = start.device;
  state.recording = start.recording;
  state.is_simulated = start.is_simulated;
  state.replay = start.replay;
  state.replay_seconds = start.replay_seconds;
  state.replay_speed = 1.0;
  replay_speed = 1.0;
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
    state.limits = next_limits;
    lock_tuner();
    tuner.judge_for(start.gains);
  }
  send_parameters();
  if (!start.replay.empty()) send_to_all(strip_message(start.replay_seconds, start.replay_force));
  send_state();
}

void LiveServer::Impl::forget_troubles() {
  state.fault = state.late = {};
  state.lates = 0;
}

void LiveServer::Impl::lock_tuner() {
  const LiveStart& start = now_running;
  tuner.lock(start.recording.empty() ? "" : kIsRecording, start.is_lockstep       ? kIsLockstep
                                                          : !start.replay.empty() ? kIsReplay
                                                                                  : "");
}

void LiveServer::Impl::lost_recording() {
  state.recording = now_running.recording = "";
  {
    const std::lock_guard lock(mutex);
    lock_tuner();
  }
  send_parameters();
  send_state();
}

void LiveServer::Impl::ended(SessionEnd end, std::uint64_t dropped) {
  send_events();  // what ended it first
  state.run = RunPhase::ended;
  state.reason = end_name(end);
  dropped_samples += dropped;
  state.recording = now_running.recording = "";
  send_state();
}

LiveServer::LiveServer(SceneView scene, const SessionConfig& config, const Pose& start,
                       std::vector<std::string> devices, std::vector<WebFile> files,
                       const WebAddress& address, WebDeviceChannel& link, const WebLimits& limits)
    : impl_(std::make_unique<Impl>(std::move(scene), config, start, std::move(devices),
                                   std::move(files), address, link, limits)) {
  Impl* impl = impl_.get();
  impl->server.start({[impl](PageId page) { impl->opened(page); },
                      [impl](PageId page) { impl->closed(page); },
                      [impl](PageId page, std::string_view message, bool is_binary) {
                        return impl->received(page, message, is_binary);
                      },
                      [impl] { impl->tick(); }});
}

LiveServer::~LiveServer() { impl_->server.stop(); }

std::string LiveServer::address() const { return impl_->server.address(); }
std::uint16_t LiveServer::port() const { return impl_->server.port(); }
LivePorts& LiveServer::ports() { return *impl_->ports; }
void LiveServer::observe(const HapticSample& sample) { impl_->feed.observe(sample); }
void LiveServer::observe(const ContactSample& sample) { impl_->feed.observe(sample); }
void LiveServer::observe(const SessionEvent& event) { impl_->feed.observe(event); }
void LiveServer::observe(const WorldFrame& frame) {
  impl_->feed.observe(impl_->world_feed.observe(frame));
  if (frame.haptic.ticks > 0) impl_->feed.observe_world_step(frame.step_cpu);
}
void LiveServer::observe(std::span<const WorldRow> rows, std::size_t near) {
  impl_->world_feed.observe(rows, near);
}

void LiveServer::prepare_session(SessionConfig& config) {
  const std::lock_guard lock(impl_->mutex);
  impl_->is_restarting = true;
  impl_->tuner.apply_to(config);
  impl_->next_limits = wrench_limits(config.haptic);
  impl_->ports->is_paused = false;
  impl_->ports->steps = 0;
  impl_->feed.begin_session(config.haptic.workspace);
  impl_->world_feed.begin_session(impl_->scene.world);
  SessionEvent began;
  began.kind = EventKind::began;  // what comes after it is of this session
  impl_->feed.observe(began);
  config.live = impl_->ports.get();
}

void LiveServer::show(SceneView scene, const SessionConfig& config, const Pose& start) {
  {
    const std::lock_guard lock(impl_->mutex);
    impl_->is_restarting = true;
    impl_->tuner = Tuner(config);
  }
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> shown = done->get_future();
  impl_->server.post([impl = impl_.get(), done, view = std::move(scene), config, start] {
    impl->show_scene(view, config, start);
    impl->feed.forget();  // else the forces of the scene before would be drawn into this one
    for (const PageId page : impl->server.pages()) impl->send_scene(page);
    impl->send_parameters();
    done->set_value();
  });
  done.reset();
  shown.wait();  // a server that has stopped drops what is posted, which also ends the wait
}

void LiveServer::refine(SceneView scene) {
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> shown = done->get_future();
  impl_->server.post([impl = impl_.get(), done, view = std::move(scene)] {
    impl->scene = view;
    impl->encode_meshes();
    impl->is_refined = true;
    for (const PageId page : impl->server.pages()) impl->send_scene(page);
    impl->is_refined = false;  // who comes later knows of no other
    done->set_value();
  });
  done.reset();
  shown.wait();
}

void LiveServer::change_world(SceneView scene, std::vector<std::int32_t> was) {
  const WorldView world = scene.world;
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> shown = done->get_future();
  impl_->server.post([impl = impl_.get(), done, view = std::move(scene), was = std::move(was)] {
    impl->scene = view;
    impl->start_pose = view.object.world_from_mesh;
    impl->encode_meshes();
    impl->carry_world(was);
    impl->is_refined = true;  // the session goes on
    for (const PageId page : impl->server.pages()) impl->send_scene(page);
    impl->is_refined = false;
    done->set_value();
  });
  done.reset();
  shown.wait();
  impl_->world_feed.begin_session(world);
}

void LiveServer::offer(const OpenMenu& menu) {
  impl_->server.post([impl = impl_.get(), menu] {
    impl->menu = menu;
    impl->send_to_all(menu_message(menu));
  });
}

void LiveServer::show_progress(const std::string& what, double share) {
  impl_->server.post(
      [impl = impl_.get(), what, share] { impl->send_to_all(progress_message(what, share)); });
}

void LiveServer::set_preparing(bool is_preparing) {
  impl_->is_cancelled = false;
  impl_->is_preparing = is_preparing;
}

bool LiveServer::is_cancelled() const { return impl_->is_cancelled; }
double LiveServer::replay_speed() const { return impl_->replay_speed; }

void LiveServer::send(PageId page, const std::string& message) {
  impl_->server.post(
      [impl = impl_.get(), page, message] { impl->server.send(page, message, false); });
}

void LiveServer::rewind() {
  impl_->feed.begin_session(impl_->config.haptic.workspace);
  auto done = std::make_shared<std::promise<void>>();
  std::future<void> rewound = done->get_future();
  impl_->server.post([impl = impl_.get(), done] {
    impl->collect_rows();  // of the time before
    impl->rows.clear();
    impl->owed.clear();
    impl->is_rewound = true;
    impl->state.session += 1;
    impl->send_state();
    done->set_value();
  });
  done.reset();
  rewound.wait();  // else rows of the time that comes would go with those before
}

void LiveServer::begin_session(const LiveStart& start) {
  impl_->server.post([impl = impl_.get(), start] { impl->began(start); });
}

void LiveServer::lose_recording() {
  impl_->server.post([impl = impl_.get()] { impl->lost_recording(); });
}

void LiveServer::end_session(SessionEnd end, std::uint64_t dropped_samples) {
  impl_->server.post(
      [impl = impl_.get(), end, dropped_samples] { impl->ended(end, dropped_samples); });
}

std::optional<LiveRequest> LiveServer::take_request() {
  const std::lock_guard lock(impl_->mutex);
  if (impl_->requests.empty()) return std::nullopt;
  LiveRequest request = std::move(impl_->requests.front());
  impl_->requests.pop_front();
  return request;
}

void LiveServer::answer(const LiveRequest& request, const std::string& reason) {
  impl_->server.post([impl = impl_.get(), page = request.page, id = request.id, reason] {
    impl->server.send(page, ack_message(id, reason), false);
    if (!impl->is_rewound) return;
    impl->collect_rows();
    impl->show();
    impl->is_rewound = false;
  });
}

std::size_t LiveServer::page_count() const { return impl_->open_pages; }

}  // namespace thigma::live
