#include "viewer/server/messages.h"

#include <cmath>

#include "viewer/server/protocol.h"
#include <nlohmann/json.hpp>

namespace thigma::live {
namespace {

using Json = nlohmann::ordered_json;

struct CommandForm {
  const char* type;
  Command::Kind kind;
  bool has_flag, has_number, has_text;
};

constexpr CommandForm kForms[] = {{"hold", Command::Kind::hold, true, false, false},
                                  {"use_device", Command::Kind::use_device, false, false, true},
                                  {"pause", Command::Kind::pause, true, false, false},
                                  {"step", Command::Kind::step, false, true, false},
                                  {"reset", Command::Kind::reset, false, false, false},
                                  {"record", Command::Kind::record, true, false, false},
                                  {"set", Command::Kind::set, false, true, false}};

constexpr std::size_t kLongestText = 256;

/// Names of files and devices need not be UTF-8, messages have to be.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }
Json vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Json quaternion(const Quat& q) { return {q.x(), q.y(), q.z(), q.w()}; }

void add_pose(Json& json, const Pose& pose) {
  json["position"] = vector(pose.position);
  json["quat_xyzw"] = quaternion(pose.orientation);
}

Json body_json(const SceneBodyView& body, std::size_t mesh) {
  const ClodHierarchy& h = *body.hierarchy;
  return {{"name", body.name},          {"mesh", mesh},
          {"radius", h.radius},         {"center", vector(h.center)},
          {"levels", h.levels.size()},  {"triangles", body.mesh->triangles.size()},
          {"patches", h.patches.size()}};
}

Json micro(double p50, double p99) {
  constexpr double kMicro = 1e6;
  return {{"p50", finite(kMicro * p50)}, {"p99", finite(kMicro * p99)}};
}

Refusal refuse(std::string why) { return {kPolicy, std::move(why)}; }

/// Fills what the form asks for; "" or what is missing.
std::string fill(const CommandForm& form, const Json& json, Command& command) {
  const auto value = json.find("value");
  const bool has_value = value != json.end();
  if (form.has_flag) {
    if (!has_value || !value->is_boolean()) return "value has to be true or false";
    command.flag = value->get<bool>();
  }
  if (form.has_number) {
    if (!has_value || !value->is_number()) return "value has to be a number";
    command.number = value->get<double>();
    if (!std::isfinite(command.number)) return "value has to be a finite number";
  }
  const char* text_key = form.has_text                     ? "value"
                         : form.kind == Command::Kind::set ? "name"
                                                           : nullptr;
  if (text_key == nullptr) return {};
  const auto text = json.find(text_key);
  if (text == json.end() || !text->is_string() ||
      text->get_ref<const std::string&>().size() > kLongestText)
    return std::string(text_key) + " has to be a text of at most 256 bytes";
  command.text = text->get<std::string>();
  return {};
}

}  // namespace

ParsedCommand parse_command(std::string_view text) {
  ParsedCommand result;
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded() || !json.is_object()) {
    result.refusal = {kBadPayload, "a text message is a JSON object"};
    return result;
  }
  const auto type = json.find("type");
  const auto id = json.find("id");
  if (type == json.end() || !type->is_string()) {
    result.refusal = refuse("type is missing");
    return result;
  }
  if (id == json.end() || !id->is_number_integer() || id->get<double>() < 0.0 ||
      id->get<double>() > 2147483647.0) {
    result.refusal = refuse("id has to be a whole number from 0 to 2147483647");
    return result;
  }
  result.command.id = id->get<std::int64_t>();
  for (const CommandForm& form : kForms) {
    if (type->get_ref<const std::string&>() != form.type) continue;
    result.command.kind = form.kind;
    const std::string why = fill(form, json, result.command);
    if (!why.empty()) result.refusal = refuse(std::string(form.type) + ": " + why);
    return result;
  }
  result.refusal = refuse("unknown type of message");
  return result;
}

std::string hello_message(const SceneView& scene, PageId page, double lost_after,
                          std::size_t max_message) {
  Json json = {{"type", "hello"}, {"protocol", kProtocol},    {"program", scene.program},
               {"page", page},    {"lost_after", lost_after}, {"max_message", max_message}};
  json["channels"] = Json::array();
  for (const Channel& c : kChannelList)
    json["channels"].push_back({{"name", std::string(c.name)}, {"unit", std::string(c.unit)}});
  json["faults"] = Json::array();
  for (int f = 0; f <= static_cast<int>(Fault::watchdog); ++f)
    json["faults"].push_back(fault_name(static_cast<Fault>(f)));
  return dumped(json);
}

std::string scene_message(const SceneView& scene, const SessionConfig& config, const Pose& start) {
  Json json = {{"type", "scene"}, {"title", scene.title}, {"name", scene.name}};
  json["object"] = body_json(scene.object, 0);
  json["statics"] = Json::array();
  for (std::size_t i = 0; i < scene.statics.size(); ++i) {
    Json body = body_json(scene.statics[i], i + 1);
    add_pose(body, scene.statics[i].world_from_mesh);
    json["statics"].push_back(std::move(body));
  }
  add_pose(json["start"], start);
  const Workspace& w = config.haptic.workspace;
  add_pose(json["workspace"], w.world_from_device);
  json["workspace"]["motion_scale"] = w.motion_scale;
  json["workspace"]["force_scale"] = w.force_scale;
  json["tolerance"] = config.contact.tolerance;
  json["rate"] = config.rate;
  return dumped(json);
}

std::string parameters_message(const std::vector<LiveParameter>& list) {
  Json json = {{"type", "parameters"}, {"list", Json::array()}};
  for (const LiveParameter& p : list) {
    json["list"].push_back({{"name", p.name},
                            {"label", p.label},
                            {"unit", p.unit},
                            {"value", p.value},
                            {"min", p.min},
                            {"max", p.max},
                            {"scale", p.is_log ? "log" : "linear"},
                            {"locked", text_or_null(p.locked)},
                            {"help", p.help}});
  }
  return dumped(json);
}

std::string state_message(const RunState& s, const Timing& t, std::string_view holder,
                          std::uint64_t dropped_yours, std::uint64_t dropped_rows,
                          std::uint64_t dropped_samples) {
  Json json = {{"type", "state"},
               {"session", s.session},
               {"run", s.run},
               {"reason", text_or_null(s.reason)},
               {"time", finite(s.time)},
               {"device", s.device},
               {"devices", s.devices},
               {"holder", std::string(holder)},
               {"recording", text_or_null(s.recording)},
               {"pages", s.pages},
               {"simulated", s.is_simulated}};
  json["timing"] = {{"step_cpu_us", micro(t.step_p50, t.step_p99)},
                    {"wake_late_us", micro(t.late_p50, t.late_p99)},
                    {"query_cpu_us", micro(t.query_p50, t.query_p99)},
                    {"haptic_hz", finite(t.haptic_hz)},
                    {"contact_hz", finite(t.contact_hz)},
                    {"missed", t.missed}};
  json["dropped"] = {
      {"yours", dropped_yours}, {"rows", dropped_rows}, {"samples", dropped_samples}};
  return dumped(json);
}

std::string event_message(const SessionEvent& event) {
  return dumped({{"type", "event"},
                 {"time", finite(event.time)},
                 {"frame", event.frame},
                 {"kind", event.kind},
                 {"detail", event.detail},
                 {"text", event.text}});
}

std::string ack_message(std::int64_t id, const std::string& reason, std::optional<double> value) {
  Json json = {
      {"type", "ack"}, {"id", id}, {"ok", reason.empty()}, {"reason", text_or_null(reason)}};
  if (value) json["value"] = *value;
  return dumped(json);
}

}  // namespace thigma::live
