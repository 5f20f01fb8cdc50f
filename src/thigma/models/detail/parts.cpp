#include "thigma/models/detail/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <vector>

#include "thigma/math/elementary.h"
#include "thigma/mesh/shapes.h"
#include "thigma/models/detail/rings.h"

namespace thigma::models {
namespace {

/// Corners joined by straight pieces, cut into `cells` segments in all: always the longest so far
/// gets another.
std::vector<Vec2> cut_into(const std::vector<Vec2>& corners, int cells) {
  const int pieces = static_cast<int>(corners.size()) - 1;
  std::vector<double> length(pieces);
  for (int i = 0; i < pieces; ++i)
    length[i] = std::sqrt((corners[i + 1] - corners[i]).squaredNorm());
  std::vector<int> cuts(pieces, 1);
  for (int n = pieces; n < cells; ++n) {
    int longest = 0;
    for (int i = 1; i < pieces; ++i) {
      if (length[i] * cuts[longest] > length[longest] * cuts[i]) longest = i;
    }
    ++cuts[longest];
  }
  std::vector<Vec2> points = {corners.front()};
  for (int i = 0; i < pieces; ++i) {
    const Vec2 step = corners[i + 1] - corners[i];
    for (int k = 1; k < cuts[i]; ++k)
      points.push_back(corners[i] + step * (static_cast<double>(k) / cuts[i]));
    points.push_back(corners[i + 1]);
  }
  return points;
}

/// Solid between an outer and an inner outline (radius over the turn), its section a rectangle of
/// four sides.
struct RingSolid {
  double height, width, mean_radius;  // [m]
  std::function<double(double)> outer, inner;
  int around_step;  // that suits the outline's symmetry
};

TriangleMesh ring_solid(int triangles, const RingSolid& ring) {
  const double height = ring.height, width = ring.width;
  const double ratio = 2.0 * (height + width) / (2.0 * kPi * ring.mean_radius);
  const auto total = [](int around, int along) { return 2ll * around * std::max(along, 4); };
  GridCounts counts =
      nearest_counts(triangles, ratio, ring.around_step, 3 * ring.around_step, total);
  // Small counts are met only without the symmetry.
  if (std::llabs(total(counts.around, counts.along) - triangles) * 100 > triangles) {
    counts = nearest_counts(triangles, ratio, 1, 2 * ring.around_step, total);
  }
  const int rows = std::max(counts.along, 4);
  // Shares of the rows: outside and inside by height, top and bottom by width, at least one each.
  const int upright =
      std::clamp(static_cast<int>(0.5 * rows * height / (height + width) + 0.5), 1, rows / 2 - 1);
  const int top = rows / 2 - upright;
  const int bottom = rows - 2 * upright - top;
  return make_grid(rows, counts.around, GridEnds::both_joined, [&](int i, int j) {
    const double turn = 2.0 * kPi * j / counts.around;
    const SinCos a = sin_cos(turn);
    const double out = ring.outer(turn);
    const double in = ring.inner(turn);
    double r = out;
    double z = -0.5 * height;
    if (i < upright) {
      z += height * i / upright;
    } else if (i < upright + top) {
      r += (in - out) * (i - upright) / top;
      z = 0.5 * height;
    } else if (i < 2 * upright + top) {
      r = in;
      z = 0.5 * height - height * (i - upright - top) / upright;
    } else {
      r = in + (out - in) * (i - 2 * upright - top) / bottom;
    }
    return Vec3(r * a.cos, r * a.sin, z);
  });
}

}  // namespace

// The two bands at the poles are of single triangles.
TriangleMesh make_turned_near(const std::vector<Vec2>& corners, int triangles,
                              double wished_ratio) {
  const GridCounts counts =
      nearest_counts(triangles, wished_ratio, 1, 3, [&](int around, int along) {
        return 2ll * around * (std::max(along, static_cast<int>(corners.size()) - 1) - 1);
      });
  return make_revolution(
      cut_into(corners, std::max(counts.along, static_cast<int>(corners.size()) - 1)),
      counts.around);
}

TriangleMesh make_ellipsoid_near(const Vec3& semi_axes, int triangles) {
  const int frequency = std::max(1, static_cast<int>(std::sqrt(triangles / 20.0) + 0.5));
  if (std::abs(20 * frequency * frequency - triangles) * 100 <= triangles)
    return make_ellipsoid(semi_axes, frequency);
  const GridCounts counts = nearest_counts(
      triangles, 0.5, 1, 3, [](int around, int along) { return 2ll * around * (along - 1); });
  return make_polar_ellipsoid(semi_axes, counts.around, counts.along);
}

TriangleMesh make_box_near(const Vec3& size, int triangles) {
  // The common edge length gives one count of segments an axis; their neighbours are tried for the
  // nearest total.
  const double area = 2.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
  const double edge = std::sqrt(2.0 * area / triangles);
  std::array<int, 3> best = {1, 1, 1};
  long long best_off = -1;
  for (int code = 0; code < 5 * 5 * 5; ++code) {
    const std::array<int, 3> off = {code % 5 - 2, code / 5 % 5 - 2, code / 25 - 2};
    std::array<int, 3> n;
    for (int a = 0; a < 3; ++a) n[a] = std::max(1, static_cast<int>(size[a] / edge + 0.5) + off[a]);
    const long long total = 4ll * (1ll * n[0] * n[1] + 1ll * n[1] * n[2] + 1ll * n[2] * n[0]);
    const long long distance = std::llabs(total - triangles);
    if (best_off < 0 || distance < best_off) {
      best = n;
      best_off = distance;
    }
  }
  return make_box(size, best);
}

TriangleMesh make_cylinder_near(double radius, double height, int triangles) {
  const double h = 0.5 * height;
  return make_turned_near({{0.0, -h}, {radius, -h}, {radius, h}, {0.0, h}}, triangles,
                          (2.0 * radius + height) / (2.0 * kPi * radius));
}

TriangleMesh make_cone_near(double radius, double height, int triangles) {
  const double h = 0.5 * height;
  const double side = std::sqrt(radius * radius + height * height);
  return make_turned_near({{0.0, -h}, {radius, -h}, {0.0, h}}, triangles,
                          (radius + side) / (2.0 * kPi * radius));
}

TriangleMesh make_probe(int triangles) {
  constexpr double kRadius = 0.010, kHalf = 0.050;
  constexpr int kArc = 16;  // segments of the tip
  std::vector<Vec2> profile = {{0.0, -kHalf}};
  for (int k = 1; k <= kArc; ++k) {
    const SinCos a = sin_cos(0.5 * kPi * k / kArc);
    profile.emplace_back(kRadius * a.sin, kRadius * (1.0 - a.cos) - kHalf);
  }
  profile.emplace_back(kRadius, kHalf);
  profile.emplace_back(0.0, kHalf);
  return make_turned_near(profile, triangles, (0.5 * kPi * kRadius + 0.1) / (2.0 * kPi * kRadius));
}

TriangleMesh make_torus_near(double major_radius, double minor_radius, int triangles) {
  const GridCounts counts =
      nearest_counts(triangles, minor_radius / major_radius, 1, 3,
                     [](int around, int across) { return 2ll * around * std::max(across, 3); });
  return make_torus(major_radius, minor_radius, counts.around, std::max(counts.along, 3));
}

TriangleMesh make_gear(int triangles) {
  constexpr int kTeeth = 20;
  const auto outline = [](double turn) {
    // A rounded trapezoid wave: steep flanks, flat tips and roots.
    const double wave = cosine(kTeeth * turn);
    const double steep = 3.0 * wave / std::sqrt(1.0 + 8.0 * wave * wave);
    return 0.0225 + 0.0025 * steep;
  };
  const auto bore = [](double) { return 0.005; };
  return ring_solid(triangles, {0.008, 0.0175, 0.014, outline, bore, kTeeth});
}

TriangleMesh make_peg(int triangles) {
  return make_turned_near(
      {{0.0, -0.025}, {0.006, -0.025}, {0.008, -0.023}, {0.008, 0.025}, {0.0, 0.025}}, triangles,
      0.066 / (2.0 * kPi * 0.008));
}

TriangleMesh make_hole(int triangles) {
  const auto square = [](double turn) {
    const SinCos a = sin_cos(turn);
    return 0.025 / std::max(std::fabs(a.sin), std::fabs(a.cos));
  };
  const auto bore = [](double) { return 0.0082; };
  return ring_solid(triangles, {0.020, 0.0168, 0.0166, square, bore, 4});
}

}  // namespace thigma::models
