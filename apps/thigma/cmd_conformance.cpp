// thigma conformance FILE...: reference vectors against the engine's own functions.

#include <cmath>
#include <cstdio>
#include <memory>

#include "reference/conformance/conformance.h"
#include "verbs.h"

#include "thigma/files/file.h"

namespace thigma::app {
namespace {

using Json = nlohmann::ordered_json;

std::string report_line(const ConformanceReport& report) {
  Json line = {{"file", report.file},
               {"cases", report.cases},
               {"passed", report.passed},
               {"failed", report.failed},
               {"not_implemented", report.not_implemented},
               {"worst", nullptr}};
  if (report.worst.used >= 0.0) {
    const Json error = std::isfinite(report.worst.error) ? Json(report.worst.error) : Json(nullptr);
    line["worst"] = {{"case", report.worst.name}, {"field", report.worst.field}, {"error", error}};
  }
  return line.dump(-1, ' ', false, Json::error_handler_t::replace);
}

// Every file gets its line: one that cannot be read does not hide what the others say.
int run_conformance(const std::vector<std::string>& files) {
  bool is_unreadable = false;
  bool is_failed = false;
  for (const std::string& file : files) {
    try {
      const ConformanceReport report = check_document(file, read_file(file));
      std::printf("%s\n", report_line(report).c_str());
      is_failed = is_failed || report.failed > 0;
    } catch (const InputError& error) {
      print_error(error.what());
      is_unreadable = true;
    }
  }
  if (is_unreadable) return kBadInput;
  return is_failed ? kClaimFails : kDone;
}

}  // namespace

void add_conformance(CLI::App& app, Common& common) {
  const auto files = std::make_shared<std::vector<std::string>>();
  CLI::App* verb = add_verb(app, common, "conformance",
                            "check reference vectors against this engine's functions",
                            [files] { return run_conformance(*files); });
  verb->add_option("files", *files, "vector files, one JSON report a line each")
      ->required()
      ->type_name("FILE");
}

}  // namespace thigma::app
