#include "run_world.h"

#include <cstdio>
#include <ctime>
#include <memory>

#include "json_out.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/replay_session.h"
#include "thigma/recording/world_recording.h"
#include "thigma/scene/world_scene.h"

namespace thigma::app {
namespace {

constexpr double kDuration = 10.0;  // where nothing is asked [s]

/// What worlds do not have yet: one line, "" where nothing of it is asked.
std::string missing(const RunOptions& options) {
  if (!options.is_lockstep)
    return "scenes with [[body]] run with --lockstep --headless: threads do not have them yet";
  if (has_page(options))
    return "scenes with [[body]] run with --headless: the page does not have them yet";
  if (!options.response.empty()) return "--response is not for scenes with [[body]]";
  if (!options.fault_text.empty()) return "--fault is not for scenes with [[body]]";
  if (options.is_passive) return "--passivity is not for scenes with [[body]]";
  return "";
}

void use_friction(std::optional<double> friction, WorldSceneDescription& scene) {
  if (!friction) return;
  for (WorldSceneBody& body : scene.bodies) {
    if (!body.object.material) body.object.material = Material{};
    body.object.material->friction = {*friction, *friction};
  }
}

void use_options(const RunOptions& options, WorldSceneDescription& scene) {
  scene.rate = options.rate.value_or(scene.rate);
  use_friction(options.friction, scene);
}

double cpu_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

nlohmann::ordered_json summary_json(const WorldSummary& s, const LoadedWorld& world,
                                    const std::vector<std::string>& devices, double seconds) {
  nlohmann::ordered_json json;
  json["scene"] = world.description.file;
  json["device"] = nullptr;
  if (!devices.empty()) json["device"] = devices.front();
  json["frames"] = s.frames;
  json["rate_hz"] = world.config.rate;
  json["bodies"] = world.config.world.bodies.size();
  json["awake"] = s.awake;
  json["step_cpu_us_mean"] = nullptr;
  if (s.frames > 0) json["step_cpu_us_mean"] = 1e6 * seconds / static_cast<double>(s.frames);
  json["contact"] = {{"pairs_max", s.pairs_max},
                     {"queries", s.queries},
                     {"rows_max", s.rows_max},
                     {"pressing_max", s.pressing_max},
                     {"largest_island", s.largest_island},
                     {"row_gap_min", nullptr}};
  if (std::isfinite(s.gap_min)) json["contact"]["row_gap_min"] = s.gap_min;
  json["joints"] = {{"count", world.config.world.joints.size()}, {"error_max", s.joint_error}};
  json["solve"] = {{"newton", s.newton},
                   {"residual_max", s.residual_max},
                   {"parts_max", s.parts_max},
                   {"squeezed", s.not_whole},
                   {"waited", s.waited}};
  json["impacts"] = s.impacts;
  json["force"] = {{"max", s.force_max}};
  json["hands"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < s.hands.size(); ++i) {
    const WorldHandSummary& hand = s.hands[i];
    const std::int32_t body = world.config.hands[i].body;
    nlohmann::ordered_json one = {{"device", devices[i]},
                                  {"holds", world.config.world.bodies[idx(body)].name},
                                  {"force_max", hand.force_max},
                                  {"energy", hand.port_energy},
                                  {"energy_min", hand.port_energy_min},
                                  {"fault", nullptr}};
    if (hand.fault != Fault::none) one["fault"] = fault_name(hand.fault);
    json["hands"].push_back(std::move(one));
  }
  json["energy"] = {{"start", s.energy_start},
                    {"end", s.energy_end},
                    {"port", s.port_energy},
                    {"energy_min", s.port_energy_min},
                    {"made", s.energy_made}};
  json["state_hash"] = hex_text(s.state_hash);
  return json;
}

void print_text(const WorldSummary& s, const LoadedWorld& world, double seconds) {
  std::printf("%s: %llu frames of %zu bodies, %d awake at the end, %.0f us a step\n",
              world.description.title.c_str(), static_cast<unsigned long long>(s.frames),
              world.config.world.bodies.size(), s.awake,
              s.frames > 0 ? 1e6 * seconds / static_cast<double>(s.frames) : 0.0);
  std::printf("contacts: at most %lld rows, %d pairs, islands of %d; residual %.2g m/s\n",
              static_cast<long long>(s.rows_max), s.pairs_max, s.largest_island, s.residual_max);
  std::printf("hand: at most %.3f N, put in %.3g mJ (least %.3g mJ)\n", s.force_max,
              1e3 * s.port_energy, 1e3 * s.port_energy_min);
  if (const std::size_t joints = world.config.world.joints.size(); joints > 0)
    std::printf("joints: %zu, met to %.2g um\n", joints, 1e6 * s.joint_error);
  if (s.waited > 0.0) std::printf("bodies waited for %.3g ms\n", 1e3 * s.waited);
  std::printf("state hash %s\n", hex_text(s.state_hash).c_str());
}

Log log_of(const Common& common) {
  if (common.quiet) return {};
  return [](const std::string& line) { std::fprintf(stderr, "thigma: %s\n", line.c_str()); };
}

}  // namespace

int run_world_scene(const RunOptions& options, const Common& common,
                    const std::atomic<bool>& stop) {
  if (const std::string wrong = missing(options); !wrong.empty()) {
    print_error("run: " + wrong);
    return kUsage;
  }
  WorldSceneDescription scene = read_world_scene(options.scene);
  use_options(options, scene);
  LoadedWorld world = load_world(std::move(scene), log_of(common));
  world.config.duration = options.duration.value_or(kDuration);
  if (world.config.hands.empty() && !options.device.empty() && options.device != "null:") {
    print_error("run: --device " + options.device + ": no body of the scene is held");
    return kUsage;
  }
  std::vector<std::string> uris;
  for (std::size_t i = 0; i < world.config.hands.size(); ++i)
    uris.push_back(i == 0 && !options.device.empty() ? options.device
                                                     : world.description.devices[i].uri);
  const WorldDevices devices = open_world_devices(world, uris, common.seed);
  std::unique_ptr<WorldRecordingWriter> writer;
  if (!options.record.empty()) {
    WorldRecordingInfo info;
    info.scene = options.scene;
    info.devices = uris;
    info.seed = common.seed;
    info.rate = world.config.rate;
    info.friction = options.friction;
    for (const WorldBody& body : world.config.world.bodies) info.bodies.push_back(body.name);
    for (const WorldJoint& joint : world.config.world.joints) info.joints.push_back(joint.name);
    writer = std::make_unique<WorldRecordingWriter>(options.record, info);
  }
  const double begin = cpu_seconds();
  std::vector<RecordedJoint> joints(world.config.world.joints.size());
  const auto record = [&](const WorldFrame& frame) {
    if (!writer) return;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const JointReading& joint = frame.joints[i];
      joints[i] = {joint.coordinate, joint.spring, joint.motor, joint.limit};
    }
    writer->write(frame.frame, frame.time, frame.bodies, joints, frame.commands);
  };
  const WorldSummary summary = run_world(world.config, devices.list, record, &stop);
  const double seconds = cpu_seconds() - begin;
  if (writer) writer->close(summary.frames, summary.state_hash);
  if (common.json || options.is_headless)
    print_json(summary_json(summary, world, uris, seconds));
  else
    print_text(summary, world, seconds);
  flush_output();
  if (summary.has_fault()) {
    print_error(std::string("run: ended by a fault: ") + fault_name(summary.fault));
    return kSafetyFault;
  }
  return summary.was_stopped ? kInterrupted : kDone;
}

int replay_world(const std::string& path, const Common& common) {
  const WorldRecording recording = read_world_recording(path);
  const std::size_t bodies = recording.bodies.size(), frames = recording.states.size() / bodies;
  WorldSceneDescription scene = read_world_scene(recording.scene);
  scene.rate = recording.rate;
  use_friction(recording.friction, scene);
  LoadedWorld world = load_world(std::move(scene));
  if (world.config.world.bodies.size() != bodies)
    throw InputError(recording.scene + ": has " + std::to_string(world.config.world.bodies.size()) +
                     " bodies, expected the " + std::to_string(bodies) + " that were recorded");
  if (world.config.world.joints.size() != recording.joints.size())
    throw InputError(recording.scene + ": has " + std::to_string(world.config.world.joints.size()) +
                     " joints, expected the " + std::to_string(recording.joints.size()) +
                     " that were recorded");
  world.config.duration = static_cast<double>(frames) / recording.rate;
  if (world.config.hands.size() != recording.devices.size())
    throw InputError(recording.scene + ": has " + std::to_string(world.config.hands.size()) +
                     " hands, expected the " + std::to_string(recording.devices.size()) +
                     " that were recorded");
  const WorldDevices devices = open_world_devices(world, recording.devices, recording.seed);
  std::int64_t first = -1;
  const auto compare = [&](const WorldFrame& frame) {
    for (std::size_t i = 0; i < bodies && first < 0 && frame.frame < frames; ++i) {
      const BodyState& recorded = recording.states[frame.frame * bodies + i];
      if (!same_bits(recorded, frame.bodies[i])) first = static_cast<std::int64_t>(frame.frame);
    }
  };
  const WorldSummary summary = run_world(world.config, devices.list, compare);
  if (first < 0 && summary.frames != frames) first = static_cast<std::int64_t>(summary.frames);
  const bool is_same =
      first < 0 && (!recording.has_end || summary.state_hash == recording.state_hash);
  nlohmann::ordered_json json;
  json["frames"] = summary.frames;
  json["state_hash"] = hex_text(summary.state_hash);
  json["recorded_hash"] = nullptr;
  if (recording.has_end) json["recorded_hash"] = hex_text(recording.state_hash);
  json["identical"] = is_same;
  json["first_difference"] = nullptr;
  if (first >= 0) json["first_difference"] = first;
  if (common.json)
    print_json(json);
  else
    std::printf("%llu frames of %zu bodies, state hash %s: %s\n",
                static_cast<unsigned long long>(summary.frames), bodies,
                hex_text(summary.state_hash).c_str(), is_same ? "identical" : "different");
  return is_same ? kDone : kClaimFails;
}

}  // namespace thigma::app
