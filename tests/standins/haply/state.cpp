// What the service says.
#include <cmath>
#include <cstdio>

#include "../common/board.h"
#include "../common/device.h"
#include "messages.h"
#include <nlohmann/json.hpp>

namespace standin {
namespace {

using Json = nlohmann::ordered_json;

// The service tells 32-bit floats; where asked for, what is no number, which JSON has as null.
Json number(double value) {
  if (!std::isfinite(value)) {
    return nullptr;
  }
  char text[32];
  std::snprintf(text, sizeof(text), "%.9g", static_cast<double>(static_cast<float>(value)));
  return Json::parse(text);
}

Json vec3(double x, double y, double z) {
  return {{"x", number(x)}, {"y", number(y)}, {"z", number(z)}};
}
Json vec3(const Vec& v) { return vec3(v[0], v[1], v[2]); }
Json quaternion(const Quat& q) {
  return {{"w", number(q[0])}, {"x", number(q[1])}, {"y", number(q[2])}, {"z", number(q[3])}};
}
Json angles() { return {{"a0", 0.0}, {"a1", 0.0}, {"a2", 0.0}}; }
Json transform() {
  return {{"position", vec3(0, 0, 0)},
          {"rotation", quaternion({1, 0, 0, 0})},
          {"scale", vec3(1, 1, 1)}};
}

bool is_plugged(int unit) { return unit < get(unit, k_count) && !is_on(unit, k_unplug); }

Json device_config(int unit) {
  const std::string id = device_id(unit);
  const std::string uuid = "00000000000000000000000000000000";
  return {{"type", "inverse3"},
          {"port", "COM" + std::to_string(12 + unit)},
          {"device_info",
           {{"major_version", 7},
            {"minor_version", 4},
            {"id", id},
            {"device_type", 4},
            {"uuid", uuid.substr(id.size()) + id}}},
          {"extended_device_id", uuid.substr(id.size()) + id},
          {"extended_firmware_version", "8C20FDC8010AA1E15AA133CDA2534874"},
          {"gravity_compensation", {{"enabled", is_on(unit, k_gravity)}, {"scaling_factor", 1.0}}},
          {"handedness", get(unit, k_type) == 1.0 ? "left" : "right"},
          {"streaming_mode", "USB"},
          {"torque_scaling", {{"enabled", true}}},
          {"home_return", {{"enabled", false}}},
          {"preset", "defaults"},
          {"basis", {{"permutation", "XYZ"}}},
          {"mount", transform()},
          {"filters", {{"force_gate", {{"gain", 0.3}}}, {"damping", {{"scalar", 0.0}}}}}};
}

Json device_state(int unit) {
  Pose pose = told_pose(unit);
  if (!is_on(unit, k_calibrated)) {
    pose.position[1] += get(unit, k_uncalibrated_offset);
  }
  const bool is_forced = mode_of(unit) == kForce;
  Vec velocity{get(unit, k_vx), get(unit, k_vy), get(unit, k_vz)};
  if (is_on(unit, k_nan_velocity)) {
    velocity[0] = std::nan("");
  }
  Json state = {{"cursor_position", vec3(pose.position)},
                {"cursor_velocity", vec3(velocity)},
                {"angular_position", angles()},
                {"angular_velocity", angles()},
                {"body_orientation", quaternion({1, 0, 0, 0})},
                {"current_cursor_force",
                 vec3(get(unit, k_applied_fx), get(unit, k_applied_fy), get(unit, k_applied_fz))},
                {"current_cursor_position", vec3(pose.position)},
                {"current_angular_torques", angles()},
                {"current_angular_position", angles()},
                {"mode", "idle"},
                {"control_domain", is_forced ? "cartesian" : "undefined"},
                {"control_mode", is_forced ? "force" : "idle"},
                {"transform", transform()}};
  if (is_on(unit, k_null_pose)) {
    state.erase("cursor_position");
  }
  return state;
}

Json device_status(int unit) {
  return {{"calibrated", is_on(unit, k_calibrated)},
          {"in_use", is_on(unit, k_in_use_by_other) || mode_of(unit) == kForce},
          {"power_supply", is_on(unit, k_powered)},
          {"ready", is_on(unit, k_ready)},
          {"started", is_on(unit, k_started)}};
}

Json grip(int unit, bool full, const char* type) {
  const bool is_wired = std::string(type) == "verse_grip";
  const auto buttons = static_cast<unsigned>(get(unit, k_buttons));
  Json result = {{"device_id", grip_id(unit)}};
  if (full) {
    result["config"] = {{"port", "COM" + std::to_string(3 + unit)}, {"type", type}};
    if (!is_wired) {
      result["config"].update({{"major_version", 2},
                               {"minor_version", 1},
                               {"hardware_version", 1},
                               {"streaming_mode", "Radio"},
                               {"basis", {{"permutation", "XYZ"}}}});
    }
  }
  const Json orientation = quaternion(told_pose(unit).orientation);
  if (is_wired) {
    result["state"] = {{"button", (buttons & 1U) != 0}, {"hall", 0}, {"orientation", orientation}};
    result["status"] = {{"error", 0}, {"ready", is_on(unit, k_grip_ready)}};
    return result;
  }
  result["state"] = {
      {"battery_voltage", 4.0},
      {"battery_level", number(get(unit, k_grip_battery))},
      {"buttons",
       {{"a", (buttons & 1U) != 0}, {"b", (buttons & 2U) != 0}, {"c", (buttons & 4U) != 0}}},
      {"hall", 16},
      {"orientation", orientation},
      {"transform", transform()}};
  if (std::string(type) == "custom_verse_grip") {
    result["state"]["extension_data"] = Json::array();
  }
  result["status"] = {{"connected", is_on(unit, k_grip_ready)},
                      {"awake", is_on(unit, k_grip_ready)},
                      {"ready", is_on(unit, k_grip_ready)}};
  return result;
}

Json everything(bool full) {
  static constexpr const char* kGrips[] = {"verse_grip", "wireless_verse_grip",
                                           "custom_verse_grip"};
  Json message = Json::object();
  message["inverse3"] = Json::array();
  for (const char* type : kGrips) {
    message[type] = Json::array();
  }
  for (int unit = 0; unit < kUnits; ++unit) {
    if (!is_plugged(unit)) {
      continue;
    }
    advance(unit);
    Json device = {{"device_id", device_id(unit)}};
    if (full) {
      device["config"] = device_config(unit);
    }
    device["state"] = device_state(unit);
    device["status"] = device_status(unit);
    message["inverse3"].push_back(device);
    const int kind = static_cast<int>(get(unit, k_verse_grip));
    if (kind >= 1 && kind <= 3) {
      message[kGrips[kind - 1]].push_back(grip(unit, full, kGrips[kind - 1]));
    }
    add(unit, k_reads);
  }
  return message;
}

std::string version() {
  std::string text;
  for (const Key key : {k_sdk_major, k_sdk_minor, k_sdk_release, k_sdk_revision}) {
    if (!text.empty()) {
      text += '.';
    }
    text += std::to_string(static_cast<int>(get(0, key)));
  }
  return text;
}

}  // namespace

int command_form() {
  if (is_on(0, k_form)) {
    return static_cast<int>(get(0, k_form));
  }
  return get(0, k_sdk_major) == 3.0 && get(0, k_sdk_minor) < 5.0 ? 31 : 35;
}

std::string device_id(int unit) {
  char text[16];
  std::snprintf(text, sizeof(text), "%04X", static_cast<unsigned>(get(unit, k_serial)) & 0xFFFFU);
  return text;
}

std::string grip_id(int unit) { return std::to_string(1102 + unit); }

std::string inventory(int session) {
  Json message = {{"session_id", session}};
  message.update(everything(true));
  return message.dump();
}

std::string state_update() { return everything(false).dump(); }

std::string version_answer() {
  const std::string text = version();
  const Json answer = {{"build_time", "2026-01-01T00:00:00Z"},
                       {"git_branch", "main"},
                       {"git_describe", text.substr(0, text.rfind('.'))},
                       {"git_hash", "00000000"},
                       {"git_tag", text.substr(0, text.rfind('.'))},
                       {"project_name", "haply-inverse-service"},
                       {"project_version", text}};
  return answer.dump();
}

std::string device_event(const char* name, const char* level, int unit, const std::string& text) {
  const Json event = {{"name", name},
                      {"category", "device"},
                      {"level", level},
                      {"data", {{"device_family", "inverse"}, {"device_id", device_id(unit)}}},
                      {"message", text}};
  return event.dump();
}

}  // namespace standin
