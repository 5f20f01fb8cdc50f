#pragma once
// How long the exact contact query takes, in CPU time of this thread.

#include <cstdint>

namespace thigma::bench {

struct QueryTiming {
  double p50_us = 0.0, p99_us = 0.0;  // CPU time of a query [us]
  double contacts = 0.0, front = 0.0, tests = 0.0, pair_queries = 0.0;  // means over the frames
  double tolerance = 0.0;             // d [m]
  double ns_per_node = 0.0;           // of the traversal alone, median CPU time over the median front [ns]
  double cold_us = 0.0;               // of the first query, without coherence [us]
};

/// Procedural jaws (47,340 and 40,180 triangles), the upper one approaching from 2 % of the radius, then grinding by
/// about `step` of the radius a frame around touch; queries at d = `tolerance` of the radius.
///
/// front  0, or the front size to reach by choosing the tolerance instead (largest over the path, to 10 %)
QueryTiming measure_jaws_query(int frames, double tolerance, double step, double front = 0.0);

}  // namespace thigma::bench
