#pragma once
// Usable meshes with triangles that have no area, or hardly any: what scanners and CAD exports
// leave behind.

#include <algorithm>
#include <array>
#include <cstdint>

#include "thigma/math/random.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::test {

/// Puts a vertex on an edge of one of its two triangles alone: that one parts in two, and a
/// triangle without an area, but for rounding and `off`, closes the gap to the other.
///
/// share   of the edge from its first end, 0 to 1
/// off     moved out of the edge by this [m]
inline void add_flat_triangle(TriangleMesh& mesh, std::size_t triangle, std::size_t side,
                              double share, const Vec3& off = Vec3::Zero()) {
  const auto corner = [&](std::size_t k) { return mesh.triangles[triangle][(side + k) % 3]; };
  const std::int32_t a = corner(0), b = corner(1), c = corner(2);
  const auto m = static_cast<std::int32_t>(mesh.positions.size());
  const Vec3 from = mesh.positions[static_cast<std::size_t>(a)],
             to = mesh.positions[static_cast<std::size_t>(b)];
  mesh.positions.push_back(from + share * (to - from) + off);
  mesh.triangles[triangle] = {a, m, c};
  mesh.triangles.push_back({m, b, c});
  mesh.triangles.push_back({a, b, m});
}

/// Moves one corner of a triangle onto its opposite side: the triangle has no area but for
/// rounding, at the size of its neighbours.
inline void flatten(TriangleMesh& mesh, std::size_t triangle, std::size_t side, double share) {
  const auto corner = [&](std::size_t k) -> Vec3& {
    return mesh.positions[static_cast<std::size_t>(mesh.triangles[triangle][(side + k) % 3])];
  };
  corner(2) = (1.0 - share) * corner(0) + share * corner(1);
}

/// A triangle of three points of a line, on its own.
inline void add_stray(TriangleMesh& mesh, const Vec3& from, const Vec3& to) {
  const auto n = static_cast<std::int32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {from, 0.5 * (from + to), to});
  mesh.triangles.push_back({n, n + 1, n + 2});
}

/// Flat triangles, slivers and vertices that nearly coincide, at `count` random places, on top of
/// each other too.
inline void add_random_flaws(TriangleMesh& mesh, Random& random, int count, double radius) {
  for (int i = 0; i < count; ++i) {
    const std::size_t recent = std::min<std::size_t>(mesh.triangles.size(), 6);
    const std::size_t t = random.below(3) == 0 ? mesh.triangles.size() - 1 - random.below(recent)
                                               : random.below(mesh.triangles.size());
    const double share =
        std::array{0.5, 0.25, 1e-9, 1.0 - 1e-12, 3e-16, random.uniform(0.0, 1.0)}[random.below(6)];
    const double off = std::array{0.0, 0.0, 1e-16, 1e-13, 1e-9, 1e-6}[random.below(6)] * radius;
    const std::uint64_t kind = random.below(5);
    if (kind == 0)
      add_stray(mesh, radius * random.in_cube(1.0), radius * random.in_cube(1.0));
    else if (kind == 1)
      flatten(mesh, t, random.below(3), share);
    else
      add_flat_triangle(mesh, t, random.below(3), share, off * random.in_cube(1.0));
  }
}

}  // namespace thigma::test
