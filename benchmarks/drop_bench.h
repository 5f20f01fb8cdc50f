#pragma once
// Queries of a body that falls by itself: with levels of detail and exact, on one path (Sec.
// 3.5.4).

#include "benchmarks/bench_rows.h"

namespace thigma::bench {

/// The spoon falls into the cup and comes to rest, exactly; every method asks at every pose of that
/// simulation. A sample is the mean query of a frame of 30 ms.
std::vector<Row> drop_rows(bool quick);

}  // namespace thigma::bench
