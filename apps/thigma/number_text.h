#pragma once
// Numbers as people read them: three digits and a unit.

#include <string>

namespace thigma::app {

/// "12.3 mm", "0 m": the metric prefix that leaves 1 to 999 before the point, within nano and kilo.
/// base   unit without a prefix, "m", "N", "s"
std::string with_unit(double value, const char* base);

/// "0.36 %": a share of 1.
std::string percent(double share);

/// Three digits: "1.23e-05".
std::string three_digits(double value);

}  // namespace thigma::app
