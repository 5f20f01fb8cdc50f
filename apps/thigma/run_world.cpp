#include "run_world.h"

#include <cstdio>
#include <memory>
#include <utility>

#include "json_out.h"
#include "run_world_live.h"
#include "world_recorder.h"
#include "world_summary.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/replay_session.h"
#include "thigma/recording/world_recording.h"
#include "thigma/scene/world_scene.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/world_threads.h"

namespace thigma::app {
namespace {

constexpr double kDuration = 10.0;  // in lockstep, where nothing is asked [s]

/// What worlds do not have yet: one line, "" where nothing of it is asked.
std::string missing(const RunOptions& options) {
  const bool is_web = device_scheme(options.device) == "web";
  if (options.is_lockstep && has_page(options))
    return "scenes with [[body]] go by the clock on the page: leave out --lockstep or --port";
  if (is_web && !has_page(options))
    return "--device web: is the page's hand, which --headless and --lockstep leave out";
  if (!options.response.empty()) return "--response is not for scenes with [[body]]";
  if (!options.fault_text.empty()) return "--fault is not for scenes with [[body]]";
  if (options.is_passive) return "--passivity is not for scenes with [[body]]";
  if (options.resolution.is_exact)
    return "--exact is not for scenes with [[body]]: they always are";
  if (asks_for_levels(options.resolution))
    return "scenes with [[body]] have no levels of detail: leave out --threshold, --budget-us and "
           "their like";
  if (!options.texture.empty()) return "--texture is not for scenes with [[body]]";
  if (options.is_repair)
    return "--repair is not for scenes with [[body]]: thigma repair mends them";
  if (!options.histograms.empty())
    return "--histograms is not for scenes with [[body]]: the summary has how long steps take";
  if (options.spin) return "--spin is not for scenes with [[body]]: they sleep until each frame";
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

Log log_of(const Common& common) {
  if (common.quiet) return {};
  return [](const std::string& line) { std::fprintf(stderr, "thigma: %s\n", line.c_str()); };
}

/// The scene with what the command line says of it.
LoadedWorld load(const RunOptions& options, const Common& common) {
  WorldSceneDescription scene = read_world_scene(options.scene);
  use_options(options, scene);
  LoadedWorld world = load_world(std::move(scene), log_of(common));
  const double usual = options.is_lockstep ? kDuration : 0.0;
  world.config.duration = options.duration.value_or(usual);
  return world;
}

std::vector<std::string> devices_of(const RunOptions& options, const LoadedWorld& world) {
  std::vector<std::string> uris;
  for (std::size_t i = 0; i < world.config.hands.size(); ++i)
    uris.push_back(i == 0 && !options.device.empty() ? options.device
                                                     : world.description.devices[i].uri);
  return uris;
}

/// What a scene whose hand is the page's lacks where there is none: one line, else "".
std::string missing_page(const RunOptions& options, const LoadedWorld& world) {
  if (has_page(options)) return "";
  for (const std::string& uri : devices_of(options, world))
    if (device_scheme(uri) == "web")
      return options.scene + ": its device '" + uri +
             "' is the page's hand, which --headless and --lockstep leave out";
  return "";
}

/// Without a page: in lockstep, or by the clock.
WorldSummary run_alone(const RunOptions& options, const LoadedWorld& world, std::uint64_t seed,
                       const std::atomic<bool>& stop, WorldRunFacts& facts) {
  facts.devices = devices_of(options, world);
  const WorldDevices devices = open_world_devices(world, facts.devices, seed);
  std::unique_ptr<WorldRecorder> recorder;
  if (!options.record.empty())
    recorder = std::make_unique<WorldRecorder>(
        options.record, world,
        WorldRecorderInfo{options.scene, facts.devices, seed, options.friction});
  const auto sink = [&](const WorldFrame& frame) {
    count_step(frame, facts);
    if (recorder) recorder->write(frame);
  };
  const std::int64_t begin = thread_cpu_ns();
  const WorldShell shell{.sink = sink, .stop = &stop};
  const auto run = [&] {
    if (options.is_lockstep) return run_world(world.config, devices.list, sink, &stop);
    // A recording has no samples of simulated hands, and replays where these are in the one loop.
    if (recorder) return run_world_by_clock(world.config, devices.list, shell);
    return run_world_on_threads(world.config, devices.list, shell, RtRequest{});
  };
  const WorldSummary summary = run();
  facts.cpu_seconds = 1e-9 * static_cast<double>(thread_cpu_ns() - begin);
  if (recorder) recorder->close(summary);
  return summary;
}

}  // namespace

int run_world_scene(const RunOptions& options, const Common& common,
                    const std::atomic<bool>& stop) {
  if (const std::string wrong = missing(options); !wrong.empty()) {
    print_error("run: " + wrong);
    return kUsage;
  }
  LoadedWorld world = load(options, common);
  const bool may_be_idle = options.device == "null:" || device_scheme(options.device) == "web";
  if (world.config.hands.empty() && !options.device.empty() && !may_be_idle) {
    print_error("run: --device " + options.device + ": no body of the scene is held");
    return kUsage;
  }
  if (const std::string wrong = missing_page(options, world); !wrong.empty()) {
    print_error("run: " + wrong);
    return kUsage;
  }
  WorldRunFacts facts;
  facts.has_clock = !options.is_lockstep;
  WorldSummary summary;
  if (has_page(options)) {
    summary = run_world_live({.world = &world,
                              .options = &options,
                              .seed = common.seed,
                              .devices = devices_of(options, world),
                              .stop = &stop,
                              .log = log_of(common)},
                             facts);
  } else {
    summary = run_alone(options, world, common.seed, stop, facts);
  }
  if (common.json || options.is_headless)
    print_json(world_summary_json(summary, world, facts));
  else
    print_world_summary(summary, world, facts);
  flush_output();
  if (summary.has_fault()) {
    print_error(std::string("run: ended by a fault: ") + fault_name(summary.fault));
    return kSafetyFault;
  }
  return summary.was_stopped ? kInterrupted : kDone;
}

namespace {

/// Aims a page's hand at what it was aimed at before the frame that comes.
void aim_as_recorded(const WorldRecording& recording, std::uint64_t frame, WorldRun& run) {
  for (const std::vector<RecordedHand>& hand : recording.hands)
    if (frame < hand.size() && hand[frame].aimed) run.aim(*hand[frame].aimed);
}

}  // namespace

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
  add_recorded_hands(recording.devices, world);
  if (world.config.hands.size() != recording.devices.size())
    throw InputError(recording.scene + ": has " + std::to_string(world.config.hands.size()) +
                     " hands, expected the " + std::to_string(recording.devices.size()) +
                     " that were recorded");
  WorldDevices devices = open_world_devices(world, recording.devices, recording.seed);
  for (std::size_t i = 0; i < devices.list.size(); ++i) {
    if (devices.list[i] != nullptr) continue;
    devices.owned.push_back(recorded_hand(recording.hands[i]));
    devices.list[i] = devices.owned.back().get();
  }
  std::int64_t first = -1;
  const auto compare = [&](const WorldFrame& frame) {
    for (std::size_t i = 0; i < bodies && first < 0 && frame.frame < frames; ++i) {
      const BodyState& recorded = recording.states[frame.frame * bodies + i];
      if (!same_bits(recorded, frame.bodies[i])) first = static_cast<std::int64_t>(frame.frame);
    }
  };
  WorldRun run(world.config, devices.list);
  for (std::uint64_t i = 0;; ++i) {
    aim_as_recorded(recording, i, run);
    const WorldFrame* frame = run.make_frame();
    if (frame == nullptr) break;
    compare(*frame);
  }
  const WorldSummary summary = run.end();
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
