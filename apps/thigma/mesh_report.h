#pragma once
// A mesh report as programs and as people read it.

#include <string>

#include <nlohmann/json.hpp>

#include "thigma/import/inspect.h"

namespace thigma::app {

/// Every field of `inspect --json`; what is unknown is null.
nlohmann::ordered_json mesh_report_json(const MeshReport& report);

/// The same in a few lines.
std::string mesh_report_text(const MeshReport& report);

}  // namespace thigma::app
