#pragma once
// The exact contact query Q(A, B, d): every pair of finest patches whose triangles come within d.

#include <cstdint>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/contact.h"
#include "thigma/convex/pair.h"
#include "thigma/math/pose.h"

namespace thigma {

struct ContactQuery {
  double tolerance = 0.0;         // d: contacts have depth >= -tolerance [m]
  bool keep_directions = false;   // penetration: among near-equal directions keep last frame's, and follow a pair
                                  // through (hysteresis for a simulation; off, a result depends on the pose alone)
  std::int32_t body = 0;          // written to the contacts
};

/// Scratch of one pair of bodies: the front of the tandem traversal with a cache a node pair. Any content is
/// valid input; clear() forgets coherence. Grows while warming up, never after.
struct ContactFront;

}  // namespace thigma
