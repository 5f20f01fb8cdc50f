#pragma once
// Worlds of boxes beside Bullet: a tower, a sliding block, a pile.

#include "benchmarks/bench_rows.h"

namespace thigma::bench {

/// Steps of 1 ms, nothing asleep. A sample is the CPU time of a step; notes say where things went.
std::vector<Row> world_rows(bool quick);

}  // namespace thigma::bench
