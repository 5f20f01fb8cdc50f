#include "thigma/recording/config_json.h"

#include <string_view>

#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/loop/safety_fields.h"
#include "thigma/recording/detail/json_read.h"
#include "thigma/recording/detail/json_text.h"

namespace thigma {
namespace {

using detail::JsonObject;
using Json = nlohmann::json;

/// Visits every number of the passivity controller with its key; one list for writing and reading.
template <class Params, class Visit>
void each_passivity_number(Params& p, Visit visit) {
  visit("period", p.period);
  visit("delay", p.delay);
  visit("max_damping", p.max_damping);
  visit("max_angular_damping", p.max_angular_damping);
  visit("stiffness", p.stiffness);
  visit("angular_stiffness", p.angular_stiffness);
  visit("acceleration", p.acceleration);
  visit("angular_acceleration", p.angular_acceleration);
  visit("velocity_lag", p.velocity_lag);
  visit("credit", p.credit);
}

template <class Device, class Number, class Flag>
void each_device_limit(Device& d, Number number, Flag flag) {
  number("max_force", d.max_force);
  number("max_torque", d.max_torque);
  number("max_stiffness", d.max_stiffness);
  number("max_angular_stiffness", d.max_angular_stiffness);
  number("workspace_radius", d.workspace_radius);
  flag("senses_translation", d.senses_translation);
  flag("senses_rotation", d.senses_rotation);
  flag("actuates_translation", d.actuates_translation);
  flag("actuates_rotation", d.actuates_rotation);
}

void put_pose(std::string& out, JsonObject& json, const char* key, const Pose& pose) {
  json.key(key);
  JsonObject inner(out);
  inner.pose(pose);
  inner.close();
}

void put_saturation(std::string& out, JsonObject& json, const char* key,
                    const std::optional<Saturation>& s) {
  json.key(key);
  if (!s) {
    out += "null";
    return;
  }
  JsonObject inner(out);
  inner.number("stiffness", s->stiffness);
  inner.number("linear_range", s->linear_range);
  inner.number("full_range", s->full_range);
  inner.number("max_force", s->max_force);
  inner.close();
}

void put_body(std::string& out, JsonObject& json, const RigidBody& body) {
  json.key("body");
  JsonObject inner(out);
  inner.number("mass", body.mass);
  inner.vector("inertia",
               Eigen::Matrix<double, 9, 1>(body.inertia.transpose().reshaped()));  // row by row
  inner.vector("gravity", body.gravity);
  inner.close();
}

void put_coupling(std::string& out, JsonObject& json, const Coupling& c) {
  json.key("coupling");
  JsonObject inner(out);
  inner.number("linear_stiffness", c.linear_stiffness);
  inner.number("linear_damping", c.linear_damping);
  inner.number("angular_stiffness", c.angular_stiffness);
  inner.number("angular_damping", c.angular_damping);
  put_saturation(out, inner, "linear_saturation", c.linear_saturation);
  put_saturation(out, inner, "angular_saturation", c.angular_saturation);
  inner.close();
}

void put_device(std::string& out, JsonObject& json, const DeviceLimits& device) {
  json.key("device_limits");
  JsonObject inner(out);
  each_device_limit(
      device, [&](const char* key, double value) { inner.number(key, value); },
      [&](const char* key, bool value) { inner.flag(key, value); });
  inner.flag("device_clock", device.clock == DeviceClock::device);
  inner.number("delay", device.delay);
  inner.flag("holds_person", device.holds_person);
  inner.close();
}

/// What is infinite, as a cap that is off, is null in JSON.
void put_resolution(std::string& out, JsonObject& json, const Resolution& r) {
  json.key("resolution");
  JsonObject inner(out);
  inner.flag("exact", r.is_exact);
  inner.number("haptic", r.metric.haptic);
  inner.number("velocity", r.metric.velocity);
  inner.vector("view", Eigen::Matrix<double, 5, 1>(
                           r.metric.view.pixels, r.metric.view.distance, r.metric.view.frustum_size,
                           r.metric.view.near_distance, r.metric.view.image_size));
  inner.number("deviation_cap", r.deviation_cap);
  inner.integer("coarsest_level", r.coarsest_level);
  inner.word("support", r.reading == SupportReading::flood ? "flood" : "one_ring");
  inner.word("area", r.area == SupportArea::larger ? "larger" : "smaller");
  inner.flag("interpolates", r.interpolates);
  inner.integer("budget_tests", r.budget_tests);
  inner.number("budget_cpu", r.budget_cpu);
  inner.close();
}

template <class Vector>
void read_vector(const Json& json, const char* key, Vector& out) {
  detail::read_vector(json, key, out, detail::NullNumber::refused);
}

void read_pose(const Json& json, Pose& pose) {
  detail::read_pose(json, pose, detail::NullNumber::refused);
}

Resolution read_resolution(const Json& json) {
  Resolution r;
  r.is_exact = json.at("exact").get<bool>();
  r.metric.haptic = json.at("haptic").get<double>();
  r.metric.velocity = json.at("velocity").get<double>();
  Eigen::Matrix<double, 5, 1> view;
  read_vector(json, "view", view);
  r.metric.view = {view[0], view[1], view[2], view[3], view[4]};
  const Json& cap = json.at("deviation_cap");
  r.deviation_cap = cap.is_null() ? kNoCap : cap.get<double>();
  // recordings from before have none
  r.coarsest_level = json.value("coarsest_level", r.coarsest_level);
  r.reading = json.at("support").get<std::string>() == "one_ring" ? SupportReading::one_ring
                                                                  : SupportReading::flood;
  r.area =
      json.at("area").get<std::string>() == "smaller" ? SupportArea::smaller : SupportArea::larger;
  r.interpolates = json.at("interpolates").get<bool>();
  r.budget_tests = json.at("budget_tests").get<std::int64_t>();
  r.budget_cpu = json.at("budget_cpu").get<double>();
  return r;
}

std::optional<Saturation> read_saturation(const Json& json) {
  if (json.is_null()) return std::nullopt;
  Saturation s;
  s.stiffness = json.at("stiffness").get<double>();
  s.linear_range = json.at("linear_range").get<double>();
  s.full_range = json.at("full_range").get<double>();
  s.max_force = json.at("max_force").get<double>();
  return s;
}

RigidBody read_body(const Json& json) {
  const double mass = json.at("mass").get<double>();
  Eigen::Matrix<double, 9, 1> flat;
  read_vector(json, "inertia", flat);
  const Mat3 inertia = Mat3(flat.reshaped(3, 3)).transpose();
  Vec3 gravity;
  read_vector(json, "gravity", gravity);
  if (!(mass > 0.0) || !(inertia.determinant() > 0.0))
    throw InputError("mass or inertia is not positive");
  return make_body(mass, inertia, gravity);
}

Coupling read_coupling(const Json& json) {
  Coupling c;
  c.linear_stiffness = json.at("linear_stiffness").get<double>();
  c.linear_damping = json.at("linear_damping").get<double>();
  c.angular_stiffness = json.at("angular_stiffness").get<double>();
  c.angular_damping = json.at("angular_damping").get<double>();
  c.linear_saturation = read_saturation(json.at("linear_saturation"));
  c.angular_saturation = read_saturation(json.at("angular_saturation"));
  return c;
}

DeviceLimits read_device(const Json& json) {
  DeviceLimits device;
  each_device_limit(
      device, [&](const char* key, double& value) { value = json.at(key).get<double>(); },
      [&](const char* key, bool& value) { value = json.at(key).get<bool>(); });
  device.clock = json.at("device_clock").get<bool>() ? DeviceClock::device : DeviceClock::engine;
  device.delay = json.value("delay", 0.0);  // older recordings lack it, and the next
  device.holds_person = json.value("holds_person", true);
  return device;
}

void read_params(const Json& json, HapticParams& params) {
  params.body = read_body(json.at("body"));
  params.coupling = read_coupling(json.at("coupling"));
  read_pose(json.at("workspace").at("world_from_device"), params.workspace.world_from_device);
  params.workspace.motion_scale = json.at("workspace").at("motion_scale").get<double>();
  params.workspace.force_scale = json.at("workspace").at("force_scale").get<double>();
  const Json& safety = json.at("safety");
  visit_safety_limits(params.safety, [&](const char* key, double& value) {
    // Early recordings of this version lack some; they are run again as they were run.
    const std::string_view name = key;
    constexpr double kNoLimit = 1e9;
    if (!safety.contains(key) && name == "clear_before_arming") {
      value = 0.0;
    } else if (!safety.contains(key) && (name == "max_turn_speed" || name == "orientation_jump")) {
      value = kNoLimit;
    } else {
      value = safety.at(key).get<double>();
    }
  });
  params.safety.rides_out_gaps = safety.value("rides_out_gaps", false);  // older ones lack it
  params.device = read_device(json.at("device_limits"));
  const std::string place = json.at("grasp_place").get<std::string>();
  params.grasp_place = place == "handle" ? GraspPlace::handle : GraspPlace::grasp_point;
  read_vector(json, "grasp_point", params.grasp_point);
  params.turn_rate = json.at("turn_rate").get<double>();
  const bool is_direct = json.value("response", std::string("coupled")) == "direct";
  params.response = is_direct ? ResponseKind::direct : ResponseKind::coupled;
  // older recordings lack it
  params.resumes_lost_device = json.value("resumes_lost_device", false);
  params.passivity.is_on = json.contains("passivity");
  if (params.passivity.is_on) {
    const Json& passivity = json.at("passivity");
    each_passivity_number(params.passivity, [&](const char* key, double& value) {
      value = passivity.at(key).get<double>();
    });
  }
}

// File names need not be UTF-8, JSON has to be.
std::string quoted(const std::string& text) {
  return Json(text).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string write_config(const RecordedConfig& config) {
  const HapticParams& p = config.params;
  std::string out;
  JsonObject json(out);
  json.integer("version", 1);
  json.key("scene");
  out += quoted(config.scene);
  json.key("device");
  out += quoted(config.device);
  json.number("rate_hz", config.rate_hz);
  json.flag("lockstep", config.is_lockstep);
  json.flag("simulated", config.is_simulated);
  json.word("seed", std::to_string(config.seed));
  put_pose(out, json, "world_from_body", config.world_from_body);
  put_body(out, json, p.body);
  put_coupling(out, json, p.coupling);
  json.key("workspace");
  JsonObject workspace(out);
  put_pose(out, workspace, "world_from_device", p.workspace.world_from_device);
  workspace.number("motion_scale", p.workspace.motion_scale);
  workspace.number("force_scale", p.workspace.force_scale);
  workspace.close();
  json.key("safety");
  JsonObject safety(out);
  visit_safety_limits(p.safety, [&](const char* key, double value) { safety.number(key, value); });
  safety.flag("rides_out_gaps", p.safety.rides_out_gaps);
  safety.close();
  put_device(out, json, p.device);
  json.word("grasp_place", p.grasp_place == GraspPlace::handle ? "handle" : "grasp_point");
  json.vector("grasp_point", p.grasp_point);
  json.number("turn_rate", p.turn_rate);
  json.word("response", p.response == ResponseKind::direct ? "direct" : "coupled");
  json.flag("resumes_lost_device", p.resumes_lost_device);
  if (p.passivity.is_on) {
    json.key("passivity");
    JsonObject passivity(out);
    each_passivity_number(p.passivity,
                          [&](const char* key, double value) { passivity.number(key, value); });
    passivity.close();
  }
  put_resolution(out, json, config.resolution);
  json.close();
  return out;
}

RecordedConfig read_config(const std::string& text) {
  RecordedConfig config;
  try {
    const Json json = Json::parse(text);
    const int version = json.at("version").get<int>();
    if (version != 1)
      throw InputError("recorded by a newer version (" + std::to_string(version) + "), expected 1");
    config.scene = json.at("scene").get<std::string>();
    config.device = json.at("device").get<std::string>();
    config.rate_hz = json.at("rate_hz").get<double>();
    config.is_lockstep = json.at("lockstep").get<bool>();
    config.is_simulated = json.value("simulated", false);
    config.seed = std::stoull(json.at("seed").get<std::string>());
    read_pose(json.at("world_from_body"), config.world_from_body);
    read_params(json, config.params);
    if (json.contains("resolution")) config.resolution = read_resolution(json.at("resolution"));
  } catch (const Json::exception& error) {
    throw InputError(std::string("/config is not a configuration of thigma: ") + error.what());
  } catch (const std::logic_error& error) {
    throw InputError(std::string("/config is not a configuration of thigma: ") + error.what());
  }
  return config;
}

RecordedConfig read_config(const std::string& text, const std::string& path) {
  try {
    return read_config(text);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

}  // namespace thigma
