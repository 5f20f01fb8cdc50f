// `thigma export F.mcap -o F.csv`: one row a frame, units in the header.

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include "json_out.h"
#include "verbs.h"
#include "warned_recording.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/recording/recording.h"
#include "thigma/recording/world_frames.h"

namespace thigma::app {
namespace {

struct Export {
  std::string path, out, haptic;  // haptic: "" where it is not asked for
};

void tell(const Export& asked, std::uint64_t frames, std::optional<std::uint64_t> steps,
          const Common& common) {
  const auto count = static_cast<unsigned long long>(frames);
  if (common.json) {
    nlohmann::ordered_json json;
    json["file"] = asked.out;
    json["frames"] = frames;
    if (steps) {
      json["haptic_file"] = asked.haptic;
      json["haptic_frames"] = *steps;
    }
    print_json(json);
  } else if (!common.quiet) {
    std::fprintf(stderr, "%llu frames written to %s\n", count, asked.out.c_str());
    if (steps)
      std::fprintf(stderr, "%llu haptic frames written to %s\n",
                   static_cast<unsigned long long>(*steps), asked.haptic.c_str());
  }
}

int export_world(const Export& asked, const Common& common) {
  std::optional<WorldCsvExport> csv;
  std::optional<HapticCsvExport> haptic;
  WorldRecordingSinks sinks;
  sinks.info = [&](const WorldRecordingInfo& info) {
    if (!asked.haptic.empty() && !info.is_apart)
      throw InputError(asked.path +
                       ": has no haptic frames of their own, as each frame of its world is one; "
                       "expected a world by the clock, or no --haptic");
    csv.emplace(asked.out, info);
    if (!asked.haptic.empty()) haptic.emplace(asked.haptic);
  };
  sinks.frame = [&](const RecordedWorldFrame& frame) { csv->add(frame); };
  sinks.tick = [&](const HandTick& tick) {
    if (haptic) haptic->add(tick);
  };
  const WorldRecordingPass pass = stream_world_warned(asked.path, sinks, common.quiet);
  csv->keep();
  if (haptic) haptic->keep();
  tell(asked, pass.frame_count, haptic ? std::optional(pass.tick_count) : std::nullopt, common);
  return kDone;
}

/// Refuses to write over what is read, or two tables into one file; "" where neither is asked for.
std::string overwritten(const Export& asked) {
  for (const std::string& out : {asked.out, asked.haptic})
    if (is_one_file(asked.path, out)) return out + " is the recording, expected another file";
  const auto whole = [](const std::string& name) {
    return std::filesystem::absolute(name).lexically_normal();
  };
  if (!asked.haptic.empty() && whole(asked.haptic) == whole(asked.out))
    return asked.haptic + " is the file of -o, expected another one";
  return "";
}

int export_recording(const Export& asked, const Common& common) {
  if (const std::string why = overwritten(asked); !why.empty()) {
    print_error("export: " + why);
    return kUsage;
  }
  if (is_world_recording(asked.path)) return export_world(asked, common);
  if (!asked.haptic.empty()) {
    stream_recording(asked.path, {});  // says what is wrong with what is none

    print_error(
        "export: --haptic is for recordings of worlds: every row of this one is a haptic "
        "frame");
    return kUsage;
  }
  CsvExport csv(asked.out);
  const RecordingInfo recording = stream_recording_warned(
      asked.path,
      {.frame = [&csv](const HapticSample& frame, const SamplePlace&) { csv.add(frame); }},
      common.quiet);
  csv.keep();
  tell(asked, recording.frame_count, std::nullopt, common);
  return kDone;
}

}  // namespace

void add_export(CLI::App& app, Common& common) {
  static Export asked;
  CLI::App* verb = add_verb(app, common, "export", "write a recording as CSV, units in the header",
                            [&common] { return export_recording(asked, common); });
  verb->add_option("FILE", asked.path, "recording (.mcap)")->required();
  verb->add_option("-o,--output", asked.out, "CSV file to write")->required();
  verb->add_option(
      "--haptic", asked.haptic,
      "second CSV file, of the haptic frames of a world's hands, where they were apart");
}

}  // namespace thigma::app
