#pragma once
// One pair of objects in the hand, queried again at several thresholds: which levels its contacts get, what that costs
// and what it leaves out.

#include <string>
#include <vector>

#include "experiments/common/assets.h"
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

/// How a query is asked.
struct Setting {
  std::string name;
  double threshold = 0.0;  // s0; 0: exact, infinite: no metric at all
  Resolution resolution;
};
Setting setting_at(double threshold);

/// What a setting gives, over the sampled poses.
struct Choice {
  double triangles = 0.0;     // of the original below a contact, mean of both sides, mean over contacts
  double contacts = 0.0;      // mean
  double front = 0.0;         // mean
  double query = 0.0;         // CPU time, median [s]
  double force_error = 0.0;   // RMS of the difference from the exact contacts' force over its RMS
  double recall = 0.0;        // share of exact contacts with one of these near it
  double separation_error = 0.0;  // of the least separation, median [m]
  double interval = 0.0;          // that the bounds leave for the least separation, median [m]
  double interval_ratio = 0.0;    // interval over error, median
  double area_rank = 0.0;         // rank correlation of level and area of the contact by the exact query
  int levels_at_once = 0;         // of detail among the contacts of a frame, most
};

/// Measures every setting at the same poses, evenly spread over those where the pair touched.
/// samples  poses; each is reached over a few frames of the path, which are what is timed
std::vector<Choice> measure(const TouchedPair& pair, const std::vector<Setting>& settings, int samples);

}  // namespace thigma::experiments::level_choice
