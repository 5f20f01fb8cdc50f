#include <cmath>
#include <limits>

#include "convex/hull_support.h"
#include <gtest/gtest.h>

namespace thigma {
namespace {

using test::PointHull;
using test::random_hull;

// The function's arithmetic one lane at a time.
bool scalar_twin(const HullView& a, const HullView& b, const RelativePose& x, const float axis[3],
                 double gap) {
  const auto top = [](const HullView& h, float ax, float ay, float az) {
    const float *px = h.lanes, *py = px + h.lane_count, *pz = py + h.lane_count;
    float best = -std::numeric_limits<float>::infinity();
    for (int i = 0; i < h.lane_count; ++i)
      best = std::max(best, (px[i] * ax + py[i] * ay) + pz[i] * az);
    return best;
  };
  const auto dot = [](const Vec3& p, const Vec3& q) {
    return p.x() * q.x() + p.y() * q.y() + p.z() * q.z();
  };
  const Vec3 n(axis[0], axis[1], axis[2]);
  const Vec3 n_b(dot(x.rotation.col(0), n), dot(x.rotation.col(1), n), dot(x.rotation.col(2), n));
  const double top_a = top(a, axis[0], axis[1], axis[2]);
  const double top_b = top(b, -static_cast<float>(n_b.x()), -static_cast<float>(n_b.y()),
                           -static_cast<float>(n_b.z()));
  const double between = dot(b.center, n_b) + dot(x.translation - a.center, n) - (top_a + top_b);
  const double far = a.center.lpNorm<1>() + b.center.lpNorm<1>() + x.translation.lpNorm<1>();
  const double need = gap + 0x1.0p-19 * (a.radius + b.radius) + 0x1.0p-48 * far;
  return between > 0.0 && between * between > need * need * dot(n, n) * (1.0 + 0x1.0p-48);
}

TEST(AxisSeparates, NeverLiesAndIsTightAndEqualsItsScalarTwin) {
  Random random(1);
  int proven = 0, proven_tight = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const double scale = trial % 3 == 0 ? 1.0 : trial % 3 == 1 ? 1e-9 : 1e9;
    const int na = 1 + static_cast<int>(random.below(32)),
              nb = 1 + static_cast<int>(random.below(32));
    const Vec3 place = random.direction() * 30.0;
    const PointHull ha = random_hull(trial % 5, na, place, scale, random);
    const PointHull hb = random_hull(
        trial / 5 % 5, nb, place + random.direction() * random.uniform(0.5, 4.0), scale, random);
    RelativePose x{random.orientation().toRotationMatrix(), Vec3::Zero()};
    x.translation = scale * place - x.rotation * (scale * place);
    GjkCache cache;
    const Separation s =
        closest_points(ha.view(), hb.view(), x, std::numeric_limits<double>::infinity(), cache);
    if (s.status != GjkStatus::separated) continue;
    const Vec3 d = (s.witness_b - s.witness_a).normalized();
    const float axis[3] = {static_cast<float>(d.x()), static_cast<float>(d.y()),
                           static_cast<float>(d.z())};
    // The best axis there is: gaps just below the distance are proven, gaps just above must not be.
    for (const double part : {0.0, 0.5, 1.0 - 1e-12, 1.0, 1.0 + 1e-9}) {
      const bool separates = axis_separates(ha.view(), hb.view(), x, axis, part * s.distance);
      proven += separates;
      EXPECT_EQ(separates, scalar_twin(ha.view(), hb.view(), x, axis, part * s.distance));
      if (part >= 1.0) {
        EXPECT_FALSE(separates);
      }
    }
    const double size = ha.radius + hb.radius;
    if (s.distance > 1e-4 * size)
      proven_tight += axis_separates(ha.view(), hb.view(), x, axis, s.distance - 1e-5 * size);
    else
      ++proven_tight;
    EXPECT_FALSE(spheres_separate(ha.view(), hb.view(), x, s.distance));
  }
  EXPECT_GT(proven, 4000);
  EXPECT_GT(proven_tight, 2000);
}

TEST(SpheresSeparate, ProvesWhatIsFarEnough) {
  const PointHull a({{-1, 0, 0}, {1, 0, 0}}), b({{-1, 0, 0}, {1, 0, 0}});
  RelativePose x;
  x.translation = Vec3(0, 3, 0);
  EXPECT_TRUE(spheres_separate(a.view(), b.view(), x, 0.999));
  EXPECT_FALSE(spheres_separate(a.view(), b.view(), x, 1.001));
}

}  // namespace
}  // namespace thigma
