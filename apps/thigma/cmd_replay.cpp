// `thigma replay F.mcap`: runs the recorded haptic frames again and compares every bit.

#include <cstdio>

#include "json_out.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/runtime/config_json.h"
#include "thigma/runtime/recording.h"
#include "thigma/runtime/replay_session.h"

namespace thigma::app {
namespace {

struct Verdict {
  ReplayReport report;
  std::uint64_t recorded_hash = 0;
};

Verdict judge(const Recording& recording, const RecordedConfig& config) {
  Verdict verdict;
  verdict.report =
      replay_session(config.params, config.world_from_body, recording.frames, recording.contacts);
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
  const Recording recording = read_recording(path);
  RecordedConfig config;
  try {
    config = read_config(recording.config);
  } catch (const InputError& error) {
    throw InputError(path + ": " + error.what());
  }
  if (!common.quiet) {
    for (const std::string& warning : recording.warnings) {
      std::fprintf(stderr, "thigma: %s: %s\n", path.c_str(), warning.c_str());
    }
    if (!recording.has_end)
      std::fprintf(stderr, "thigma: %s: the session was cut off; replaying what is there\n",
                   path.c_str());
  }
  const Verdict verdict = judge(recording, config);
  const ReplayReport& report = verdict.report;
  if (common.json) {
    nlohmann::ordered_json json;
    json["frames"] = report.frames;
    json["state_hash"] = hex_text(report.state_hash);
    json["recorded_hash"] = hex_text(verdict.recorded_hash);
    json["identical"] = report.identical;
    json["first_difference"] = nullptr;
    if (report.first_difference >= 0) json["first_difference"] = report.first_difference;
    json["reason"] = nullptr;
    if (!report.reason.empty()) json["reason"] = report.reason;
    print_json(json);
  } else {
    std::printf("%llu frames, state hash %s, recorded %s: %s\n",
                static_cast<unsigned long long>(report.frames), hex_text(report.state_hash).c_str(),
                hex_text(verdict.recorded_hash).c_str(),
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
