#include "number_text.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace thigma::app {
namespace {

struct Prefix {
  double factor;
  const char* name;
};
constexpr std::array<Prefix, 5> kPrefixes{
    {{1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "u"}, {1e-9, "n"}}};

// 999.6 is 1e+03 in three digits.
constexpr double kRoundsUp = 0.9995;

}  // namespace

std::string three_digits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string with_unit(double value, const char* base) {
  if (value == 0.0 || !std::isfinite(value)) return three_digits(value) + ' ' + base;
  for (const Prefix& prefix : kPrefixes)
    if (std::fabs(value) >= kRoundsUp * prefix.factor)
      return three_digits(value / prefix.factor) + ' ' + prefix.name + base;
  return three_digits(value) + ' ' + base;
}

std::string percent(double share) { return three_digits(100.0 * share) + " %"; }

}  // namespace thigma::app
