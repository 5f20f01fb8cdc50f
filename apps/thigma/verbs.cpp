#include "verbs.h"

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "thigma/core/one_line.h"

namespace thigma::app {
namespace {

// The parser itself takes -3 for 2^64 - 3, and what is larger for 2^64 - 1.
std::string check_seed(const std::string& text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  const bool is_whole = error == std::errc() && rest == end;
  return is_whole ? "" : "'" + text + "', expected a whole number of 0 to 18446744073709551615";
}

}  // namespace

CLI::App* add_verb(CLI::App& app, Common& common, const char* name, const char* help,
                   std::function<int()> body) {
  CLI::App* verb = app.add_subcommand(name, help);
  CLI::Option* json =
      verb->add_flag("--json", common.json,
                     "one JSON object a line on standard output, as where it is no terminal");
  verb->add_flag("--text", common.text,
                 "lines for people, also where standard output is no terminal")
      ->excludes(json);
  verb->add_flag("--quiet", common.quiet, "no progress or notes on standard error");
  verb->add_option("--seed", common.seed, "seed of everything random")
      ->capture_default_str()
      ->check(check_seed, "", "seed");
  verb->final_callback([&common, body = std::move(body)] {
    common.json = common.json || (!common.text && ::isatty(STDOUT_FILENO) == 0);
    common.exit_code = body();
  });
  return verb;
}

bool is_one_file(const std::string& a, const std::string& b) {
  std::error_code failed;  // what is not there is no file
  return std::filesystem::equivalent(a, b, failed);
}

void print_error(const std::string& text) {
  const std::string line = one_line("thigma: " + text) + '\n';
  std::fputs(line.c_str(), stderr);
}

}  // namespace thigma::app
