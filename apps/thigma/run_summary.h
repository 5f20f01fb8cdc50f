#pragma once
// The summary of `thigma run`.

#include <string>

#include <nlohmann/json.hpp>

#include "thigma/runtime/session.h"

namespace thigma::app {

/// The fields of INTERFACE; what is unknown is null.
nlohmann::ordered_json run_summary_json(const SessionSummary& summary, const std::string& scene,
                                        const std::string& device);

/// The same for people.
std::string run_summary_text(const SessionSummary& summary);

}  // namespace thigma::app
