#include "thigma/texture/detail/texel_owners.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "thigma/math/plane_cross.h"

namespace thigma::detail {
namespace {

double segment_distance(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 way = b - a;
  const double share = std::clamp(way.dot(p - a) / way.squaredNorm(), 0.0, 1.0);
  return (a + share * way - p).norm();
}

double distance_to(const std::array<Vec2, 3>& c, const Vec2& p) {
  if (corner_weights(c, p).minCoeff() >= 0.0) return 0.0;
  return std::min({segment_distance(c[0], c[1], p), segment_distance(c[1], c[2], p),
                   segment_distance(c[2], c[0], p)});
}

}  // namespace

Vec3 corner_weights(const std::array<Vec2, 3>& c, const Vec2& at) {
  const double area = cross(c[1] - c[0], c[2] - c[0]);
  return {cross(c[2] - c[1], at - c[1]) / area, cross(c[0] - c[2], at - c[2]) / area,
          cross(c[1] - c[0], at - c[0]) / area};
}

TexelOwners find_texel_owners(const std::vector<std::array<Vec2, 3>>& corners, int width,
                              int height, double margin) {
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  TexelOwners owners;
  owners.triangle.assign(count, -1);
  std::vector<float> nearest(count, std::numeric_limits<float>::infinity());
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const std::array<Vec2, 3>& c = corners[t];
    const Vec2 low = c[0].cwiseMin(c[1]).cwiseMin(c[2]), high = c[0].cwiseMax(c[1]).cwiseMax(c[2]);
    const auto first = [&](double at) {
      return std::max(0, static_cast<int>(std::ceil(at - margin)));
    };
    const auto last = [&](double at, int side) {
      return std::min(side - 1, static_cast<int>(std::floor(at + margin)));
    };
    for (int row = first(low.y()); row <= last(high.y(), height); ++row) {
      for (int column = first(low.x()); column <= last(high.x(), width); ++column) {
        const std::size_t i = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                              static_cast<std::size_t>(column);
        if (nearest[i] == 0.0f) continue;
        const double distance = distance_to(c, Vec2(column, row));
        if (distance > margin || !(static_cast<float>(distance) < nearest[i])) continue;
        nearest[i] = static_cast<float>(distance);
        owners.triangle[i] = static_cast<std::int32_t>(t);
      }
    }
  }
  return owners;
}

}  // namespace thigma::detail
