#pragma once
// JSON on standard output.

#include <string>

#include <nlohmann/json.hpp>

#include "thigma/core/error.h"
#include "thigma/session/histogram.h"

namespace thigma::app {

/// The reader of standard output went away, as `| head -1` does: nothing to complain about.
class ReaderGone : public IoError {
 public:
  using IoError::IoError;
};

/// One line without its end. File names need not be UTF-8, JSON has to be: bytes that are not
/// become U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);

/// p50, p99, p999, p9999 and max of durations, each in `unit` [s]; null where nothing was counted.
/// has_tail  p999 and p9999 are told
nlohmann::ordered_json quantiles_json(const DurationSummary& durations, double unit,
                                      bool has_tail = true);

/// Prints the line. Throws IoError when standard output does not take it, ReaderGone when nobody
/// reads it.
void print_json(const nlohmann::ordered_json& json);

/// Hands on what was printed, in either way. Throws as print_json.
void flush_output();

}  // namespace thigma::app
