#pragma once
// The options of `thigma run`.

#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "thigma/math/pose.h"
#include "thigma/runtime/fault_injection.h"

namespace thigma::app {

/// As given on the command line; what is empty is the scene's business.
struct RunOptions {
  std::string scene;            // file or built-in name
  std::string object, against;  // instead of a scene
  double scale = 1.0;
  std::string pose_text;
  std::string device;
  std::optional<double> duration;  // otherwise until stopped [s]
  bool is_headless = false;
  bool is_lockstep = false;
  std::optional<double> rate;  // otherwise the scene's [Hz]
  std::string record;
  bool is_exact = false;
  std::string response = "coupled";
  bool is_repair = false;
  std::string fault_text;
  // Of parts that are not built yet: refused with a sentence.
  std::string threshold, budget_us, budget_tests, deviation_cap, texture, port;
};

void add_run_options(CLI::App& verb, RunOptions& options);

/// What is wrong with the options as such, one sentence, "" when nothing; exit code 2.
std::string check_run_options(const RunOptions& options);

/// Pose "x,y,z,qx,qy,qz,qw" of --pose; no value when the text is no such thing (usage), InputError
/// when |q| is off 1 by more than 1e-6.
std::optional<Pose> parse_pose(const std::string& text);

}  // namespace thigma::app
