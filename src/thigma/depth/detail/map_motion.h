#pragma once
// Where the samples of a moved height map come from.

#include "thigma/depth/height_map.h"

namespace thigma::detail {

/// A shift within the plane: moved sample (i, j) is the old one at (i + whole[0] + way[0], j +
/// whole[1] + way[1]), for i in first[0] .. last[0] - 1 and j likewise; there is none elsewhere.
struct MapShift {
  int whole[2] = {0, 0}, first[2] = {0, 0}, last[2] = {0, 0};
  float way[2] = {0.0f, 0.0f};
};
MapShift map_shift(const MapGrid& grid, const Vec2& shift) noexcept;

/// A turn and a shift: where a sample was.
struct MapTurn {
  Mat2 back = Mat2::Identity();                       // turns back
  Vec2 centre = Vec2::Zero(), shift = Vec2::Zero();   // [m; contact plane]
  Vec2 first = Vec2::Zero(), spacing = Vec2::Ones();  // sample (0, 0), and from one to the next [m]
  Vec2 by_column = Vec2::Zero();                      // from one moved sample to the next [cells]
  /// Old place of a moved sample at a point of the plane [cells].
  Vec2 old(const Vec2& at) const noexcept {
    const Vec2 from = back * (at - shift - centre) + centre;
    return (from - first).cwiseQuotient(spacing);
  }
};
MapTurn map_turn(const MapGrid& grid, const PlaneMotion& motion) noexcept;

/// Less than the smallest weight leaves of an empty sample [m].
inline constexpr float kMixedSample = 1e-10f * kEmptySample;

}  // namespace thigma::detail
