#include "thigma/recording/world_frames.h"

#include <cmath>
#include <limits>
#include <utility>

#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/core/one_line.h"
#include "thigma/files/byte_source.h"
#include "thigma/recording/detail/cut_text.h"
#include "thigma/recording/detail/world_messages.h"
#include "thigma/recording/mcap_file.h"

namespace thigma {
namespace {

using detail::refuse;
using Json = nlohmann::json;

/// What the messages of a channel are of.
struct Place {
  enum class Kind : std::uint8_t { other, config, body, joint, command, sample, haptic, events };
  Kind kind = Kind::other;
  std::size_t index = 0;  // of the body, joint or device
};

/// Number of the device of "/device/sample", "/device/2/sample".
std::size_t device_of(const std::string& topic, std::size_t devices, const std::string& path) {
  constexpr std::string_view kStart = "/device/";
  const std::string_view rest = std::string_view(topic).substr(kStart.size());
  if (rest.find('/') == std::string_view::npos) return 0;
  const std::string digits(rest.substr(0, rest.find('/')));
  const bool is_number = !digits.empty() && digits.size() <= 6 &&
                         digits.find_first_not_of("0123456789") == std::string::npos;
  const std::size_t number = is_number ? std::stoull(digits) : 0;
  if (number < 2 || number > devices)
    refuse(path, topic + " of " + std::to_string(devices) + " devices");
  return number - 1;
}

std::size_t index_of(const std::string& topic, const char* start,
                     const std::vector<std::string>& names, const std::string& path) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (topic == start + names[i] + "/state") return i;
  refuse(path, topic + " is of nothing in /config");
}

Place place_of(const std::string& topic, const WorldRecordingInfo& info, const std::string& path) {
  using Kind = Place::Kind;
  if (topic == "/config") return {Kind::config};
  if (topic == "/events") return {Kind::events};
  if (topic.starts_with("/body/"))
    return {Kind::body, index_of(topic, "/body/", info.bodies, path)};
  if (topic.starts_with("/joint/"))
    return {Kind::joint, index_of(topic, "/joint/", info.joints, path)};
  if (!topic.starts_with("/device/")) return {};
  const auto of_device = [&](Kind kind) {
    if (info.devices.empty()) refuse(path, topic + " of 0 devices");
    return Place{kind, device_of(topic, info.devices.size(), path)};
  };
  if (topic.ends_with("/command")) return of_device(Kind::command);
  if (topic.ends_with("/sample")) return of_device(Kind::sample);
  if (topic.ends_with("/haptic")) return of_device(Kind::haptic);
  return {};
}

/// A frame of which nothing has been read.
RecordedWorldFrame empty_frame(const WorldRecordingInfo& info) {
  const Vec3 none = Vec3::Constant(std::numeric_limits<double>::quiet_NaN());
  RecordedWorldFrame frame;
  frame.bodies.resize(info.bodies.size());
  frame.is_asleep.resize(info.bodies.size());
  frame.joints.assign(info.joints.size(), {none.x(), none.x(), none.x(), none.x()});
  frame.commands.assign(info.devices.size(), {none, none});
  frame.hands.resize(info.devices.size());
  return frame;
}

/// Puts frames together and tells of each when the next begins, or the file ends.
struct Assembly {
  const std::string& path;
  const WorldRecordingSinks& sinks;
  WorldRecording said{};  // by /config and the end; its frames stay empty
  WorldRecordingPass pass{};
  RecordedWorldFrame frame{};
  std::vector<Place> places{};         // by channel
  std::vector<std::uint64_t> steps{};  // of the hands so far
  std::vector<double> step_times{};    // of the last of each [s]
  // messages of the frame, and of the one before; bodies of it
  std::size_t has = 0, had = 0, bodies = 0;

  void take(const McapScan& scan, const McapMessage& message) {
    const auto channel = static_cast<std::size_t>(message.channel);
    const std::string& topic = scan.topics[channel];
    if (said.bodies.empty()) {
      if (topic != "/config") refuse(path, topic + " before /config");
      return begin(message.data);
    }
    while (places.size() < scan.topics.size())
      places.push_back(place_of(scan.topics[places.size()], said, path));
    const Place place = places[channel];
    if (place.kind == Place::Kind::config) refuse(path, "/config a second time");
    if (place.kind == Place::Kind::other) return;
    const Json json = Json::parse(message.data);
    if (place.kind == Place::Kind::events) return read_end(json);
    if (place.kind == Place::Kind::haptic) return read_haptic(place.index, json);
    if (place.kind == Place::Kind::body && place.index == 0) begin_frame(message, json);
    read_part(place, topic, json);
  }

  /// What was begun and not ended is left out, unless the recording says that it is whole.
  void finish() {
    const bool is_whole = said.has_end || has >= had;
    if (bodies == said.bodies.size() && is_whole) end_frame();
  }

 private:
  void begin(std::string_view text) {
    detail::read_world_config(text, path, said);
    if (said.bodies.empty()) refuse(path, "/config without bodies");
    steps.assign(said.devices.size(), 0);
    step_times.assign(said.devices.size(), 0.0);
    if (sinks.info) sinks.info(said);
  }

  void begin_frame(const McapMessage& message, const Json& json) {
    if (bodies != 0 && bodies != said.bodies.size())
      refuse(path, "a frame without all of its bodies");
    end_frame();
    frame = empty_frame(said);
    frame.frame = pass.frame_count;
    frame.time = static_cast<double>(message.time) / 1e9;
  }

  void end_frame() {
    if (bodies == 0) return;
    ++pass.frame_count;
    pass.last_time = frame.time;
    if (sinks.frame) sinks.frame(frame);
    had = std::exchange(has, 0);
    bodies = 0;
  }

  /// Every frame has its message: one that is left out would have all that follow compared with
  /// others.
  void check_frame(const std::string& topic, const Json& json) const {
    if (json.contains("frame") && detail::read_count(json, "frame") != frame.frame)
      throw InputError(topic + " out of order, at frame " + std::to_string(frame.frame));
  }

  void read_part(const Place& place, const std::string& topic, const Json& json) {
    using Kind = Place::Kind;
    check_frame(topic, json);
    if (place.kind == Kind::body) {
      if (place.index != bodies++) refuse(path, topic + " out of order");
      frame.bodies[place.index] = detail::read_body(json);
      if (json.contains("asleep")) frame.is_asleep[place.index] = json.at("asleep").get<bool>();
    }
    ++has;
    // Whoever reads such a message without its frame still hears what is wrong with it.
    if (place.kind == Kind::joint) {
      const RecordedJoint joint = detail::read_joint(json);
      if (bodies > 0) frame.joints[place.index] = joint;
    } else if (place.kind == Kind::command) {
      const Wrench wrench = detail::read_wrench(json);
      if (bodies > 0) frame.commands[place.index] = wrench;
    } else if (place.kind == Kind::sample) {
      RecordedHand hand = detail::read_hand(json);
      if (bodies > 0) frame.hands[place.index] = hand;
    }
  }

  void read_haptic(std::size_t hand, const Json& json) {
    if (!said.is_apart) refuse(path, "a haptic step of hands that are not apart");
    const HandTick tick = detail::read_tick(json, hand, steps[hand]++, step_times[hand]);
    step_times[hand] = tick.tick.now;
    ++pass.tick_count;
    if (sinks.tick) sinks.tick(tick);
  }

  void read_end(const Json& json) {
    if (json.value("event", "") != "end") return;
    said.frames = detail::read_count(json, "frames");
    said.state_hash = std::stoull(json.at("state_hash").get<std::string>(), nullptr, 16);
    if (json.contains("haptic_steps")) {  // older recordings do not tell
      said.haptic_steps.clear();
      for (const Json& made : json.at("haptic_steps"))
        said.haptic_steps.push_back(detail::count_of(made, "haptic_steps"));
      if (said.haptic_steps.size() != said.devices.size())
        throw InputError("haptic_steps are not of each device");
    }
    said.has_end = true;
  }
};

/// Errors of the parser and of messages, by the file's name.
McapScan scan(ByteSource& source, const std::string& path, Assembly& assembly) {
  try {
    return scan_mcap(source, path, [&](const McapScan& file, const McapMessage& message) {
      assembly.take(file, message);
      return true;
    });
  } catch (const Json::exception&) {
    refuse(path, "a message is damaged");
  } catch (const std::logic_error&) {  // of stoull
    refuse(path, "the hash is damaged");
  } catch (const InputError& error) {
    const std::string why = error.what();
    if (why.starts_with(path)) throw;
    refuse(path, why);
  }
}

WorldRecordingPass stream(ByteSource& source, const std::string& path,
                          const WorldRecordingSinks& sinks) {
  Assembly assembly{path, sinks};
  McapScan file = scan(source, path, assembly);
  if (assembly.said.bodies.empty()) refuse(path, "no /config");
  assembly.finish();
  WorldRecordingPass pass = std::move(assembly.pass);
  pass.info = static_cast<const WorldRecordingInfo&>(assembly.said);
  pass.warnings = std::move(file.warnings);
  if (!pass.info.has_end || !file.cut.empty()) {
    pass.cut_off = detail::cut_text(pass.last_time, pass.frame_count, file);
    pass.warnings.push_back(pass.cut_off);
  }
  return pass;
}

/// All of it in memory.
WorldRecording gather(ByteSource& source, const std::string& path) {
  WorldRecording out;
  WorldRecordingSinks sinks;
  sinks.info = [&](const WorldRecordingInfo& info) {
    out.hands.resize(info.devices.size());
    out.ticks.resize(info.devices.size());
  };
  sinks.frame = [&](const RecordedWorldFrame& frame) {
    out.states.insert(out.states.end(), frame.bodies.begin(), frame.bodies.end());
    for (std::size_t i = 0; i < frame.hands.size(); ++i)
      if (frame.hands[i]) out.hands[i].push_back(*frame.hands[i]);
  };
  sinks.tick = [&](const HandTick& tick) {
    out.ticks[static_cast<std::size_t>(tick.hand)].push_back(tick);
  };
  WorldRecordingPass pass = stream(source, path, sinks);
  static_cast<WorldRecordingInfo&>(out) = std::move(pass.info);
  out.cut_off = std::move(pass.cut_off);
  out.warnings = std::move(pass.warnings);
  return out;
}

}  // namespace

WorldRecordingPass stream_world_recording(const std::string& path,
                                          const WorldRecordingSinks& sinks) {
  refuse_absent_recording(path);
  FileSource source(path);
  return stream(source, path, sinks);
}

WorldRecording read_world_recording(const std::string& path) {
  refuse_absent_recording(path);
  FileSource source(path);
  return gather(source, path);
}

WorldRecording parse_world_recording(std::string bytes, const std::string& path) {
  MemorySource source(bytes);
  return gather(source, path);
}

}  // namespace thigma
