#pragma once
// Points sorted into the cells of a grid: who is near whom.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/math/types.h"

namespace thigma::bench {

/// Points by the cell of side `reach` they lie in.
struct PointCells {
  double reach = 0.0;  // [m]
  struct Entry {
    std::array<std::int64_t, 3> cell{};
    Vec3 point = Vec3::Zero();
    std::int32_t index = -1;  // in the order given
  };
  std::vector<Entry> entries;  // by cell, then index
};

PointCells sort_into_cells(const std::vector<Vec3>& points, double reach);

/// Whether a point lies within reach of p.
bool has_point_within(const PointCells& cells, const Vec3& p);

/// Region of each point, 0..count-1: points of cells that touch, even at a corner, are of one.
std::vector<int> regions_of(const std::vector<Vec3>& points, double reach, int& count);

}  // namespace thigma::bench
