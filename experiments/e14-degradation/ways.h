#pragma once
// Queries without a budget, of two surfaces that fit each other and of two that bite.

#include "experiments/common/experiment.h"
#include "experiments/common/replay.h"

namespace thigma::experiments::e14_degradation {

/// What is asked of ways to query, and where.
struct WayStudy {
  const char* name;  // of the pair
  const Pair& pair;
  const Path& path;
  const PenaltyParams& gains;
  int exact_stride = 0;  // the force is compared with the exact query's in every so many frames; 0:
                         // never, where that has millions of contacts
  double limit = 0.0;    // of p99.9, that the last way has to keep [us]
};

/// Plays the path in every way: rows of `table`, and what there is to say of the times.
/// Thread [offline].
std::vector<Claim> study_ways(const Context& context, const WayStudy& study, Table& table);

/// Columns of its rows.
Table way_table();

}  // namespace thigma::experiments::e14_degradation
