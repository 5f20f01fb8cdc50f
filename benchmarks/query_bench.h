#pragma once
// How long the exact contact query takes, in CPU time of this thread.

#include <cstdint>

#include "benchmarks/probe.h"

namespace thigma::bench {

struct QueryTiming {
  Figure us;                                                            // CPU time of a query [us]
  double contacts = 0.0, front = 0.0, tests = 0.0, pair_queries = 0.0;  // means over the frames
  double tolerance = 0.0;                                               // d [m]
  // of the traversal alone, median CPU time over the median front [ns]
  double ns_per_node = 0.0;
  double cold_us = 0.0;  // of the first query, without coherence [us]
};

/// Procedural jaws (47,340 and 40,180 triangles), the upper one approaching from 2 % of the radius,
/// then grinding by about `step` of the radius a frame around touch; queries at d = `tolerance` of
/// the radius.
///
/// front  0, or the front size to reach (largest over the path): a smaller one by coarser jaws at
///        the same tolerance, a larger one by a larger tolerance
QueryTiming measure_jaws_query(int frames, double tolerance, double step, double front = 0.0);

/// The same query beside FCL's distance on the same meshes and poses, and beside the truth: every
/// pair of patches with original triangles within d, by an independent search.
struct JawsComparison {
  QueryTiming ours;           // over all frames
  bool has_baseline = false;  // built with FCL
  Figure baseline_us;         // over `checked` frames [us]
  // share of the true patch pairs found, over `checked` frames
  double recall_ours = 0.0, recall_baseline = 0.0;
  // of the smallest separation, largest, by the radius
  double error_ours = 0.0, error_baseline = 0.0;
};

/// checked  frames, evenly along the path, on which baseline and truth are computed; at least 1
JawsComparison compare_jaws_query(int frames, int checked, double tolerance, double step);

}  // namespace thigma::bench
