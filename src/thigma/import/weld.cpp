#include "thigma/import/weld.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace thigma {
namespace {

// Boundary vertices in cells of the tolerance's size, sorted by cell: neighbours are found by
// binary search.
struct Grid {
  using Cell = std::array<std::int64_t, 3>;
  struct Entry {
    Cell cell;
    std::int32_t vertex;
    bool operator<(const Entry& o) const {
      return cell < o.cell || (cell == o.cell && vertex < o.vertex);
    }
  };
  Vec3 origin;
  double size;
  std::vector<Entry> entries;

  Cell cell_of(const Vec3& p) const {
    Cell c{};
    for (int k = 0; k < 3; ++k) {
      c[static_cast<std::size_t>(k)] =
          static_cast<std::int64_t>(std::floor((p[k] - origin[k]) / size));
    }
    return c;
  }
};

struct WeldSearch {
  const TriangleMesh& mesh;
  const EdgeTable& table;
  std::vector<double> reach;                    // of each vertex [m]; 0 away from boundaries
  std::vector<std::vector<std::int32_t>> near;  // boundary vertices within reach, ascending
  std::vector<std::int32_t> parent;

  std::int32_t find(std::int32_t v) const {
    while (parent[static_cast<std::size_t>(v)] != v) v = parent[static_cast<std::size_t>(v)];
    return v;
  }
  void join(std::int32_t v, std::int32_t w) {
    v = find(v);
    w = find(w);
    parent[static_cast<std::size_t>(std::max(v, w))] = std::min(v, w);
  }
};

void measure_reach(WeldSearch& search, double tolerance) {
  const std::vector<Vec3>& at = search.mesh.positions;
  std::vector<double> shortest(at.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> is_boundary(at.size(), false);
  for (const MeshEdge& e : search.table.edges) {
    const std::size_t a = static_cast<std::size_t>(e.a), b = static_cast<std::size_t>(e.b);
    const double length = (at[a] - at[b]).norm();
    shortest[a] = std::min(shortest[a], length);
    shortest[b] = std::min(shortest[b], length);
    if (e.use_count == 1) is_boundary[a] = is_boundary[b] = true;
  }
  search.reach.assign(at.size(), 0.0);
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (is_boundary[v]) search.reach[v] = std::min(tolerance, kWeldEdgeFraction * shortest[v]);
  }
}

void find_near(WeldSearch& search, double tolerance) {
  const std::vector<Vec3>& at = search.mesh.positions;
  Grid grid{Vec3::Zero(), tolerance, {}};
  bool is_first = true;
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (search.reach[v] <= 0.0) continue;
    grid.origin = is_first ? at[v] : Vec3(grid.origin.cwiseMin(at[v]));
    is_first = false;
  }
  for (std::size_t v = 0; v < at.size(); ++v) {
    if (search.reach[v] > 0.0)
      grid.entries.push_back({grid.cell_of(at[v]), static_cast<std::int32_t>(v)});
  }
  std::sort(grid.entries.begin(), grid.entries.end());
  search.near.resize(at.size());
  // a vertex with more has lost its place anyway, and time stays bounded
  constexpr std::size_t kMaxNear = 16;
  for (const Grid::Entry& entry : grid.entries) {
    std::vector<std::int32_t>& near = search.near[static_cast<std::size_t>(entry.vertex)];
    const Vec3& p = at[static_cast<std::size_t>(entry.vertex)];
    for (int i = 0; i < 9; ++i) {
      const Grid::Cell first{entry.cell[0] + i / 3 - 1, entry.cell[1] + i % 3 - 1,
                             entry.cell[2] - 1};
      auto it = std::lower_bound(grid.entries.begin(), grid.entries.end(), Grid::Entry{first, -1});
      for (; it != grid.entries.end() && near.size() < kMaxNear && it->cell[0] == first[0] &&
             it->cell[1] == first[1] && it->cell[2] <= first[2] + 2;
           ++it) {
        if (it->vertex == entry.vertex) continue;
        const double reach = std::min(search.reach[static_cast<std::size_t>(entry.vertex)],
                                      search.reach[static_cast<std::size_t>(it->vertex)]);
        if ((at[static_cast<std::size_t>(it->vertex)] - p).norm() <= reach)
          near.push_back(it->vertex);
      }
    }
    near.push_back(entry.vertex);  // an edge may share one end already
    std::sort(near.begin(), near.end());
  }
}

std::int32_t boundary_edge_between(const EdgeTable& table, std::int32_t a, std::int32_t b) {
  const std::int32_t low = std::min(a, b), high = std::max(a, b);
  const auto it = std::lower_bound(
      table.edges.begin(), table.edges.end(), 0,
      [&](const MeshEdge& e, int) { return e.a < low || (e.a == low && e.b < high); });
  if (it == table.edges.end() || it->a != low || it->b != high || it->use_count != 1) return -1;
  return static_cast<std::int32_t>(it - table.edges.begin());
}

}  // namespace

Welds find_welds(const TriangleMesh& mesh, const EdgeTable& table, double radius) {
  Welds welds;
  welds.target.resize(mesh.positions.size());
  std::iota(welds.target.begin(), welds.target.end(), 0);
  const bool is_closed = std::none_of(table.edges.begin(), table.edges.end(),
                                      [](const MeshEdge& e) { return e.use_count == 1; });
  if (is_closed || !(radius > 0.0)) return welds;
  WeldSearch search{mesh, table, {}, {}, welds.target};
  measure_reach(search, kWeldTolerance * radius);
  find_near(search, kWeldTolerance * radius);
  for (const MeshEdge& e : table.edges) {
    if (e.use_count != 1) continue;
    for (const std::int32_t c : search.near[static_cast<std::size_t>(e.a)]) {
      for (const std::int32_t d : search.near[static_cast<std::size_t>(e.b)]) {
        if ((c == e.a && d == e.b) || c == d || boundary_edge_between(table, c, d) < 0) continue;
        search.join(e.a, c);
        search.join(e.b, d);
      }
    }
  }
  for (std::size_t v = 0; v < welds.target.size(); ++v) {
    welds.target[v] = search.find(static_cast<std::int32_t>(v));
    welds.count += welds.target[v] != static_cast<std::int32_t>(v);
  }
  return welds;
}

}  // namespace thigma
