#pragma once
// The summary of `thigma run`.

#include <string>

#include "run_session.h"
#include <nlohmann/json.hpp>

#include "thigma/session/session.h"

namespace thigma::app {

/// The fields of the summary of `thigma run`; what is unknown is null.
/// floor   empty loop of the same minute; null where it was not measured
nlohmann::ordered_json run_summary_json(const SessionSummary& summary, const std::string& scene,
                                        const std::string& device,
                                        const EmptyLoop* floor = nullptr);

/// The durations of every stage, a bucket a line: stage,from_us,to_us,count.
/// Thread   [offline]; IoError.
void write_histograms(const std::string& path, const std::vector<StageHistogram>& histograms);

/// Of a scene with [simulation]: what it took, energy, penetration over the tolerance, whether it
/// rests. A query that a level of detail misled may see a penetration that is none: `deepest` is
/// what queries saw.
nlohmann::ordered_json simulation_json(const Run& run);
std::string simulation_text(const Run& run);

/// The same for people.
std::string run_summary_text(const SessionSummary& summary);

}  // namespace thigma::app
