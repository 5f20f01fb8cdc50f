#include "experiments/common/experiment.h"

#include <cmath>
#include <fstream>
#include <system_error>

#include "benchmarks/probe.h"
#include <nlohmann/json.hpp>

#include "thigma/core/cpu_clock.h"
#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma::experiments {
namespace {

using Json = nlohmann::ordered_json;

Json number(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

const char* kind_name(ClaimKind kind) {
  switch (kind) {
    case ClaimKind::checked:
      return "checked";
    case ClaimKind::stated:
      return "stated";
    case ClaimKind::not_reproduced:
      return "not reproduced";
  }
  return "";
}

Json claim_json(const Claim& claim) {
  Json json;
  json["id"] = claim.id;
  json["text"] = claim.text;
  json["kind"] = kind_name(claim.kind);
  json["value"] = number(claim.value);
  json["bound"] = number(claim.bound);
  if (claim.bound_low) json["bound_low"] = number(claim.bound_low);
  json["unit"] = claim.unit;
  json["holds"] = claim.holds;
  json["expected"] = claim.expected;
  json["reason"] = claim.reason;
  if (claim.kind != ClaimKind::not_reproduced) return json;
  json["sweep"] = claim.sweep;
  json["floor"] = number(claim.floor);
  if (claim.floor_low) json["floor_low"] = number(claim.floor_low);
  return json;
}

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.rfind("model name", 0) != 0) continue;
    const std::size_t colon = line.find(": ");
    if (colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown";
}

std::string run_json(const Experiment& experiment, const Context& context, double cpu) {
  Json json;
  json["name"] = experiment.name;
  json["quick"] = context.quick;
  json["seed"] = context.seed;
  json["compiler"] = std::string("g++ ") + __VERSION__;
  json["processor"] = processor_name();
  json["dependent_adds_ghz"] = bench::dependent_adds();
  json["cpu_seconds"] = cpu;
  return json.dump(2) + "\n";
}

}  // namespace

void tell(const Context& context, const std::string& line) {
  if (context.tell) context.tell(line);
}

std::string claims_json(const Experiment& experiment, const std::vector<Claim>& claims) {
  Json json;
  json["name"] = experiment.name;
  json["source"] = experiment.source;
  const ClaimCounts counts = count_claims(claims);
  json["counts"] = {{"checked", counts.checked},
                    {"stated", counts.stated},
                    {"not_reproduced", counts.not_reproduced},
                    {"broken", counts.broken}};
  json["claims"] = Json::array();
  for (const Claim& claim : claims) json["claims"].push_back(claim_json(claim));
  return json.dump(2) + "\n";
}

Outcome run_experiment(const Experiment& experiment, const Context& context,
                       const std::filesystem::path& folder) {
  const std::filesystem::path own = folder / experiment.name;
  std::error_code failed;
  std::filesystem::create_directories(own, failed);
  if (failed)
    throw IoError(own.string() + ": cannot be made: " + failed.message() +
                  "; expected a folder to write to");
  // A claims file of an earlier run must not stand for one that did not finish.
  std::filesystem::remove(own / "claims.json", failed);
  const double start = process_cpu_seconds();
  Assets own_assets;
  Context complete = context;
  if (complete.assets == nullptr) complete.assets = &own_assets;
  Outcome outcome = experiment.run(complete);
  for (const Table& table : outcome.tables)
    write_file((own / (table.name + ".csv")).string(), csv_text(table));
  write_file((own / (std::string(experiment.name) + ".png")).string(),
             plot::figure_bytes(outcome.figure));
  write_file((own / "run.json").string(),
             run_json(experiment, context, process_cpu_seconds() - start));
  write_file((own / "claims.json").string(), claims_json(experiment, outcome.claims));
  return outcome;
}

}  // namespace thigma::experiments
