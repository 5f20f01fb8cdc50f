#include "thigma/device/detail/haply_message.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace thigma::detail {
namespace {

using nlohmann::json;

/// What a message lacks.
struct Lacks : std::runtime_error {
  using std::runtime_error::runtime_error;
};

const json& member(const json& object, const char* name) {
  const auto at = object.is_object() ? object.find(name) : object.end();
  if (!object.is_object() || at == object.end()) throw Lacks(std::string("has no ") + name);
  return *at;
}

/// A member or null.
const json& member_or_null(const json& object, const char* name) {
  static const json null;
  if (!object.is_object()) return null;
  const auto at = object.find(name);
  return at == object.end() ? null : *at;
}

double number(const json& object, const char* name) {
  const json& value = member(object, name);
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    throw Lacks(std::string("has a ") + name + " that is no number");
  return value.get<double>();
}

Vec3 vector(const json& object, const char* name) {
  const json& v = member(object, name);
  return {number(v, "x"), number(v, "y"), number(v, "z")};
}

std::string text(const json& object, const char* name) {
  const json& value = member(object, name);
  if (!value.is_string()) throw Lacks(std::string("has a ") + name + " that is no text");
  return value.get<std::string>();
}

bool flag(const json& object, const char* name, bool otherwise) {
  const json& value = member_or_null(object, name);
  return value.is_boolean() ? value.get<bool>() : otherwise;
}

bool is_vector_of(const json& v, double all) {
  for (const char* axis : {"x", "y", "z"}) {
    const json& value = member_or_null(v, axis);
    if (!value.is_null() && value != all) return false;
  }
  return true;
}

bool is_no_turn(const json& q) {
  const json& w = member_or_null(q, "w");
  return is_vector_of(q, 0.0) && (w.is_null() || w == 1.0);
}

/// Whether a person has given the device other axes or units than its own.
bool has_own_axes(const json& arm) {
  const json& config = member_or_null(arm, "config");
  const json& permutation = member_or_null(member_or_null(config, "basis"), "permutation");
  if (permutation.is_string() && permutation != "XYZ") return true;
  const json* const places[] = {&member_or_null(config, "mount"),
                                &member_or_null(member_or_null(arm, "state"), "transform")};
  for (const json* place : places) {
    if (!is_no_turn(member_or_null(*place, "rotation"))) return true;
    if (!is_vector_of(member_or_null(*place, "scale"), 1.0)) return true;
  }
  return false;
}

HaplyArm read_arm(const json& entry) {
  HaplyArm arm;
  arm.id = text(entry, "device_id");
  const json& state = member(entry, "state");
  arm.position = vector(state, "cursor_position");
  arm.velocity = vector(state, "cursor_velocity");
  const json& status = member_or_null(entry, "status");
  arm.is_calibrated = flag(status, "calibrated", true);
  arm.is_ready = flag(status, "ready", true);
  arm.has_power = flag(status, "power_supply", true);
  const json& type = member_or_null(member_or_null(entry, "config"), "type");
  if (type.is_string()) arm.type = type.get<std::string>();
  arm.has_own_axes = has_own_axes(entry);
  return arm;
}

HaplyGrip read_grip(const json& entry) {
  HaplyGrip grip;
  grip.id = text(entry, "device_id");
  const json& state = member_or_null(entry, "state");
  const json& q = member_or_null(state, "orientation");
  if (q.is_object()) {
    const Quat turn(number(q, "w"), number(q, "x"), number(q, "y"), number(q, "z"));
    const double norm = turn.norm();
    if (!(std::abs(norm - 1.0) < 0.05)) throw Lacks("has an orientation that is no rotation");
    grip.orientation = Quat(turn.coeffs() / norm);
    grip.has_orientation = true;
  }
  const json& buttons = member_or_null(state, "buttons");
  const json& one = member_or_null(state, "button");
  grip.has_buttons = buttons.is_object() || one.is_boolean();
  if (flag(state, "button", false)) grip.buttons |= 1u;
  const char* const names[][2] = {{"a", "button_0"}, {"b", "button_1"}, {"c", "button_2"}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    for (const char* name : names[i]) {
      if (flag(buttons, name, false)) grip.buttons |= 1u << i;
    }
  }
  return grip;
}

const json& list(const json& message, const char* name) {
  static const json none = json::array();
  const json& value = member_or_null(message, name);
  if (value.is_null()) return none;
  if (!value.is_array()) throw Lacks(std::string("has a ") + name + " that is no list");
  return value;
}

}  // namespace

std::string read_haply_frame(std::string_view message, HaplyFrame& frame) {
  frame = {};
  const json root = json::parse(message, nullptr, false);
  if (root.is_discarded()) return "a message is no JSON";
  if (!root.is_object()) return "a message is no JSON object";
  try {
    for (const json& entry : list(root, "inverse3")) frame.arms.push_back(read_arm(entry));
    for (const json& entry : list(root, "wireless_verse_grip"))
      frame.grips.push_back(read_grip(entry));
    for (const json& entry : list(root, "verse_grip")) frame.grips.push_back(read_grip(entry));
  } catch (const Lacks& error) {
    return std::string("a message ") + error.what();
  }
  return "";
}

std::string haply_form_of(std::string_view answer, HaplyForm& form) {
  std::string version(answer.substr(0, 40));
  json root = json::parse(answer, nullptr, false);
  if (root.is_discarded()) root = nullptr;
  for (const char* name : {"project_version", "version"}) {
    const json& named = member_or_null(root, name);
    if (named.is_string()) version = named.get<std::string>();
  }
  if (root.is_string()) version = root.get<std::string>();
  if (!version.empty() && version[0] == 'v') version.erase(0, 1);
  int major = 0, minor = 0;
  if (std::sscanf(version.c_str(), "%3d.%3d", &major, &minor) != 2)
    return "it does not say its version";
  if (major != 3 || minor < 1)
    return "it is version " + std::to_string(major) + "." + std::to_string(minor) +
           ", expected 3.1 to 3.x";
  form = minor >= 5 ? HaplyForm::vector : HaplyForm::values;
  return "";
}

std::string haply_force_message(HaplyForm form, const std::string& id, const Vec3& force,
                                bool is_first) {
  const char* const name = form == HaplyForm::vector ? "vector" : "values";
  json message;
  if (is_first) message["session"]["configure"]["profile"]["name"] = "org.thigma:thigma";
  message["inverse3"] = {
      {{"device_id", id},
       {"commands",
        {{"set_cursor_force", {{name, {{"x", force.x()}, {"y", force.y()}, {"z", force.z()}}}}}}}}};
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace thigma::detail
