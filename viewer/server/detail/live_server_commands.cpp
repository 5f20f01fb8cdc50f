// What a page sends: samples of the device, and commands.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "viewer/server/detail/live_server_state.h"

namespace thigma::live {

bool is_recording_name(const std::string& name) {
  return std::filesystem::path(name).extension() == ".mcap";
}

namespace {

/// Whether what runs ends where this is granted. Files are only looked at, but recordings shown.
bool ends_session(const LiveRequest& request) {
  return request.kind != LiveRequest::Kind::inspect || is_recording_name(request.text);
}

LiveRequest request_of(PageId page, const Command& command) {
  LiveRequest request;
  switch (command.kind) {
    case Command::Kind::use_device:
      request.kind = LiveRequest::Kind::use_device;
      break;
    case Command::Kind::record:
      request.kind = LiveRequest::Kind::record;
      break;
    case Command::Kind::open:
      request.kind = LiveRequest::Kind::open;
      break;
    case Command::Kind::seek:
      request.kind = LiveRequest::Kind::seek;
      break;
    case Command::Kind::place:
      request.kind = LiveRequest::Kind::place;
      break;
    case Command::Kind::compose:
      request.kind = LiveRequest::Kind::compose;
      break;
    case Command::Kind::save:
      request.kind = LiveRequest::Kind::save;
      break;
    case Command::Kind::add:
      request.kind = LiveRequest::Kind::add;
      break;
    case Command::Kind::remove:
      request.kind = LiveRequest::Kind::remove;
      break;
    default:
      request.kind = LiveRequest::Kind::reset;
      break;
  }
  request.page = page;
  request.id = command.id;
  request.text = command.text;
  request.number = command.number;
  request.flag = command.flag;
  request.data = command.objects;
  request.point = command.point;
  return request;
}

}  // namespace

Refusal LiveServer::Impl::received(PageId page, std::string_view message, bool is_binary) {
  if (is_binary) {
    const bool is_upload = !message.empty() && message[0] == static_cast<char>(MessageKind::upload);
    return is_upload ? take_chunk(page, message) : take_samples(page, message);
  }
  ParsedCommand parsed = parse_command(message);
  if (parsed.refusal.code == 0) take_command(page, parsed.command);
  return parsed.refusal;
}

Refusal LiveServer::Impl::take_samples(PageId page, std::string_view message) {
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

std::string LiveServer::Impl::hold(PageId page, bool wanted) {
  if (!wanted) {
    if (page != holder) return "this page does not hold the device";
    holder = 0;
    link.release();
    return {};
  }
  if (!now_running.is_web)
    return "the object is moved by " + now_running.device + "; choose web: first";
  if (is_held_by_other(page)) return kIsHeld;
  holder = page;
  last_sample = -std::numeric_limits<double>::infinity();
  link.begin();
  return {};
}

/// What the page's hand takes hold of when its clutch closes next. That comes after this on the
/// same connection, and the world looks for this once it has read the hand.
std::string LiveServer::Impl::grab(PageId page, const Command& command) {
  if (!scene.world.is_world()) return kIsNoWorld;
  if (page != holder) return "this page does not hold the device";
  if (command.text.empty()) {
    ports->aim.publish(WorldAim{-1, Vec3::Zero(), scene.world.changes});
    return {};
  }
  const auto has_name = [&](const SceneBodyView& body) { return body.name == command.text; };
  const auto found = std::find_if(scene.statics.begin(), scene.statics.end(), has_name);
  const SceneBodyView* body = has_name(scene.object)         ? &scene.object
                              : found != scene.statics.end() ? &*found
                                                             : nullptr;
  if (body == nullptr) return "there is no body '" + command.text + "' here";
  if (!body->moves) return "body '" + command.text + "' stands still or goes its own way";
  WorldAim aim{body->body, Vec3::Zero(), scene.world.changes};
  if (command.point) {
    if (!((*command.point - body->hierarchy->center).norm() <= 2.0 * body->hierarchy->radius))
      return "the point is not on body '" + command.text + "'";
    aim.point = transform_point(scene.world.body_from_mesh[static_cast<std::size_t>(body->body)],
                                *command.point);
  }
  ports->aim.publish(aim);
  return {};
}

bool LiveServer::Impl::is_choice(const std::string& name) const {
  return std::any_of(now_running.choices.begin(), now_running.choices.end(),
                     [&](const LiveParameter& p) { return p.name == name; });
}

bool LiveServer::Impl::is_held_by_other(PageId page) const { return holder != 0 && holder != page; }

std::string LiveServer::Impl::pause(bool wanted) {
  // A session that is about to begin would stand still unseen: prepare_session sets both of these
  // at once.
  const std::lock_guard lock(mutex);
  if (is_restarting) return kIsRestarting;
  if (now_running.is_lockstep) return kIsLockstep;
  if (state.run == RunPhase::ended) return "the session has ended; begin again";
  if (!now_running.is_simulated)
    return "a device with motors cannot be paused: it would keep its force";
  ports->is_paused = wanted;
  ports->steps = 0;
  state.run = wanted ? RunPhase::paused : RunPhase::running;
  return {};
}

std::string LiveServer::Impl::step(double frames) {
  const std::lock_guard lock(mutex);
  if (is_restarting) return kIsRestarting;
  if (state.run != RunPhase::paused) return "only a paused session goes step by step";
  if (!(frames >= 1.0 && frames <= 1000.0) || frames != std::floor(frames))
    return "1 to 1000 frames at a time";
  ports->steps.fetch_add(static_cast<int>(frames));
  return {};
}

std::string LiveServer::Impl::cancel() {
  if (!is_preparing) return "nothing is being prepared";
  is_cancelled = true;
  return {};
}

std::string LiveServer::Impl::set_speed(double value) {
  if (now_running.replay.empty()) return "only a recording is shown faster or slower";
  if (!(value >= 0.01 && value <= 4.0)) return "a speed is from 0.01 to 4";
  replay_speed = state.replay_speed = value;
  return {};
}

std::string LiveServer::Impl::change(const Command& command) {
  const std::lock_guard lock(mutex);
  if (is_restarting) return kIsRestarting;
  if (scene.world.is_world()) return kIsWorld;
  std::string why = tuner.set(command.text, command.number);
  if (!why.empty()) return why;
  ports->haptic_tuning.publish(tuner.haptic());
  ports->contact_tuning.publish(tuner.contact());
  return {};
}

std::string LiveServer::Impl::send_level(PageId page, const Command& command) {
  const bool is_there =
      command.mesh >= 0 && command.mesh <= static_cast<std::int64_t>(scene.statics.size());
  if (!is_there) return "there is no mesh of that number";
  const SceneBodyView& body =
      command.mesh == 0 ? scene.object : scene.statics[static_cast<std::size_t>(command.mesh - 1)];
  const double level = command.number, levels = static_cast<double>(body.meshes.size());
  if (!(level >= 1.0 && level < levels) || level != std::floor(level))
    return "that level has no surface of its own";
  // Answers are never dropped, so a page that asks and does not read may not have many of these
  // waiting.
  if (server.waiting_bytes(page) > limits.waiting_bytes)
    return "this page has not taken yet what it was sent before; ask again";
  server.send(
      page,
      encode_level(static_cast<std::uint32_t>(command.mesh), static_cast<std::int32_t>(level),
                   body.meshes[static_cast<std::size_t>(level)], *body.hierarchy),
      true);
  return {};
}

/// Files that are here and that nobody has looked at yet; any may be as large as an upload may be.
std::size_t LiveServer::Impl::waiting_files() {
  const std::lock_guard lock(mutex);
  return static_cast<std::size_t>(std::count_if(
      requests.begin(), requests.end(),
      [](const LiveRequest& request) { return request.kind == LiveRequest::Kind::inspect; }));
}

void LiveServer::Impl::ask_program(LiveRequest request) {
  using Kind = LiveRequest::Kind;
  const PageId page = request.page;
  const std::int64_t id = request.id;
  const bool is_replay = !now_running.replay.empty();
  std::string why;
  if (now_running.is_lockstep) why = kIsLockstep;
  if (request.kind == Kind::use_device &&
      std::find(state.devices.begin(), state.devices.end(), request.text) == state.devices.end())
    why = "there is no device '" + request.text + "' here";
  if (ends_session(request) && is_held_by_other(page)) why = kIsHeld;
  if (request.kind == Kind::record && request.flag && !now_running.recording.empty())
    why = "a recording is being written already";
  if (request.kind == Kind::record && !request.flag && now_running.recording.empty())
    why = "no recording is being written";
  if (request.kind == Kind::seek && !is_replay) why = "no recording is shown";
  const bool is_of_bodies = request.kind == Kind::add || request.kind == Kind::remove;
  if (is_of_bodies && !scene.world.is_world()) why = kIsNoWorld;
  if (why.empty()) {
    const std::lock_guard lock(mutex);
    constexpr std::size_t kMostRequests = 32;
    if (requests.size() < kMostRequests) {
      requests.push_back(std::move(request));
      return;
    }
    why = kIsRestarting;
  }
  server.send(page, ack_message(id, why), false);
}

std::string LiveServer::Impl::take_upload(PageId page, const Command& command) {
  constexpr double kMost = 256.0 * 1024.0 * 1024.0;
  if (!(command.number >= 1.0 && command.number <= kMost)) return "a file may have up to 256 MiB";
  if (uploads.contains(page)) return "another file of this page is still on its way";
  if (uploads.size() + waiting_files() >= 2) return "other files are still on their way";
  if (is_recording_name(command.text) && is_held_by_other(page)) return kIsHeld;
  uploads[page] = {command.id, command.text, static_cast<std::size_t>(command.number), {}};
  return {};
}

Refusal LiveServer::Impl::take_chunk(PageId page, std::string_view message) {
  const std::optional<std::string_view> chunk = decode_upload(message);
  if (!chunk) return {kPolicy, "the length does not fit the upload"};
  const auto found = uploads.find(page);
  if (found == uploads.end()) return {kPolicy, "an upload that nobody asked for"};
  Upload& upload = found->second;
  if (chunk->empty() || chunk->size() > upload.bytes - upload.data.size())
    return {kPolicy, "more of a file than was said"};
  upload.data.append(*chunk);
  if (upload.data.size() < upload.bytes) return {};
  LiveRequest request{LiveRequest::Kind::inspect, page, upload.id, upload.name};
  request.data = std::move(upload.data);
  uploads.erase(found);
  ask_program(std::move(request));
  return {};
}

void LiveServer::Impl::take_command(PageId page, const Command& command) {
  // Who watches may ask for what is drawn.
  if (command.kind != Command::Kind::level && !server.may_control(page)) {
    server.send(page, ack_message(command.id, kIsWatching), false);
    return;
  }
  std::string why;
  std::optional<double> value;
  switch (command.kind) {
    case Command::Kind::hold:
      why = hold(page, command.flag);
      break;
    case Command::Kind::grab:
      why = grab(page, command);
      break;
    case Command::Kind::pause:
      why = is_held_by_other(page) ? kIsHeld : pause(command.flag);
      break;
    case Command::Kind::step:
      why = is_held_by_other(page) ? kIsHeld : step(command.number);
      break;
    case Command::Kind::set:
      if (is_choice(command.text)) {
        LiveRequest request = request_of(page, command);
        request.kind = LiveRequest::Kind::choose;
        ask_program(std::move(request));
        return;
      }
      why = is_held_by_other(page) ? kIsHeld : change(command);
      if (why.empty()) value = command.number;
      break;
    case Command::Kind::level:
      why = send_level(page, command);
      break;
    case Command::Kind::cancel:
      why = cancel();
      break;
    case Command::Kind::speed:
      why = is_held_by_other(page) ? kIsHeld : set_speed(command.number);
      break;
    case Command::Kind::upload:
      // Answered once it is here and was looked at.
      why = take_upload(page, command);
      if (why.empty()) return;
      break;
    case Command::Kind::use_device:
    case Command::Kind::reset:
    case Command::Kind::record:
    case Command::Kind::open:
    case Command::Kind::seek:
    case Command::Kind::place:
    case Command::Kind::compose:
    case Command::Kind::save:
    case Command::Kind::add:
    case Command::Kind::remove:
      ask_program(request_of(page, command));
      return;
  }
  server.send(page, ack_message(command.id, why, value), false);
  if (!why.empty()) return;
  if (command.kind == Command::Kind::set) {
    send_parameters();
  } else if (command.kind != Command::Kind::step && command.kind != Command::Kind::level &&
             command.kind != Command::Kind::grab) {
    send_state();
  }
}

}  // namespace thigma::live
