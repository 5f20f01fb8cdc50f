// `thigma export F.mcap -o F.csv`: one row a haptic frame, units in the header.

#include <cstdio>

#include "json_out.h"
#include "verbs.h"
#include "warned_recording.h"
#include <nlohmann/json.hpp>

#include "thigma/recording/recording.h"

namespace thigma::app {
namespace {

int export_recording(const std::string& path, const std::string& out, const Common& common) {
  CsvExport csv(out);
  const RecordingInfo recording = stream_recording_warned(
      path, {.frame = [&csv](const HapticSample& frame, const SamplePlace&) { csv.add(frame); }},
      common.quiet);
  csv.keep();
  if (common.json) {
    nlohmann::ordered_json json;
    json["file"] = out;
    json["frames"] = recording.frame_count;
    print_json(json);
  } else if (!common.quiet) {
    std::fprintf(stderr, "%llu frames written to %s\n",
                 static_cast<unsigned long long>(recording.frame_count), out.c_str());
  }
  return kDone;
}

}  // namespace

void add_export(CLI::App& app, Common& common) {
  static std::string path, out;
  CLI::App* verb = add_verb(app, common, "export", "write a recording as CSV, units in the header",
                            [&common] { return export_recording(path, out, common); });
  verb->add_option("FILE", path, "recording (.mcap)")->required();
  verb->add_option("-o,--output", out, "CSV file to write")->required();
}

}  // namespace thigma::app
