#include "run_view.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <system_error>

#include "named_scene.h"
#include "version.h"
#include "viewer/server/origin.h"

#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/files/file.h"
#include "thigma/scene/gain_task.h"

namespace thigma::app {
namespace {

live::LiveParameter choice(const char* name, const char* label, const char* help,
                           std::vector<std::string> words, std::size_t chosen) {
  live::LiveParameter p;
  p.name = name;
  p.label = label;
  p.help = help;
  p.kind = live::ParameterKind::choice;
  p.choices = std::move(words);
  p.value = static_cast<double>(chosen);
  p.max = static_cast<double>(p.choices.size() - 1);
  p.is_log = false;
  p.begins_again = true;
  return p;
}

/// What is felt in place of level 0; null where that is smooth.
const HapticTexture* relief_of(const TexturedBody& body) {
  return body.has_relief && !body.textures.empty() ? body.textures.front() : nullptr;
}

}  // namespace

live::SceneView view_of(const Run& run) {
  const SceneDescription& scene = run.scene.description;
  live::SceneView view;
  view.title = scene.title.empty() ? scene.object.name : scene.title;
  view.name = scene.file;
  view.program = std::string("thigma ") + kVersion;
  const TexturedWorld& textures = run.session.config.contact.textures;
  view.object = {scene.object.name,
                 run.scene.object->meshes,
                 &run.scene.object->hierarchy,
                 {},
                 relief_of(textures.object)};
  for (std::size_t i = 0; i < scene.statics.size(); ++i) {
    view.statics.push_back({scene.statics[i].name, run.scene.statics[i]->meshes,
                            &run.scene.statics[i]->hierarchy, scene.statics[i].world_from_mesh,
                            i < textures.scene.size() ? relief_of(textures.scene[i]) : nullptr});
  }
  const auto add_given = [](const SceneObject& object, live::SceneBodyView& body) {
    body.unit_scale = object.unit_scale;
    if (object.material) body.friction = object.material->friction.kinetic;
  };
  add_given(scene.object, view.object);
  view.object.mass = scene.mass;
  view.object.density = scene.density;
  for (std::size_t i = 0; i < scene.statics.size(); ++i)
    add_given(scene.statics[i], view.statics[i]);
  return view;
}

std::vector<std::string> devices_of(const Run& run) {
  std::vector<std::string> devices = {run.session.device_uri};
  if (run.session.simulation) return devices;  // nobody holds the object
  for (const char* other : {"web:", "hand:"}) {
    const bool is_there = std::any_of(devices.begin(), devices.end(), [&](const std::string& uri) {
      return device_scheme(uri) + ":" == other;
    });
    if (!is_there) devices.push_back(other);
  }
  return devices;
}

std::optional<GainTask> gains_of(const Run& run) {
  const HapticParams& haptic = run.session.config.haptic;
  if (haptic.response == ResponseKind::direct) return std::nullopt;  // no springs to judge
  DevicePort port;
  try {
    port = describe_device(run.session.device_uri);
  } catch (const std::exception&) {  // the page's mouse, a recording: their limits alone
    port.limits = run.session.device->limits();
    port.linear = {port.limits.max_force, port.limits.max_stiffness};
    port.angular = {port.limits.max_torque, port.limits.max_angular_stiffness};
  }
  return gain_task(port, haptic.body, haptic.workspace, run.session.config.rate, haptic.response);
}

std::vector<std::string> response_choices() {
  return {"penalty", "direct", "constraint", "potential"};
}

std::vector<live::LiveParameter> choices_of(const Run& run) {
  const auto response = static_cast<int>(run.session.config.haptic.response);
  std::vector<live::LiveParameter> choices = {choice(
      "response", "response",
      "constraint: through a simulated body that never enters; penalty: through one that "
      "contacts push out like springs; direct: contact forces as they are; potential: springs "
      "over the area of contact",
      response_choices(), response)};
  if (has_relief(run.scene.description)) {
    choices.push_back(choice("texture", "texture", "on: relief is felt; off: coarse surfaces alone",
                             {"on", "off"},
                             run.session.config.contact.textures.is_empty() ? 1 : 0));
  }
  return choices;
}

live::WebAddress page_address(const RunOptions& options) {
  live::WebAddress address{.port = options.port.value_or(0)};
  if (options.bind.empty()) return address;
  address.bind = options.bind;
  if (!live::is_loopback_address(options.bind)) address.token = live::make_token();
  return address;
}

std::string page_line(const RunOptions& options, const std::string& address) {
  const bool is_open = !options.bind.empty() && !live::is_loopback_address(options.bind);
  return "the page is at " + address +
         (is_open ? " - without the token others may only watch; nothing is encrypted"
                  : " - open it in a browser on this machine") +
         "; Ctrl-C ends it";
}

namespace {

/// A name no file has yet, in a folder that may take none.
std::string free_recording() {
  const std::filesystem::path folder = user_folder("recordings");
  std::error_code unknown;
  if (!folder.empty()) std::filesystem::create_directories(folder, unknown);
  for (int i = 1; i < 1000; ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "session-%03d.mcap", i);
    const std::string path = (folder / name).string();
    if (!std::filesystem::exists(path, unknown) &&
        !std::filesystem::exists(path + ".part", unknown))
      return path;
  }
  throw IoError((folder / "session-999.mcap").string() +
                ": there is already a file, expected a free name from session-001 on");
}

}  // namespace

std::string next_recording() {
  const std::string path = free_recording();
  const std::string attempt = path + ".try";
  constexpr std::size_t kSome = 1u << 16;  // a file without any bytes may be made on a full disk
  try {
    write_file(attempt, std::string(kSome, '\0'));
  } catch (const IoError& error) {
    // People know the recording, not the attempt.
    std::string why = error.what();
    if (why.starts_with(attempt)) why.replace(0, attempt.size(), path);
    throw IoError(why);
  }
  std::error_code ignored;
  std::filesystem::remove(attempt, ignored);
  return path;
}

}  // namespace thigma::app
