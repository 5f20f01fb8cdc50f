#pragma once
// What a pair's study becomes in the tables, the figure and the claims.

#include <string>
#include <vector>

#include "experiments/common/experiment.h"
#include "experiments/level-choice/study.h"

namespace thigma::experiments::level_choice {

// The default's s0: paths are led at it, level and area compared.
inline constexpr double kShipped = 0.025;

/// A pair that was studied.
struct Studied {
  std::string name;
  bool is_quick = false;     // fewer poses of a shorter session
  double radius = 0.0;       // the smaller one [m]
  double shell_build = 0.0;  // CPU [s]
  std::vector<Setting> settings;
  PairStudy study;
};

/// What a threshold that is among the settings gave.
const Choice& choice_at(const Studied& pair, double s0);

/// Empty tables and panels, in the order that add_rows expects.
Outcome empty_outcome();

/// Adds the rows and curves of a pair. data.csv: a row a setting and one of the shells; growth.csv:
/// from each asked threshold to the next; area.csv: level and area, and what is between them.
void add_rows(const Studied& pair, Outcome& outcome);

/// Growth from one of the asked thresholds, 1, 2.5, 5 % and no metric, to the next.
struct Step {
  std::string from, to;
  Growth below, error, shared;
};
std::vector<Step> steps_of(const Studied& pair);

/// The claims of a pair.
std::vector<Claim> claims_of(const Studied& pair);

}  // namespace thigma::experiments::level_choice
