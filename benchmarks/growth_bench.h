#pragma once
// Worlds of many bodies of 5,000 triangles each that lie on each other: how a step's time grows.

#include "benchmarks/bench_rows.h"

namespace thigma::bench {

/// Steps of 1 ms, from a fall of a millimetre at most until all sleep. A sample is the CPU time of
/// a step in which something moved; notes say what the solver got and what waited.
///
/// Flat rings on each other, 10 and 30 of them; rings and blocks in a tray, three on each other,
/// from 2 to 300.
std::vector<Row> growth_rows(bool quick);

}  // namespace thigma::bench
