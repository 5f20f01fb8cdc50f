#pragma once
// The summary of `thigma run`.

#include <string>

#include <nlohmann/json.hpp>

#include "thigma/runtime/session.h"

namespace thigma::app {

/// The fields of INTERFACE; what is unknown is null.
/// floor   empty loop of the same minute; null where it was not measured
nlohmann::ordered_json run_summary_json(const SessionSummary& summary, const std::string& scene,
                                        const std::string& device, const EmptyLoop* floor = nullptr);

/// The durations of every stage, a bucket a line: stage,from_us,to_us,count.
/// Thread   [offline]; IoError.
void write_histograms(const std::string& path, const std::vector<StageHistogram>& histograms);

/// The same for people.
std::string run_summary_text(const SessionSummary& summary);

}  // namespace thigma::app
