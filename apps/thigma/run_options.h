#pragma once
// The options of `thigma run`.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "resolution_options.h"
#include <CLI/CLI.hpp>

#include "thigma/math/pose.h"
#include "thigma/session/fault_injection.h"

namespace thigma::app {

/// What is said of a --response that response_of does not know.
inline constexpr const char* kWrongResponse =
    "--response is penalty (or coupled, its older name), constraint, potential or direct";

/// As given on the command line; what is empty is the scene's business.
struct RunOptions {
  std::string scene;            // file or built-in name
  std::string object, against;  // instead of a scene
  std::optional<double> scale;  // of both meshes; 1 where none is named
  std::string pose_text;
  std::string device;
  std::optional<double> duration;  // otherwise until stopped [s]
  bool is_headless = false;
  bool is_lockstep = false;
  std::optional<double> rate;  // otherwise the scene's [Hz]
  std::string record;
  std::string replay;  // recording to show instead of a session; its scene, where none is named
  bool sends_zero = false;  // not of `run`: whatever the scene, the device is sent no force
  bool is_shown = false;    // not of the command line: a recording is shown, contacts by its levels
  std::string histograms;   // file for the durations of every stage
  std::optional<double> spin;  // polled before each deadline [us]; otherwise as wake-ups ask for
  ResolutionOptions resolution;
  bool has_no_blend = false;       // contacts change level at once
  std::string response;            // otherwise the scene's
  std::optional<double> friction;  // of every contact, over all materials
  bool is_passive = false;         // passivity controller; otherwise as the scene says
  bool has_no_cache = false;       // levels of detail are built and forgotten
  bool is_repair = false;
  std::string fault_text;
  std::string texture;                // "on", "off"; otherwise on where the scene has some
  std::optional<std::uint16_t> port;  // of the page; otherwise any free one
  std::string bind;                   // address of the page; otherwise this machine alone
  bool is_embedded = false;           // pages of this machine may show the page in a frame
};

/// Whether the run has a page: not headless, and in lockstep only where a port is named.
bool has_page(const RunOptions& options);

void add_run_options(CLI::App& verb, RunOptions& options);

/// What is wrong with the options as such, one sentence, "" when nothing; exit code 2.
std::string check_run_options(const RunOptions& options);

/// Pose "x,y,z,qx,qy,qz,qw" of --pose; no value when the text is no such thing (usage), InputError
/// when |q| is off 1 by more than 1e-6.
std::optional<Pose> parse_pose(const std::string& text);

}  // namespace thigma::app
