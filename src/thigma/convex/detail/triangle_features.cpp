#include "thigma/convex/detail/triangle_features.h"

#include <algorithm>

#include "thigma/convex/detail/simplex.h"

// The closest points of disjoint triangles lie on two edges, or on a corner and a face (Ericson
// 2005, 5.1.10).

namespace thigma::detail {
namespace {

// Of bounds against measured squares: far above the rounding of either where they are not about
// equal.
constexpr double kMargin = 1.0 + 1e-12;

// An edge of a triangle, of any length.
struct Edge {
  const Vec3& start;
  const Vec3& along;  // to its end
  int corners;        // mask of the two
};

// Closest points of two edges. Offers the interior pair; pairs with an end of an edge come from
// offer_corner, so nothing is clamped here.
void offer_interior(const Edge& a, const Edge& b, ClosestFeatures& best) {
  const Vec3 &p = a.start, &u = a.along, &q = b.start, &v = b.along;
  const Vec3 n = u.cross(v), r = q - p;
  const double nn = n.squaredNorm(), along = r.dot(n);
  // The lines' distance bounds that of the segments; most pairs end here.
  if (along * along > best.squared * nn * kMargin) return;
  if (!(nn > 1e-28 * u.squaredNorm() * v.squaredNorm()))
    return;  // parallel to rounding: ends are as close
  const double s = r.cross(v).dot(n) / nn, t = r.cross(u).dot(n) / nn;
  if (s < 0.0 || s > 1.0 || t < 0.0 || t > 1.0) return;
  // Along the common normal: exact in direction and length where the points are nearly equal.
  const Vec3 offset = n * (along / nn);
  const double d = offset.squaredNorm();
  if (!(d < best.squared)) return;
  best.squared = d;
  best.a = p + s * u;
  best.b = best.a + offset;
  best.corners_a = static_cast<std::uint8_t>(a.corners);
  best.corners_b = static_cast<std::uint8_t>(b.corners);
}

// Corner p against triangle t: interior and edges. swapped: p is of b.
void offer_corner(const Vec3& p, const PlacedTriangle& t, int corner, bool swapped,
                  ClosestFeatures& best) {
  const double height = t.height(p);
  if (height * height * t.inverse_squared > best.squared * kMargin) return;
  int mask = 0;
  double w[3];
  const Vec3 v = nearest_on_triangle(t.p[0] - p, t.p[1] - p, t.p[2] - p, mask, w);
  const double d = v.squaredNorm();
  if (!(d < best.squared)) return;
  best.squared = d;
  best.a = swapped ? Vec3(p + v) : p;
  best.b = swapped ? p : Vec3(p + v);
  best.corners_a = static_cast<std::uint8_t>(swapped ? mask : 1 << corner);
  best.corners_b = static_cast<std::uint8_t>(swapped ? 1 << corner : mask);
}

}  // namespace

void offer_features(const PlacedTriangle& a, const PlacedTriangle& b, ClosestFeatures& best) {
  offer_features(a, b, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}}, best);
}

void offer_features(const PlacedTriangle& a, const PlacedTriangle& b, const CornerHeights& along,
                    ClosestFeatures& best) {
  const double* const at_a = along.a;
  const double* const at_b = along.b;
  const double top = std::max({at_a[0], at_a[1], at_a[2]}),
               bottom = std::min({at_b[0], at_b[1], at_b[2]});
  for (int i = 0; i < 3; ++i) {
    if (!(bottom - at_a[i] > along.most)) offer_corner(a.p[i], b, i, false, best);
    if (!(at_b[i] - top > along.most)) offer_corner(b.p[i], a, i, true, best);
  }
  Vec3 along_b[3];
  for (int j = 0; j < 3; ++j) along_b[j] = b.p[j == 2 ? 0 : j + 1] - b.p[j];
  for (int i = 0; i < 3; ++i) {
    const int i2 = i == 2 ? 0 : i + 1;
    const double top_of_edge = std::max(at_a[i], at_a[i2]);
    if (bottom - top_of_edge > along.most) continue;
    const Vec3 along_a = a.p[i2] - a.p[i];
    for (int j = 0; j < 3; ++j) {
      const int j2 = j == 2 ? 0 : j + 1;
      if (std::min(at_b[j], at_b[j2]) - top_of_edge > along.most) continue;
      offer_interior({a.p[i], along_a, 1 << i | 1 << i2}, {b.p[j], along_b[j], 1 << j | 1 << j2},
                     best);
    }
  }
}

int pierce(const Vec3 edges[3], const PlacedTriangle& face, Vec3& sum) {
  const double h[3] = {face.height(edges[0]), face.height(edges[1]), face.height(edges[2])};
  int count = 0;
  for (int i = 0; i < 3; ++i) {
    const int j = i == 2 ? 0 : i + 1;
    if (!((h[i] < 0.0 && h[j] > 0.0) || (h[i] > 0.0 && h[j] < 0.0))) continue;
    const Vec3 p = edges[i], d = edges[j] - edges[i];
    const Vec3 r[3] = {face.p[0] - p, face.p[1] - p, face.p[2] - p};
    const double first = d.dot(r[0].cross(r[1])), second = d.dot(r[1].cross(r[2]));
    if ((first < 0.0 && second > 0.0) || (first > 0.0 && second < 0.0)) continue;
    const double third = d.dot(r[2].cross(r[0]));
    const bool inside = (first >= 0.0 && second >= 0.0 && third >= 0.0) ||
                        (first <= 0.0 && second <= 0.0 && third <= 0.0);
    if (!inside) continue;
    sum += p + (h[i] / (h[i] - h[j])) * d;
    ++count;
  }
  return count;
}

}  // namespace thigma::detail
