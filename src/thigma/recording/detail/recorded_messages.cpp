#include "thigma/recording/detail/recorded_messages.h"

#include <charconv>

#include <nlohmann/json.hpp>

#include "thigma/core/byte_source.h"
#include "thigma/core/error.h"
#include "thigma/recording/detail/json_read.h"

namespace thigma::detail {
namespace {

using Json = nlohmann::json;

constexpr NullNumber kNull = NullNumber::not_a_number;

double number(const Json& json, const char* key) { return read_number(json.at(key), kNull); }

template <class Vector>
void read_sample_vector(const Json& json, const char* key, Vector& out) {
  read_vector(json, key, out, kNull);
}

void read_sample_pose(const Json& json, Pose& pose) { read_pose(json, pose, kNull); }

void read_twist(const Json& json, Twist& twist) {
  read_sample_vector(json, "linear_velocity", twist.linear);
  read_sample_vector(json, "angular_velocity", twist.angular);
}

void read_wrench(const Json& json, const char* force, const char* torque, Wrench& wrench) {
  read_sample_vector(json, force, wrench.force);
  read_sample_vector(json, torque, wrench.torque);
}

void read_body(const Json& json, BodyState& body) {
  Pose pose;
  read_sample_pose(json, pose);
  body.position = pose.position;
  body.orientation = pose.orientation;
  read_sample_vector(json, "linear_momentum", body.linear_momentum);
  read_sample_vector(json, "angular_momentum", body.angular_momentum);
}

std::uint64_t read_hex(const Json& json, const char* key) {
  const std::string text = json.at(key).get<std::string>();
  std::uint64_t value = 0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (result.ptr != text.data() + text.size() || text.empty()) {
    throw InputError(std::string("'") + key + "' is no hexadecimal number");
  }
  return value;
}

/// Recordings of earlier builds have none: 0, not compared.
std::uint64_t read_digest(const Json& json, const char* key) {
  return json.contains(key) ? read_hex(json, key) : 0;
}

DeviceStatus read_status(const Json& json) {
  const std::string name = json.at("status").get<std::string>();
  if (name == "ok") return DeviceStatus::ok;
  if (name == "not_ready") return DeviceStatus::not_ready;
  if (name == "finished") return DeviceStatus::finished;
  if (name == "lost") return DeviceStatus::lost;
  throw InputError("'status' is '" + name + "'");
}

Fault read_fault(const Json& json, const char* key) {
  const std::string name = json.at(key).get<std::string>();
  for (int i = 0; i <= static_cast<int>(Fault::watchdog); ++i) {
    if (name == fault_name(static_cast<Fault>(i))) return static_cast<Fault>(i);
  }
  throw InputError(std::string("'") + key + "' is '" + name + "'");
}

void read_device(const Json& json, HapticSample& s) {
  s.frame = json.at("frame").get<std::uint64_t>();
  s.time = number(json, "time");
  s.elapsed = number(json, "elapsed");
  s.device.time = number(json, "sample_time");
  read_sample_pose(json, s.device.motion.pose);
  read_twist(json, s.device.motion.twist);
  s.device.buttons = json.at("buttons").get<std::uint32_t>();
  s.device.status = read_status(json);
  if (json.contains("weight")) s.device.weight = number(json, "weight");
  s.device.has_true_handle = json.contains("true_handle");
  if (s.device.has_true_handle) read_sample_pose(json.at("true_handle"), s.device.true_handle);
  s.model_sequence = json.at("model_sequence").get<std::uint64_t>();
  s.external_fault = read_fault(json, "external_fault");
  s.input_digest = read_digest(json, "input_digest");
}

void read_state(const Json& json, HapticSample& s) {
  read_body(json, s.body);
  read_sample_pose(json.at("handle"), s.handle.pose);
  read_twist(json.at("handle"), s.handle.twist);
  read_wrench(json, "coupling_force", "coupling_torque", s.coupling);
  read_wrench(json, "contact_force", "contact_torque", s.contact);
  s.model_age = number(json, "model_age");
  s.model_weight = number(json, "model_weight");
  s.penetration = number(json, "penetration");
  s.stretch = number(json, "stretch");
  s.energy = number(json, "energy");
  s.touching = json.at("touching").get<std::int32_t>();
  s.is_grasped = json.at("is_grasped").get<bool>();
  s.is_armed = json.at("is_armed").get<bool>();
  s.fault = read_fault(json, "fault");
}

PlaneTerm read_plane(const Json& json) {
  PlaneTerm p;
  read_sample_vector(json, "arm_body", p.arm_body);
  read_sample_vector(json, "normal", p.normal);
  read_sample_vector(json, "scene_point", p.scene_point);
  read_sample_vector(json, "scene_velocity", p.scene_velocity);
  read_sample_vector(json, "tangential_anchor", p.tangential_anchor);
  p.stiffness = number(json, "stiffness");
  p.damping = number(json, "damping");
  p.tolerance = number(json, "tolerance");
  p.id = json.at("id").get<std::int32_t>();
  return p;
}

DepthTerm read_depth(const Json& json) {
  DepthTerm t;
  t.depth = number(json, "depth");
  read_sample_vector(json, "linear", t.linear);
  read_sample_vector(json, "angular", t.angular);
  t.stiffness = number(json, "stiffness");
  t.damping = number(json, "damping");
  t.tolerance = number(json, "tolerance");
  t.id = json.at("id").get<std::int32_t>();
  return t;
}

DepthBend read_bend(const Json& json) {
  Eigen::Matrix<double, 36, 1> flat;
  read_sample_vector(json, "rows", flat);
  DepthBend bend;
  for (int i = 0; i < 36; ++i) bend(i / 6, i % 6) = flat[i];
  return bend;
}

TaylorTerm read_taylor(const Json& json) {
  TaylorTerm t;
  read_wrench(json, "force", "torque", t.wrench);
  read_sample_vector(json, "normal", t.normal);
  Eigen::Matrix<double, 78, 1> flat;
  read_sample_vector(json, "jacobian", flat);
  for (int i = 0; i < 78; ++i) t.jacobian(i / 13, i % 13) = flat[i];
  return t;
}

void read_model(const Json& json, LinearContactModel& model) {
  model.sequence = json.at("sequence").get<std::uint64_t>();
  model.time = number(json, "time");
  read_body(json, model.state);
  for (const Json& plane : json.at("planes")) {
    if (!model.planes.push_back(read_plane(plane))) throw InputError("too many 'planes'");
  }
  // Recordings of earlier builds have none.
  if (json.contains("depths")) {
    for (const Json& depth : json.at("depths")) {
      if (!model.depths.push_back(read_depth(depth))) throw InputError("too many 'depths'");
    }
  }
  if (json.contains("bends")) {
    for (const Json& bend : json.at("bends")) {
      if (!model.bends.push_back(read_bend(bend))) throw InputError("too many 'bends'");
    }
    if (model.bends.size() > model.depths.size()) throw InputError("more 'bends' than 'depths'");
  }
  for (const Json& taylor : json.at("taylors")) {
    if (!model.taylors.push_back(read_taylor(taylor))) throw InputError("too many 'taylors'");
  }
}

void read_counts(const Json& json, LevelCounts& counts) {
  if (!json.is_array() || json.size() > counts.size()) throw InputError("too many levels");
  for (std::size_t i = 0; i < json.size(); ++i) counts[i] = json[i].get<std::int32_t>();
}

void read_frame(const Json& json, ContactSample& c) {
  c.time = number(json, "time");
  c.published = number(json, "published");
  c.query_cpu = number(json, "query_cpu");
  c.step_cpu = number(json, "step_cpu");
  c.contacts = json.at("contacts").get<std::int64_t>();
  c.dropped = json.at("dropped").get<std::int64_t>();
  c.front = json.at("front").get<std::int64_t>();
  c.tests = json.at("tests").get<std::int64_t>();
  c.clusters = json.at("clusters").get<std::int32_t>();
  c.depth_max = number(json, "depth_max");
  if (!json.contains("object_levels")) return;  // recordings of builds without levels of detail
  c.mandatory_tests = json.at("mandatory_tests").get<std::int64_t>();
  c.unrefined = json.at("unrefined").get<std::int64_t>();
  c.level_changes = json.at("level_changes").get<std::int32_t>();
  c.bound_max = number(json, "bound_max");
  read_counts(json.at("object_levels"), c.object_levels);
  read_counts(json.at("scene_levels"), c.scene_levels);
}

/// The sample a message of a later topic belongs to: the last one begun.
template <class Sample>
Sample& begun(std::optional<Sample>& sample) {
  if (!sample) throw InputError("comes before the message it belongs to");
  return *sample;
}

void read_event(const Json& json, RecordingInfo& recording) {
  SessionEvent event;
  event.kind = json.at("event").get<std::string>();
  if (event.kind == "end") {
    recording.has_end = true;
    recording.end.frames = json.at("frames").get<std::uint64_t>();
    recording.end.state_hash = read_hex(json, "state_hash");
    recording.end.dropped = json.at("dropped").get<std::uint64_t>();
    return;
  }
  event.time = number(json, "time");
  event.frame = json.value("frame", std::uint64_t{0});
  event.detail = json.value(event.kind == "fault" ? "fault" : "detail", std::string());
  recording.events.push_back(event);
}

}  // namespace

void read_message(const std::string& topic, std::string_view data, RecordingInfo& recording,
                  BegunSamples& begun_samples) {
  if (topic == "/config") {
    recording.config = std::string(data);
    return;
  }
  std::optional<HapticSample>& frame = begun_samples.frame;
  std::optional<ContactSample>& contact = begun_samples.contact;
  const Json json = Json::parse(data);
  if (topic == "/device/state") {
    read_device(json, frame.emplace());
  } else if (topic == "/device/command") {
    HapticSample& sample = begun(frame);
    read_wrench(json, "force", "torque", sample.command);
    read_wrench(json, "feedback_force", "feedback_torque", sample.feedback);
  } else if (topic == "/body/state") {
    read_state(json, begun(frame));
  } else if (topic == "/timing") {
    HapticSample& sample = begun(frame);
    sample.step_cpu = static_cast<float>(number(json, "step_cpu"));
    sample.wake_late = static_cast<float>(number(json, "wake_late"));
  } else if (topic == "/contact/model") {
    ContactSample& sample = contact.emplace();
    read_model(json, sample.model);
    sample.model_digest = read_digest(json, "model_digest");
  } else if (topic == "/contact/frame") {
    read_frame(json, begun(contact));
  } else if (topic == "/events") {
    read_event(json, recording);
  }
}

}  // namespace thigma::detail
