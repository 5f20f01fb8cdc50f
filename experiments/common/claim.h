#pragma once
// What an experiment claims: checked against a bound, only stated, or known not to reproduce.

#include <optional>
#include <string>
#include <vector>

#include "experiments/common/table.h"

namespace thigma::experiments {

enum class ClaimKind {
  checked,        // compared with a bound; breaks where it does not hold
  stated,         // a number for the reader, compared with nothing
  not_reproduced  // known not to hold, with a reason that a sweep shows; breaks beyond its floor
};

/// How a value is compared with the bound: >=, <=, low <= value <= high, >, <.
enum class Comparison { none, at_least, at_most, within, above, below };

/// One statement that the run bears out, or does not, or that is only a number.
/// Invariant: it is broken exactly where it does not hold and is expected to; what is not a finite
/// number is broken.
struct Claim {
  std::string id;                   // short name, unique in the experiment
  std::string text;                 // one sentence, with the bound in words
  std::optional<double> value;      // measured; none: could not be
  std::optional<double> bound;      // value is compared with it; none: stated
  std::optional<double> bound_low;  // set: value has to lie in [bound_low, bound]
  std::string unit;                 // of value and bounds, "" for a ratio or a count
  ClaimKind kind = ClaimKind::checked;
  Comparison comparison = Comparison::none;
  bool holds = false;     // against the bound; of a stated claim: there is a number
  bool is_timed = false;  // compares times of this machine: no test asks for it
  bool expected = true;   // false: does not hold, as known, and is not beyond its floor
  // Of a claim that is not reproduced.
  std::string reason;
  std::string sweep;            // rows that show the reason, as Known has them
  std::optional<double> floor;  // a second bound, further off, with the same comparison
  std::optional<double> floor_low;
};

/// value >= bound; value <= bound; low <= value <= high; value > bound; value < bound.
Claim at_least(std::string id, std::string text, double value, double bound, std::string unit = "");
Claim at_most(std::string id, std::string text, double value, double bound, std::string unit = "");
Claim within(std::string id, std::string text, double value, double low, double high,
             std::string unit = "");
Claim above(std::string id, std::string text, double value, double bound, std::string unit = "");
Claim below(std::string id, std::string text, double value, double bound, std::string unit = "");
/// A number that is stated and compared with nothing. It never "holds" for a reader; it is broken
/// where it is no number.
Claim stated(std::string id, std::string text, double value, std::string unit = "");

/// What is known about a claim that does not reproduce.
struct Known {
  std::string reason;  // what was shown by taking the cause away
  // the table with the rows that show it: "damping.csv", or "data.csv:series=damping", those rows
  // in whose column of that name the word stands; a run's tables have at least three
  std::string sweep;
  double floor = 0.0;                 // beyond it the claim breaks all the same; outside the bound
  std::optional<double> floor_low{};  // lower end, of a claim with two bounds
};

/// Marks a claim as one that does not reproduce.
/// Error   std::invalid_argument: nothing to hold, no reason, no sweep, or a floor that is stricter
///         than the bound.
Claim known_not_to(Claim claim, Known known);

/// Marks a claim as one about times of this machine.
Claim on_this_machine(Claim claim);

/// The same claim had another value been measured: how tests plant a wrong one.
Claim with_value(Claim claim, double value);

/// True when the run fails for it: it does not hold and is expected to.
bool is_broken(const Claim& claim);

/// True for one that is marked as not reproduced and holds: the mark has to go.
bool holds_though_marked(const Claim& claim);

/// One or a few words for a person: "holds", "DOES NOT HOLD", "stated", "NO NUMBER", "not
/// reproduced", "WORSE THAN KNOWN", "holds, though marked".
const char* verdict(const Claim& claim);

/// How many there are of each kind.
struct ClaimCounts {
  int checked = 0, stated = 0, not_reproduced = 0;
  int broken = 0;              // of any kind
  int marked_though_held = 0;  // of those not reproduced
};
ClaimCounts count_claims(const std::vector<Claim>& claims);
ClaimCounts operator+(const ClaimCounts& a, const ClaimCounts& b);

/// "7 claims: 5 checked, 1 stated, 1 not reproduced; 0 broken", and what holds though it is marked.
std::string counts_text(const ClaimCounts& counts);

/// What is wrong with the claims themselves, a line each: an id twice, a claim that is not
/// reproduced without three rows of its sweep in the tables. Empty where nothing is.
std::vector<std::string> faults(const std::vector<Claim>& claims, const std::vector<Table>& tables);

}  // namespace thigma::experiments
