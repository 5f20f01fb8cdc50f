#pragma once
// The rows of `thigma bench`: our figure, the baseline's on the same work, what each of them found.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace thigma::bench {

/// CPU time of a call, in the row's unit.
struct Figure {
  double p50 = 0.0, p99 = 0.0;
};

/// One row. What was not measured is absent, never 0.
struct Row {
  std::string name, unit;
  Figure ours;
  std::string baseline;                                  // its name; empty without one
  std::optional<Figure> theirs;
  std::optional<double> contacts_ours, contacts_baseline;  // mean a query
  std::optional<double> recall_ours, recall_baseline;      // share of the patch pairs within the tolerance that were found
  std::optional<double> error_ours, error_baseline;        // of the smallest separation against the other's, by the radius
  std::string note;
};

/// A named measurement; several rows may come from one.
struct Measurement {
  std::string name;  // matched by --filter
  std::function<std::vector<Row>()> run;
};

/// Every measurement, cheapest first. quick: fewer frames, for tests.
std::vector<Measurement> measurements(bool quick);

}  // namespace thigma::bench
