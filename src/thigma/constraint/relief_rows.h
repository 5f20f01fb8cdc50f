#pragma once
// Rows between fine surfaces: where contacts touch relief, a row a peak of the directional depth
// instead of rows of the coarse features.

#include <cstdint>
#include <span>
#include <vector>

#include "thigma/constraint/feature_rows.h"
#include "thigma/contact/clustering.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/depth/depth_peaks.h"
#include "thigma/dynamics/body.h"
#include "thigma/response/texture_contacts.h"

namespace thigma {

/// Which finest patches have relief; the others are met by rows of their features.
struct ReliefPatches {
  std::vector<std::uint8_t> object;
  std::vector<std::vector<std::uint8_t>> scene;  // one a body
};

/// Thread  [offline]; throws std::bad_alloc.
ReliefPatches find_relief_patches(const TexturedWorld& world);

/// How far rows of relief have to hold.
struct ReliefReach {
  double travel = 0.0;        // no point of the object is to go farther, > 0 [m]
  double turn = 0.0;          // nor does it turn by more on that way [rad]
  double least_travel = 0.0;  // nor is less of use, whatever the relief [m]
};

/// What a frame found.
struct ReliefStats {
  std::int32_t depths = 0;    // contacts of a cluster with a body that were looked at
  std::int32_t folds = 0;     // of these, where a surface is no height field at the deepest peak
  std::int32_t coarse = 0;    // where samples lay farther apart than two texels
  std::int32_t bent = 0;      // where rows leave out more than 1 % of the amplitude
  std::int64_t left_out = 0;  // peaks for want of room
  double deepest = kNoDepth;  // of all peaks [m]
};

/// Working memory: grows while warming up, never after.
struct ReliefScratch {
  struct Known {  // a row of the last frame
    std::uint64_t id = 0;
    std::int32_t body = 0;
    Vec3 on_object = Vec3::Zero();  // [m; mesh frame]
    Vec3 on_scene = Vec3::Zero();   // [m; world]
    bool is_taken = false;
  };
  PeakScratch search;
  TextureScratch textures;
  ContactSet plain;  // the contacts that touch no relief
  std::vector<Contact> touching;
  ContactClusters clusters;
  ClusterScratch clustering;
  DepthPeaks peaks;
  std::vector<FoundRow> rows;      // of the frame
  std::vector<Known> known, next;  // to tell rows again
  std::uint64_t new_id = 1;
  double travel = 0.0;       // of the rows, at most what was asked for [m]
  double next_travel = 0.0;  // to begin the next frame with [m]
  ReliefStats stats;
};

/// Thread [offline]; throws std::bad_alloc.
void reserve_relief(const TexturedWorld& world, std::size_t capacity, ReliefScratch& scratch);

/// The contacts of a frame at the finest level, searched with tolerance + relief_of(world).
struct ReliefContacts {
  const TexturedWorld& world;  // not empty
  const ReliefPatches& patches;
  std::span<const SceneBody> bodies;
  const ContactSet& contacts;
  int max_clusters = 5;
  double tolerance = 0.0;  // of the query, relief left aside [m]
};

/// Parts contacts by whether they touch relief, and finds the rows of those that do.
///
/// world_from_object  of the object's mesh
/// centre             of the object's mass [m; world]
/// scratch            rows, travel, plain and stats are results; rows keep their ids as long as
///                    the place on either surface stays
/// Thread    [contact]; no failure.
/// Source    Sec. 4.2.2: gap = -depth, its gradient that of the depth, over its length. The depth
///           is to second order in the object's way along the surface; the travel ends where that
///           leaves out more than 1 % of the relief's amplitude.
void find_relief_rows(const ReliefContacts& touching, const Pose& world_from_object,
                      const Vec3& centre, const ReliefReach& reach,
                      ReliefScratch& scratch) noexcept;

}  // namespace thigma
