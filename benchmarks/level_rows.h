#pragma once
// Contact levels of detail beside the exact query on the same asset and beside every baseline.

#include <vector>

#include "benchmarks/bench_rows.h"

namespace thigma::bench {

/// A measurement a pair: levels with and without the cap, exact, and the baselines; and the heavy
/// ones.
std::vector<Measurement> level_measurements(bool quick);

}  // namespace thigma::bench
