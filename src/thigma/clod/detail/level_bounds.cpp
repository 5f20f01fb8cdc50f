// Distances between patches of a level and the original triangles below their nodes. Searches run
// down the hierarchy itself, whose nodes bound those triangles. Over a triangle, distance to a
// convex set is convex, so its largest value to one triangle of the other side is at a corner: a
// bound that is exact where the two are of a size, and is reached by division where they are not.

#include "thigma/clod/detail/level_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "thigma/convex/quickhull.h"
#include "thigma/core/index.h"
#include "thigma/core/parallel.h"
#include "thigma/math/infinity.h"
#include "thigma/mesh/triangle_tree.h"

namespace thigma::detail {
namespace {

constexpr int kDivisions = 5;   // of a triangle into four, one after the other
constexpr double kTight = 2.0;  // a bound within this of the largest distance met is good
// Nor is one worth dividing that is below s, which counts in every sum it enters.

using Corners = std::array<Vec3, 3>;

Corners corners(const HullView& hull, int t) {
  const std::uint8_t* c = hull.triangles[t].corner;
  return {hull.vertices[c[0]], hull.vertices[c[1]], hull.vertices[c[2]]};
}

double distance(const Vec3& p, const Corners& t) {
  return point_triangle_distance(p, t[0], t[1], t[2]);
}

double farthest_corner(const Corners& of, const Corners& from) {
  return std::max({distance(of[0], from), distance(of[1], from), distance(of[2], from)});
}

/// The finest patches, and the boxes of their triangles in the order of hull_triangles.
struct Finest {
  const ClodHierarchy& hierarchy;
  std::vector<TreeBox> boxes;
};

Finest finest_of(const ClodHierarchy& hierarchy) {
  Finest finest{hierarchy, std::vector<TreeBox>(hierarchy.hull_triangles.size())};
  for (const ClodPatch& patch : hierarchy.patches) {
    const HullView leaf = hull_view(hierarchy, patch.node);
    for (int t = 0; t < leaf.triangle_count; ++t) {
      const Corners c = corners(leaf, t);
      finest.boxes[idx(patch.first_triangle + t)] = {c[0].cwiseMin(c[1]).cwiseMin(c[2]),
                                                     c[0].cwiseMax(c[1]).cwiseMax(c[2])};
    }
  }
  return finest;
}

/// A triangle of the finest patches.
struct Nearest {
  std::int32_t node = -1;
  int triangle = 0;
  double distance = kInfinity;
};

void search_leaf(const Finest& finest, std::int32_t node, const Vec3& p, Nearest& best) {
  const HullView leaf = hull_view(finest.hierarchy, node);
  const TreeBox* boxes =
      finest.boxes.data() + (leaf.triangles - finest.hierarchy.hull_triangles.data());
  double far2 = kFarther * best.distance * best.distance;
  for (int t = 0; t < leaf.triangle_count; ++t) {
    if (squared_distance(boxes[t], p) > far2) continue;
    const double d = distance(p, corners(leaf, t));
    if (d >= best.distance) continue;
    best = {node, t, d};
    far2 = kFarther * d * d;
  }
}

/// Least possible distance to the finest surface below a node.
double least_distance(const ClodNode& n, const Vec3& p) {
  return (p - n.center).norm() - n.radius - n.hausdorff;
}

// NOLINTNEXTLINE(misc-no-recursion): as deep as the tree.
void search_below(const Finest& finest, std::int32_t index, const Vec3& p, Nearest& best) {
  const std::vector<ClodNode>& nodes = finest.hierarchy.nodes;
  const ClodNode& n = nodes[idx(index)];
  if (n.child_count == 0) {
    search_leaf(finest, index, p, best);
    return;
  }
  std::int32_t first = n.first_child;
  double least = kInfinity;
  for (std::int32_t c = n.first_child; c < n.first_child + n.child_count; ++c) {
    const double d = least_distance(nodes[idx(c)], p);
    if (d < least) {
      least = d;
      first = c;
    }
  }
  if (least < best.distance) search_below(finest, first, p, best);
  for (std::int32_t c = n.first_child; c < n.first_child + n.child_count; ++c)
    if (c != first && least_distance(nodes[idx(c)], p) < best.distance)
      search_below(finest, c, p, best);
}

/// Nearest original triangle below a node. guess: one that may be near.
Nearest nearest_below(const Finest& finest, std::int32_t node, const Vec3& p,
                      const Nearest& guess) {
  Nearest best;
  if (guess.node >= 0) {
    best = guess;
    best.distance = distance(p, corners(hull_view(finest.hierarchy, guess.node), guess.triangle));
  }
  search_below(finest, node, p, best);
  return best;
}

/// What is measured of one contact patch.
struct PatchBounds {
  const Finest& finest;
  std::int32_t node;
  double deviation;  // s

  /// Largest distance of a part of the patch to the surface below. met: the largest distance of a
  /// point so far.
  double to_below(const Corners& part, int divisions, const Nearest& guess, double& met) const {
    const Vec3 center = (part[0] + part[1] + part[2]) / 3.0;
    const Nearest near = nearest_below(finest, node, center, guess);
    met = std::max(met, near.distance);
    double reach = 0.0;
    for (const Vec3& p : part) reach = std::max(reach, (p - center).norm());
    const double bound = std::min(
        near.distance + reach,
        farthest_corner(part, corners(hull_view(finest.hierarchy, near.node), near.triangle)));
    if (divisions == 0 || bound <= std::max(kTight * met, deviation)) return bound;
    const Vec3 ab = 0.5 * (part[0] + part[1]), bc = 0.5 * (part[1] + part[2]),
               ca = 0.5 * (part[2] + part[0]);
    const std::array<Corners, 4> parts = {
        {{part[0], ab, ca}, {ab, part[1], bc}, {ca, bc, part[2]}, {ab, bc, ca}}};
    double largest = 0.0;
    for (const Corners& q : parts)
      largest = std::max(largest, to_below(q, divisions - 1, near, met));
    return std::min(bound, largest);
  }

  /// Raises `largest` to the distance of everything below to the triangles of the patch.
  // NOLINTNEXTLINE(misc-no-recursion): as deep as the tree.
  void from_below(std::int32_t index, const HullView& patch, int& guess, double& largest) const {
    const ClodNode& n = finest.hierarchy.nodes[idx(index)];
    for (std::int32_t c = n.first_child; c < n.first_child + n.child_count; ++c)
      from_below(c, patch, guess, largest);
    if (n.child_count > 0) return;
    const HullView leaf = hull_view(finest.hierarchy, index);
    for (int t = 0; t < leaf.triangle_count; ++t) {
      const Corners fine = corners(leaf, t);
      double bound = farthest_corner(fine, corners(patch, guess));
      for (int k = 0; k < patch.triangle_count && bound > largest; ++k) {
        const Corners coarse = corners(patch, k);
        double other = 0.0;
        for (std::size_t i = 0; i < 3 && other < bound; ++i)
          other = std::max(other, distance(fine[i], coarse));
        if (other >= bound) continue;
        bound = other;
        guess = k;
      }
      largest = std::max(largest, bound);
    }
  }
};

float round_up(double x) {
  const auto f = static_cast<float>(x);
  return static_cast<double>(f) < x ? std::nextafterf(f, std::numeric_limits<float>::infinity())
                                    : f;
}

void measure_patch(const Finest& finest, ClodHierarchy& hierarchy, LevelPatch& c) {
  const double rounding = 1e-12 * hierarchy.radius;
  const PatchBounds bounds{finest, c.patch.node, c.deviation};
  const HullView patch = level_surface(hierarchy, c.patch.node);
  int guess = 0;
  bounds.from_below(c.patch.node, patch, guess, c.from_below);
  c.from_below += rounding;
  Nearest near;
  for (int v = 0; v < patch.vertex_count; ++v) {
    near = nearest_below(finest, c.patch.node, patch.vertices[v], near);
    const double d = near.distance + rounding;
    hierarchy.vertex_to_below[idx(c.first_vertex + v)] = round_up(d);
    c.to_below = std::max(c.to_below, d);
  }
  for (int t = 0; t < patch.triangle_count; ++t) {
    double met = 0.0;
    for (const std::uint8_t v : patch.triangles[t].corner)
      met = std::max(met, static_cast<double>(hierarchy.vertex_to_below[idx(c.first_vertex) + v]));
    const double d =
        std::max(met, bounds.to_below(corners(patch, t), kDivisions, near, met) + rounding);
    hierarchy.triangle_to_below[idx(c.patch.first_triangle + t)] = round_up(d);
    c.to_below = std::max(c.to_below, static_cast<double>(round_up(d)));
  }
  c.hausdorff = std::max({c.hausdorff, c.from_below - c.deviation, c.to_below - c.deviation,
                          hierarchy.nodes[idx(c.patch.node)].hausdorff - c.deviation});
}

}  // namespace

void measure_level_bounds(int threads, ClodHierarchy& hierarchy) {
  if (hierarchy.level_patches.empty()) return;
  hierarchy.vertex_to_below.assign(hierarchy.vertices.size(), 0.0f);
  hierarchy.triangle_to_below.assign(hierarchy.hull_triangles.size(), 0.0f);
  const Finest finest = finest_of(hierarchy);
  for_each_piece(hierarchy.level_patches.size(), threads, [&](std::size_t i) {
    if (hierarchy.level_patches[i].patch.node >= 0)
      measure_patch(finest, hierarchy, hierarchy.level_patches[i]);
  });
}

}  // namespace thigma::detail
