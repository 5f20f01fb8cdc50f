#pragma once
// How near two bodies are, at least and at most, to a width that the caller asks for.

#include <cstdint>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/contact/contact.h"
#include "thigma/convex/gjk.h"
#include "thigma/math/infinity.h"
#include "thigma/math/pose.h"

namespace thigma {

/// What is asked.
struct SeparationQuery {
  double tolerance = 0.0;  // d of the query that found the contacts [m]
  std::int32_t body = 0;   // of the contacts that count
  double width = 0.01;     // of the interval, times the smaller radius; 0: as narrow as can be
  std::int64_t budget = 100'000;  // pairs of nodes that are divided, at most
};

/// Where the least separation of two bodies lies: minus the depth of the deepest contact that the
/// exact query would report.
struct SeparationInterval {
  double low = -kInfinity;  // at most d, beyond which nothing is looked at [m]
  double high = kInfinity;  // of two patches that were measured; infinite where nothing is near [m]
  bool is_narrow = false;   // as narrow as was asked, or nothing nearer than d; else budget or room
                            // ended it
  std::int64_t expansions = 0;    // pairs of nodes that were divided
  std::int64_t pair_queries = 0;  // convex pairs solved
};

/// A pair of nodes whose patches may still be the nearest. 40 bytes.
struct SeparationPair {
  double low = -kInfinity;  // no two patches below are nearer [m]
  std::int32_t a = 0, b = 0;
  float axis[3] = {0.0f, 0.0f, 0.0f};  // from a to b, unit or zero [frame of a]
  GjkCache gjk{};
};

/// Scratch of one pair of bodies. Owned by the caller; any content is valid input. Thread: of the
/// caller; not shared.
struct SeparationScratch {
  std::vector<SeparationPair> pairs;  // a heap, the lowest on top
  const void* object = nullptr;       // hierarchies it was reserved for, for comparison only
  const void* scene = nullptr;
  bool object_closed = true, scene_closed = true;  // see surface_crossing.h
};

/// Takes the memory for a pair of hierarchies.
/// capacity  pairs that may wait at once; 40 bytes each
/// Thread    [offline] or warm-up; throws std::bad_alloc.
void reserve_separation(SeparationScratch& scratch, const ClodHierarchy& object,
                        const ClodHierarchy& scene, std::size_t capacity = 1 << 15);

/// Narrows the interval that the contacts of a query give for the least separation: of the pairs
/// that may be the nearest the one with the lowest bound is divided, until that bound is within the
/// width of a pair of finest patches that was measured.
///
/// object, scene  hierarchies and poses of the query; alive and unchanged while the scratch is used
///                with them
/// contacts       all that the query found for this pair of bodies, exact or with levels, with a
///                budget or without. Where some were dropped the search starts from the roots
/// returns        a function of the poses and the contacts alone. `high` is proven. `low` is for
///                bodies that are apart; where patches meet or are through each other it bounds the
///                shift that parts their hulls, and depth, which is measured along normals of
///                faces, may be more
/// Thread         [contact]; no failure: a pose that is not finite gives an interval without ends.
///                Allocates when the scratch has no memory for these hierarchies yet, never after.
/// Source         this project's; the bounds are those of Eq. 3.5.
SeparationInterval least_separation(const PlacedHierarchy& object, const PlacedHierarchy& scene,
                                    const ContactSet& contacts, const SeparationQuery& query,
                                    SeparationScratch& scratch) noexcept;

}  // namespace thigma
