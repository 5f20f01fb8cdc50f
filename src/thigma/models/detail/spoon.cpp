// Two heights over one floor plan, the upper and the lower side of a thin sheet: both are meshed
// over the same places with the same diagonals, so their distance is positive everywhere and the
// surface cannot cross itself.

#include <algorithm>
#include <cmath>
#include <vector>

#include "thigma/math/elementary.h"
#include "thigma/models/detail/rings.h"
#include "thigma/models/detail/tableware.h"

namespace thigma::models {
namespace {

constexpr double kLength = 0.200;
constexpr double kBowlMiddle = 0.036;  // x of its greatest width
constexpr double kBowlHalfWidth = 0.021;
constexpr double kBowlDepth = 0.0085;
constexpr double kNeck = 0.074;  // x of the least width
constexpr double kNeckHalfWidth = 0.0034;
constexpr double kEndHalfWidth = 0.0095;
constexpr double kEndRounding = 0.010;  // length of the handle's round end
constexpr double kHandleRise = 0.016;

double squared(double x) { return x * x; }

double smooth_step(double x) {
  const double c = std::clamp(x, 0.0, 1.0);
  return c * c * (3.0 - 2.0 * c);
}

double half_width(double x) {
  if (x < kBowlMiddle)
    return kBowlHalfWidth * std::sqrt(std::max(0.0, 1.0 - squared(1.0 - x / kBowlMiddle)));
  if (x < kNeck) {
    return kBowlHalfWidth + (kNeckHalfWidth - kBowlHalfWidth) *
                                smooth_step((x - kBowlMiddle) / (kNeck - kBowlMiddle));
  }
  const double w = kNeckHalfWidth + (kEndHalfWidth - kNeckHalfWidth) *
                                        smooth_step((x - kNeck) / (0.9 * kLength - kNeck));
  const double past = std::max(0.0, (x - (kLength - kEndRounding)) / kEndRounding);
  return w * std::sqrt(std::max(0.0, 1.0 - squared(past)));
}

double half_thickness(double x) {
  const double neck = std::max(0.0, 1.0 - squared((x - kNeck) / 0.045));
  return 0.0009 + 0.0010 * squared(neck) + 0.0004 * smooth_step((x - kNeck) / 0.05);
}

/// Height of the sheet's middle at x and u = y / half_width.
double middle(double x, double u) {
  const double inside = std::max(0.0, 1.0 - squared((x - kBowlMiddle) / 0.038));
  const double bowl = kBowlDepth * inside * (1.0 - u * u);
  const double rise = kHandleRise * smooth_step((x - 0.055) / 0.075) -
                      0.10 * std::max(0.0, x - 0.12) * smooth_step((x - 0.12) / 0.05);
  return rise - bowl;
}

/// Place of station i of n along the spoon: closer towards both ends, where the outline turns.
double station(int i, int n) {
  const double first = 0.004;
  const double s = first + (1.0 - 2.0 * first) * i / n;
  const double clustered = 0.5 * (1.0 - cosine(kPi * s));
  return kLength *
         (0.45 * clustered + 0.55 * (s - first) / (1.0 - 2.0 * first) * (1.0 - 2e-4) + 0.55 * 1e-4);
}

}  // namespace

TriangleMesh make_spoon(int triangles) {
  const GridCounts counts = nearest_counts(triangles, 2.6, 2, 8, [](int around, int along) {
    return 2ll * around * along + 2ll * disc_triangles(around);
  });
  TriangleMesh mesh;
  std::vector<Ring> rings;
  for (int i = 0; i <= counts.along; ++i) {
    const double x = station(i, counts.along);
    std::vector<Vec3> section(counts.around);
    for (int j = 0; j <= counts.around / 2; ++j) {
      const SinCos a = sin_cos(2.0 * kPi * j / counts.around);
      const bool is_edge = j == 0 || 2 * j == counts.around;
      const double u = is_edge ? (j == 0 ? 1.0 : -1.0) : a.cos;
      const double lift = is_edge ? 0.0 : half_thickness(x) * a.sin * (2.0 - a.sin);
      const double y = half_width(x) * u;
      const double z = middle(x, u);
      section[(counts.around - j) % counts.around] = {x, y, z - lift};
      section[j] = {x, y, z + lift};
    }
    rings.push_back(add_ring(mesh, section));
  }
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    join_rings(mesh, rings[i], rings[i + 1], [&](int j) { return 2 * j >= counts.around; });
  }
  for (const bool at_end : {false, true}) {
    const Ring& ring = at_end ? rings.back() : rings.front();
    const double x = mesh.positions[ring.first].x();
    close_ring(mesh, ring, {x, 0.0, middle(x, 0.0)}, !at_end);
  }
  return mesh;
}

double spoon_neck() { return kNeck; }

}  // namespace thigma::models
