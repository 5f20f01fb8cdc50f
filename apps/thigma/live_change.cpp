#include "live_change.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "composed_scene.h"
#include "named_scene.h"
#include "run_view.h"

#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/loop/safety_fields.h"
#include "thigma/recording/recording.h"
#include "thigma/scene/packed_scene.h"

namespace thigma::app {
namespace {

using Kind = live::LiveRequest::Kind;

[[noreturn]] void refuse_request(const std::string& why) { throw std::runtime_error(why); }

/// What of the options is not about the scene that runs.
RunOptions scene_options(const RunOptions& now) {
  RunOptions options = now;
  options.scene = options.object = options.against = options.pose_text = options.response =
      options.texture = "";
  options.scale.reset();
  options.is_repair = options.is_shown = false;
  return options;
}

void prepare(SceneDescription scene, RunOptions options, const LiveNow& now, LiveChange& change) {
  scene.safety = stricter(scene.safety, now.first.safety);
  scene.is_strict = scene.is_strict || now.first.is_strict;
  // Who moves the object goes on doing so, where they can.
  const std::string scheme = device_scheme(now.run.session.device_uri);
  options.device = scheme == "web" || scheme == "hand" ? now.run.session.device_uri : "web:";
  now.hooks.progress("preparing " + scene.title, 0.0);
  change.run = prepare_run(std::move(scene), options, now.seed, now.hooks);
  change.options = std::move(options);
}

void open_again(const std::string& uri, const LiveNow& now, LiveChange& change) {
  change.device = open_run_device(now.options, now.seed, uri, now.start, now.run);
}

void change_device(const live::LiveRequest& request, const LiveNow& now, LiveChange& change) {
  if (now.run.session.config.haptic.response == ResponseKind::direct)
    refuse_request("the direct response is set up for its device; choose another response first");
  open_again(request.text, now, change);
  if (device_scheme(request.text) == "web") change.holder = request.page;
  if (!now.record.empty()) change.record = next_recording();  // one file a session
}

/// Response and texture decide the contact tolerance and how surfaces are loaded: the run is
/// prepared anew.
void choose(const live::LiveRequest& request, const LiveNow& now, LiveChange& change) {
  const std::vector<std::string> responses = response_choices();
  const bool is_first = request.number == 0.0;
  const bool is_response = request.text == "response";
  const double most = is_response ? static_cast<double>(responses.size()) - 1.0 : 1.0;
  if (!(request.number >= 0.0 && request.number <= most) ||
      request.number != std::floor(request.number))
    refuse_request("there is no such choice");
  RunOptions options = now.options;
  if (is_response) options.response = responses[static_cast<std::size_t>(request.number)];
  if (request.text == "texture") options.texture = is_first ? "on" : "off";
  prepare(now.run.given, std::move(options), now, change);
}

bool has(const std::vector<live::OpenMenu::Item>& items, const std::string& name) {
  return std::any_of(items.begin(), items.end(),
                     [&](const live::OpenMenu::Item& item) { return item.name == name; });
}

LiveChange open(const std::string& what, const LiveNow& now) {
  const live::OpenMenu menu = open_menu();
  if (has(menu.recordings, what)) return change_to_recording(what, RecordingFrom::user, now);
  if (!has(menu.scenes, what)) refuse_request("there is no '" + what + "' to open here");
  LiveChange change;
  prepare(read_named_scene(what), scene_options(now.options), now, change);
  return change;
}

void place_dropped(const live::LiveRequest& request, const LiveNow& now, LiveChange& change) {
  if (!now.dropped.is_there()) refuse_request("no mesh has been dropped on the page");
  if (request.text != "hold" && request.text != "touch")
    refuse_request("a mesh can be held or touched");
  if (!(request.number > 0.0 && request.number < 1e6))
    refuse_request("a unit has to be a length above 0");
  const bool is_held = request.text == "hold";
  if (is_held && now.run.scene.statics.empty())
    refuse_request("nothing stands still here to hold it against");
  const ClodAsset& other = is_held ? *now.run.scene.statics.front() : *now.run.scene.object;
  RunOptions options = scene_options(now.options);
  options.is_repair = request.flag;
  prepare(scene_with(now.run.given, now.dropped, is_held, request.number,
                     bounds_of(other.meshes.front().positions)),
          std::move(options), now, change);
}

void change_recording(const live::LiveRequest& request, const LiveNow& now, LiveChange& change) {
  if (request.flag && !now.record.empty()) refuse_request("a recording is being written already");
  if (!request.flag && now.record.empty()) refuse_request("no recording is being written");
  open_again(now.run.session.device_uri, now, change);
  if (request.flag) change.record = next_recording();
}

}  // namespace

namespace {

/// Whether the scene that a file carries is the one that runs, with the same files.
bool is_scene_of_run(const std::string& path, const LiveNow& now) {
  try {
    FileSource source(path);
    const std::vector<McapAttachment> theirs = read_attachments(source, path);
    const std::vector<McapAttachment> ours = pack_scene(now.run.given);
    return std::equal(theirs.begin(), theirs.end(), ours.begin(), ours.end(),
                      [](const McapAttachment& a, const McapAttachment& b) {
                        return a.name == b.name && a.data == b.data;
                      });
  } catch (const InputError&) {
    return false;  // whoever reads it says what is wrong
  }
}

}  // namespace

LiveChange change_to_recording(const std::string& path, RecordingFrom from, const LiveNow& now) {
  LiveChange change;
  if (is_packed_scene(path)) {
    prepare(read_named_scene(path), scene_options(now.options), now, change);
    return change;
  }
  change.playback = std::make_unique<Playback>(path);
  if (now.hooks.log) {
    for (const std::string& line : recording_warnings(path, change.playback->recording()))
      now.hooks.log(line);
  }
  const std::string& scene = change.playback->config().scene;
  const ResponseKind response = change.playback->config().params.response;
  const bool is_there = now.options.replay == path;  // what it takes was made ready for it
  const bool is_packed = has_packed_scene(path);
  const bool is_other_scene =
      is_packed ? !is_scene_of_run(path, now) : scene != now.run.scene.description.file;
  const bool is_other_response =
      response != ResponseKind::direct && response != now.run.session.config.haptic.response;
  if (is_there || !(is_other_scene || is_other_response)) return change;
  if (from == RecordingFrom::page && is_other_scene && !is_packed &&
      !has(open_menu().scenes, scene))
    refuse_request("it brings no scene, and '" + scene + "' is none of the program's");
  RunOptions options = scene_options(now.options);
  use_recorded_response(response, options);
  options.is_shown = true;
  prepare(is_other_scene ? read_named_scene(is_packed ? path : scene) : now.run.given,
          std::move(options), now, change);
  return change;
}

LiveChange make_change(const live::LiveRequest& request, const LiveNow& now) {
  LiveChange change;
  switch (request.kind) {
    case Kind::use_device:
      change_device(request, now, change);
      break;
    case Kind::choose:
      choose(request, now, change);
      break;
    case Kind::open:
      return open(request.text, now);
    case Kind::place:
      place_dropped(request, now, change);
      break;
    case Kind::record:
      change_recording(request, now, change);
      break;
    case Kind::reset:
      open_again(now.run.session.device_uri, now, change);
      if (!now.record.empty()) change.record = next_recording();
      break;
    case Kind::compose:
      prepare(composed_scene(request.text, request.data, now.base, now.dropped),
              scene_options(now.options), now, change);
      change.sources = sources_of(request.data);
      break;
    case Kind::save:
    case Kind::seek:
      refuse_request("no recording is shown");
    case Kind::inspect:
      refuse_request("a mesh is looked at, not opened");
    case Kind::add:
    case Kind::remove:
      refuse_request("no world of several bodies runs");
  }
  return change;
}

}  // namespace thigma::app
