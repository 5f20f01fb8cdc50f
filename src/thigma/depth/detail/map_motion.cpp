#include "thigma/depth/detail/map_motion.h"

#include <algorithm>
#include <cmath>

#include "thigma/math/elementary.h"

namespace thigma::detail {
namespace {

// Of a cell: nearer to a sample than this, an offset is meant to be whole, and must not fall off
// the edge by rounding.
constexpr double kWholeCell = 1e-9;

}  // namespace

MapShift map_shift(const MapGrid& grid, const Vec2& shift) noexcept {
  const Vec2 offset = -shift.cwiseQuotient(grid.spacing());
  MapShift result;
  for (int k = 0; k < 2; ++k) {
    const int count = k == 0 ? grid.columns : grid.rows;
    double at = std::clamp(offset[k], -static_cast<double>(count), static_cast<double>(count));
    if (std::fabs(at - std::round(at)) <= kWholeCell) at = std::round(at);
    result.whole[k] = static_cast<int>(std::floor(at));
    result.way[k] = static_cast<float>(at - result.whole[k]);
    result.first[k] = std::max(0, -result.whole[k]);
    result.last[k] = std::min(count, count - result.whole[k] - (result.way[k] > 0.0f));
  }
  return result;
}

MapTurn map_turn(const MapGrid& grid, const PlaneMotion& motion) noexcept {
  const SinCos turn = sin_cos(motion.turn);
  MapTurn result;
  result.back << turn.cos, turn.sin, -turn.sin, turn.cos;
  result.centre = motion.centre;
  result.shift = motion.shift;
  result.first = grid.at(0, 0);
  result.spacing = grid.spacing();
  result.by_column = result.old(grid.at(1, 0)) - result.old(result.first);
  return result;
}

}  // namespace thigma::detail
