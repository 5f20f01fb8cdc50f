#include "thigma/recording/detail/world_messages.h"

#include <limits>

#include "thigma/core/error.h"
#include "thigma/recording/detail/json_read.h"

namespace thigma::detail {
namespace {

constexpr auto kNull = NullNumber::not_a_number;
constexpr double kMostTime = 1e9;  // of a session [s]; its nanoseconds are numbers of 64 bits

}  // namespace

std::uint64_t count_of(const nlohmann::json& value, const char* name, std::uint64_t most) {
  if (value.is_number_unsigned() && value.get<std::uint64_t>() <= most)
    return value.get<std::uint64_t>();
  const bool is_any = most == std::numeric_limits<std::uint64_t>::max();
  throw InputError(std::string(name) + " is not a whole number from 0 " +
                   (is_any ? "on" : "to " + std::to_string(most)));
}

std::uint64_t read_count(const nlohmann::json& json, const char* name, std::uint64_t most) {
  return count_of(json.at(name), name, most);
}

void refuse(const std::string& path, const std::string& what) {
  throw InputError(path + ": " + what + ", expected a recording of a world");
}

void put_body(const BodyState& y, JsonObject& json) {
  json.pose({y.position, y.orientation});
  json.vector("linear_momentum", y.linear_momentum);
  json.vector("angular_momentum", y.angular_momentum);
}

BodyState read_body(const nlohmann::json& json) {
  BodyState y;
  Pose pose;
  read_pose(json, pose, kNull);
  y.position = pose.position;
  y.orientation = pose.orientation;
  read_vector(json, "linear_momentum", y.linear_momentum, kNull);
  read_vector(json, "angular_momentum", y.angular_momentum, kNull);
  return y;
}

void put_joint(const RecordedJoint& joint, JsonObject& json) {
  json.number("coordinate", joint.coordinate);
  json.number("spring", joint.spring);
  json.number("motor", joint.motor);
  json.number("limit", joint.limit);
}

RecordedJoint read_joint(const nlohmann::json& json) {
  RecordedJoint joint;
  joint.coordinate = read_number(json.at("coordinate"), kNull);
  joint.spring = read_number(json.at("spring"), kNull);
  joint.motor = read_number(json.at("motor"), kNull);
  joint.limit = read_number(json.at("limit"), kNull);
  return joint;
}

void put_wrench(const Wrench& wrench, JsonObject& json) {
  json.vector("force", wrench.force);
  json.vector("torque", wrench.torque);
}

Wrench read_wrench(const nlohmann::json& json) {
  Wrench wrench;
  read_vector(json, "force", wrench.force, kNull);
  read_vector(json, "torque", wrench.torque, kNull);
  return wrench;
}

namespace {

void put_device(const DeviceState& d, JsonObject& json) {
  json.number("time", d.time);
  json.pose(d.motion.pose);
  json.vector("linear", d.motion.twist.linear);
  json.vector("angular", d.motion.twist.angular);
  json.integer("buttons", d.buttons);
  json.integer("status", static_cast<int>(d.status));
  json.number("weight", d.weight);
}

DeviceState read_device(const nlohmann::json& json) {
  DeviceState d;
  d.time = read_number(json.at("time"), kNull);
  read_pose(json, d.motion.pose, kNull);
  read_vector(json, "linear", d.motion.twist.linear, kNull);
  read_vector(json, "angular", d.motion.twist.angular, kNull);
  d.buttons = static_cast<std::uint32_t>(
      read_count(json, "buttons", std::numeric_limits<std::uint32_t>::max()));
  d.status = static_cast<DeviceStatus>(
      read_count(json, "status", static_cast<std::uint64_t>(DeviceStatus::finished)));
  d.weight = read_number(json.at("weight"), kNull);
  return d;
}

/// Number of a body that was aimed at, or below 0: none. What is no body of the world is none, too.
std::int32_t read_aimed(const nlohmann::json& value) {
  if (!value.is_number_integer()) throw InputError("aim is not the number of a body");
  const bool is_one = value.is_number_unsigned() &&
                      value.get<std::uint64_t>() <= std::numeric_limits<std::int32_t>::max();
  return is_one ? value.get<std::int32_t>() : -1;
}

/// Time of a session [s].
double read_time(const nlohmann::json& json, const char* name) {
  const double time = json.at(name).get<double>();
  if (!(time >= 0.0 && time <= kMostTime))
    throw InputError(std::string(name) + " is not a time of a session");
  return time;
}

}  // namespace

void put_hand(const RecordedHand& hand, JsonObject& json) {
  put_device(hand.device, json);
  if (hand.seen.told != 0) {
    json.integer("read", static_cast<long long>(hand.seen.read));
    json.integer("told", static_cast<long long>(hand.seen.told));
  }
  if (hand.energy == hand.energy) json.number("energy", hand.energy);
  if (!hand.aimed) return;
  json.integer("aim", hand.aimed->body);
  json.vector("point", hand.aimed->point);
}

RecordedHand read_hand(const nlohmann::json& json) {
  RecordedHand hand;
  hand.device = read_device(json);
  if (json.contains("read")) hand.seen.read = read_count(json, "read");
  if (json.contains("told")) hand.seen.told = read_count(json, "told");
  if (json.contains("energy")) hand.energy = read_number(json.at("energy"), kNull);
  if (!json.contains("aim")) return hand;
  hand.aimed = WorldAim{read_aimed(json.at("aim")), Vec3::Zero()};
  read_vector(json, "point", hand.aimed->point, kNull);
  return hand;
}

void put_tick(const HandTick& made, JsonObject& json) {
  json.number("now", made.tick.now);
  json.number("elapsed", made.tick.elapsed);
  json.integer("fault", static_cast<int>(made.tick.external_fault));
  json.integer("news", static_cast<long long>(made.news));
  put_device(made.device, json);
  if (made.device.has_true_handle) {
    json.vector("true_position", made.device.true_handle.position);
    json.vector("true_quat_xyzw", made.device.true_handle.orientation.coeffs());
  }
  put_wrench(made.sent, json);
  json.number("energy", made.energy);
}

HandTick read_tick(const nlohmann::json& json, std::size_t hand, std::uint64_t step, double last) {
  HandTick made;
  made.hand = static_cast<std::int32_t>(hand);
  made.step = read_count(json, "frame");
  if (made.step != step) throw InputError("a haptic step is missing");
  made.tick.now = read_time(json, "now");
  made.tick.elapsed = read_time(json, "elapsed");
  if (made.tick.now < last) throw InputError("a haptic step is before the one before it");
  const std::uint64_t fault = read_count(json, "fault");
  if (fault > static_cast<std::uint64_t>(Fault::watchdog))
    throw InputError("a haptic step has a fault that there is not");
  made.tick.external_fault = static_cast<Fault>(fault);
  made.news = read_count(json, "news");
  made.device = read_device(json);
  if (json.contains("true_position")) {
    made.device.has_true_handle = true;
    read_vector(json, "true_position", made.device.true_handle.position, kNull);
    Vec4 q = Vec4::Zero();
    read_vector(json, "true_quat_xyzw", q, kNull);
    made.device.true_handle.orientation.coeffs() = q;
  }
  made.sent = read_wrench(json);
  made.energy = std::numeric_limits<double>::quiet_NaN();  // of older recordings
  if (json.contains("energy")) made.energy = read_number(json.at("energy"), kNull);
  return made;
}

}  // namespace thigma::detail
