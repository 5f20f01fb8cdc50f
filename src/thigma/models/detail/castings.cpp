#include "thigma/models/detail/castings.h"

#include <cmath>
#include <vector>

#include "thigma/math/elementary.h"
#include "thigma/models/detail/parts.h"

namespace thigma::models {
namespace {

constexpr double kRim = 0.030;     // mean radius of a flange [m]
constexpr double kPlain = 0.022;   // within this all is round [m]
constexpr double kLobe = 0.003;    // that the rim goes out and in [m]
constexpr double kThick = 0.009;   // of a flange [m]
constexpr double kSpigot = 0.014;  // radius [m]
constexpr double kPlay = 0.0003;   // of the socket around it [m]

double length_of(const std::vector<Vec2>& corners) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const Vec2 step = corners[i + 1] - corners[i];
    sum += std::sqrt(step.squaredNorm());
  }
  return sum;
}

/// Turned, then with three lobes at the rim; its faces stay planes.
TriangleMesh make_flange(const std::vector<Vec2>& corners, int triangles) {
  TriangleMesh mesh =
      make_turned_near(corners, triangles, length_of(corners) / (2.0 * kPi * 0.6 * kRim));
  for (Vec3& p : mesh.positions) {
    const double radius = std::sqrt(p.x() * p.x() + p.y() * p.y());
    if (radius <= kPlain) continue;
    const double x = p.x() / radius, y = p.y() / radius;
    const double lobes = x * x * x - 3.0 * x * y * y;  // the cosine of three turns
    const double out = kLobe * (radius - kPlain) / (kRim - kPlain) * lobes;
    p.x() += out * x;
    p.y() += out * y;
  }
  return mesh;
}

}  // namespace

TriangleMesh make_flange_spigot(int triangles) {
  return make_flange({{0.0, -0.012},
                      {kSpigot - 0.001, -0.012},
                      {kSpigot, -0.010},
                      {kSpigot, 0.0},
                      {kRim, 0.0},
                      {kRim, kThick},
                      {0.013, kThick},
                      {0.012, 0.025},
                      {0.0, 0.025}},
                     triangles);
}

TriangleMesh make_flange_socket(int triangles) {
  constexpr double kBore = kSpigot + kPlay;
  return make_flange({{0.0, -0.026},
                      {0.020, -0.026},
                      {0.021, -kThick},
                      {kRim, -kThick},
                      {kRim, 0.0},
                      {kBore + 0.0017, 0.0},
                      {kBore, -0.0017},
                      {kBore, -0.014},
                      {0.0, -0.014}},
                     triangles);
}

}  // namespace thigma::models
