#pragma once
// An experiment: one figure or table of the text, run again on this engine, with what it claims.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "experiments/common/assets.h"
#include "experiments/common/claim.h"
#include "experiments/common/plot.h"
#include "experiments/common/table.h"

namespace thigma::experiments {

/// What a run is given.
struct Context {
  bool quick = false;                              // fewer frames and poses, smaller models
  std::uint64_t seed = 1;                          // of everything random
  std::function<void(const std::string&)> tell{};  // progress for a person; may be empty
  Assets* assets = nullptr;  // models shared by the experiments of a run; never null in a run
};
void tell(const Context& context, const std::string& line);

/// What a run gives back.
struct Outcome {
  std::vector<Table> tables;  // the first is data.csv, the others NAME.csv
  plot::Figure figure;        // NAME.png
  std::vector<Claim> claims;
};

/// One experiment.
struct Experiment {
  const char* name;    // as on the command line; also its folder
  const char* source;  // where the text shows it
  const char* text;    // what it is, one line
  std::function<Outcome(const Context&)> run;
};

/// All of them, in the order of listings.
const std::vector<Experiment>& all_experiments();

/// claims.json of an outcome: {name, source, counts: {checked, stated, not_reproduced, broken},
/// claims: [{id, text, kind, value, bound, unit, holds, expected, reason}]}, on lines. bound_low
/// stands beside bound where a claim has two; one that is not reproduced has its sweep and floor
/// (floor_low). Numbers that are not finite become null. A stated claim has no bound and `holds`
/// where it is a number, so that a run fails exactly where `expected` and not `holds`.
std::string claims_json(const Experiment& experiment, const std::vector<Claim>& claims);

/// Runs one and writes folder/NAME/{data.csv, NAME.png, claims.json, run.json}. Every file is
/// complete or absent.
/// Thread   [offline]; IoError where a file cannot be written, and what the experiment throws.
Outcome run_experiment(const Experiment& experiment, const Context& context,
                       const std::filesystem::path& folder);

}  // namespace thigma::experiments
