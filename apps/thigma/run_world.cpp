#include "run_world.h"

#include <cstdio>
#include <memory>
#include <span>
#include <utility>

#include "guarded_writer.h"
#include "json_out.h"
#include "named_scene.h"
#include "run_world_live.h"
#include "world_recorder.h"
#include "world_summary.h"

#include "thigma/device/open_device.h"
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
    return "scenes with [[body]] say themselves what is coarse far away ([contact] threshold): "
           "leave out --threshold, --budget-us and their like";
  if (options.resolution.carry) return "--carry is not for scenes with [[body]]";
  if (!options.texture.empty()) return "--texture is not for scenes with [[body]]";
  if (options.is_repair)
    return "--repair is not for scenes with [[body]]: thigma repair mends them";
  if (!options.histograms.empty())
    return "--histograms is not for scenes with [[body]]: the summary has how long steps take";
  if (options.spin)
    return "--spin is not for scenes with [[body]]: hands of people poll as long as wake-ups ask "
           "for, all else sleeps";
  return "";
}

void use_options(const RunOptions& options, WorldSceneDescription& scene) {
  scene.rate = options.rate.value_or(scene.rate);
  if (options.friction) use_friction(*options.friction, scene);
}

Log log_of(const Common& common) {
  if (common.quiet) return {};
  return [](const std::string& line) { std::fprintf(stderr, "thigma: %s\n", line.c_str()); };
}

/// The scene with what the command line says of it.
LoadedWorld load(const RunOptions& options, const Common& common) {
  WorldSceneDescription scene = read_named_world(options.scene);
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
WorldSummary run_alone(const RunOptions& options, LoadedWorld& world, const Common& common,
                       const std::atomic<bool>& stop, WorldRunFacts& facts) {
  facts.devices = devices_of(options, world);
  use_clutches(facts.devices, world);
  const WorldDevices devices =
      open_world_devices(world, facts.devices, common.seed, !options.is_lockstep);
  if (!options.is_lockstep)
    prepare_for_people(devices, facts.devices, world.config.rate, log_of(common));
  GuardedWriter<WorldRecorder> recorder([&](const RecordingFailure& failure) {
    facts.is_recorded_whole = false;
    print_error(failure.line());
  });
  if (!options.record.empty())
    recorder.begin(std::make_unique<WorldRecorder>(
        options.record, world,
        WorldRecorderInfo{options.scene, facts.devices, common.seed, options.friction,
                          !options.is_lockstep, limits_of(devices.list)}));
  WorldShell shell;
  shell.stop = &stop;
  shell.sink = [&](const WorldFrame& frame) {
    count_step(frame, facts);
    recorder.write_frame(frame);
  };
  if (recorder.is_open())
    shell.ticks = [&](std::span<const HandTick> ticks) { recorder.write(ticks); };
  const std::int64_t begin = thread_cpu_ns();
  const WorldSummary summary =
      options.is_lockstep ? run_world(world.config, devices.list, shell.sink, &stop)
                          : run_world_on_threads(world.config, devices.list, shell, RtRequest{});
  facts.cpu_seconds = 1e-9 * static_cast<double>(thread_cpu_ns() - begin);
  recorder.close(summary);
  return summary;
}

}  // namespace

void prepare_for_people(const WorldDevices& devices, const std::vector<std::string>& uris,
                        double rate, const Log& log) {
  std::vector<std::string> lines;
  bool has_person = false;
  for (std::size_t i = 0; i < devices.list.size(); ++i) {
    const HapticDevice* device = devices.list[i];
    if (device == nullptr || !device->limits().holds_person) continue;
    has_person = true;
    lines.push_back(delay_line(*device, uris[i], rate));
  }
  if (has_person) lines.push_back(lock_process_memory());
  for (const std::string& line : lines)
    if (log && !line.empty()) log(line);
}

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
    summary = run_alone(options, world, common, stop, facts);
  }
  if (common.json)
    print_json(world_summary_json(summary, world, facts));
  else
    print_world_summary(summary, world, facts);
  flush_output();
  if (summary.has_fault()) {
    print_error(fault_line(summary, world, facts.devices));
    return kSafetyFault;
  }
  if (!facts.is_recorded_whole) return kFailed;
  return summary.was_stopped ? kInterrupted : kDone;
}

}  // namespace thigma::app
