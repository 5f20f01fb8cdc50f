#pragma once
// Depth and gradient of textured contacts, each way beside the scalar one.

#include <vector>

#include "benchmarks/bench_rows.h"

namespace thigma::bench {

/// On the processor, per contact; and on a graphics processor where there is one, per frame over
/// the number of contacts.
std::vector<Row> texture_rows(bool quick);
std::vector<Row> gpu_texture_rows(bool quick);

}  // namespace thigma::bench
