#include "thigma/simplify/relaxation.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/math/elementary.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

/// A closed ring of n triangles around the origin, each with one beyond, lifted to z = height(x,
/// y).
template <class Height>
std::vector<RingTriangle> make_ring(int n, Random& random, Height height) {
  std::vector<Vec3> inner, outer;
  for (int i = 0; i < n; ++i) {
    const double turn = 2.0 * kPi * (i + random.uniform(-0.2, 0.2)) / n;
    const double r = random.uniform(0.7, 1.3), far = random.uniform(1.8, 2.4);
    const double half = kPi / n;
    inner.push_back({r * cosine(turn), r * sine(turn), 0.0});
    outer.push_back({far * cosine(turn + half), far * sine(turn + half), 0.0});
  }
  for (auto* list : {&inner, &outer})
    for (Vec3& p : *list) p.z() = height(p.x(), p.y());
  std::vector<RingTriangle> ring;
  for (int i = 0; i < n; ++i) {
    const auto k = static_cast<std::size_t>(i), l = static_cast<std::size_t>((i + 1) % n),
               m = static_cast<std::size_t>((i + 2) % n);
    ring.push_back({inner[k], inner[l], outer[k], inner[m], true, true});
  }
  return ring;
}

/// Sum over the edges of the squared jump of the gradient of one coordinate, from its definition:
/// the triangles are laid flat with the vertex at `from`, then it takes the value of `to`.
double energy(const Vec3& from, const Vec3& to, const std::vector<RingTriangle>& ring) {
  const auto jump2 = [](const std::array<Vec3, 4>& x, const std::array<Vec3, 4>& g) {
    // x: edge from 0 to 1, apexes 2 and 3; the gradient's part across the edge on either side.
    const Vec3 e = (x[1] - x[0]).normalized();
    const double length = (x[1] - x[0]).norm();
    Vec3 jump = Vec3::Zero();
    for (const std::size_t apex : {std::size_t{2}, std::size_t{3}}) {
      const double along = e.dot(x[apex] - x[0]);
      const double across = (x[apex] - x[0] - along * e).norm();
      jump += (g[apex] - (g[0] + along / length * (g[1] - g[0]))) / across;
    }
    return jump.squaredNorm();
  };
  double sum = 0.0;
  for (const RingTriangle& t : ring) {
    sum += jump2({t.a, t.b, from, t.beyond}, {t.a, t.b, to, t.beyond});
    sum += jump2({from, t.b, t.following, t.a}, {to, t.b, t.following, t.a});
  }
  return sum;
}

TEST(Relax, LeavesAPlaneAlone) {
  Random random(11);
  for (int n = 3; n < 9; ++n) {
    const auto ring = make_ring(n, random, [](double x, double y) { return 0.3 * x - 0.7 * y; });
    EXPECT_LT(relax(Vec3::Zero(), ring).norm(), 1e-12);
  }
}

TEST(Relax, MinimisesTheJumpsOfTheGradient) {
  Random random(12);
  for (int trial = 0; trial < 30; ++trial) {
    const auto ring =
        make_ring(3 + trial % 6, random, [&](double, double) { return random.uniform(-0.3, 0.3); });
    const Vec3 from = 0.2 * random.in_cube(1.0);
    const Vec3 best = relax(from, ring);
    const double least = energy(from, best, ring);
    for (int k = 0; k < 20; ++k)
      EXPECT_GE(energy(from, best + 0.1 * random.in_cube(1.0), ring), least);
  }
}

TEST(Relax, TakesABumpOutAndKeepsItsPlaceOnABoundary) {
  Random random(13);
  const auto flat = make_ring(6, random, [](double, double) { return 0.0; });
  EXPECT_LT(std::fabs(relax({0, 0, 0.4}, flat).z()), 1e-12);
  auto alone = flat;
  alone.resize(1);
  alone[0].has_beyond = alone[0].has_following = false;
  EXPECT_EQ(relax({0, 0, 0.4}, alone), Vec3(0, 0, 0.4));
}

}  // namespace
}  // namespace thigma
