#pragma once
// A way to ask for contacts, in words: what scripts/instructions compares.

#include <string>

#include "benchmarks/stored_pair.h"

#include "thigma/contact/query_contacts.h"

namespace thigma::bench {

/// Words joined by commas: `exact`, or `levels` as they are by default, and what differs: `s0=X`,
/// `cap=X` (fractions of the radius), `d=ring|flood|patch` (SupportReading), `plain` (no
/// interpolation), `carry=X` (a share of d).
/// Thread [offline]; throws InputError for any other word.
Resolution query_way(const std::string& words);

/// How near a way is to the exact query, on every eighth pose of the path, which it walks whole.
struct WayQuality {
  // RMS of the difference of the force of 16 clusters, each as stiff as one alone, over the RMS of
  // the exact one
  double force = 0.0;
  // the same of the step of that force from pose to pose, over its mean size
  double step = 0.0;
  double separation = 0.0;  // mean error of the least separation, kept within 0..d, by the radius
  double contacts = 0.0;    // mean
};
WayQuality way_quality(const StoredPair& pair, const Resolution& way);

}  // namespace thigma::bench
