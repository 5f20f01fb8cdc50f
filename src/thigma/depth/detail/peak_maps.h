#pragma once
// Where two textured patches may be nearest, from height maps of both.

#include <vector>

#include "thigma/depth/detail/prepared_contact.h"

namespace thigma::detail {

/// Both sides over one grid, and what is made of them. Any content is valid to fill.
struct PeakMaps {
  MapGrid grid;
  HeightMap object, scene;
  HeightMap moved;                    // the object's after a shift
  std::vector<float> sum;             // of a moved object's and the scene's [m]
  std::vector<float> row_most, most;  // of it: among three in a row, among the nine about a sample
};

/// A place that may be a local maximum of the depth.
struct Summit {
  double score = kNoDepth;    // depth, and what a turn may add to it far out [m]
  Vec2 at = Vec2::Zero();     // [m; contact plane]
  Vec2 shift = Vec2::Zero();  // of the object along the plane that makes it one [m]
};

/// Most of `find_summits`: of one way of the object.
inline constexpr int kMostBlocks = 64;

/// Room for the finest maps there can be. Thread [offline]; throws std::bad_alloc.
void reserve_maps(PeakMaps& maps);

/// Renders both sides over the part of the domain where they may be as near as a depth.
///
/// least      that depth, relief that no sample may show left aside [m]
/// is_found   set where the patches have a common domain, else left
/// returns    false where no part is as near
/// Thread     [contact]; allocates for a grid larger than ever before.
bool look_for_peaks(const PreparedContact& prepared, double least, PeakMaps& maps,
                    bool& is_found) noexcept;

/// What a summit has to be.
struct SummitWish {
  double least = 0.0;        // depth below which none counts [m]
  double turn = 0.0;         // by which the object may turn [rad]
  double way = 0.0;          // by which it may go along the plane; 0: it does not [m]
  double least_moved = 0.0;  // depth after that way below which none counts [m]
};

/// Samples that none beside is above: of every block of the grid the one that a turn may bring
/// nearest, with the object where it is; then another one with the object gone along either axis,
/// where what was farther may come to lie nearest: surfaces that conform touch on the one flank of
/// a ridge, then on the other. Along a ridge that lies on another all samples are summits, and its
/// far ends count. The nearest first, before those after a way.
void find_summits(const SummitWish& wish, PeakMaps& maps, std::vector<Summit>& summits) noexcept;

}  // namespace thigma::detail
