#pragma once
// An experiment: one figure or table of the text, run again on this engine, with what it claims.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/common/assets.h"
#include "experiments/common/plot.h"
#include "experiments/common/table.h"

namespace thigma::experiments {

/// One statement that the run either bears out or does not.
/// Invariant: what is not a finite number does not hold.
struct Claim {
  std::string id;                   // of reference/CLAIMS, or our own
  std::string text;                 // one sentence, with the bound in words
  std::optional<double> value;      // measured; none: could not be
  std::optional<double> bound;      // value is compared with it; none: only stated
  std::optional<double> bound_low;  // set: value has to lie in [bound_low, bound]
  std::string unit;                 // of value and bounds, "" for a ratio or a count
  bool holds = false;
  bool expected = true;  // false: known not to reproduce, `reason` says why
  std::string reason;
};

/// value >= bound; value <= bound; low <= value <= high; value > bound; value < bound.
Claim at_least(std::string id, std::string text, double value, double bound, std::string unit = "");
Claim at_most(std::string id, std::string text, double value, double bound, std::string unit = "");
Claim within(std::string id, std::string text, double value, double low, double high,
             std::string unit = "");
Claim above(std::string id, std::string text, double value, double bound, std::string unit = "");
Claim below(std::string id, std::string text, double value, double bound, std::string unit = "");
/// A number that is stated and compared with nothing; holds when finite.
Claim stated(std::string id, std::string text, double value, std::string unit = "");

/// What is known beforehand about a claim that does not reproduce: where it does not hold it is marked as not
/// expected, with the reason; where it does hold nothing changes.
Claim known_not_to(Claim claim, std::string reason);

/// True when the run fails: a claim that does not hold and is expected to.
bool is_broken(const Claim& claim);

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

/// claims.json of an outcome: {name, source, claims: [{id, text, value, bound, unit, holds, expected, reason}]}, on
/// lines, with bound_low where a claim has two bounds. Numbers that are not finite become null.
std::string claims_json(const Experiment& experiment, const std::vector<Claim>& claims);

/// Runs one and writes folder/NAME/{data.csv, NAME.png, claims.json, run.json}. Every file is complete or absent.
/// Thread   [offline]; IoError where a file cannot be written, and what the experiment throws.
Outcome run_experiment(const Experiment& experiment, const Context& context,
                       const std::filesystem::path& folder);

}  // namespace thigma::experiments
