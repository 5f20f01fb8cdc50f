#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "thigma/clod/clod_asset.h"
#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/device/replay.h"
#include "thigma/device/web_device.h"
#include "thigma/recording/config_json.h"
#include "thigma/recording/recording.h"
#include "thigma/scene/load_scene.h"
#include "thigma/session/session_config.h"
#include "thigma/session/simulated_session.h"

namespace thigma {
namespace {

/// What find_start did, for people.
std::string placement_line(const StartPlacement& start, bool has_approach) {
  if (!start.has_scene) return "nothing to touch is near";
  char line[240];
  const char* way = has_approach ? "against its approach" : "along the closest points";
  const double gap = 1e3 * start.given_gap, clearance = 1e3 * start.clearance;
  if (!start.is_moved) {
    std::snprintf(line, sizeof line,
                  "the objects start as given, %.3g mm apart; %.3g mm to the first touch", gap,
                  clearance);
  } else if (gap < 0.0) {
    std::snprintf(line, sizeof line,
                  "the objects overlap as given: moved apart %s; %.3g mm to the first touch", way,
                  clearance);
  } else {
    std::snprintf(line, sizeof line,
                  "the objects touch as given (%.3g mm apart, within twice the tolerance): moved "
                  "apart %s; %.3g mm to the first touch",
                  std::abs(gap), way, clearance);
  }
  return line;
}

/// One device of one scene being opened.
struct Opening {
  const Scene& scene;
  const SessionOptions& options;
  SceneSession session;

  bool is_direct() const { return session.config.haptic.response == ResponseKind::direct; }
  bool is_constrained() const {
    return session.config.haptic.response == ResponseKind::constrained;
  }
  bool is_potential() const { return session.config.haptic.response == ResponseKind::potential; }
};

/// Only a hand comes to the object by itself; scripts and people start where the scene says.
void place(Opening& o) {
  const std::optional<Vec3>& approach = o.scene.description.device.approach;
  o.session.start = place_at_start(approach, o.session.config);
  if (o.options.log) o.options.log(placement_line(o.session.start, approach.has_value()));
}

/// Rows keep outside what is outside: an object that overlaps the scene as given is moved out, and
/// that is said.
void lead_out(Opening& o) {
  const std::optional<Vec3>& approach = o.scene.description.device.approach;
  const Pose given = o.session.config.world_from_body;
  const StartPlacement start = place_at_start(approach, o.session.config);
  if (start.has_scene && start.given_gap < 0.0) {
    if (o.options.log) o.options.log(placement_line(start, approach.has_value()));
  } else {
    o.session.config.world_from_body = given;
  }
}

/// The samples of a recording as a device. Forces come out as recorded only from where that session
/// started and at its rate, so both are taken over.
std::unique_ptr<HapticDevice> open_recorded(const std::string& path, Opening& o) {
  std::vector<DeviceState> samples;
  const RecordingInfo recording =
      stream_recording(path, {.frame = [&samples](const HapticSample& frame, const SamplePlace&) {
                         samples.push_back(frame.device);
                       }});
  if (o.options.log) {
    for (const std::string& line : recording_warnings(path, recording)) o.options.log(line);
  }
  try {
    const RecordedConfig recorded = read_config(recording.config);
    o.session.config.world_from_body = recorded.world_from_body;
    if (!o.options.rate) o.session.config.rate = recorded.rate_hz;
    return make_replay_device(std::move(samples), recorded.params.device);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
}

/// The page's mouse, slower than what safety takes for a fault.
std::unique_ptr<HapticDevice> open_web(const Opening& o) {
  WebMotionParams params;
  const SafetyLimits& safety = o.session.config.haptic.safety;
  params.max_speed = std::min(params.max_speed, 0.8 * safety.max_speed);
  params.max_angular_speed = std::min(params.max_angular_speed, 0.8 * safety.max_turn_speed);
  return make_web_device(*o.options.web_channel, params);
}

void measure_areas(Opening& o) {
  try {
    use_potential(o.session.config);
  } catch (const std::invalid_argument& error) {
    throw InputError(o.session.scene_file + ": " + error.what());
  }
}

/// Opens the device, and places the object before a hand comes to it. With the direct response the
/// device decides the contact tolerance, and that the place: a hand is opened once more for its
/// limits.
void open_at(Opening& o) {
  SceneSession& session = o.session;
  const std::string scheme = device_scheme(session.device_uri);
  if ((o.is_constrained() || o.is_potential()) && session.config.contact.scene.empty())
    throw InputError(session.scene_file +
                     ": nothing to touch, expected what the object meets as [[static]]");
  if (scheme == "hand" && o.is_direct())
    use_direct_response(open_device(session.device_uri, {})->limits(), session.config);
  if (scheme == "hand" || scheme == "web")
    place(o);
  else if (o.is_constrained() && scheme != "replay")
    lead_out(o);
  if (o.is_constrained()) use_constraints(session.config);
  if (o.is_potential()) measure_areas(o);
  if (scheme == "web") {
    // Its samples come over a socket, milliseconds apart: a wake-up a tenth of one late is not
    // felt, and polling would take a quarter of a processor that draws the page as well.
    if (session.config.spin < 0.0) session.config.spin = 0.0;
    session.device = add_camera(open_web(o), session.device_uri);
  } else if (scheme == "replay") {
    session.device = open_recorded(session.device_uri.substr(scheme.size() + 1), o);
  } else {
    const double radius = o.scene.object->hierarchy.radius;
    session.device = open_device(
        session.device_uri, device_context(session.config, session.start, radius, o.options.seed));
  }
  if (o.is_direct()) use_direct_response(session.device->limits(), session.config);
}

/// What moves by itself instead of in a hand.
void start_simulation(const SimulatedBody& body, Opening& o) {
  const std::string& file = o.scene.description.file;
  SessionConfig& config = o.session.config;
  if (device_scheme(o.session.device_uri) != "null")
    throw DeviceAddressError(
        file + ": nobody holds the object of a [simulation], expected --device null:");
  if (o.is_direct() || o.is_constrained() || o.is_potential() ||
      !config.contact.textures.is_empty())
    throw InputError(file +
                     ": [simulation] knows no --response but penalty, and no textures, "
                     "expected none of them");
  ContactWorld& contact = config.contact;
  if (!body.has_tolerance) {
    double radius = contact.object->radius;
    for (const SceneBody& other : contact.scene) radius = std::min(radius, other.hierarchy->radius);
    contact.tolerance = contact.response.tolerance = 1e-3 * radius;
  }
  contact.resolution.interpolates = false;
  o.session.simulation = std::make_shared<const SimulatedStart>(SimulatedStart{
      simulation_world(body, config), simulation_start(body, config, o.options.seed)});
  const BodyState& start = o.session.simulation->state.body;
  config.world_from_body = {start.position, start.orientation};
}

}  // namespace

void refuse_web_without_page(const std::string& device_uri, const WebDeviceChannel* channel) {
  if (device_scheme(device_uri) == "web" && channel == nullptr)
    throw DeviceUnavailable("web: needs the page, which --headless and --lockstep leave out");
}

std::string delay_line(const HapticDevice& device, const std::string& uri, double rate) {
  const double delay = device.limits().delay;
  if (!device.limits().holds_person || !(delay > 1.5 / rate)) return "";
  char line[320];
  std::snprintf(line, sizeof line,
                "%s: slower than the haptic rate, its samples are %.1f ms old; gains = \"auto\" in "
                "the scene follow from that, `thigma tune --device %s` shows which",
                device.name().c_str(), 1e3 * delay, uri.c_str());
  return line;
}

namespace {

/// Says where samples of a device come later than frames and gains do not follow from it.
void tell_of_delay(const Opening& o) {
  if (!o.options.log || o.scene.description.has_auto_gains) return;
  const std::string line =
      delay_line(*o.session.device, o.session.device_uri, o.session.config.rate);
  if (!line.empty()) o.options.log(line);
}

}  // namespace

SceneSession open_session(const Scene& scene, const SessionOptions& options) {
  Opening o{scene, options, {}};
  SceneSession& session = o.session;
  session.device_uri = options.device.empty() ? scene.description.device.uri : options.device;
  session.scene_file = scene.description.file;
  session.seed = options.seed;
  session.config = scene.config;
  session.config.duration = options.duration;
  if (options.rate) session.config.rate = *options.rate;
  if (options.world_from_body) session.config.world_from_body = *options.world_from_body;
  refuse_web_without_page(session.device_uri, options.web_channel);
  open_at(o);
  HapticParams& haptic = session.config.haptic;
  // Faults that are asked for are to be seen as a device would have them.
  haptic.safety.rides_out_gaps = !scene.description.is_strict && session.config.faults.empty();
  use_device_limits(session.device->limits(), haptic);
  tell_of_delay(o);
  if (scene.description.is_passive) enable_passivity(session.device->limits(), session.config);
  if (scene.description.simulation) start_simulation(*scene.description.simulation, o);
  return std::move(o.session);
}

SessionSummary run_lockstep(SceneSession& session, const SessionSinks& sinks,
                            const std::atomic<bool>* stop) {
  if (!session.simulation) return run_lockstep(session.config, *session.device, sinks, stop);
  return run_simulated(session.config, *session.simulation, false, sinks, stop).session;
}

}  // namespace thigma
