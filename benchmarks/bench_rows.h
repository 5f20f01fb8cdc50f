#pragma once
// The rows of `thigma bench`: our figure, the baseline's on the same work, what each of them found.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/probe.h"

namespace thigma::bench {

/// What a method found of the exact contacts, over some poses. Absent: not asked, or not of that
/// method.
struct Quality {
  std::optional<double> recall;      // share of the exact contacts with a reported one near
  std::optional<double> regions;     // share of their local regions with one
  std::optional<double> error_max;   // of the smallest separation, kept within 0..d, by the radius
  std::optional<double> error_mean;  // the same
  // largest, of the depth where surfaces intersect, by the radius
  std::optional<double> depth_error;
  // of a session that has these contacts: RMS of its force less the exact session's, by that one's
  // RMS; how deep the exact surfaces got through each other, by the object's radius
  std::optional<double> force_error, entered;
};

/// One row. What was not measured is absent, never 0.
struct Row {
  std::string name, unit;
  Figure ours;
  std::string baseline;  // its name; empty without one
  std::optional<Figure> theirs;
  std::optional<double> contacts_ours, contacts_baseline;  // mean a query
  Quality found_ours, found_baseline;
  // node pairs held, mean; of the exact query on the same asset
  std::optional<double> front, front_exact;
  std::optional<double> speedup;  // over that query, of the medians
  std::string note;
};

/// value as printf writes it with this format.
std::string number(const char* format, double value);

/// A named measurement; several rows may come from one.
struct Measurement {
  std::string name;  // matched by --filter
  std::function<std::vector<Row>()> run;
  bool is_heavy = false;  // takes many minutes: only when asked for by name or in full
};

/// Every measurement, cheapest first. quick: fewer frames, for tests.
std::vector<Measurement> measurements(bool quick);

}  // namespace thigma::bench
