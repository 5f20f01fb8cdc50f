#include "thigma/recording/world_recording.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
constexpr double kMostTime = 1e9;  // of a session [s]; its nanoseconds are numbers of 64 bits

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

std::string topic_of_device(std::size_t number) {
  return number == 0 ? "/device" : "/device/" + std::to_string(number + 1);
}

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

constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();

/// A whole number from 0 to `most`; whoever casts -1 or 1.5 has another.
std::uint64_t count_of(const nlohmann::json& value, const char* name, std::uint64_t most = kAny) {
  if (value.is_number_unsigned() && value.get<std::uint64_t>() <= most)
    return value.get<std::uint64_t>();
  throw InputError(std::string(name) + " is not a whole number from 0 " +
                   (most == kAny ? "on" : "to " + std::to_string(most)));
}

std::uint64_t read_count(const nlohmann::json& json, const char* name, std::uint64_t most = kAny) {
  return count_of(json.at(name), name, most);
}

void read_config_text(std::string_view text, const std::string& path, WorldRecording& out) {
  const auto json = nlohmann::json::parse(text);
  if (json.value("kind", "") != kKind) refuse(path, "/config is of another kind");
  if (!out.bodies.empty()) refuse(path, "a second /config");
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
  out.seed = read_count(json, "seed");
  out.rate = json.at("rate_hz").get<double>();
  out.bodies = json.at("bodies").get<std::vector<std::string>>();
  if (json.contains("joints"))  // older recordings have none
    out.joints = json.at("joints").get<std::vector<std::string>>();
  if (out.bodies.empty()) refuse(path, "/config has no bodies");
  if (!(out.rate >= 50.0 && out.rate <= 20000.0)) refuse(path, "rate_hz is not from 50 to 20000");
  if (json.contains("friction")) {
    out.friction = json.at("friction").get<double>();
    if (!(*out.friction >= 0.0 && std::isfinite(*out.friction)))
      refuse(path, "friction is not a number from 0 on");
  }
}

/// Every frame has its message: one that is left out would have all that follow compared with
/// others.
void check_frame(const nlohmann::json& json, std::size_t frame, const std::string& topic) {
  if (json.contains("frame") && read_count(json, "frame") != frame)
    throw InputError(topic + " out of order, at frame " + std::to_string(frame));
}

BodyState read_state(const nlohmann::json& json) {
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
  d.buttons = static_cast<std::uint32_t>(
      read_count(json, "buttons", std::numeric_limits<std::uint32_t>::max()));
  d.status = static_cast<DeviceStatus>(
      read_count(json, "status", static_cast<std::uint64_t>(DeviceStatus::finished)));
  d.weight = detail::read_number(json.at("weight"), kNull);
  return d;
}

/// Number of a body that was aimed at, or below 0: none. What is no body of the world is none, too.
std::int32_t read_body(const nlohmann::json& value) {
  if (!value.is_number_integer()) throw InputError("aim is not the number of a body");
  const bool is_one = value.is_number_unsigned() &&
                      value.get<std::uint64_t>() <= std::numeric_limits<std::int32_t>::max();
  return is_one ? value.get<std::int32_t>() : -1;
}

RecordedHand read_hand(const nlohmann::json& json) {
  RecordedHand hand;
  hand.device = read_device(json);
  if (json.contains("read")) hand.seen.read = read_count(json, "read");
  if (json.contains("told")) hand.seen.told = read_count(json, "told");
  if (!json.contains("aim")) return hand;
  hand.aimed = WorldAim{read_body(json.at("aim")), Vec3::Zero()};
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

/// Time of a session [s].
double read_time(const nlohmann::json& json, const char* name) {
  const double time = json.at(name).get<double>();
  if (!(time >= 0.0 && time <= kMostTime))
    throw InputError(std::string(name) + " is not a time of a session");
  return time;
}

/// ticks   of the hand so far
HandTick read_tick(std::string_view text, std::size_t hand, const std::vector<HandTick>& ticks) {
  const auto json = nlohmann::json::parse(text);
  HandTick made;
  made.hand = static_cast<std::int32_t>(hand);
  made.step = read_count(json, "frame");
  if (made.step != ticks.size()) throw InputError("a haptic step is missing");
  made.tick.now = read_time(json, "now");
  made.tick.elapsed = read_time(json, "elapsed");
  if (!ticks.empty() && made.tick.now < ticks.back().tick.now)
    throw InputError("a haptic step is before the one before it");
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
  const std::size_t last = topic.rfind('/');
  for (std::size_t i = 0; i < out.devices.size(); ++i)
    if (topic.substr(0, last) == topic_of_device(i)) return i;
  throw InputError(topic + " of " + std::to_string(out.devices.size()) + " devices");
}

void read_end(std::string_view text, WorldRecording& out) {
  const auto json = nlohmann::json::parse(text);
  if (json.value("event", "") != "end") return;
  out.frames = read_count(json, "frames");
  out.state_hash = std::stoull(json.at("state_hash").get<std::string>(), nullptr, 16);
  if (json.contains("haptic_steps")) {  // older recordings do not tell
    out.haptic_steps.clear();
    for (const auto& steps : json.at("haptic_steps"))
      out.haptic_steps.push_back(count_of(steps, "haptic_steps"));
    if (out.haptic_steps.size() != out.devices.size())
      throw InputError("haptic_steps are not of each device");
  }
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
    const std::string topic = topic_of_device(i);
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

void WorldRecordingWriter::close(std::uint64_t frames, std::uint64_t state_hash,
                                 std::span<const std::uint64_t> haptic_steps) {
  text_.clear();
  detail::JsonObject json(text_);
  json.word("event", "end");
  json.integer("frames", static_cast<long long>(frames));
  json.word("state_hash", hex_text(state_hash));
  if (!haptic_.empty() && !haptic_steps.empty()) {
    json.key("haptic_steps");
    text_ += nlohmann::json(std::vector(haptic_steps.begin(), haptic_steps.end())).dump();
  }
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

namespace {

WorldRecording world_of(const McapFile& file, const std::string& path) {
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
        std::vector<RecordedHand>& hand = out.hands[device_of(topic, out)];
        const auto json = nlohmann::json::parse(message.data);
        check_frame(json, hand.size(), topic);
        hand.push_back(read_hand(json));
      } else if (topic.starts_with("/device") && topic.ends_with("/haptic")) {
        if (out.devices.empty()) refuse(path, "a haptic step before /config");
        if (!out.is_apart) refuse(path, "a haptic step of hands that are not apart");
        const std::size_t hand = device_of(topic, out);
        out.ticks[hand].push_back(read_tick(message.data, hand, out.ticks[hand]));
      } else if (topic.starts_with("/body/")) {
        if (out.bodies.empty()) refuse(path, "a state before /config");
        const std::string& name = out.bodies[next++ % out.bodies.size()];
        if (topic != "/body/" + name + "/state") refuse(path, topic + " out of order");
        const auto json = nlohmann::json::parse(message.data);
        check_frame(json, out.states.size() / out.bodies.size(), topic);
        out.states.push_back(read_state(json));
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

}  // namespace

WorldRecording read_world_recording(const std::string& path) {
  return world_of(read_mcap(path), path);
}

WorldRecording parse_world_recording(std::string bytes, const std::string& path) {
  return world_of(parse_mcap(std::move(bytes), path), path);
}

}  // namespace thigma
