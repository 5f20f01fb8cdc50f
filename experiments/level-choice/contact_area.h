#pragma once
// Whether the level of a contact follows its area (Sec. 3.4.3), and if not, what is between them.

#include <cstdint>
#include <string>
#include <vector>

#include "experiments/level-choice/pose_frame.h"
#include "experiments/level-choice/touched_region.h"

namespace thigma::experiments::level_choice {

/// What is known of both surfaces ahead of time.
struct PairSurfaces {
  TreeRanges object, scene;
  PatchCorners object_corners, scene_corners;
};
PairSurfaces pair_surfaces(const ClodHierarchy& object, const ClodHierarchy& scene);

/// An exact contact: finest patches, counted as in TreeRanges, and the region it lies in.
struct TouchedPlace {
  std::int32_t object = -1, scene = -1;
  double region = 0.0;  // area, the smaller of the two sides [m^2]
};

/// Exact contacts of a frame by their object's patch.
std::vector<TouchedPlace> touched_places(const PairSurfaces& surfaces, const ClodHierarchy& object,
                                         const ClodHierarchy& scene, const PoseFrame& exact);

/// Contacts that have something of the exact query below them, of all poses.
struct AreaSamples {
  std::vector<double> level;   // mean of both sides
  std::vector<double> weight;  // its share of the force's blend
  // Of the finest patches below it that touch, the smaller of the two sides [m^2].
  std::vector<double> below;
  std::vector<double> region;                       // area of the largest region below it [m^2]
  std::vector<double> support;                      // D of the contact (Eq. 3.7) [m^2]
  std::vector<std::vector<double>> region_by_pose;  // `region` again
};

/// Adds the contacts of a frame.
void add_contacts(AreaSamples& samples, const TouchedPair& pair, const PairSurfaces& surfaces,
                  const Pose& pose, const std::vector<TouchedPlace>& exact, const PoseFrame& frame);

/// Adds the contacts there would be if Eq. 3.7 divided by the area of the exact contact's own
/// region instead of by D: from every exact contact up through the pairs above it, the finer side
/// first, while s* stays within the threshold.
/// threshold  s0 [m]
void add_contacts_by_region(AreaSamples& samples, const TouchedPair& pair,
                            const PairSurfaces& surfaces, const PoseFrame& exact,
                            const std::vector<TouchedPlace>& places, double threshold);

/// One way to ask, with its answer.
struct AreaRank {
  std::string what;
  double rank = 0.0;   // correlation
  double count = 0.0;  // of contacts
};

/// The same poses asked in several ways.
struct AreaTrials {
  AreaSamples blended;    // as reported
  AreaSamples single;     // without interpolation
  AreaSamples smaller;    // as reported, with the smaller of the two D
  AreaSamples by_region;  // as add_contacts_by_region
};

/// The statistic and what takes each supposed cause of its smallness away; by_region last.
std::vector<AreaRank> area_ranks(const AreaTrials& trials);

/// Share of the contacts, by weight, that are of the level most of them have. Near 1 no rank says
/// anything.
double commonest_level(const AreaSamples& samples);

}  // namespace thigma::experiments::level_choice
