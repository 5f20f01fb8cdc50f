#include "thigma/recording/detail/recorded_messages.h"

#include <charconv>
#include <concepts>

#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/dynamics/contact_model_fields.h"
#include "thigma/files/byte_source.h"
#include "thigma/loop/sample_fields.h"
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

void read_counts(const Json& json, LevelCounts& counts) {
  if (!json.is_array() || json.size() > counts.size()) throw InputError("too many levels");
  for (std::size_t i = 0; i < json.size(); ++i) counts[i] = json[i].get<std::int32_t>();
}

/// Reads the fields of a list (sample_fields.h) out of an object.
struct FieldReader {
  const Json& json;

  void operator()(const char* key, double& value) const { value = number(json, key); }
  void operator()(const char* key, float& value) const {
    value = static_cast<float>(number(json, key));
  }
  void operator()(const char* key, Fault& value) const { value = read_fault(json, key); }
  void operator()(const char*, DeviceStatus& value) const { value = read_status(json); }
  void operator()(const char* key, RowKind& value) const {
    const int kind = json.at(key).get<int>();
    if (kind < 0 || kind > static_cast<int>(RowKind::relief))
      throw InputError(std::string("'") + key + "' is " + std::to_string(kind));
    value = static_cast<RowKind>(kind);
  }
  template <std::integral Integer>
  void operator()(const char* key, Integer& value) const {
    value = json.at(key).get<Integer>();
  }
  template <class Vector>
  void vector(const char* key, Vector& v) const {
    read_sample_vector(json, key, v);
  }
  void pose(Pose& pose) const { read_sample_pose(json, pose); }
  void twist(Twist& twist) const { read_twist(json, twist); }
  void wrench(const char* force, const char* torque, Wrench& wrench) const {
    read_wrench(json, force, torque, wrench);
  }
  void body(BodyState& body) const { read_body(json, body); }
  void motion(const char* key, Motion& motion) const {
    read_sample_pose(json.at(key), motion.pose);
    read_twist(json.at(key), motion.twist);
  }
  void unless_zero(const char* key, Vec3& v) const {
    v.setZero();
    if (json.contains(key)) vector(key, v);
  }
  template <class Value>
  void unless(const char* key, Value& value, Value usual) const {
    value = usual;
    if (json.contains(key)) (*this)(key, value);
  }
  void pressing(const char* key, PressingRows& rows) const {
    rows.clear();
    if (!json.contains(key)) return;
    for (const Json& row : json.at(key)) {
      PressingRow pressing{read_hex(row, "id"), Vec3::Zero()};
      read_sample_vector(row, "force", pressing.force);
      if (!rows.push_back(pressing)) throw InputError("too many rows in 'pressing'");
    }
  }
  void optional_pose(const char* key, bool& has, Pose& pose) const {
    has = json.contains(key);
    if (has) read_sample_pose(json.at(key), pose);
  }
  void digest(const char* key, std::uint64_t& value) const { value = read_hex(json, key); }
  void counts(const char* key, LevelCounts& counts) const { read_counts(json.at(key), counts); }
};

PlaneTerm read_plane(const Json& json) {
  PlaneTerm p;
  visit_plane(p, FieldReader{json});
  return p;
}

DepthTerm read_depth(const Json& json) {
  DepthTerm t;
  visit_depth(t, FieldReader{json});
  return t;
}

void read_constraints(const Json& json, const BodyState& state, ConstraintModel& constraints) {
  constraints.state = state;
  constraints.travel = number(json, "travel");
  constraints.reach = number(json, "reach");
  for (const Json& row : json.at("rows")) {
    ContactRow r = make_row(RowKind::scene_plane);
    visit_row(r, FieldReader{row});
    if (!constraints.rows.push_back(r)) throw InputError("too many 'rows'");
  }
}

void read_model(const Json& json, LinearContactModel& model) {
  model.sequence = json.at("sequence").get<std::uint64_t>();
  model.time = number(json, "time");
  read_body(json, model.state);
  for (const Json& plane : json.at("planes")) {
    if (!model.planes.push_back(read_plane(plane))) throw InputError("too many 'planes'");
  }
  for (const Json& depth : json.at("depths")) {
    if (!model.depths.push_back(read_depth(depth))) throw InputError("too many 'depths'");
  }
  if (json.contains("constraints"))
    read_constraints(json.at("constraints"), model.state, model.constraints);
}

void read_frame(const Json& json, ContactSample& c) {
  visit_contact_frame(c, FieldReader{json});
  visit_contact_levels(c, FieldReader{json});
  visit_contact_rows(c, FieldReader{json});
}

/// The sample a message of a later topic belongs to: the last one begun.
template <class Sample>
Sample& begun(std::optional<Sample>& sample) {
  if (!sample) throw InputError("comes before the message it belongs to");
  return *sample;
}

void read_event(const Json& json, RecordingInfo& recording) {
  SessionEvent event;
  const std::string name = json.at("event").get<std::string>();
  if (name == "end") {
    recording.has_end = true;
    recording.end.frames = json.at("frames").get<std::uint64_t>();
    recording.end.state_hash = read_hex(json, "state_hash");
    recording.end.dropped = json.at("dropped").get<std::uint64_t>();
    return;
  }
  const std::optional<EventKind> kind = event_of_name(name);
  if (!kind) throw InputError("'event' is '" + name + "'");
  event.kind = *kind;
  event.time = number(json, "time");
  event.frame = json.value("frame", std::uint64_t{0});
  event.detail = json.value(event.kind == EventKind::fault ? "fault" : "detail", std::string());
  recording.events.push_back(event);
}

}  // namespace

void read_message(const std::string& topic, std::string_view data, RecordingInfo& recording,
                  BegunSamples& begun_samples) {
  if (topic == "/config") {
    const Json config = Json::parse(data, nullptr, false);  // whoever uses it says what is wrong
    if (config.is_object() && config.contains("kind"))
      throw InputError(
          "it is of a world of several bodies, which `thigma replay`, `run`, `export` and "
          "`plot` read");
    recording.config = std::string(data);
    return;
  }
  if (topic == "/tf" || topic == "/scene") return;  // pictures of what the others tell
  std::optional<HapticSample>& frame = begun_samples.frame;
  std::optional<ContactSample>& contact = begun_samples.contact;
  const Json json = Json::parse(data);
  if (topic == "/device/state") {
    visit_device_state(frame.emplace(), FieldReader{json});
  } else if (topic == "/device/command") {
    visit_device_command(begun(frame), FieldReader{json});
  } else if (topic == "/body/state") {
    visit_body_state(begun(frame), FieldReader{json});
  } else if (topic == "/timing") {
    visit_timing(begun(frame), FieldReader{json});
  } else if (topic == "/contact/model") {
    ContactSample& sample = contact.emplace();
    read_model(json, sample.model);
    sample.model_digest = read_hex(json, "model_digest");
  } else if (topic == "/contact/frame") {
    read_frame(json, begun(contact));
  } else if (topic == "/events") {
    read_event(json, recording);
  }
}

}  // namespace thigma::detail
