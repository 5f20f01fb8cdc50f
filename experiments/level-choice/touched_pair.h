#pragma once
// One pair of objects in the hand, and how its contacts are asked for again afterwards.

#include <limits>
#include <string>
#include <vector>

#include "experiments/common/session_pair.h"

#include "thigma/contact/resolution.h"

namespace thigma::experiments::level_choice {

/// A pair, and where its object was while it touched.
struct TouchedPair {
  SessionPair session;
  std::vector<Pose> touching;  // world_from_mesh, one a contact frame
};

/// Runs the scene in lockstep at the threshold, coupled, under the penalty law.
TouchedPair touch(SessionPair session, double threshold);

// s0 of a query without a metric.
inline constexpr double kNoMetric = std::numeric_limits<double>::infinity();

/// How a query is asked.
struct Setting {
  std::string name;
  double threshold = 0.0;  // s0; 0: exact, or kNoMetric
  Resolution resolution;
};
Setting setting_at(double threshold);

}  // namespace thigma::experiments::level_choice
