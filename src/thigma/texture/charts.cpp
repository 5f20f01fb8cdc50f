// Charts grow from large triangles over edges while the normals stay within a cone, are flattened,
// and are halved along their longer side as long as that fails. Packed in shelves, at the largest
// scale that fits.
#include "thigma/texture/charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

#include "thigma/core/error.h"
#include "thigma/core/index.h"
#include "thigma/math/elementary.h"
#include "thigma/mesh/topology.h"
#include "thigma/texture/detail/flatten_chart.h"
#include "thigma/texture/haptic_texture.h"

namespace thigma {
namespace {

using detail::FlatChart;

struct Surface {
  const TriangleMesh& mesh;
  EdgeTable edges;
  std::vector<Vec3> normals;  // times twice the area
};

Surface prepare(const TriangleMesh& mesh, const std::string& name) {
  Surface surface{mesh, build_edge_table(mesh), {}};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& v = mesh.triangles[t];
    const Vec3 a = mesh.positions[idx(v[1])] - mesh.positions[idx(v[0])];
    const Vec3 b = mesh.positions[idx(v[2])] - mesh.positions[idx(v[0])];
    surface.normals.push_back(a.cross(b));
    constexpr double kFlat = 1e-8;  // of the edges' product: below, a chart of it has no shape
    if (!(surface.normals.back().norm() > kFlat * a.norm() * b.norm()))
      throw InputError(name + ": no area, triangle " + std::to_string(t) +
                       ", expected a coarse surface without needles");
  }
  return surface;
}

template <class Visit>
void visit_neighbours(const Surface& surface, std::int32_t t, const Visit& visit) {
  for (const std::int32_t e : surface.edges.of_triangle[idx(t)]) {
    const MeshEdge& edge = surface.edges.edges[idx(e)];
    if (edge.use_count != 2) continue;
    for (const EdgeUse& use : surface.edges.uses_of(edge))
      if (use.triangle != t) visit(use.triangle);
  }
}

/// Connected triangles among those that `is_free` allows, from a seed, within a cone of normals.
/// They are taken.
std::vector<std::int32_t> grow(const Surface& surface, std::int32_t seed, double cone,
                               std::vector<char>& is_free) {
  struct Candidate {
    double off = 0.0;
    std::int32_t triangle = -1;
    bool operator<(const Candidate& o) const {
      return off != o.off ? off > o.off : triangle > o.triangle;
    }
  };
  std::vector<std::int32_t> chart;
  Vec3 mean = Vec3::Zero();
  std::priority_queue<Candidate> queue;
  queue.push({0.0, seed});
  while (!queue.empty()) {
    const std::int32_t t = queue.top().triangle;
    queue.pop();
    if (!is_free[idx(t)]) continue;
    const Vec3& normal = surface.normals[idx(t)];
    if (!chart.empty() && normal.dot(mean) < cone * normal.norm() * mean.norm()) continue;
    is_free[idx(t)] = 0;
    chart.push_back(t);
    mean += normal;
    visit_neighbours(surface, t, [&](std::int32_t other) {
      if (!is_free[idx(other)]) return;
      const Vec3& n = surface.normals[idx(other)];
      const double size = n.norm() * mean.norm();
      queue.push({size > 0.0 ? 1.0 - n.dot(mean) / size : 1.0, other});
    });
  }
  return chart;
}

Vec3 middle(const Surface& surface, std::int32_t t) {
  const auto& v = surface.mesh.triangles[idx(t)];
  return (surface.mesh.positions[idx(v[0])] + surface.mesh.positions[idx(v[1])] +
          surface.mesh.positions[idx(v[2])]) /
         3.0;
}

/// Both sides of the plane through the middle of a chart, across its longest extent.
std::array<std::vector<std::int32_t>, 2> halve(const Surface& surface,
                                               const std::vector<std::int32_t>& chart) {
  Vec3 low = middle(surface, chart[0]), high = low;
  for (const std::int32_t t : chart) {
    low = low.cwiseMin(middle(surface, t));
    high = high.cwiseMax(middle(surface, t));
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  std::vector<std::int32_t> sorted = chart;
  std::sort(sorted.begin(), sorted.end(), [&](std::int32_t a, std::int32_t b) {
    const double x = middle(surface, a)[axis], y = middle(surface, b)[axis];
    return x != y ? x < y : a < b;
  });
  const auto cut = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  return {std::vector<std::int32_t>(sorted.begin(), cut),
          std::vector<std::int32_t>(cut, sorted.end())};
}

struct Chart {
  std::vector<std::int32_t> triangles;
  FlatChart flat;
};

/// Flattens a chart, or its connected halves.
void add_charts(const Surface& surface, const ChartParams& params,
                std::vector<std::int32_t> triangles, std::vector<Chart>& charts) {
  FlatChart flat = detail::flatten_chart(surface.mesh, triangles);
  if (flat.is_usable && (flat.stretch <= params.most_stretch || triangles.size() == 1)) {
    charts.push_back({std::move(triangles), std::move(flat)});
    return;
  }
  std::vector<char> is_free(surface.mesh.triangles.size(), 0);
  for (const std::vector<std::int32_t>& half : halve(surface, triangles)) {
    for (const std::int32_t t : half) is_free[idx(t)] = 1;
    for (const std::int32_t t : half)
      if (is_free[idx(t)]) add_charts(surface, params, grow(surface, t, -1.0, is_free), charts);
  }
}

std::vector<Chart> segment(const Surface& surface, const ChartParams& params) {
  std::vector<std::int32_t> by_area(surface.mesh.triangles.size());
  std::iota(by_area.begin(), by_area.end(), 0);
  std::sort(by_area.begin(), by_area.end(), [&](std::int32_t a, std::int32_t b) {
    const double x = surface.normals[idx(a)].squaredNorm(),
                 y = surface.normals[idx(b)].squaredNorm();
    return x != y ? x > y : a < b;
  });
  std::vector<char> is_free(surface.mesh.triangles.size(), 1);
  std::vector<Chart> charts;
  for (const std::int32_t seed : by_area) {
    if (!is_free[idx(seed)]) continue;
    add_charts(surface, params, grow(surface, seed, params.widest_cone, is_free), charts);
  }
  return charts;
}

Vec2 turned(const Vec2& p, const SinCos& turn) {
  return {turn.cos * p.x() - turn.sin * p.y(), turn.sin * p.x() + turn.cos * p.y()};
}

/// Turns a chart so that its box is small and no higher than wide; moves its corner to the origin.
Vec2 lay_flat(FlatChart& flat) {
  constexpr int kTurns = 32;  // of a quarter turn
  double least = std::numeric_limits<double>::infinity();
  SinCos best;
  Vec2 corner = Vec2::Zero(), size = Vec2::Zero();
  for (int i = 0; i < 2 * kTurns; ++i) {
    const SinCos turn = sin_cos(0.5 * kPi * i / kTurns);
    Vec2 low = turned(flat.at[0][0], turn), high = low;
    for (const auto& triangle : flat.at) {
      for (const Vec2& p : triangle) {
        low = low.cwiseMin(turned(p, turn));
        high = high.cwiseMax(turned(p, turn));
      }
    }
    const Vec2 box = high - low;
    if (box.y() > box.x() || !(box.prod() < least)) continue;
    least = box.prod();
    best = turn;
    corner = low;
    size = box;
  }
  for (auto& triangle : flat.at)
    for (Vec2& p : triangle) p = turned(p, best) - corner;
  return size;
}

struct Packing {
  bool is_fitting = false;
  std::vector<Vec2> place;  // of each chart's corner [texels]
};

/// Shelves from the highest chart to the lowest, at a scale in texels a metre.
Packing pack(const std::vector<Vec2>& sizes, const std::vector<std::int32_t>& order, double scale,
             const ChartParams& params) {
  Packing packing;
  packing.place.resize(sizes.size());
  double x = 0.0, y = 0.0, shelf = 0.0;
  const double border = 2.0 * params.gutter + 1.0, side = params.texels;
  for (const std::int32_t i : order) {
    const double width = std::ceil(scale * sizes[idx(i)].x()) + border;
    const double height = std::ceil(scale * sizes[idx(i)].y()) + border;
    if (x + width > side) {
      x = 0.0;
      y += shelf;
      shelf = 0.0;
    }
    if (width > side || y + height > side) return packing;
    packing.place[idx(i)] = Vec2(x + params.gutter, y + params.gutter);
    x += width;
    shelf = std::max(shelf, height);
  }
  packing.is_fitting = true;
  return packing;
}

}  // namespace

ChartMap make_charts(const TriangleMesh& mesh, const ChartParams& params, const std::string& name) {
  const Surface surface = prepare(mesh, name);
  std::vector<Chart> charts = segment(surface, params);
  std::vector<Vec2> sizes;
  double area = 0.0;
  for (Chart& chart : charts) sizes.push_back(lay_flat(chart.flat));
  for (const Vec3& normal : surface.normals) area += 0.5 * normal.norm();
  std::vector<std::int32_t> order(charts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
    return sizes[idx(a)].y() > sizes[idx(b)].y();
  });
  double low = 0.0, high = params.texels / std::sqrt(area);
  if (!pack(sizes, order, low, params).is_fitting)
    throw InputError(name + ": " + std::to_string(charts.size()) + " charts in " +
                     std::to_string(params.texels) + " x " + std::to_string(params.texels) +
                     " texels, in the map, expected a coarser surface or more texels");
  constexpr int kBits = 30;
  for (int i = 0; i < kBits; ++i) {
    const double scale = 0.5 * (low + high);
    (pack(sizes, order, scale, params).is_fitting ? low : high) = scale;
  }
  const Packing packing = pack(sizes, order, low, params);
  ChartMap map;
  map.corners.resize(mesh.triangles.size());
  map.chart.resize(mesh.triangles.size());
  map.count = static_cast<std::int32_t>(charts.size());
  map.texels_per_metre = low;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    map.distortion_max = std::max(map.distortion_max, charts[i].flat.stretch);
    for (std::size_t k = 0; k < charts[i].triangles.size(); ++k) {
      const std::size_t t = idx(charts[i].triangles[k]);
      map.chart[t] = static_cast<std::int32_t>(i);
      for (std::size_t c = 0; c < 3; ++c)
        map.corners[t][c] = packing.place[i] + low * charts[i].flat.at[k][c];
    }
  }
  return map;
}

}  // namespace thigma
