// `thigma replay F.mcap`: runs the recorded haptic frames again and compares every bit.

#include <cstdio>
#include <optional>
#include <vector>

#include "json_out.h"
#include "run_session.h"
#include "run_world.h"
#include "verbs.h"
#include "warned_recording.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/recording/config_json.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/replay_session.h"
#include "thigma/recording/world_recording.h"
#include "thigma/scene/packed_scene.h"
#include "thigma/session/simulated_session.h"

namespace thigma::app {
namespace {

struct Verdict {
  RecordingInfo recording;
  ReplayReport report;
  std::uint64_t recorded_hash = 0;
};

/// Of a recorded frame, what a simulation that is run again is compared with.
struct SimulatedFrame {
  std::uint64_t frame = 0;
  BodyState body;
  Wrench command;
};

/// Simulates the recorded scene again, with the seed and resolution of the recording.
ReplayReport replay_simulation(const std::vector<SimulatedFrame>& frames,
                               const RecordedConfig& config, const std::string& path) {
  RunOptions options;
  options.scene = has_packed_scene(path) ? path : config.scene;
  options.device = "null:";
  options.rate = config.rate_hz;
  options.is_headless = options.is_lockstep = true;
  options.resolution.is_exact = config.resolution.is_exact;
  const std::unique_ptr<Run> run = prepare_run(read_run_scene(options), options, config.seed, {});
  if (!run->session.simulation)
    throw InputError(config.scene +
                     ": has no [simulation] any more, expected the scene that was recorded");
  SimulatedStart start = *run->session.simulation;
  start.world.resolution = config.resolution;
  run->session.simulation = std::make_shared<const SimulatedStart>(std::move(start));
  run->session.config.duration = static_cast<double>(frames.size()) / config.rate_hz;
  ReplayReport report;
  StateHash recorded_hash;
  const auto differs = [&report](std::uint64_t frame, const char* what) {
    if (report.first_difference >= 0) return;
    report.first_difference = static_cast<std::int64_t>(frame);
    report.reason = what;
  };
  SessionSinks sinks;
  sinks.haptic = [&](const HapticSample& sample) {
    const SimulatedFrame& recorded = frames.at(report.frames++);
    add_frame(recorded_hash, recorded.body, recorded.command);
    if (recorded.frame != sample.frame) differs(recorded.frame, "frames are missing");
    if (!same_bits(recorded.body, sample.body)) differs(sample.frame, "body state");
  };
  if (!frames.empty())
    report.state_hash =
        run_session(*run, run->session.config, {.is_lockstep = true}, sinks).state_hash;
  report.recorded_hash = recorded_hash.value;
  return report;
}

/// A session is run again while its recording is read; a simulation afterwards, from 200 bytes a
/// frame.
struct Rerun {
  const std::string& path;
  RecordedConfig config{};
  std::optional<SessionReplay> session{};
  std::vector<SimulatedFrame> simulated{};

  bool begin(const std::string& text) {
    config = read_config(text, path);
    if (!config.is_simulated) session.emplace(config.params, config.world_from_body);
    return true;
  }
  void add(const HapticSample& frame) {
    if (session) {
      session->add(frame);
    } else if (config.is_simulated) {
      simulated.push_back({frame.frame, frame.body, frame.command});
    } else {
      throw InputError(path + ": a frame before the /config message, expected it first");
    }
  }
  void add(const ContactSample& model) {
    if (session) session->add(model);
  }
};

Verdict judge(const std::string& path, bool is_quiet) {
  Rerun rerun{path};
  Verdict verdict;
  verdict.recording = stream_recording_warned(
      path,
      {[&](const std::string& text) { return rerun.begin(text); },
       [&](const HapticSample& frame, const SamplePlace&) { rerun.add(frame); },
       [&](const ContactSample& model, const SamplePlace&) { rerun.add(model); }},
      is_quiet);
  const RecordingInfo& recording = verdict.recording;
  verdict.report = rerun.session ? rerun.session->finish()
                                 : replay_simulation(rerun.simulated, rerun.config, path);
  ReplayReport& report = verdict.report;
  verdict.recorded_hash = recording.has_end ? recording.end.state_hash : report.recorded_hash;
  if (report.first_difference < 0 && recording.has_end && report.frames != recording.end.frames) {
    report.first_difference = static_cast<std::int64_t>(report.frames);
    report.reason = "the session had " + std::to_string(recording.end.frames) + " frames";
  }
  report.identical = report.first_difference < 0 && report.state_hash == verdict.recorded_hash;
  return verdict;
}

int replay(const std::string& path, const Common& common) {
  if (is_world_recording(path)) return replay_world(path, common);
  const Verdict verdict = judge(path, common.quiet);
  const RecordingInfo& recording = verdict.recording;
  const ReplayReport& report = verdict.report;
  if (common.json) {
    nlohmann::ordered_json json;
    json["frames"] = report.frames;
    json["state_hash"] = hex_text(report.state_hash);
    json["recorded_hash"] = nullptr;
    if (recording.has_end) json["recorded_hash"] = hex_text(verdict.recorded_hash);
    json["identical"] = report.identical;
    json["first_difference"] = nullptr;
    if (report.first_difference >= 0) json["first_difference"] = report.first_difference;
    json["reason"] = nullptr;
    if (!report.reason.empty()) json["reason"] = report.reason;
    json["cut_off"] = nullptr;
    if (!recording.cut_off.empty()) json["cut_off"] = recording.cut_off;
    print_json(json);
  } else {
    std::printf("%llu frames, state hash %s, %s: %s\n",
                static_cast<unsigned long long>(report.frames), hex_text(report.state_hash).c_str(),
                recording.has_end ? ("recorded " + hex_text(verdict.recorded_hash)).c_str()
                                  : "no recorded hash as the end is missing",
                report.identical ? "identical" : "different");
    if (report.first_difference >= 0) {
      std::printf("first difference at frame %lld: %s\n",
                  static_cast<long long>(report.first_difference), report.reason.c_str());
    }
  }
  return report.identical ? kDone : kClaimFails;
}

}  // namespace

void add_replay(CLI::App& app, Common& common) {
  static std::string path;
  CLI::App* verb = add_verb(app, common, "replay", "run a recording again and compare every bit",
                            [&common] { return replay(path, common); });
  verb->add_option("FILE", path, "recording (.mcap)")->required();
}

}  // namespace thigma::app
