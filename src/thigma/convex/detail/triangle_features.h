#pragma once
// Closest features of two triangles, and where one pierces the other.

#include <cmath>
#include <cstdint>
#include <limits>

#include "thigma/math/types.h"

namespace thigma::detail {

/// A triangle with its plane.
struct PlacedTriangle {
  Vec3 p[3];
  Vec3 normal;             // not normalized; may be zero
  double inverse_squared;  // 1 / |normal|^2, 0 without one

  double height(const Vec3& q) const { return normal.dot(q - p[0]); }  // times |normal|
};

inline PlacedTriangle place_triangle(const Vec3& p0, const Vec3& p1, const Vec3& p2) {
  const Vec3 normal = (p1 - p0).cross(p2 - p0);
  const double squared = normal.squaredNorm();
  return {{p0, p1, p2}, normal, squared > 0.0 ? 1.0 / squared : 0.0};
}

/// The nearest points found so far.
struct ClosestFeatures {
  double squared = std::numeric_limits<double>::infinity();  // nothing farther is of interest
  Vec3 a, b;
  std::uint8_t corners_a = 0, corners_b = 0;  // masks of the corners that span the features
};

/// Offers every pair of features of two triangles; blind to edges that pierce faces. Points about a
/// local origin. Among features to rounding equally near it depends on their order alone which is
/// kept.
void offer_features(const PlacedTriangle& a, const PlacedTriangle& b, ClosestFeatures& best);

/// Heights of the corners of two triangles along one direction, and the most by which those of b
/// may be above those of a for features to be of interest.
struct CornerHeights {
  double a[3], b[3];
  double most = 0.0;
};

/// The same for a caller who knows a direction along which most features are far apart.
void offer_features(const PlacedTriangle& a, const PlacedTriangle& b, const CornerHeights& along,
                    ClosestFeatures& best);

/// Adds the points where the edges of a triangle pierce the inside of another; returns how many.
int pierce(const Vec3 edges[3], const PlacedTriangle& face, Vec3& sum);

/// Largest coordinate of the corners: what rounding is measured by.
inline double largest_coordinate(const PlacedTriangle& a, const PlacedTriangle& b) {
  double reach = 0.0;
  for (int i = 0; i < 3; ++i)
    reach = std::fmax(
        reach, std::fmax(a.p[i].lpNorm<Eigen::Infinity>(), b.p[i].lpNorm<Eigen::Infinity>()));
  return reach;
}

/// Distance below which triangles count as touching.
inline double touch_distance(const PlacedTriangle& a, const PlacedTriangle& b) {
  return 0x1.0p-51 * largest_coordinate(a, b);
}

}  // namespace thigma::detail
