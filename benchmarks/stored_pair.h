#pragma once
// A pair of the bench and its path in files, so that queries can be run again without building: a
// profiler that counts instructions is fifty times too slow for that.

#include <string>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/math/pose.h"

namespace thigma::bench {

/// What a query needs of a pair, and where its object goes; the scene object at the identity.
struct StoredPair {
  ClodHierarchy object, scene;
  double radius = 0.0;     // the smaller of the two [m]
  double tolerance = 0.0;  // d of the queries [m]
  std::vector<Pose> path;
};

/// Names of the pairs that can be stored.
std::vector<std::string> storable_pairs();

/// Builds a pair and writes it into a folder that exists, as NAME.object.clod, NAME.scene.clod,
/// NAME.meeting.path (the bench's own, whose least separation swings between -1 and 1 % of the
/// radius) and NAME.apart.path (0 to 1 %).
///
/// triangles  of each model; 0: as the bench has them
/// Thread     [offline]; throws InputError for a name that is not of storable_pairs, IoError.
void store_pair(const std::string& folder, const std::string& name, int triangles);

/// Reads a pair with one of its paths, `meeting` or `apart`. Thread [offline]; throws InputError.
StoredPair load_pair(const std::string& folder, const std::string& name, const std::string& path);

}  // namespace thigma::bench
