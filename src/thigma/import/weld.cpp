#include "thigma/import/weld.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace thigma {
namespace {

// Boundary vertices in cells of the tolerance's size, sorted by cell: neighbours are found by
// binary search.
struct WeldSearch {
  const TriangleMesh& mesh;
  const EdgeTable& table;
  std::vector<double> reach;                    // of each vertex [m]; 0 away from boundaries
  std::vector<std::vector<std::int32_t>> near;  // boundary vertices within reach, ascending
  std::vector<std::int32_t> parent;

  std::int32_t find(std::int32_t v) {
    while (parent[static_cast<std::size_t>(v)] != v) {
      std::int32_t& above = parent[static_cast<std::size_t>(v)];
      v = above = parent[static_cast<std::size_t>(above)];  // halves the way of the next
    }
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

/// Boundary vertices, so that those near a place whose reach is no less than a length are found in
/// time, however unlike the reaches of others there are. A range's middle is its node; what is
/// before and behind it lies on either side along its axis.
class ReachTree {
 public:
  explicit ReachTree(const WeldSearch& search) {
    for (std::size_t v = 0; v < search.reach.size(); ++v) {
      if (search.reach[v] > 0.0)
        nodes_.push_back({search.mesh.positions[v], search.reach[v], search.reach[v],
                          static_cast<std::int32_t>(v), 0});
    }
    order(0, nodes_.size());
  }

  /// Of the vertices within its reach: calls found(w) for those that reach farther, and of those
  /// that reach as far for the ones of a higher number, until it says that this is enough.
  template <class Found>
  void visit(const Vec3& at, double reach, std::int32_t vertex, const Found& found) const {
    visit({at, reach, vertex}, 0, nodes_.size(), found);
  }

 private:
  struct Node {
    Vec3 at;
    double reach, most;  // its own, the largest of its range [m]
    std::int32_t vertex;
    int axis;
  };
  struct Sought {
    Vec3 at;
    double reach;
    std::int32_t vertex;
  };

  double order(std::size_t begin, std::size_t end) {
    if (begin == end) return 0.0;
    Vec3 low = nodes_[begin].at, high = low;
    for (std::size_t i = begin; i < end; ++i) {
      low = low.cwiseMin(nodes_[i].at);
      high = high.cwiseMax(nodes_[i].at);
    }
    int axis = 0;
    (high - low).maxCoeff(&axis);
    const std::size_t middle = begin + (end - begin) / 2;
    const auto place = [&](std::size_t k) {
      return nodes_.begin() + static_cast<std::ptrdiff_t>(k);
    };
    std::nth_element(place(begin), place(middle), place(end), [&](const Node& a, const Node& b) {
      return a.at[axis] < b.at[axis] || (a.at[axis] == b.at[axis] && a.vertex < b.vertex);
    });
    nodes_[middle].axis = axis;
    const double before = order(begin, middle), behind = order(middle + 1, end);
    return nodes_[middle].most = std::max({nodes_[middle].reach, before, behind});
  }

  template <class Found>
  bool visit(const Sought& sought, std::size_t begin, std::size_t end, const Found& found) const {
    if (begin == end) return true;
    const std::size_t middle = begin + (end - begin) / 2;
    const Node& node = nodes_[middle];
    if (node.most < sought.reach) return true;
    const bool is_other =
        node.reach > sought.reach || (node.reach == sought.reach && node.vertex > sought.vertex);
    if (is_other && (node.at - sought.at).norm() <= sought.reach && !found(node.vertex))
      return false;
    const double beyond = sought.at[node.axis] - node.at[node.axis];
    if (beyond <= sought.reach && !visit(sought, begin, middle, found)) return false;
    return !(beyond >= -sought.reach) || visit(sought, middle + 1, end, found);
  }

  std::vector<Node> nodes_;
};

/// Two vertices are near each other within the lesser of their reaches.
void find_near(WeldSearch& search) {
  const ReachTree tree(search);
  search.near.resize(search.reach.size());
  // a vertex with more has lost its place anyway, and time stays bounded
  constexpr std::size_t kMaxNear = 16;
  for (std::size_t v = 0; v < search.reach.size(); ++v) {
    if (search.reach[v] <= 0.0) continue;
    const std::int32_t vertex = static_cast<std::int32_t>(v);
    std::vector<std::int32_t>& near = search.near[v];
    if (near.size() >= kMaxNear) continue;
    tree.visit(search.mesh.positions[v], search.reach[v], vertex, [&](std::int32_t w) {
      std::vector<std::int32_t>& theirs = search.near[static_cast<std::size_t>(w)];
      if (theirs.size() < kMaxNear) theirs.push_back(vertex);
      near.push_back(w);
      return near.size() < kMaxNear;
    });
  }
  for (std::size_t v = 0; v < search.reach.size(); ++v) {
    if (search.reach[v] <= 0.0) continue;
    search.near[v].push_back(static_cast<std::int32_t>(v));  // an edge may share one end already
    std::sort(search.near[v].begin(), search.near[v].end());
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
  find_near(search);
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
