#pragma once
// Quantiles of measured samples: one rule for every percentile the project prints.

#include <vector>

namespace thigma {

/// Value below which a share of the samples lies, between samples by linear interpolation of the
/// sorted ones (Hyndman and Fan 1996, type 7).
///
/// samples  in any order, any unit, no NaN
/// share    0 (the least) to 1 (the largest); held to that
/// returns  NaN of nothing
/// Thread   [offline]: takes linear time and a copy; throws std::bad_alloc.
double sample_quantile(std::vector<double> samples, double share);

}  // namespace thigma
