#pragma once
// Where the ends of the patches hold a maximum of the depth: a place that the samples of a grid
// miss when less than a cell of it is left over both.

#include "thigma/core/static_vector.h"
#include "thigma/depth/detail/prepared_contact.h"

namespace thigma::detail {

/// A place to climb from, and how high it may be [m].
struct Rival {
  double hope = kNoDepth;
  Vec2 at = Vec2::Zero();
  double tent = 0.0;  // of the hope, what is more than a sample [m]
};

inline constexpr std::size_t kMostRivals = 8;
using Rivals = StaticVector<Rival, kMostRivals>;

inline bool is_lower(const Rival& a, const Rival& b) noexcept { return a.hope < b.hope; }

/// Adds a rival; where there is no room the lowest has to be lower, and goes.
void add_rival(const Rival& rival, Rivals& rivals) noexcept;

/// The highest places along the rims of both patches, over the other one, each of one edge over one
/// triangle. An edge is of the rim where no triangle of the patch lies on its other side. What the
/// relief of its two triangles, as first order carries it, leaves lower than what is known is left
/// out: no bound where triangles are steeper than 45 degrees or others reach over the rim.
///
/// apart    of samples along an edge, along either axis; short parts have five [m]
/// reading  of the samples: which is the highest is told as maps tell it
/// deepest  that is known [m]
/// Thread   [contact]; no failure. After bind_near. Allocates when a patch has more triangles than
///          any before.
Rivals rivals_on_rims(PreparedContact& prepared, const Vec2& apart, const MapReading& reading,
                      double deepest) noexcept;

}  // namespace thigma::detail
