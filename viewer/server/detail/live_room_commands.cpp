// What a page sends: samples of the device, and commands.

#include <algorithm>
#include <cmath>
#include <optional>

#include "viewer/server/detail/live_room_state.h"

namespace thigma::live {

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
  if (now_running.is_lockstep) return kIsLockstep;
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
  if (is_restarting) return kIsRestarting;
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
  if (now_running.is_lockstep) why = kIsLockstep;
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
    why = kIsRestarting;
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

}  // namespace thigma::live
