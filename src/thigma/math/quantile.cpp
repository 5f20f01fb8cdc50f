#include "thigma/math/quantile.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace thigma {

double sample_quantile(std::vector<double> samples, double share) {
  if (samples.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(samples.size() - 1);
  const auto below = samples.begin() + static_cast<std::ptrdiff_t>(at);
  std::nth_element(samples.begin(), below, samples.end());
  const double low = *below;
  if (below + 1 == samples.end()) return low;
  const double high = *std::min_element(below + 1, samples.end());
  return low + (at - static_cast<double>(below - samples.begin())) * (high - low);
}

}  // namespace thigma
