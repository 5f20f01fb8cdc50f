#pragma once
// Meshes that nobody would model: what a build has to survive.

#include <array>
#include <limits>

#include "support/wavy_ball.h"

#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma::test {

inline TriangleMesh waved_ball(int frequency) { return wavy_ball_of(frequency, 1.0, 0.12); }

inline TriangleMesh base_of_broken_mesh(Random& random, bool is_large) {
  const int n = is_large ? 3 : 1;
  switch (random.below(6)) {
    case 0:
      return waved_ball(3 * n);
    case 1:
      return make_torus(1.0, 0.4, 12 * n, 8 * n);
    case 2:
      return make_sheet(1, 1, 8 * n, 8 * n);
    case 3:
      return make_dome(1.0, 12 * n, 5 * n);
    case 4:
      return make_moebius(1.0, 0.6, 16 * n, 3 * n);
    default:
      return joined(make_box({1, 1, 1}, {3 * n, 3 * n, 3 * n}), make_hollow_ball(0.6, 0.5, 2 * n));
  }
}

/// Noise up to folds, squashed flat or to a line, coinciding vertices, single precision, holes,
/// edges of three faces, faces turned over, any scale. Positions finite, indices in range; at most
/// 5,000 triangles. Same number, same mesh.
inline TriangleMesh broken_mesh(int number) {
  Random random(7000 + static_cast<std::uint64_t>(number));
  const bool is_large = random.below(8) == 0;
  TriangleMesh mesh = base_of_broken_mesh(random, is_large);
  const double noise = std::array{0.0, 0.01, 0.3}[random.below(3)];
  const Vec3 squash(1, std::array{1.0, 1.0, 1e-3, 0.0}[random.below(4)],
                    std::array{1.0, 1.0, 1.0, 1.0, 0.0}[random.below(5)]);
  const double scale = std::array{1.0, 1e-9, 1e6}[random.below(3)];
  const Quat turn = random.orientation();
  const bool is_single = random.below(2) == 0;
  const std::uint64_t rarity = std::array{20, 200, 1000000}[random.below(3)];
  for (Vec3& p : mesh.positions) {
    p = turn * (p + noise * random.in_cube(1.0)).cwiseProduct(squash);
    if (is_single) p = p.cast<float>().cast<double>();
    p *= scale;
  }
  for (Vec3& p : mesh.positions)
    if (random.below(rarity) == 0) p = mesh.positions[random.below(mesh.positions.size())];
  for (auto& t : mesh.triangles)
    if (random.below(3 * rarity) == 0) t = mesh.triangles[random.below(mesh.triangles.size())];
  for (auto& t : mesh.triangles)
    if (random.below(3 * rarity) == 0) std::swap(t[0], t[1]);
  for (auto& t : mesh.triangles)
    if (random.below(3 * rarity) == 0)
      t[random.below(3)] = static_cast<std::int32_t>(random.below(mesh.positions.size()));
  return mesh;
}

/// One number or index of the mesh made impossible.
inline TriangleMesh with_impossible_value(TriangleMesh mesh, int number) {
  Random random(9000 + static_cast<std::uint64_t>(number));
  const std::size_t vertex = random.below(mesh.positions.size());
  const std::size_t triangle = random.below(mesh.triangles.size());
  switch (random.below(4)) {
    case 0:
      mesh.positions[vertex].x() = std::numeric_limits<double>::quiet_NaN();
      break;
    case 1:
      mesh.positions[vertex].y() = std::numeric_limits<double>::infinity();
      break;
    case 2:
      mesh.triangles[triangle][1] = -1;
      break;
    default:
      mesh.triangles[triangle][2] = static_cast<std::int32_t>(mesh.positions.size());
  }
  return mesh;
}

}  // namespace thigma::test
