#include "viewer/server/messages.h"

#include <algorithm>
#include <cmath>

#include "viewer/server/protocol.h"
#include <nlohmann/json.hpp>

#include "thigma/import/read_mesh.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma::live {
namespace {

using Json = nlohmann::ordered_json;

struct CommandForm {
  const char* type;
  Command::Kind kind;
  bool has_flag, has_number;  // `value` is one
  const char* text_key;       // where a text is; "" without
};

constexpr CommandForm kForms[] = {{"hold", Command::Kind::hold, true, false, ""},
                                  {"use_device", Command::Kind::use_device, false, false, "value"},
                                  {"pause", Command::Kind::pause, true, false, ""},
                                  {"step", Command::Kind::step, false, true, ""},
                                  {"reset", Command::Kind::reset, false, false, ""},
                                  {"record", Command::Kind::record, true, false, ""},
                                  {"set", Command::Kind::set, false, true, "name"},
                                  {"level", Command::Kind::level, false, true, ""},
                                  {"open", Command::Kind::open, false, false, "value"},
                                  {"seek", Command::Kind::seek, false, true, ""},
                                  {"upload", Command::Kind::upload, false, true, "name"},
                                  {"place", Command::Kind::place, false, true, "name"},
                                  {"cancel", Command::Kind::cancel, false, false, ""},
                                  {"speed", Command::Kind::speed, false, true, ""},
                                  {"compose", Command::Kind::compose, false, false, "title"},
                                  {"save", Command::Kind::save, true, false, "name"},
                                  {"grab", Command::Kind::grab, false, false, "value"},
                                  {"add", Command::Kind::add, false, false, "value"},
                                  {"remove", Command::Kind::remove, false, false, "value"}};

constexpr std::size_t kLongestText = 256;
constexpr std::size_t kMostObjects = 32;  // of a scene made on a page

/// Names of files and devices need not be UTF-8, messages have to be.
std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json number_or_null(std::optional<double> value) { return value ? finite(*value) : Json(nullptr); }
Json text_or_null(const std::string& text) { return text.empty() ? Json(nullptr) : Json(text); }
Json vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Json quaternion(const Quat& q) { return {q.x(), q.y(), q.z(), q.w()}; }

void add_pose(Json& json, const Pose& pose) {
  json["position"] = vector(pose.position);
  json["quat_xyzw"] = quaternion(pose.orientation);
}

/// What a page can show of each level: a surface of its own, or for free levels groups of the
/// finest patches.
Json level_list_json(const SceneBodyView& body) {
  Json list = Json::array();
  for (std::size_t i = 0; i < body.hierarchy->levels.size(); ++i) {
    const ClodLevel& level = body.hierarchy->levels[i];
    const bool has_mesh = i < body.meshes.size() && !level.is_free;
    list.push_back({{"free", level.is_free},
                    {"triangles", has_mesh ? body.meshes[i].triangles.size() : 0},
                    {"patches", i == 0     ? body.hierarchy->patches.size()
                                : has_mesh ? static_cast<std::size_t>(level.patch_count)
                                           : static_cast<std::size_t>(level.node_count)},
                    {"deviation", has_mesh ? finite(level.deviation_max) : Json(nullptr)}});
  }
  return list;
}

Json body_json(const SceneBodyView& body, std::size_t mesh) {
  const ClodHierarchy& h = *body.hierarchy;
  if (body.mesh >= 0) mesh = static_cast<std::size_t>(body.mesh);
  Json json = {
      {"name", body.name},
      {"mesh", mesh},
      {"radius", h.radius},
      {"center", vector(h.center)},
      {"levels", h.levels.size()},
      {"triangles", body.meshes.front().triangles.size()},
      {"relief", body.relief == nullptr ? Json(nullptr) : finite(2.0 * body.relief->amplitude)},
      {"patches", h.patches.size()},
      {"level_list", level_list_json(body)},
      {"source", text_or_null(body.source)},
      {"unit", body.unit_scale},
      {"friction", number_or_null(body.friction)},
      {"mass", number_or_null(body.mass)},
      {"density", number_or_null(body.density)}};
  if (body.body < 0) return json;
  json["body"] = body.body;
  json["moves"] = body.moves;
  return json;
}

Json micro(double p50, double p99) {
  constexpr double kMicro = 1e6;
  return {{"p50", finite(kMicro * p50)}, {"p99", finite(kMicro * p99)}};
}

Json trouble_json(const Trouble& trouble) {
  return {
      {"name", trouble.name}, {"time", finite(trouble.time)}, {"text", text_or_null(trouble.text)}};
}

Json constraint_json(const std::optional<RowsNow>& rows, const Timing& t) {
  if (!rows) return nullptr;
  return {{"rows", rows->rows},
          {"in_model", rows->in_model},
          {"halvings", rows->halvings},
          {"left_out", rows->left_out},
          {"travel", finite(rows->travel)},
          {"look_ahead", finite(rows->look_ahead)},
          {"held_back", finite(t.held_back)},
          {"squeezed", finite(t.squeezed)}};
}

const char* kind_name(ParameterKind kind) {
  constexpr const char* kNames[] = {"number", "optional", "choice"};
  return kNames[static_cast<std::size_t>(kind)];
}

const char* phase_name(RunPhase phase) {
  constexpr const char* kNames[] = {"running", "paused", "ended"};
  return kNames[static_cast<std::size_t>(phase)];
}

Refusal refuse(std::string why) { return {kPolicy, std::move(why)}; }

/// Of numbers that a float can say.
bool is_triple(const Json& json) {
  constexpr double kMost = 1e30;
  return json.is_array() && json.size() == 3 &&
         std::all_of(json.begin(), json.end(), [](const Json& one) {
           return one.is_number() && std::fabs(one.get<double>()) <= kMost;
         });
}

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
  if (form.kind == Command::Kind::level) {
    const auto mesh = json.find("mesh");
    if (mesh == json.end() || !mesh->is_number_integer()) return "mesh has to be a whole number";
    command.mesh = mesh->get<std::int64_t>();
  }
  if (form.kind == Command::Kind::place) {
    const auto repair = json.find("repair");
    if (repair == json.end() || !repair->is_boolean()) return "repair has to be true or false";
    command.flag = repair->get<bool>();
  }
  if (form.kind == Command::Kind::compose) {
    const auto objects = json.find("objects");
    const bool is_list = objects != json.end() && objects->is_array() && !objects->empty() &&
                         objects->size() <= kMostObjects;
    if (!is_list || !std::all_of(objects->begin(), objects->end(),
                                 [](const Json& one) { return one.is_object(); }))
      return "objects has to be a list of 1 to 32 objects";
    command.objects = objects->dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  if (form.kind == Command::Kind::grab || form.kind == Command::Kind::add) {
    const char* const key = form.kind == Command::Kind::grab ? "point" : "position";
    const auto point = json.find(key);
    if (point != json.end() && !point->is_null()) {
      if (!is_triple(*point)) return std::string(key) + " has to be three finite numbers, or null";
      command.point =
          Vec3((*point)[0].get<double>(), (*point)[1].get<double>(), (*point)[2].get<double>());
    }
  }
  const std::string text_key = form.text_key;
  if (text_key.empty()) return {};
  const auto text = json.find(text_key);
  if (text == json.end() || !text->is_string() ||
      text->get_ref<const std::string&>().size() > kLongestText)
    return text_key + " has to be a text of at most 256 bytes";
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

std::string hello_message(const SceneView& scene, const PageRights& page, double lost_after,
                          std::size_t max_message) {
  Json json = {
      {"type", "hello"},           {"protocol", kProtocol},           {"program", scene.program},
      {"page", page.id},           {"may_control", page.may_control}, {"lost_after", lost_after},
      {"max_message", max_message}};
  json["channels"] = Json::array();
  for (const Channel& c : kChannelList)
    json["channels"].push_back({{"name", std::string(c.name)}, {"unit", std::string(c.unit)}});
  json["faults"] = Json::array();
  for (int f = 0; f <= static_cast<int>(Fault::watchdog); ++f)
    json["faults"].push_back(fault_name(static_cast<Fault>(f)));
  return dumped(json);
}

std::string scene_message(const SceneView& scene, const SessionConfig& config, const Pose& start,
                          bool is_refined) {
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
  json["refined"] = is_refined;
  if (scene.world.is_world()) json["world"] = {{"bodies", scene.world.body_from_mesh.size()}};
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
                            {"kind", kind_name(p.kind)},
                            {"choices", p.choices},
                            {"begins_again", p.begins_again},
                            {"warning", text_or_null(p.warning)},
                            {"locked", text_or_null(p.locked)},
                            {"help", p.help}});
  }
  return dumped(json);
}

WrenchLimits wrench_limits(const HapticParams& params) {
  WrenchLimits limits;
  limits.force = std::min(params.safety.max_force, params.device.max_force);
  if (params.device.actuates_rotation)
    limits.torque = std::min(params.safety.max_torque, params.device.max_torque);
  return limits;
}

std::string state_message(const RunState& s, const Timing& t, std::string_view holder,
                          std::uint64_t dropped_yours, std::uint64_t dropped_rows,
                          std::uint64_t dropped_samples) {
  Json json = {{"type", "state"},
               {"session", s.session},
               {"run", phase_name(s.run)},
               {"reason", text_or_null(s.reason)},
               {"time", finite(s.time)},
               {"device", s.device},
               {"devices", s.devices},
               {"holder", std::string(holder)},
               {"recording", text_or_null(s.recording)},
               {"replay", s.replay.empty() ? Json(nullptr)
                                           : Json{{"file", s.replay},
                                                  {"seconds", s.replay_seconds},
                                                  {"speed", s.replay_speed}}},
               {"pages", s.pages},
               {"simulated", s.is_simulated}};
  json["fault"] = s.fault.name.empty() ? Json(nullptr) : trouble_json(s.fault);
  json["late"] = s.lates == 0 ? Json(nullptr) : trouble_json(s.late);
  if (s.lates > 0) json["late"]["count"] = s.lates;
  json["limits"] = {{"force", finite(s.limits.force)}, {"torque", finite(s.limits.torque)}};
  json["constraint"] = constraint_json(s.rows, t);
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

std::string saved_message(std::int64_t id, const std::string& path) {
  return dumped({{"type", "saved"}, {"id", id}, {"file", path}});
}

std::string menu_message(const OpenMenu& menu) {
  const auto list = [](const std::vector<OpenMenu::Item>& items) {
    Json json = Json::array();
    for (const OpenMenu::Item& item : items)
      json.push_back({{"name", item.name}, {"title", item.title}});
    return json;
  };
  Json meshes = Json::array();
  for (const MeshKind& kind : mesh_kinds())
    meshes.push_back({{"name", kind.name}, {"ending", kind.ending}});
  return dumped({{"type", "menu"},
                 {"scenes", list(menu.scenes)},
                 {"recordings", list(menu.recordings)},
                 {"meshes", std::move(meshes)}});
}

std::string progress_message(const std::string& what, double share) {
  return dumped({{"type", "progress"}, {"what", text_or_null(what)}, {"share", finite(share)}});
}

std::string strip_message(double seconds, const std::vector<float>& force) {
  Json list = Json::array();
  for (const float newtons : force) list.push_back(finite(std::round(1e4 * newtons) / 1e4));
  return dumped({{"type", "strip"}, {"seconds", finite(seconds)}, {"force", std::move(list)}});
}

std::string event_message(const SessionEvent& event) {
  return dumped({{"type", "event"},
                 {"time", finite(event.time)},
                 {"frame", event.frame},
                 {"kind", event_name(event.kind)},
                 {"detail", event.detail},
                 {"text", event.text}});
}

std::string camera_message(const Pose& pose) {
  Json json = {{"type", "camera"}};
  add_pose(json, pose);
  return dumped(json);
}

std::string ack_message(std::int64_t id, const std::string& reason, std::optional<double> value) {
  Json json = {
      {"type", "ack"}, {"id", id}, {"ok", reason.empty()}, {"reason", text_or_null(reason)}};
  if (value) json["value"] = *value;
  return dumped(json);
}

}  // namespace thigma::live
