#pragma once
// The verbs of the program. Each lives in cmd_<verb>.cpp, adds its options to the parser and, when
// chosen, returns an exit code (0 done, 1 failed, 2 usage, 3 device, 4 input, 5 claim, 6
// safety, 130 interrupted).

#include <cstdint>
#include <functional>
#include <string>

#include <CLI/CLI.hpp>

namespace thigma::app {

enum ExitCode : int {
  kDone = 0,
  kFailed = 1,
  kUsage = 2,
  kUnavailable = 3,
  kBadInput = 4,
  kClaimFails = 5,
  kSafetyFault = 6,
  kInterrupted = 130
};

/// Options every verb has.
struct Common {
  // one JSON object a line on standard output: asked for, or nobody reads (no terminal)
  bool json = false;
  bool text = false;   // lines for people, wherever they go
  bool quiet = false;  // nothing on standard error but errors
  std::uint64_t seed = 1;
  int exit_code = 0;  // of the verb that ran
};

/// Adds --json, --text, --quiet, --seed to a verb; `body` runs when it is chosen and returns the
/// exit code. InputError thrown by body prints its one line and exits 4, IoError 1.
CLI::App* add_verb(CLI::App& app, Common& common, const char* name, const char* help,
                   std::function<int()> body);

struct RunOptions;

/// What `run` does with options that are right (cmd_run.cpp); exit code. InputError, IoError.
int run_verb(const RunOptions& options, const Common& common);

/// Every verb of this build, in the order of --help (all_verbs.cpp).
void add_all_verbs(CLI::App& app, Common& common);

/// Whether two names are of one file that is there. A verb that would write over what it reads says
/// so instead: kUsage.
bool is_one_file(const std::string& a, const std::string& b);

/// "thigma: TEXT" as one line on standard error. What a file or a file name brought along and a
/// terminal would act on, control characters, becomes '?'.
void print_error(const std::string& text);

}  // namespace thigma::app
