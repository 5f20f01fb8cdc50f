#include "thigma/recording/world_recording.h"

#include <algorithm>
#include <cmath>

#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/recording/detail/config_fields.h"
#include "thigma/recording/detail/json_read.h"
#include "thigma/recording/detail/json_text.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"

namespace thigma {
namespace {

constexpr const char* kKind = "thigma world 1";
constexpr auto kNull = detail::NullNumber::not_a_number;

std::uint64_t nanoseconds(double seconds) {
  return static_cast<std::uint64_t>(std::llround(1e9 * seconds));
}

/// Limits of a device as JSON, written and read by one list of fields.
struct LimitsWriter {
  nlohmann::ordered_json& json;
  template <class Value>
  void operator()(const char* key, const Value& value) const {
    json[key] = value;
  }
  template <class Enum>
  void flag_for(const char* key, Enum value, Enum of_true, Enum) const {
    json[key] = value == of_true;
  }
};

struct LimitsReader {
  const nlohmann::json& json;
  void operator()(const char* key, double& value) const {
    value = detail::read_number(json.at(key), kNull);
    if (!(value >= 0.0) || !std::isfinite(value))
      throw InputError(std::string("a device's ") + key + " is not a number from 0 on");
  }
  void operator()(const char* key, bool& value) const { value = json.at(key).get<bool>(); }
  template <class Enum>
  void flag_for(const char* key, Enum& value, Enum of_true, Enum of_false) const {
    value = json.at(key).get<bool>() ? of_true : of_false;
  }
};

std::string config_text(const WorldRecordingInfo& info) {
  nlohmann::ordered_json json;
  json["kind"] = kKind;
  json["scene"] = info.scene;
  json["device"] = info.devices.empty() ? "" : info.devices.front();
  json["devices"] = info.devices;
  json["seed"] = info.seed;
  json["rate_hz"] = info.rate;
  if (info.friction) json["friction"] = *info.friction;
  json["bodies"] = info.bodies;
  json["joints"] = info.joints;
  if (info.is_apart) json["apart"] = true;
  if (!info.limits.empty()) {
    json["limits"] = nlohmann::ordered_json::array();
    for (const DeviceLimits& limits : info.limits)
      detail::visit_device_limits(limits, LimitsWriter{json["limits"].emplace_back()});
  }
  return json.dump();
}

[[noreturn]] void refuse(const std::string& path, const std::string& what) {
  throw InputError(path + ": " + what + ", expected a recording of a world");
}

void read_config_text(std::string_view text, const std::string& path, WorldRecording& out) {
  const auto json = nlohmann::json::parse(text);
  if (json.value("kind", "") != kKind) refuse(path, "/config is of another kind");
  out.scene = json.at("scene").get<std::string>();
  if (json.contains("devices"))  // older recordings have one at most
    out.devices = json.at("devices").get<std::vector<std::string>>();
  else if (const auto device = json.at("device").get<std::string>(); !device.empty())
    out.devices = {device};
  out.hands.resize(out.devices.size());
  out.ticks.resize(out.devices.size());
  out.is_apart = json.value("apart", false);
  if (json.contains("limits")) {
    for (const auto& limits : json.at("limits"))
      detail::visit_device_limits(out.limits.emplace_back(), LimitsReader{limits});
    if (out.limits.size() != out.devices.size()) refuse(path, "/config has not all limits");
  }
  out.seed = json.at("seed").get<std::uint64_t>();
  out.rate = json.at("rate_hz").get<double>();
  out.bodies = json.at("bodies").get<std::vector<std::string>>();
  if (json.contains("joints"))  // older recordings have none
    out.joints = json.at("joints").get<std::vector<std::string>>();
  if (!(out.rate >= 50.0 && out.rate <= 20000.0)) refuse(path, "rate_hz is not from 50 to 20000");
  if (json.contains("friction")) {
    out.friction = json.at("friction").get<double>();
    if (!(*out.friction >= 0.0 && std::isfinite(*out.friction)))
      refuse(path, "friction is not a number from 0 on");
  }
}

BodyState read_state(std::string_view text) {
  const auto json = nlohmann::json::parse(text);
  BodyState y;
  Pose pose;
  detail::read_pose(json, pose, kNull);
  y.position = pose.position;
  y.orientation = pose.orientation;
  detail::read_vector(json, "linear_momentum", y.linear_momentum, kNull);
  detail::read_vector(json, "angular_momentum", y.angular_momentum, kNull);
  return y;
}

void put_device(const DeviceState& d, detail::JsonObject& json) {
  json.number("time", d.time);
  json.pose(d.motion.pose);
  json.vector("linear", d.motion.twist.linear);
  json.vector("angular", d.motion.twist.angular);
  json.integer("buttons", d.buttons);
  json.integer("status", static_cast<int>(d.status));
  json.number("weight", d.weight);
}

void put_hand(const RecordedHand& hand, detail::JsonObject& json) {
  put_device(hand.device, json);
  if (hand.seen.told != 0) {
    json.integer("read", static_cast<long long>(hand.seen.read));
    json.integer("told", static_cast<long long>(hand.seen.told));
  }
  if (!hand.aimed) return;
  json.integer("aim", hand.aimed->body);
  json.vector("point", hand.aimed->point);
}

DeviceState read_device(const nlohmann::json& json) {
  DeviceState d;
  d.time = detail::read_number(json.at("time"), kNull);
  detail::read_pose(json, d.motion.pose, kNull);
  detail::read_vector(json, "linear", d.motion.twist.linear, kNull);
  detail::read_vector(json, "angular", d.motion.twist.angular, kNull);
  d.buttons = json.at("buttons").get<std::uint32_t>();
  const int status = json.at("status").get<int>();
  if (status < 0 || status > static_cast<int>(DeviceStatus::finished))
    throw InputError("a hand's status is not from 0 to 3");
  d.status = static_cast<DeviceStatus>(status);
  d.weight = detail::read_number(json.at("weight"), kNull);
  return d;
}

/// A whole number from 0 on; whoever casts -1 or 1.5 has another.
std::uint64_t read_count(const nlohmann::json& json, const char* name) {
  const auto& value = json.at(name);
  if (!value.is_number_unsigned())
    throw InputError(std::string(name) + " is not a whole number from 0 on");
  return value.get<std::uint64_t>();
}

RecordedHand read_hand(std::string_view text) {
  const auto json = nlohmann::json::parse(text);
  RecordedHand hand;
  hand.device = read_device(json);
  if (json.contains("read")) hand.seen.read = read_count(json, "read");
  if (json.contains("told")) hand.seen.told = read_count(json, "told");
  if (!json.contains("aim")) return hand;
  hand.aimed = WorldAim{json.at("aim").get<std::int32_t>(), Vec3::Zero()};
  detail::read_vector(json, "point", hand.aimed->point, kNull);
  return hand;
}

void put_tick(const HandTick& made, detail::JsonObject& json) {
  json.number("now", made.tick.now);
  json.number("elapsed", made.tick.elapsed);
  json.integer("fault", static_cast<int>(made.tick.external_fault));
  json.integer("news", static_cast<long long>(made.news));
  put_device(made.device, json);
  if (made.device.has_true_handle) {
    json.vector("true_position", made.device.true_handle.position);
    json.vector("true_quat_xyzw", made.device.true_handle.orientation.coeffs());
  }
  json.vector("force", made.sent.force);
  json.vector("torque", made.sent.torque);
}

HandTick read_tick(std::string_view text, std::size_t hand, std::size_t step) {
  const auto json = nlohmann::json::parse(text);
  HandTick made;
  made.hand = static_cast<std::int32_t>(hand);
  made.step = read_count(json, "frame");
  if (made.step != step) throw InputError("a haptic step is missing");
  made.tick.now = detail::read_number(json.at("now"), kNull);
  made.tick.elapsed = detail::read_number(json.at("elapsed"), kNull);
  const std::uint64_t fault = read_count(json, "fault");
  if (fault > static_cast<std::uint64_t>(Fault::watchdog))
    throw InputError("a haptic step has a fault that there is not");
  made.tick.external_fault = static_cast<Fault>(fault);
  made.news = read_count(json, "news");
  made.device = read_device(json);
  if (json.contains("true_position")) {
    made.device.has_true_handle = true;
    detail::read_vector(json, "true_position", made.device.true_handle.position, kNull);
    Vec4 q = Vec4::Zero();
    detail::read_vector(json, "true_quat_xyzw", q, kNull);
    made.device.true_handle.orientation.coeffs() = q;
  }
  detail::read_vector(json, "force", made.sent.force, kNull);
  detail::read_vector(json, "torque", made.sent.torque, kNull);
  return made;
}

/// Number of the device of a topic "/device/sample", "/device/2/sample".
std::size_t device_of(const std::string& topic, const WorldRecording& out) {
  constexpr std::string_view kStart = "/device/";
  if (topic == "/device/sample" || topic == "/device/haptic") return 0;
  const std::size_t number = std::stoull(topic.substr(kStart.size())) - 1;
  return number < out.devices.size() ? number : 0;
}

void read_end(std::string_view text, WorldRecording& out) {
  const auto json = nlohmann::json::parse(text);
  if (json.value("event", "") != "end") return;
  out.frames = json.at("frames").get<std::uint64_t>();
  out.state_hash = std::stoull(json.at("state_hash").get<std::string>(), nullptr, 16);
  out.has_end = true;
}

}  // namespace

bool is_page_hand(const std::string& address) { return device_scheme(address) == "web"; }

WorldRecordingWriter::WorldRecordingWriter(const std::string& path, const WorldRecordingInfo& info)
    : file_(std::make_unique<McapWriter>(path)), steps_(info.devices.size(), 0), path_(path) {
  const std::uint16_t config = file_->add_channel("/config", "thigma.world_config", "");
  for (const std::string& name : info.bodies)
    bodies_.push_back(file_->add_channel("/body/" + name + "/state", "thigma.body_state", ""));
  for (const std::string& name : info.joints)
    joints_.push_back(file_->add_channel("/joint/" + name + "/state", "thigma.joint_state", ""));
  for (std::size_t i = 0; i < info.devices.size(); ++i) {
    std::string topic = "/device";
    if (i > 0) topic.append("/").append(std::to_string(i + 1));
    commands_.push_back(file_->add_channel(topic + "/command", "thigma.wrench", ""));
    if (is_page_hand(info.devices[i]) || info.is_apart)
      samples_.emplace_back(i, file_->add_channel(topic + "/sample", "thigma.hand_sample", ""));
    if (info.is_apart)
      haptic_.push_back(file_->add_channel(topic + "/haptic", "thigma.hand_tick", ""));
  }
  events_ = file_->add_channel("/events", "thigma.event", "");
  file_->write(config, 0, 0, config_text(info));
}

WorldRecordingWriter::~WorldRecordingWriter() = default;

template <class Fill>
void WorldRecordingWriter::put(std::uint16_t channel, std::uint64_t number, std::uint64_t time_ns,
                               const Fill& fill) {
  text_.clear();
  detail::JsonObject json(text_);
  json.integer("frame", static_cast<long long>(number));
  fill(json);
  json.close();
  file_->write(channel, static_cast<std::uint32_t>(number), time_ns, text_);
}

void WorldRecordingWriter::write(std::span<const HandTick> ticks) {
  for (const HandTick& made : ticks) {
    const auto hand = static_cast<std::size_t>(made.hand);
    if (made.step != steps_[hand]++)
      throw IoError(path_ + ": more haptic steps at once than there is room for");
    put(haptic_[hand], made.step, nanoseconds(made.tick.now),
        [&made](detail::JsonObject& json) { put_tick(made, json); });
  }
}

void WorldRecordingWriter::write(std::uint64_t frame, double time,
                                 std::span<const BodyState> bodies,
                                 std::span<const RecordedJoint> joints,
                                 std::span<const Wrench> commands,
                                 std::span<const RecordedHand> hands) {
  const auto put = [&](std::uint16_t channel, const auto& fill) {
    this->put(channel, frame, nanoseconds(time), fill);
  };
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    put(bodies_[i], [&y = bodies[i]](detail::JsonObject& json) {
      json.pose({y.position, y.orientation});
      json.vector("linear_momentum", y.linear_momentum);
      json.vector("angular_momentum", y.angular_momentum);
    });
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    put(joints_[i], [&joint = joints[i]](detail::JsonObject& json) {
      json.number("coordinate", joint.coordinate);
      json.number("spring", joint.spring);
      json.number("motor", joint.motor);
      json.number("limit", joint.limit);
    });
  }
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    put(commands_[i], [&command = commands[i]](detail::JsonObject& json) {
      json.vector("force", command.force);
      json.vector("torque", command.torque);
    });
  }
  for (const auto& [device, channel] : samples_) {
    if (device >= hands.size()) continue;
    put(channel, [&hand = hands[device]](detail::JsonObject& json) { put_hand(hand, json); });
  }
}

void WorldRecordingWriter::close(std::uint64_t frames, std::uint64_t state_hash) {
  text_.clear();
  detail::JsonObject json(text_);
  json.word("event", "end");
  json.integer("frames", static_cast<long long>(frames));
  json.word("state_hash", hex_text(state_hash));
  json.close();
  file_->write(events_, 0, file_->last_time(), text_);
  file_->close();
}

bool is_world_recording(const std::string& path) {
  bool is_one = false;
  try {
    FileSource source(path);
    scan_mcap(source, path, [&](const McapScan& scan, const McapMessage& message) {
      is_one = scan.topics[static_cast<std::size_t>(message.channel)] == "/config" &&
               nlohmann::json::parse(message.data).value("kind", "") == kKind;
      return false;
    });
  } catch (const std::exception&) {
    return false;  // whoever reads it says what is wrong
  }
  return is_one;
}

WorldRecording read_world_recording(const std::string& path) {
  const McapFile file = read_mcap(path);
  WorldRecording out;
  std::size_t next = 0;
  try {
    for (const McapMessage& message : file.messages) {
      const std::string& topic = file.topics[static_cast<std::size_t>(message.channel)];
      if (topic == "/config") {
        read_config_text(message.data, path, out);
      } else if (topic == "/events") {
        read_end(message.data, out);
      } else if (topic.starts_with("/device") && topic.ends_with("/sample")) {
        if (out.devices.empty()) refuse(path, "a sample before /config");
        out.hands[device_of(topic, out)].push_back(read_hand(message.data));
      } else if (topic.starts_with("/device") && topic.ends_with("/haptic")) {
        if (out.devices.empty()) refuse(path, "a haptic step before /config");
        if (!out.is_apart) refuse(path, "a haptic step of hands that are not apart");
        const std::size_t hand = device_of(topic, out);
        out.ticks[hand].push_back(read_tick(message.data, hand, out.ticks[hand].size()));
      } else if (topic.starts_with("/body/")) {
        if (out.bodies.empty()) refuse(path, "a state before /config");
        const std::string& name = out.bodies[next++ % out.bodies.size()];
        if (topic != "/body/" + name + "/state") refuse(path, topic + " out of order");
        out.states.push_back(read_state(message.data));
      }
    }
  } catch (const nlohmann::json::exception&) {
    refuse(path, "a message is damaged");
  } catch (const std::logic_error&) {  // of stoull
    refuse(path, "the hash is damaged");
  } catch (const InputError& error) {
    const std::string why = error.what();
    if (why.starts_with(path)) throw;
    refuse(path, why);
  }
  if (out.bodies.empty()) refuse(path, "no /config");
  out.states.resize(out.states.size() / out.bodies.size() * out.bodies.size());
  return out;
}

}  // namespace thigma
