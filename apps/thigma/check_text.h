#pragma once
// What `thigma devices check` prints.

#include <string>

#include <nlohmann/json.hpp>

#include "thigma/session/check_device.h"

namespace thigma::app {

/// One object: what was measured, rules under "rules".
nlohmann::ordered_json check_json(const std::string& uri, const DeviceLimits& limits,
                                  const DeviceReport& report);

/// For a terminal; with_rules also lists the rules.
std::string check_text(const DeviceLimits& limits, const DeviceReport& report, bool with_rules);

}  // namespace thigma::app
