#include "verbs.h"

#include <utility>

namespace thigma::app {

CLI::App* add_verb(CLI::App& app, Common& common, const char* name, const char* help,
                   std::function<int()> body) {
  CLI::App* verb = app.add_subcommand(name, help);
  verb->add_flag("--json", common.json, "one JSON object a line on standard output");
  verb->add_flag("--quiet", common.quiet, "no progress or notes on standard error");
  verb->add_option("--seed", common.seed, "seed of everything random")->capture_default_str();
  verb->final_callback([&common, body = std::move(body)] { common.exit_code = body(); });
  return verb;
}

}  // namespace thigma::app
