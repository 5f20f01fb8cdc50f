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
#include "thigma/recording/detail/world_messages.h"
#include "thigma/recording/mcap_file.h"
#include "thigma/recording/recording.h"

namespace thigma {
namespace {

using detail::refuse;

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
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
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
  out.seed = detail::read_count(json, "seed");
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

}  // namespace

void detail::read_world_config(std::string_view text, const std::string& path,
                               WorldRecording& out) {
  read_config_text(text, path, out);
}

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
    samples_.push_back(file_->add_channel(topic + "/sample", "thigma.hand_sample", ""));
    if (info.is_apart)
      haptic_.push_back(file_->add_channel(topic + "/haptic", "thigma.hand_tick", ""));
  }
  events_ = file_->add_channel("/events", "thigma.event", "");
  file_->write(config, 0, 0, config_text(info));
}

WorldRecordingWriter::~WorldRecordingWriter() = default;

void WorldRecordingWriter::attach(const McapAttachment& file) { file_->attach(file); }

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
        [&made](detail::JsonObject& json) { detail::put_tick(made, json); });
  }
}

void WorldRecordingWriter::write(std::uint64_t frame, double time,
                                 std::span<const BodyState> bodies,
                                 std::span<const RecordedJoint> joints,
                                 std::span<const Wrench> commands,
                                 std::span<const RecordedHand> hands,
                                 std::span<const std::uint8_t> is_asleep) {
  const auto put = [&](std::uint16_t channel, const auto& fill) {
    this->put(channel, frame, nanoseconds(time), fill);
  };
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    put(bodies_[i], [&, i](detail::JsonObject& json) {
      detail::put_body(bodies[i], json);
      if (i < is_asleep.size()) json.flag("asleep", is_asleep[i] != 0);
    });
  }
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    put(joints_[i],
        [&joint = joints[i]](detail::JsonObject& json) { detail::put_joint(joint, json); });
  }
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    put(commands_[i],
        [&command = commands[i]](detail::JsonObject& json) { detail::put_wrench(command, json); });
  }
  for (std::size_t i = 0; i < samples_.size() && i < hands.size(); ++i)
    put(samples_[i],
        [&hand = hands[i]](detail::JsonObject& json) { detail::put_hand(hand, json); });
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

}  // namespace thigma
