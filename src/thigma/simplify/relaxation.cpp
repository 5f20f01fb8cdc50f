#include "thigma/simplify/relaxation.h"

#include <array>
#include <cmath>

namespace thigma {
namespace {

/// The sum over edges of (weight of the vertex)^2, and of that weight times what the others give.
struct Sums {
  double squares = 0.0;
  Vec3 others = Vec3::Zero();
};

struct Weights {
  double j = 0.0, k = 0.0, left = 0.0, right = 0.0;
  bool is_valid = false;
};

/// Weights of the difference across edge j k with apexes left and right, hinge laid flat. Guskov's
/// L/A of either triangle is 2 / height; the common factor 2 is left out.
Weights hinge_weights(const Vec3& j, const Vec3& k, const Vec3& left, const Vec3& right) {
  const Vec3 edge = k - j;
  const double length2 = edge.squaredNorm();
  if (!(length2 > 0.0)) return {};
  const double s = edge.dot(left - j) / length2, t = edge.dot(right - j) / length2;
  const double height_left = (left - j - s * edge).norm();
  const double height_right = (right - j - t * edge).norm();
  const double least = 1e-6 * std::sqrt(length2);
  if (!(height_left > least) || !(height_right > least)) return {};
  Weights w;
  w.left = 1.0 / height_left;
  w.right = 1.0 / height_right;
  w.k = -(s * w.left + t * w.right);
  w.j = -((1.0 - s) * w.left + (1.0 - t) * w.right);
  w.is_valid = true;
  return w;
}

void add(Sums& sums, double own, const Vec3& others) {
  sums.squares += own * own;
  sums.others += own * others;
}

}  // namespace

Vec3 relax(const Vec3& p, std::span<const RingTriangle> ring) {
  Sums sums;
  for (const RingTriangle& t : ring) {
    if (t.has_beyond) {
      const Weights w = hinge_weights(t.a, t.b, p, t.beyond);
      if (w.is_valid) add(sums, w.left, w.j * t.a + w.k * t.b + w.right * t.beyond);
    }
    if (t.has_following) {  // the spoke to b
      const Weights w = hinge_weights(p, t.b, t.following, t.a);
      if (w.is_valid) add(sums, w.j, w.k * t.b + w.left * t.following + w.right * t.a);
    }
  }
  return sums.squares > 0.0 ? Vec3(-sums.others / sums.squares) : p;
}

}  // namespace thigma
