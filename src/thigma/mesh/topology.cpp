#include "thigma/mesh/topology.h"

#include <algorithm>
#include <numeric>

#include "thigma/math/random.h"
#include "thigma/mesh/predicates.h"
#include "thigma/mesh/triangle_tree.h"

namespace thigma {
namespace {

using Triangle = std::array<std::int32_t, 3>;

// Sets of 0..n-1 that grow together. The smallest member stands for its set.
class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::int32_t find(std::int32_t i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }
  void join(std::int32_t i, std::int32_t j) {
    i = find(i);
    j = find(j);
    if (i != j) at(std::max(i, j)) = std::min(i, j);
  }
  /// Number of each element's set, in the order of first members; returns how many.
  std::int32_t number(std::vector<std::int32_t>& of) {
    of.assign(parent_.size(), -1);
    std::int32_t count = 0;
    for (std::size_t i = 0; i < parent_.size(); ++i) {
      const std::int32_t root = find(static_cast<std::int32_t>(i));
      of[i] = root == static_cast<std::int32_t>(i) ? count++ : of[static_cast<std::size_t>(root)];
    }
    return count;
  }

 private:
  std::int32_t& at(std::int32_t i) { return parent_[static_cast<std::size_t>(i)]; }
  std::vector<std::int32_t> parent_;
};

std::int32_t corner_id(const EdgeUse& use, int step) {
  return 3 * use.triangle + (use.corner + step) % 3;
}

// Joins the corners of two faces at both ends of the edge they share.
void join_along_edge(const EdgeUse& u, const EdgeUse& v, UnionFind& corners) {
  const int turned = u.is_forward == v.is_forward ? 0 : 1;
  corners.join(corner_id(u, 0), corner_id(v, turned));
  corners.join(corner_id(u, 1), corner_id(v, 1 - turned));
}

Components number_triangles(UnionFind& sets) {
  Components c;
  c.count = sets.number(c.of_triangle);
  return c;
}

}  // namespace

EdgeTable build_edge_table(const TriangleMesh& mesh) {
  struct Half {
    std::uint64_t key;
    std::uint32_t corner;
    bool operator<(const Half& o) const {
      return key < o.key || (key == o.key && corner < o.corner);
    }
  };
  std::vector<Half> halves;
  halves.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint64_t v = static_cast<std::uint32_t>(mesh.triangles[t][k]);
      const std::uint64_t w = static_cast<std::uint32_t>(mesh.triangles[t][(k + 1) % 3]);
      halves.push_back(
          {std::min(v, w) << 32 | std::max(v, w), static_cast<std::uint32_t>(3 * t + k)});
    }
  }
  std::sort(halves.begin(), halves.end());
  EdgeTable table;
  table.uses.reserve(halves.size());
  table.edges.reserve(halves.size() / 2 + 1);
  table.of_triangle.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const std::int32_t a = static_cast<std::int32_t>(halves[i].key >> 32);
    if (i == 0 || halves[i].key != halves[i - 1].key) {
      const std::int32_t b = static_cast<std::int32_t>(halves[i].key & 0xffffffffu);
      table.edges.push_back({a, b, static_cast<std::int32_t>(i), 0});
    }
    ++table.edges.back().use_count;
    const std::size_t t = halves[i].corner / 3;
    const std::size_t k = halves[i].corner % 3;
    table.uses.push_back(
        {static_cast<std::int32_t>(t), static_cast<std::int8_t>(k), mesh.triangles[t][k] == a});
    table.of_triangle[t][k] = static_cast<std::int32_t>(table.edges.size()) - 1;
  }
  return table;
}

Components connect_over_edges(const TriangleMesh& mesh, const EdgeTable& table) {
  UnionFind sets(mesh.triangles.size());
  for (const MeshEdge& e : table.edges) {
    for (const EdgeUse& u : table.uses_of(e)) sets.join(table.uses_of(e)[0].triangle, u.triangle);
  }
  return number_triangles(sets);
}

Orientation orient_sheets(const TriangleMesh& mesh, const EdgeTable& table) {
  Orientation o;
  const std::size_t n = mesh.triangles.size();
  o.sheet_of_triangle.assign(n, -1);
  o.is_flipped.assign(n, false);
  std::vector<std::int32_t> members;
  for (std::size_t seed = 0; seed < n; ++seed) {
    if (o.sheet_of_triangle[seed] >= 0) continue;
    o.sheet_of_triangle[seed] = o.sheets;
    o.is_orientable.push_back(true);
    members.assign(1, static_cast<std::int32_t>(seed));
    std::size_t flipped = 0;
    for (std::size_t i = 0; i < members.size(); ++i) {
      const std::size_t t = static_cast<std::size_t>(members[i]);
      for (const std::int32_t edge : table.of_triangle[t]) {
        const std::span<const EdgeUse> uses =
            table.uses_of(table.edges[static_cast<std::size_t>(edge)]);
        if (uses.size() != 2) continue;
        const EdgeUse& other = uses[0].triangle == members[i] ? uses[1] : uses[0];
        const std::size_t u = static_cast<std::size_t>(other.triangle);
        const bool flip = o.is_flipped[t] != (uses[0].is_forward == uses[1].is_forward);
        if (o.sheet_of_triangle[u] < 0) {
          o.sheet_of_triangle[u] = o.sheets;
          o.is_flipped[u] = flip;
          flipped += flip;
          members.push_back(other.triangle);
        } else if (o.is_flipped[u] != flip) {
          o.is_orientable.back() = false;
        }
      }
    }
    if (2 * flipped > members.size()) {
      for (const std::int32_t t : members) {
        o.is_flipped[static_cast<std::size_t>(t)] = !o.is_flipped[static_cast<std::size_t>(t)];
      }
    }
    ++o.sheets;
  }
  return o;
}

Fans build_fans(const TriangleMesh& mesh, const EdgeTable& table) {
  UnionFind corners(3 * mesh.triangles.size());
  for (const MeshEdge& e : table.edges) {
    const std::span<const EdgeUse> uses = table.uses_of(e);
    for (std::size_t i = 1; i < uses.size(); ++i) join_along_edge(uses[0], uses[i], corners);
  }
  Fans fans;
  fans.count = corners.number(fans.of_corner);
  return fans;
}

Fans build_fans(const TriangleMesh& mesh, std::span<const UsePair> links) {
  UnionFind corners(3 * mesh.triangles.size());
  for (const UsePair& link : links) join_along_edge(link[0], link[1], corners);
  Fans fans;
  fans.count = corners.number(fans.of_corner);
  return fans;
}

std::vector<std::int32_t> find_duplicates(const TriangleMesh& mesh) {
  std::vector<std::pair<Triangle, std::int32_t>> sorted;
  sorted.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle key = mesh.triangles[t];
    std::sort(key.begin(), key.end());
    sorted.emplace_back(key, static_cast<std::int32_t>(t));
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::int32_t> first(mesh.triangles.size(), -1);
  std::size_t start = 0;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i].first != sorted[start].first) {
      start = i;
    } else {
      first[static_cast<std::size_t>(sorted[i].second)] = sorted[start].second;
    }
  }
  return first;
}

struct InsideTest::Data {
  const TriangleMesh& mesh;
  const Components& components;
  TriangleTree tree;
};

InsideTest::InsideTest(const TriangleMesh& mesh, const Components& components) {
  std::vector<std::int32_t> all(mesh.triangles.size());
  std::iota(all.begin(), all.end(), 0);
  data_ = std::make_unique<Data>(Data{mesh, components, build_triangle_tree(mesh, std::move(all))});
}

InsideTest::~InsideTest() = default;

namespace {

enum class Crossing : std::uint8_t { none, proper, degenerate };

// Where the segment from p to q, q away from everything, stands to a triangle; degenerate when it
// grazes it.
Crossing cross(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int sp = orient3d(a, b, c, p);
  const int sq = orient3d(a, b, c, q);
  if (sp * sq > 0) return Crossing::none;
  const int ab = orient3d(p, q, a, b);
  const int bc = orient3d(p, q, b, c);
  const int ca = orient3d(p, q, c, a);
  const bool negative = ab < 0 || bc < 0 || ca < 0;
  const bool positive = ab > 0 || bc > 0 || ca > 0;
  if (negative && positive) return Crossing::none;
  return ab * bc * ca * sp * sq == 0 ? Crossing::degenerate : Crossing::proper;
}

}  // namespace

// Components of the triangles that the segment crosses, unordered; none when it grazes one.
std::optional<std::vector<std::int32_t>> InsideTest::crossed_between(const Vec3& p, const Vec3& q,
                                                                     std::int32_t own) const {
  const TriangleTree& tree = data_->tree;
  const TreeBox way{p.cwiseMin(q), p.cwiseMax(q)};
  std::vector<std::int32_t> crossed;
  std::vector<std::int32_t> stack{0};
  while (!stack.empty()) {
    const std::int32_t self = stack.back();
    const TreeNode& node = tree.nodes[static_cast<std::size_t>(self)];
    stack.pop_back();
    if (!node.box.overlaps(way)) continue;
    if (node.count == 0) {
      stack.push_back(self + 1);
      stack.push_back(node.right);
      continue;
    }
    for (std::int32_t i = node.first; i < node.first + node.count; ++i) {
      const std::int32_t t = tree.order[static_cast<std::size_t>(i)];
      const std::int32_t component = data_->components.of_triangle[static_cast<std::size_t>(t)];
      if (component == own) continue;
      const Triangle& v = data_->mesh.triangles[static_cast<std::size_t>(t)];
      const std::vector<Vec3>& at = data_->mesh.positions;
      const Crossing c =
          cross(p, q, at[static_cast<std::size_t>(v[0])], at[static_cast<std::size_t>(v[1])],
                at[static_cast<std::size_t>(v[2])]);
      if (c == Crossing::degenerate) return std::nullopt;
      if (c == Crossing::proper) crossed.push_back(component);
    }
  }
  return crossed;
}

std::optional<std::vector<std::int32_t>> InsideTest::components_around(const Vec3& point,
                                                                       std::int32_t own) const {
  const TreeBox& all = data_->tree.nodes[0].box;
  const double reach = (all.max - all.min).sum();
  Random random(1);
  for (int attempt = 0; attempt < 16; ++attempt) {
    // Almost along x: the box of the way stays thin. Another way is tried when this one grazes an
    // edge.
    const double y = point.y() + 1e-3 * reach * random.uniform(-1.0, 1.0);
    const double z = point.z() + 1e-3 * reach * random.uniform(-1.0, 1.0);
    std::optional<std::vector<std::int32_t>> crossed =
        crossed_between(point, Vec3(all.max.x() + reach, y, z), own);
    if (!crossed) continue;
    std::sort(crossed->begin(), crossed->end());
    std::vector<std::int32_t> odd;
    for (const std::int32_t c : *crossed) {
      if (!odd.empty() && odd.back() == c)
        odd.pop_back();
      else
        odd.push_back(c);
    }
    return odd;
  }
  return std::nullopt;
}

}  // namespace thigma
