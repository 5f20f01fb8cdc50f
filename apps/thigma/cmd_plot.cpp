// `thigma plot F.mcap -o F.png`: a recorded session against time.

#include <cstdio>
#include <filesystem>

#include "json_out.h"
#include "session_figure.h"
#include "told_recording.h"
#include "verbs.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/core/file.h"
#include "thigma/runtime/recording.h"

namespace thigma::app {
namespace {

int plot_recording(const std::string& path, const std::string& out, const Common& common) {
  const Recording recording = read_recording_told(path, common.quiet);
  if (recording.frames.empty())
    throw InputError(path + ": no haptic frame in it, at least one was expected");
  const std::string name = std::filesystem::path(path).filename().string();
  const plot::Figure figure = session_figure(recording, name);
  write_file(out, plot::png_bytes(figure));
  if (common.json) {
    nlohmann::ordered_json json;
    json["file"] = out;
    json["frames"] = recording.frames.size();
    json["panels"] = figure.panels.size();
    print_json(json);
  } else if (!common.quiet) {
    std::fprintf(stderr, "%zu frames drawn in %s\n", recording.frames.size(), out.c_str());
  }
  return kDone;
}

}  // namespace

void add_plot(CLI::App& app, Common& common) {
  static std::string path, out;
  CLI::App* verb = add_verb(app, common, "plot",
                            "draw a recording: force, torque, penetration, stretch, rates, energy",
                            [&common] { return plot_recording(path, out, common); });
  verb->add_option("FILE", path, "recording (.mcap)")->required();
  verb->add_option("-o,--output", out, "PNG file to write")->required();
}

}  // namespace thigma::app
