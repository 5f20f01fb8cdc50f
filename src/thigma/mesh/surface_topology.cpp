#include "thigma/mesh/surface_topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "thigma/mesh/predicates.h"

namespace thigma {
namespace {

struct Side {  // one triangle's use of an edge
  std::int32_t low, high, triangle;
  std::int8_t slot;
  bool is_forward;  // low -> high
};

std::int32_t find_root(std::vector<std::int32_t>& parent, std::int32_t i) {
  while (parent[static_cast<std::size_t>(i)] != i) {
    auto& up = parent[static_cast<std::size_t>(i)];
    up = parent[static_cast<std::size_t>(up)];
    i = up;
  }
  return i;
}

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k) {
      const std::int32_t a = mesh.triangles[t][static_cast<std::size_t>(k)];
      const std::int32_t b = mesh.triangles[t][static_cast<std::size_t>((k + 1) % 3)];
      sides.push_back({std::min(a, b), std::max(a, b), static_cast<std::int32_t>(t),
                       static_cast<std::int8_t>(k), a < b});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    if (a.low != b.low) return a.low < b.low;
    if (a.high != b.high) return a.high < b.high;
    return a.triangle != b.triangle ? a.triangle < b.triangle : a.slot < b.slot;
  });
  return sides;
}

bool edge_passes(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  const int sp = orient3d(t[0], t[1], t[2], p);
  if (sp == 0 || orient3d(t[0], t[1], t[2], q) != -sp) return false;
  const int turn = orient3d(p, q, t[0], t[1]);
  return turn != 0 && orient3d(p, q, t[1], t[2]) == turn && orient3d(p, q, t[2], t[0]) == turn;
}

}  // namespace

SurfaceTopology compute_topology(const TriangleMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  SurfaceTopology surface;
  surface.neighbor.assign(count, {-1, -1, -1});
  surface.shell.resize(count);
  surface.normal.assign(count, Vec3::Zero());
  surface.height.assign(count, 0.0);
  std::iota(surface.shell.begin(), surface.shell.end(), 0);
  const std::vector<Side> sides = sorted_sides(mesh);
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i + 1;
    for (; j < sides.size() && sides[j].low == sides[i].low && sides[j].high == sides[i].high;
         ++j) {
      const std::int32_t a = find_root(surface.shell, sides[i].triangle);
      const std::int32_t b = find_root(surface.shell, sides[j].triangle);
      surface.shell[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    const Side &one = sides[i], &other = sides[j - 1];
    if (j == i + 2 && one.is_forward != other.is_forward && one.triangle != other.triangle) {
      surface.neighbor[static_cast<std::size_t>(one.triangle)][static_cast<std::size_t>(one.slot)] =
          other.triangle;
      surface.neighbor[static_cast<std::size_t>(other.triangle)]
                      [static_cast<std::size_t>(other.slot)] = one.triangle;
    }
    i = j;
  }
  for (std::size_t t = 0; t < count; ++t) {
    surface.shell[t] = find_root(surface.shell, static_cast<std::int32_t>(t));
    const auto& v = mesh.triangles[t];
    const Vec3& a = mesh.positions[static_cast<std::size_t>(v[0])];
    const Vec3 ab = mesh.positions[static_cast<std::size_t>(v[1])] - a;
    const Vec3 ac = mesh.positions[static_cast<std::size_t>(v[2])] - a;
    const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (ac - ab).squaredNorm()});
    const Vec3 cross = ab.cross(ac);
    const double length = cross.norm();
    // Below this the direction of the normal is rounding alone.
    if (!(length > 1e-15 * longest2)) continue;
    surface.normal[t] = cross / length;
    surface.height[t] = length / std::sqrt(longest2);
  }
  return surface;
}

bool triangles_cross(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (edge_passes(a[k], a[(k + 1) % 3], b) || edge_passes(b[k], b[(k + 1) % 3], a)) return true;
  return false;
}

}  // namespace thigma
