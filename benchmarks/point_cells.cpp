#include "benchmarks/point_cells.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace thigma::bench {
namespace {

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Vec3& p, double reach) {
  Cell cell{};
  for (int a = 0; a < 3; ++a)
    cell[static_cast<std::size_t>(a)] = static_cast<std::int64_t>(std::floor(p[a] / reach));
  return cell;
}

// First entry of a cell, or of the next one there is.
std::size_t first_of(const PointCells& cells, const Cell& cell) {
  const auto at =
      std::lower_bound(cells.entries.begin(), cells.entries.end(), cell,
                       [](const PointCells::Entry& e, const Cell& c) { return e.cell < c; });
  return static_cast<std::size_t>(at - cells.entries.begin());
}

// visit(first entry, cell) of the cell and its 26 neighbours, until it returns true.
template <class Visit>
bool each_near(const PointCells& cells, const Cell& cell, Visit&& visit) {
  for (std::int64_t x = -1; x <= 1; ++x) {
    for (std::int64_t y = -1; y <= 1; ++y) {
      for (std::int64_t z = -1; z <= 1; ++z) {
        const Cell near = {cell[0] + x, cell[1] + y, cell[2] + z};
        const std::size_t first = first_of(cells, near);
        if (first < cells.entries.size() && cells.entries[first].cell == near && visit(first, near))
          return true;
      }
    }
  }
  return false;
}

}  // namespace

PointCells sort_into_cells(const std::vector<Vec3>& points, double reach) {
  PointCells cells;
  cells.reach = reach;
  cells.entries.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    cells.entries.push_back({cell_of(points[i], reach), points[i], static_cast<std::int32_t>(i)});
  }
  std::sort(cells.entries.begin(), cells.entries.end(),
            [](const PointCells::Entry& a, const PointCells::Entry& b) {
              return a.cell != b.cell ? a.cell < b.cell : a.index < b.index;
            });
  return cells;
}

bool has_point_within(const PointCells& cells, const Vec3& p) {
  return each_near(cells, cell_of(p, cells.reach), [&](std::size_t first, const Cell& cell) {
    for (std::size_t i = first; i < cells.entries.size() && cells.entries[i].cell == cell; ++i) {
      if ((cells.entries[i].point - p).squaredNorm() <= cells.reach * cells.reach) return true;
    }
    return false;
  });
}

std::vector<int> regions_of(const std::vector<Vec3>& points, double reach, int& count) {
  const PointCells cells = sort_into_cells(points, reach);
  std::vector<int> of_entry(points.size(), -1), region(points.size(), -1);
  std::vector<std::size_t> waiting;
  count = 0;
  auto take = [&](std::size_t first, const Cell& cell) {
    if (of_entry[first] >= 0) return false;
    for (std::size_t i = first; i < cells.entries.size() && cells.entries[i].cell == cell; ++i)
      of_entry[i] = count;
    waiting.push_back(first);
    return false;
  };
  for (std::size_t i = 0; i < cells.entries.size(); ++i) {
    if (of_entry[i] >= 0) continue;
    take(i, cells.entries[i].cell);
    while (!waiting.empty()) {
      const Cell cell = cells.entries[waiting.back()].cell;
      waiting.pop_back();
      each_near(cells, cell, take);
    }
    ++count;
  }
  for (std::size_t i = 0; i < cells.entries.size(); ++i)
    region[static_cast<std::size_t>(cells.entries[i].index)] = of_entry[i];
  return region;
}

}  // namespace thigma::bench
