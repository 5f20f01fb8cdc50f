// The program `thigma`: parses, runs one verb, turns what went wrong into one line and an exit code.

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>

#include "thigma/core/error.h"
#include "verbs.h"
#include "version.h"

namespace thigma::app {
namespace {

int run(int argc, char** argv) {
  CLI::App app("Six-degree-of-freedom haptic rendering: move a virtual object against others, feel force and torque.",
               "thigma");
  app.set_version_flag("--version", std::string("thigma ") + kVersion);
  app.require_subcommand(1);
  app.footer("thigma VERB --help tells the options of a verb. Exit codes: 0 done, 1 failed, 2 usage, 3 device or\n"
             "permission unavailable, 4 bad input, 5 a claim does not hold, 6 safety fault, 130 interrupted.");
  Common common;
  add_all_verbs(app, common);
  try {
    app.parse(argc, argv);
    return common.exit_code;
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "thigma: %s\nthigma: try `thigma --help`\n", error.what());
    return kUsage;
  }
}

}  // namespace
}  // namespace thigma::app

int main(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a closed pipe is a failed write, not a death
  try {
    return thigma::app::run(argc, argv);
  } catch (const thigma::InputError& error) {
    std::fprintf(stderr, "thigma: %s\n", error.what());
    return thigma::app::kBadInput;
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "thigma: out of memory\n");
    return thigma::app::kFailed;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "thigma: %s\n", error.what());
    return thigma::app::kFailed;
  }
}
