// `thigma plot F.mcap -o F.png`, .svg or .pdf: a recorded session against time.

#include <cstdio>
#include <filesystem>
#include <optional>

#include "json_out.h"
#include "session_figure.h"
#include "verbs.h"
#include "warned_recording.h"
#include "world_figure.h"
#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/recording/recording.h"

namespace thigma::app {
namespace {

int write_figure(const plot::Figure& figure, plot::PageFormat format, std::size_t frames,
                 const std::string& out, const Common& common) {
  write_file(out, plot::figure_bytes(figure, format));
  if (common.json) {
    nlohmann::ordered_json json;
    json["file"] = out;
    json["frames"] = frames;
    json["panels"] = figure.panels.size();
    print_json(json);
  } else if (!common.quiet) {
    std::fprintf(stderr, "%zu frames drawn in %s\n", frames, out.c_str());
  }
  return kDone;
}

std::string title_of(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

[[noreturn]] void refuse_empty(const std::string& path) {
  throw InputError(path + ": no haptic frame in it, at least one was expected");
}

int plot_world(const std::string& path, plot::PageFormat format, const std::string& out,
               const Common& common) {
  WorldExtent extent;
  const WorldRecordingPass pass =
      stream_world_warned(path,
                          {[&](const WorldRecordingInfo& info) { extent.add(info); },
                           [&](const RecordedWorldFrame& frame) { extent.add(frame); },
                           [&](const HandTick& tick) { extent.add(tick); }},
                          common.quiet);
  if (extent.frames == 0) refuse_empty(path);
  WorldCurves curves(extent);
  stream_world_recording(path, {{},
                                [&](const RecordedWorldFrame& frame) { curves.add(frame); },
                                [&](const HandTick& tick) { curves.add(tick); }});
  return write_figure(curves.figure(pass, title_of(path)), format, extent.frames, out, common);
}

int plot_recording(const std::string& path, const std::string& out, const Common& common) {
  const std::optional<plot::PageFormat> format = plot::page_format(out);
  if (!format) {
    print_error("plot: -o " + out + ": expected a file that ends in .png, .svg or .pdf");
    return kUsage;
  }
  if (is_world_recording(path)) return plot_world(path, *format, out, common);
  // Twice over the file, so that no recording is too long for memory. One that is still being
  // written is longer the second time; what is new is left out.
  SessionExtent extent;
  const RecordingInfo recording = stream_recording_warned(
      path,
      {{},
       [&](const HapticSample& frame, const SamplePlace&) { extent.add(frame); },
       [&](const ContactSample&, const SamplePlace&) { ++extent.contacts; }},
      common.quiet);
  if (extent.frames == 0) refuse_empty(path);
  SessionCurves curves(extent);
  SessionExtent drawn;
  stream_recording(path, {{},
                          [&](const HapticSample& frame, const SamplePlace&) {
                            if (drawn.frames < extent.frames) curves.add(frame);
                            drawn.add(frame);
                          },
                          [&](const ContactSample& contact, const SamplePlace&) {
                            if (drawn.contacts++ < extent.contacts) curves.add(contact);
                          }});
  return write_figure(curves.figure(recording, title_of(path)), *format, extent.frames, out,
                      common);
}

}  // namespace

void add_plot(CLI::App& app, Common& common) {
  static std::string path, out;
  CLI::App* verb = add_verb(app, common, "plot",
                            "draw a recording: force, torque, penetration, stretch, rates, energy",
                            [&common] { return plot_recording(path, out, common); });
  verb->add_option("FILE", path, "recording (.mcap)")->required();
  verb->add_option("-o,--output", out, "file to write: .png, .svg or .pdf")->required();
}

}  // namespace thigma::app
