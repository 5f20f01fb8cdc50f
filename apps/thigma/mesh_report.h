#pragma once
// A mesh report as programs and as people read it.

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "thigma/import/inspect.h"
#include "thigma/import/shell.h"

namespace thigma::app {

/// Every field of `inspect --json`; what is unknown is null.
nlohmann::ordered_json mesh_report_json(const MeshReport& report);

/// The same in a few lines.
std::string mesh_report_text(const MeshReport& report);

/// What makes it usable, "repair --shell"; the first changes least. Empty for what is usable, and
/// where nothing does.
std::vector<std::string> ways_on(const MeshReport& report, const TriangleMesh& mesh);

}  // namespace thigma::app
