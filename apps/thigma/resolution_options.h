#pragma once
// How fine contacts are asked to be, on the command line: --exact, --threshold and their kin.

#include <cstdint>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "thigma/contact/resolution.h"

namespace thigma::app {

/// As given; what is not given stays as it is.
struct ResolutionOptions {
  bool is_exact = false;
  std::optional<double> threshold;  // s0 of the haptic metric, a fraction of the smaller radius
  std::string deviation_cap;        // a fraction of the smaller radius, or "off"
  std::optional<double> budget_us;  // [us]
  std::optional<std::int64_t> budget_tests;
  std::string support;          // one_ring, flood or patch
  std::optional<double> carry;  // a share of the tolerance
  std::string metric;           // of haptic, velocity=ALPHA, view=N,l,n,f,i; several joined by +
};

/// Whether anything but --exact was given.
bool asks_for_levels(const ResolutionOptions& options);

void add_resolution_options(CLI::App& verb, ResolutionOptions& options);

/// Puts what was given into a resolution. Anything but --exact asks for levels of detail.
///
/// resolution  changed where an option says so
/// returns     what is wrong with the options, one sentence; "" when nothing
std::string apply(const ResolutionOptions& options, Resolution& resolution);

/// Sets what s0 is compared with from the text of --metric; the threshold is kept for the haptic
/// one.
/// returns  what is wrong, one sentence; "" when nothing
std::string parse_metric(const std::string& text, RefinementMetric& metric);

}  // namespace thigma::app
