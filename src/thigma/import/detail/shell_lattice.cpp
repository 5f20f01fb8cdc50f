#include "thigma/import/detail/shell_lattice.h"

#include <algorithm>
#include <cmath>

#include "thigma/core/index.h"
#include "thigma/import/nearest_point.h"
#include "thigma/mesh/measure.h"

namespace thigma::detail {
namespace {

using Int3 = std::array<std::int64_t, 3>;

constexpr double kMargin = 2.5;  // cells between the offset surface and the border of the lattice
// How near a cut comes to the ends of its lattice edge, in shares of it: where it comes nearer,
// triangles become needles. The snap puts it right.
constexpr double kLeastShare = 0.1;
// Blocks of this side are searched point by point.
constexpr std::int64_t kSmallBlock = 2;

std::size_t at(std::int64_t point) { return static_cast<std::size_t>(point); }

Int3 corner_counts(const Vec3& extent, double cell, double offset) {
  Int3 count{};
  for (int axis = 0; axis < 3; ++axis)
    count[static_cast<std::size_t>(axis)] =
        static_cast<std::int64_t>(std::ceil((extent[axis] + 2.0 * offset) / cell + 2.0 * kMargin)) +
        1;
  return count;
}

struct Field {
  const TriangleMesh& mesh;
  const TriangleTree& tree;
  ShellLattice& lattice;
  std::size_t most_near;
  const std::function<void(double)>& progress;
  std::vector<std::uint8_t> is_near;  // within the offset, by point
  bool is_full() const { return lattice.distance.size() > most_near; }
};

void measure_points(Field& field, const Int3& low, const Int3& high) {
  ShellLattice& l = field.lattice;
  // Both ends of an edge that crosses the offset are within it and a cell.
  const double reach = (l.offset + l.cell) * (1.0 + 1e-9);
  for (int kind = 0; kind < 2; ++kind)
    for (std::int64_t k = low[2]; k < high[2]; ++k)
      for (std::int64_t j = low[1]; j < high[1]; ++j)
        for (std::int64_t i = low[0]; i < high[0]; ++i) {
          const std::int64_t point = l.index(kind, i, j, k);
          const NearestPoint n = nearest_point(field.mesh, field.tree, l.position(point), reach);
          if (n.triangle < 0) continue;
          l.distance.emplace(point, n.distance);
          field.is_near[at(point)] = n.distance <= l.offset;
        }
}

// Distances of the points of a block of cubes: none where the whole block is far.
void measure_block(Field& field, const Int3& low, const Int3& high) {
  if (field.is_full()) return;
  const ShellLattice& l = field.lattice;
  const Vec3 first = l.position(l.index(0, low[0], low[1], low[2]));
  const Vec3 sides(static_cast<double>(high[0] - low[0]), static_cast<double>(high[1] - low[1]),
                   static_cast<double>(high[2] - low[2]));
  const Vec3 half = 0.5 * l.cell * sides;  // middles included
  const double reach = half.norm() + (l.offset + l.cell) * (1.0 + 1e-9);
  if (nearest_point(field.mesh, field.tree, first + half, reach).triangle < 0) return;
  std::size_t axis = 0;
  for (std::size_t a = 1; a < 3; ++a)
    if (high[a] - low[a] > high[axis] - low[axis]) axis = a;
  if (high[axis] - low[axis] <= kSmallBlock) return measure_points(field, low, high);
  Int3 middle_high = high, middle_low = low;
  middle_high[axis] = middle_low[axis] = low[axis] + (high[axis] - low[axis]) / 2;
  measure_block(field, low, middle_high);
  measure_block(field, middle_low, high);
}

void measure(Field& field) {
  const Int3& n = field.lattice.count;
  constexpr std::int64_t kSlab = 8;  // of planes between two reports
  for (std::int64_t k = 0; k < n[2]; k += kSlab) {
    measure_block(field, {0, 0, k}, {n[0], n[1], std::min(n[2], k + kSlab)});
    if (field.progress)
      field.progress(static_cast<double>(std::min(n[2], k + kSlab)) / static_cast<double>(n[2]));
  }
}

// Calls visit(point) for the 14 neighbours of a point that the lattice has.
template <class Visit>
void visit_neighbours(const ShellLattice& l, std::int64_t point, const Visit& visit) {
  const std::int64_t i = point % l.count[0], rest = point / l.count[0];
  const std::int64_t j = rest % l.count[1], rest2 = rest / l.count[1];
  const std::int64_t k = rest2 % l.count[2];
  const int kind = static_cast<int>(rest2 / l.count[2]);
  const auto call = [&](int of_kind, std::int64_t x, std::int64_t y, std::int64_t z) {
    if (x >= 0 && y >= 0 && z >= 0 && x < l.count[0] && y < l.count[1] && z < l.count[2])
      visit(l.index(of_kind, x, y, z));
  };
  for (const std::int64_t step : {-1, 1}) {
    call(kind, i + step, j, k);
    call(kind, i, j + step, k);
    call(kind, i, j, k + step);
  }
  const std::int64_t low = kind == 0 ? -1 : 0;  // a corner's middles lie before it as well
  for (std::int64_t z = low; z < low + 2; ++z)
    for (std::int64_t y = low; y < low + 2; ++y)
      for (std::int64_t x = low; x < low + 2; ++x) call(1 - kind, i + x, j + y, k + z);
}

void flood(ShellLattice& lattice, const std::vector<std::uint8_t>& is_near) {
  lattice.is_outside.assign(at(lattice.points()), 0);
  lattice.is_outside[0] = 1;
  std::vector<std::int64_t> front{0}, next;
  while (!front.empty()) {
    next.clear();
    for (const std::int64_t point : front)
      visit_neighbours(lattice, point, [&](std::int64_t other) {
        if (is_near[at(other)] != 0 || lattice.is_outside[at(other)] != 0) return;
        lattice.is_outside[at(other)] = 1;
        next.push_back(other);
      });
    front.swap(next);
  }
}

// What is cut out of the lattice.
struct Cut {
  const ShellLattice& lattice;
  TriangleMesh mesh;
  std::unordered_map<std::uint64_t, std::int32_t> vertex_of_edge;

  // The vertex on the lattice edge between two points, one inside and one outside.
  std::int32_t vertex(std::int64_t p, std::int64_t q) {
    if (p > q) std::swap(p, q);  // the same bits from every tetrahedron
    const std::uint64_t key = static_cast<std::uint64_t>(p) << 32 | static_cast<std::uint64_t>(q);
    const auto [found, is_new] =
        vertex_of_edge.try_emplace(key, static_cast<std::int32_t>(mesh.positions.size()));
    if (is_new) {
      const double dp = lattice.distance.at(p), dq = lattice.distance.at(q);
      const double share =
          std::clamp((dp - lattice.offset) / (dp - dq), kLeastShare, 1.0 - kLeastShare);
      const Vec3 a = lattice.position(p);
      mesh.positions.push_back(a + share * (lattice.position(q) - a));
    }
    return found->second;
  }
  void triangle(std::int32_t a, std::int32_t b, std::int32_t c) {
    mesh.triangles.push_back({a, b, c});
  }
};

// Even permutations of the corners of a tetrahedron: turning is kept.
constexpr int kOneFirst[4][4] = {{0, 1, 2, 3}, {1, 0, 3, 2}, {2, 0, 1, 3}, {3, 0, 2, 1}};
constexpr int kTwoFirst[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                 {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}};

// Cuts a tetrahedron whose corners turn positively.
void cut_tetrahedron(Cut& cut, const std::array<std::int64_t, 4>& p) {
  std::array<bool, 4> is_in{};
  int in = 0;
  for (std::size_t c = 0; c < 4; ++c) {
    is_in[c] = cut.lattice.is_outside[at(p[c])] == 0;
    in += is_in[c];
  }
  if (in == 0 || in == 4) return;
  const auto corner = [&](int c) { return p[static_cast<std::size_t>(c)]; };
  if (in == 2) {
    for (const auto& order : kTwoFirst) {
      if (!is_in[static_cast<std::size_t>(order[0])] || !is_in[static_cast<std::size_t>(order[1])])
        continue;
      const std::int64_t u = corner(order[0]), v = corner(order[1]);
      const std::int64_t w = corner(order[2]), x = corner(order[3]);
      const std::int32_t uw = cut.vertex(u, w), ux = cut.vertex(u, x);
      const std::int32_t vx = cut.vertex(v, x), vw = cut.vertex(v, w);
      cut.triangle(uw, ux, vx);
      cut.triangle(uw, vx, vw);
    }
    return;
  }
  for (const auto& order : kOneFirst) {
    if (is_in[static_cast<std::size_t>(order[0])] != (in == 1)) continue;
    const std::int64_t u = corner(order[0]);
    const std::int32_t a = cut.vertex(u, corner(order[1]));
    const std::int32_t b = cut.vertex(u, corner(order[2]));
    const std::int32_t c = cut.vertex(u, corner(order[3]));
    if (in == 1)
      cut.triangle(a, b, c);
    else
      cut.triangle(a, c, b);
  }
}

// The four tetrahedra around the edge from a middle to the next along an axis.
void cut_around(Cut& cut, const Int3& middle, std::size_t axis) {
  const ShellLattice& l = cut.lattice;
  const std::size_t y = (axis + 1) % 3, z = (axis + 2) % 3;
  Int3 beyond = middle;
  ++beyond[axis];
  const auto corner = [&](std::int64_t at_y, std::int64_t at_z) {
    Int3 c = beyond;
    c[y] += at_y;
    c[z] += at_z;
    return l.index(0, c[0], c[1], c[2]);
  };
  const std::array<std::int64_t, 4> ring{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
  const std::int64_t a = l.index(1, middle[0], middle[1], middle[2]);
  const std::int64_t b = l.index(1, beyond[0], beyond[1], beyond[2]);
  for (std::size_t m = 0; m < 4; ++m) cut_tetrahedron(cut, {a, b, ring[m], ring[(m + 1) % 4]});
}

}  // namespace

Vec3 ShellLattice::position(std::int64_t point) const {
  const std::int64_t i = point % count[0], rest = point / count[0];
  const std::int64_t j = rest % count[1], rest2 = rest / count[1];
  const double half = rest2 >= count[2] ? 0.5 : 0.0;
  return origin + cell * Vec3(static_cast<double>(i) + half, static_cast<double>(j) + half,
                              static_cast<double>(rest2 % count[2]) + half);
}

double lattice_points(const Vec3& extent, double cell, double offset) {
  double points = 2.0;
  for (int axis = 0; axis < 3; ++axis)
    points *= (extent[axis] + 2.0 * offset) / cell + 2.0 * kMargin + 2.0;
  return points;
}

std::optional<ShellLattice> build_shell_lattice(const TriangleMesh& mesh, const TriangleTree& tree,
                                                double cell, double offset, std::size_t most_near,
                                                const std::function<void(double)>& progress) {
  const Bounds bounds = bounds_of(mesh.positions);
  ShellLattice lattice;
  lattice.cell = cell;
  lattice.offset = offset;
  lattice.count = corner_counts(bounds.max - bounds.min, cell, offset);
  lattice.origin = bounds.min - Vec3::Constant(offset + kMargin * cell);
  Field field{mesh, tree, lattice, most_near, progress, {}};
  field.is_near.assign(at(lattice.points()), 0);
  measure(field);
  if (field.is_full()) return std::nullopt;
  flood(lattice, field.is_near);
  return lattice;
}

bool is_seen_from_outside(const ShellLattice& l, const Vec3& p) {
  const double reach = l.offset + l.cell;
  for (int kind = 0; kind < 2; ++kind) {
    const Vec3 middle = (p - l.origin) / l.cell - Vec3::Constant(0.5 * kind);
    Int3 low{}, high{};
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t a = static_cast<std::size_t>(axis);
      low[a] = std::max<std::int64_t>(
          0, static_cast<std::int64_t>(std::ceil(middle[axis] - reach / l.cell)));
      high[a] = std::min<std::int64_t>(
          l.count[a] - 1, static_cast<std::int64_t>(std::floor(middle[axis] + reach / l.cell)));
    }
    for (std::int64_t k = low[2]; k <= high[2]; ++k)
      for (std::int64_t j = low[1]; j <= high[1]; ++j)
        for (std::int64_t i = low[0]; i <= high[0]; ++i) {
          const std::int64_t point = l.index(kind, i, j, k);
          if (l.is_outside[at(point)] != 0 && (l.position(point) - p).norm() <= reach) return true;
        }
  }
  return false;
}

TriangleMesh cut_shell_lattice(const ShellLattice& l) {
  Cut cut{l, {}, {}};
  for (std::int64_t k = 0; k + 1 < l.count[2]; ++k)
    for (std::int64_t j = 0; j + 1 < l.count[1]; ++j)
      for (std::int64_t i = 0; i + 1 < l.count[0]; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) cut_around(cut, {i, j, k}, axis);
  return std::move(cut.mesh);
}

}  // namespace thigma::detail
