// The program `thigma`: parses, runs one verb, turns what went wrong into one line and an exit
// code.

#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <string_view>

#include "json_out.h"
#include "verbs.h"
#include "version.h"

#include "thigma/core/error.h"
#include "thigma/models/make_model.h"

namespace thigma::app {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
  return all;
}

/// What is wrong with the first word when it is no verb, "" otherwise. The parser would only say
/// that one is missing.
std::string what_is_wrong(const CLI::App& app, std::string_view word) {
  if (word.empty() || word.front() == '-') return "";
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) names.push_back(verb->get_name());
  if (std::find(names.begin(), names.end(), word) != names.end()) return "";
  const std::string named = "'" + std::string(word) + "'";
  const std::string near = models::nearest_word(word, names);
  return "no verb " + named + (near.empty() ? "" : ", nearest is '" + near + "'") +
         ", expected one of " + joined(names);
}

/// What is wrong with the first option that the verb does not have, "" where there is none. The
/// parser would only say that it did not expect it.
std::string unknown_option(const CLI::App& app, const std::string& verb,
                           const std::vector<std::string>& left) {
  const auto is_option = [](const std::string& word) {
    return word.size() > 1 && word.front() == '-';
  };
  const auto found = std::find_if(left.begin(), left.end(), is_option);
  if (found == left.end()) return "";
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_subcommand(verb)->get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  const std::string given = found->substr(0, found->find('='));
  const std::string near = models::nearest_word(given, names);
  return verb + ": no option '" + given + "'" +
         (near.empty() ? "" : ", nearest is '" + near + "'") + ", expected one of " + joined(names);
}

int refuse(const std::string& why, const std::string& verb) {
  print_error(why + "; try `thigma " + (verb.empty() ? "" : verb + " ") + "--help`");
  return kUsage;
}

int run(int argc, char** argv) {
  CLI::App app(
      "Six-degree-of-freedom haptic rendering: move a virtual object against others, feel force "
      "and torque.",
      "thigma");
  app.set_version_flag("--version", std::string("thigma ") + kVersion);
  app.require_subcommand(1);
  app.footer(
      "thigma VERB --help tells the options of a verb. Exit codes: 0 done, 1 failed, 2 usage, 3 "
      "device or\n"
      "permission unavailable, 4 bad input, 5 a claim does not hold, 6 safety fault, 130 "
      "interrupted.");
  Common common;
  add_all_verbs(app, common);
  // `thigma help VERB` is `thigma VERB --help`.
  std::vector<const char*> words(argv, argv + argc);
  if (argc > 1 && words[1] == std::string_view("help")) {
    words.resize(std::min<std::size_t>(words.size(), 3));
    words.erase(words.begin() + 1);
    words.push_back("--help");
  }
  const std::string_view first = words.size() > 1 ? words[1] : "";
  if (const std::string wrong = what_is_wrong(app, first); !wrong.empty()) return refuse(wrong, "");
  if (first.empty()) return refuse("no verb", "");
  try {
    app.parse(static_cast<int>(words.size()), words.data());
    flush_output();
    return common.exit_code;
  } catch (const CLI::Success& success) {
    const int code = app.exit(success);
    flush_output();
    return code;
  } catch (const CLI::ExtrasError& error) {
    const std::string verb(first.front() == '-' ? "" : first);
    const std::string wrong = verb.empty() ? "" : unknown_option(app, verb, app.remaining(true));
    return refuse(wrong.empty() ? error.what() : wrong, verb);
  } catch (const CLI::ConversionError& error) {
    const std::string said = error.what();  // "Could not convert: --scale = mm"
    const std::size_t given = said.find("--");
    return refuse(
        (given == std::string::npos ? said : said.substr(given)) + ", no number that it takes",
        first.front() == '-' ? "" : std::string(first));
  } catch (const CLI::ParseError& error) {
    return refuse(error.what(), first.front() == '-' ? "" : std::string(first));
  }
}

int fail(const std::string& why, int code) {
  print_error(why);
  return code;
}

}  // namespace
}  // namespace thigma::app

int main(int argc, char** argv) {
  using namespace thigma;
  using namespace thigma::app;
  // A closed pipe and a file at its limit are failed writes, not a death with forces on.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return run(argc, argv);
  } catch (const ReaderGone&) {
    return kFailed;
  } catch (const InputError& error) {
    return fail(error.what(), kBadInput);
  } catch (const std::bad_alloc&) {
    return fail("out of memory", kFailed);
  } catch (const std::exception& error) {
    return fail(error.what(), kFailed);
  }
}
