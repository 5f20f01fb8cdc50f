#pragma once
// One pair of objects in the hand, queried again at several thresholds and by point shells: which
// levels its contacts get, what that costs and what it leaves out.

#include <vector>

#include "experiments/level-choice/contact_area.h"
#include "experiments/level-choice/resample.h"
#include "experiments/level-choice/shells.h"
#include "experiments/level-choice/touched_pair.h"

namespace thigma::experiments::level_choice {

/// What a setting gives, over the sampled poses. Errors of the force: RMS of the difference from
/// the exact contacts' force over its RMS.
struct Choice {
  double triangles = 0.0;          // of the original below a contact, mean of both sides
  double contacts = 0.0;           // mean
  double front = 0.0;              // mean
  double query = 0.0;              // CPU time, median [s]
  double force_error = 0.0;        // of clusters each by itself
  double shared_error = 0.0;       // of clusters that share the stiffness
  double recall = 0.0;             // share of exact contacts with one of these near it
  double separation_error = 0.0;   // of the least separation, median [m]
  double bounds = 0.0;             // interval the contacts' bounds leave for it, median [m]
  double interval = 0.0;           // what least_separation narrows that to, median [m]
  double outside = 0.0;            // poses whose exact one is not within
  double narrowing = 0.0;          // CPU time of that, median [s]
  double divided = 0.0;            // pairs of nodes it divides, median
  double interval_ratio = 0.0;     // interval over error, median
  double area_rank = 0.0;          // correlation of level and region of the exact query, by weight
  double levels_at_once = 0.0;     // of detail among the contacts of a frame, most
  double bytes = 0.0;              // of both objects' assets
  PoseShare below, error, shared;  // triangles below, and squares of both errors, by pose
};

/// Everything measured of a pair.
struct PairStudy {
  std::vector<Choice> choices;  // by setting
  Choice shell;
  std::vector<AreaRank> ranks;   // at the threshold asked for
  double commonest_level = 0.0;  // there
  Growth region_spread;          // of the areas of the regions there
};

/// Measures every setting and the shells at the same poses, evenly spread over those where the pair
/// touched.
///
/// samples    poses; each is reached over a few frames of the path, which are what is timed
/// threshold  s0 that level and area are compared at
PairStudy measure(const TouchedPair& pair, const ShellPair& shells,
                  const std::vector<Setting>& settings, int samples, double threshold);

}  // namespace thigma::experiments::level_choice
