#include "thigma/convex/penetration.h"

#include <cmath>
#include <cstdio>

#include "convex/hull_support.h"
#include <gtest/gtest.h>

#include "thigma/convex/decomposition.h"
#include "thigma/convex/patch_separation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

using test::MeshPatch;

// A rectangle of two triangles at height z, facing up or down.
MeshPatch plate(double half, double z, bool up) {
  const std::vector<Vec3> p{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}};
  const test::Triangles t =
      up ? test::Triangles{{0, 1, 2}, {0, 2, 3}} : test::Triangles{{0, 2, 1}, {0, 3, 2}};
  return test::make_patch(p, t, {0, 1});
}

PairContact contact(const MeshPatch& a, const MeshPatch& b, const Vec3& shift,
                    const SegmentProbe& probe = {}) {
  RelativePose x;
  x.translation = shift;
  GjkCache cache;
  return pair_contact({a.view(), b.view(), x}, 10.0, cache, nullptr, probe);
}

TEST(PairContact, PlatesPassThroughEachOtherContinuously) {
  const MeshPatch lower = plate(1.0, 0.0, true), upper = plate(1.0, 0.0, false);
  for (const double gap : {0.1, 1e-3, 1e-6, -1e-6, -1e-3, -0.1, -0.5}) {
    const PairContact c = contact(lower, upper, Vec3(0.3, 0.2, gap));
    EXPECT_NEAR(c.depth, -gap, 1e-12) << gap;
    EXPECT_NEAR((c.normal - Vec3::UnitZ()).norm(), 0.0, 1e-9) << gap;
    EXPECT_NEAR((c.witness_a - c.witness_b - c.depth * c.normal).norm(), 0.0, 1e-12);
    EXPECT_EQ(c.status, gap > 0.0 ? PairContactStatus::separated : PairContactStatus::deep);
  }
}

TEST(PairContact, BackToBackPlatesArePenetratingUnlessTheProbeFindsSurfaceBetween) {
  const MeshPatch down = plate(1.0, 0.0, false), up = plate(1.0, 0.0, true);
  const SegmentProbe between{[](const void*, const ProbeSegment&) noexcept { return true; },
                             nullptr};
  const PairContact apart = contact(down, up, Vec3(0, 0, 0.1), between);
  EXPECT_EQ(apart.status, PairContactStatus::separated);
  EXPECT_TRUE(apart.backs_facing);
  EXPECT_NEAR(apart.depth, -0.1, 1e-15);
  const PairContact through = contact(down, up, Vec3(0, 0, 0.1));
  EXPECT_EQ(through.status, PairContactStatus::deep);
  EXPECT_NEAR(through.depth, 0.1, 1e-12);
  EXPECT_NEAR(through.normal.z(), -1.0, 1e-12);
  // Front to back, as two layers of one wall: separated, the probe is not asked.
  const PairContact mixed = contact(up, up, Vec3(0, 0, 0.1));
  EXPECT_EQ(mixed.status, PairContactStatus::separated);
  EXPECT_FALSE(mixed.backs_facing);
}

TEST(PairContact, TurnsContinuouslyFromBesideToThrough) {
  // Back to back 0.1 apart, slid from far beside each other to one above the other.
  const MeshPatch down = plate(1.0, 0.0, false), up = plate(1.0, 0.0, true);
  constexpr double kStep = 1e-3;
  Vec3 last = Vec3::Zero();
  int besides = 0, deeps = 0;
  for (int i = 0; i <= 3000; ++i) {
    const PairContact c = contact(down, up, Vec3(3.0 - kStep * i, 0.1, 0.1));
    const Vec3 vector = c.depth * c.normal;
    EXPECT_NEAR((c.witness_a - c.witness_b - vector).norm(), 0.0, 1e-12);
    EXPECT_GE(c.depth, -c.separation * (1.0 + 1e-12));
    EXPECT_EQ(c.depth > 0.0, c.status == PairContactStatus::deep);
    if (i > 0) {
      EXPECT_LE((vector - last).norm(), 4.0 * kStep) << i;
    }
    last = vector;
    besides += c.status == PairContactStatus::grazing;
    deeps += c.status == PairContactStatus::deep;
  }
  EXPECT_GT(besides, 10);
  EXPECT_GT(deeps, 100);
  EXPECT_NEAR(last.z(), -0.1, 1e-12);
}

TEST(BacksFacing, TellsTheSidesOfSurfacesApart) {
  const MeshPatch up = plate(1.0, 0.0, true), down = plate(1.0, 0.0, false);
  const RelativePose x;
  const Vec3 z = Vec3::UnitZ();
  EXPECT_DOUBLE_EQ(backs_facing({down.view(), up.view(), x}, 1, 1, z), 1.0);
  EXPECT_DOUBLE_EQ(backs_facing({up.view(), down.view(), x}, 1, 1, z), -1.0);
  EXPECT_LE(backs_facing({up.view(), up.view(), x}, 1, 1, z), 0.0);
  EXPECT_LE(backs_facing({down.view(), down.view(), x}, 1, 1, z), 0.0);
}

TEST(PairContact, FartherThanTheToleranceIsApart) {
  const MeshPatch lower = plate(1.0, 0.0, true), upper = plate(1.0, 0.0, false);
  RelativePose x;
  x.translation = Vec3(0, 0, 0.5);
  GjkCache cache;
  EXPECT_EQ(pair_contact({lower.view(), upper.view(), x}, 0.499, cache, nullptr, {}).status,
            PairContactStatus::apart);
  EXPECT_EQ(pair_contact({lower.view(), upper.view(), x}, 0.501, cache, nullptr, {}).status,
            PairContactStatus::separated);
}

TEST(PairContact, ACornerInAPlateAndCrossedEdgesLeaveByTheShortWay) {
  // Closed boxes as one patch each: hull and object are the same, all faces are real.
  const TriangleMesh box = make_box(Vec3(1, 1, 1));
  std::vector<int> all;
  for (int i = 0; i < static_cast<int>(box.triangles.size()); ++i) all.push_back(i);
  const MeshPatch patch = test::make_patch(box.positions, box.triangles, all);
  GjkCache cache;
  RelativePose x;
  x.translation = Vec3(0.1, 0.05, 0.98);
  const PairContact face = pair_contact({patch.view(), patch.view(), x}, 1.0, cache, nullptr, {});
  EXPECT_EQ(face.status, PairContactStatus::penetrating);
  EXPECT_NEAR(face.depth, 0.02, 1e-12);
  EXPECT_NEAR(face.normal.z(), 1.0, 1e-12);
  // a's edge along y, at x = z = 0.5, against b's lower edge along x, crossed at right angles, both
  // turned by 45 degrees: the way out is the cross of the edges.
  const double r = std::sqrt(0.5);
  MeshPatch a = patch, b = patch;
  std::vector<Vec3> pa = box.positions, pb = box.positions;
  for (Vec3& p : pa) p = Vec3(r * (p.x() - p.z()), p.y(), r * (p.x() + p.z()));
  for (Vec3& p : pb) p = Vec3(p.x(), r * (p.y() - p.z()), r * (p.y() + p.z()));
  a = test::make_patch(pa, box.triangles, all);
  b = test::make_patch(pb, box.triangles, all);
  for (const double depth : {-1e-3, 1e-9, 1e-3, 0.05}) {
    x.translation = Vec3(0.02, 0.03, 2.0 * r - depth);
    const PairContact edges = pair_contact({a.view(), b.view(), x}, 1.0, cache, nullptr, {});
    EXPECT_NEAR(edges.depth, depth, 1e-12);
    EXPECT_NEAR(edges.normal.z(), 1.0, 1e-6);
  }
}

TEST(PairContact, NeverPushesOutThroughTheBackOfAThinPatch) {
  // A shallow cap 0.01 thick pressed 0.05 through another: unrestricted depth would leave by the
  // virtual lids.
  const std::vector<Vec3> p{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}, {0, 0, 0.01}};
  const test::Triangles t{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  std::vector<Vec3> q = p;
  for (Vec3& v : q) v.z() = -v.z();
  const test::Triangles u{{1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
  const MeshPatch a = test::make_patch(p, t, {0, 1, 2, 3}),
                  b = test::make_patch(q, u, {0, 1, 2, 3});
  for (const double depth : {0.001, 0.004, 0.01, 0.02, 0.05}) {
    const PairContact c = contact(a, b, Vec3(0.01, 0.02, 0.02 - depth));
    EXPECT_GT(c.normal.z(), 0.99) << depth;
    EXPECT_NEAR(c.depth, depth, 0.011) << depth;
    EXPECT_EQ(c.status, c.depth > 0.5 * a.thickness ? PairContactStatus::deep
                                                    : PairContactStatus::penetrating);
  }
}

TEST(PairContact, AmongNearEqualDirectionsTheLastOneIsKept) {
  const TriangleMesh box = make_box(Vec3(1, 1, 1));
  std::vector<int> all;
  for (int i = 0; i < static_cast<int>(box.triangles.size()); ++i) all.push_back(i);
  const MeshPatch patch = test::make_patch(box.positions, box.triangles, all);
  RelativePose x;
  x.translation = Vec3(0.9, 0, 0.903);  // 0.1 out along x, 0.097 along z
  GjkCache cache;
  const Vec3 last = Vec3::UnitX(), other = Vec3::UnitZ();
  EXPECT_GT(pair_contact({patch.view(), patch.view(), x}, 1.0, cache, nullptr, {}).normal.z(),
            0.999);
  EXPECT_GT(pair_contact({patch.view(), patch.view(), x}, 1.0, cache, &other, {}).normal.z(),
            0.999);
  const PairContact kept = pair_contact({patch.view(), patch.view(), x}, 1.0, cache, &last, {});
  EXPECT_GT(kept.normal.x(), 0.999);
  EXPECT_NEAR(kept.depth, 0.1, 1e-12);
  x.translation = Vec3(0.9, 0, 0.92);  // 0.08: no longer near-equal
  EXPECT_GT(pair_contact({patch.view(), patch.view(), x}, 1.0, cache, &last, {}).normal.z(), 0.999);
}

// --- Pressing two bodies into each other
// --------------------------------------------------------

struct Body {
  std::vector<MeshPatch> patches;
};

// Patches of a convex mesh near direction d, turned by rotation first.
Body ball_side(int frequency, int max_vertices, const Vec3& d, double cosine) {
  const TriangleMesh mesh = make_ball(1.0, frequency);
  DecompositionParams params;
  params.max_vertices = max_vertices;
  Body body;
  for (const auto& members : decompose_surface(mesh, params).patches) {
    MeshPatch patch =
        test::make_patch(mesh.positions, mesh.triangles, {members.begin(), members.end()});
    if (patch.center.normalized().dot(d) > cosine) body.patches.push_back(std::move(patch));
  }
  return body;
}

struct Pressing {
  std::int64_t pair_steps = 0, jumps = 0, turned = 0, penetrating = 0;
  double deepest = 0.0;
};

struct PairMemory {
  bool known = false;
  Vec3 first, last, vector;
  GjkCache cache;
};

// Presses b along -d from touch to `press` in `steps`; counts jumps and turned normals.
Pressing press(const Body& a, const Body& b, const Mat3& rotation, const Vec3& d,
               double press_depth, int steps, bool memory) {
  constexpr double kTolerance = 0.01;
  const std::size_t na = a.patches.size(), nb = b.patches.size();
  const auto near = [&](const HullView& va, const HullView& vb, const RelativePose& x) {
    return !spheres_separate(va, vb, x, kTolerance);
  };
  const auto touching = [&](double at) {
    const RelativePose x{rotation, d * at};
    for (const MeshPatch& pa : a.patches) {
      for (const MeshPatch& pb : b.patches) {
        GjkCache cache;
        if (near(pa.view(), pb.view(), x) &&
            patch_separation({pa.view(), pb.view(), x}, 0.0, cache).intersecting)
          return true;
      }
    }
    return false;
  };
  double low = 1.99, high = 2.01;
  for (int i = 0; i < 30; ++i) (touching(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  std::vector<PairMemory> memories(na * nb);
  Pressing result;
  const double step = press_depth / steps;
  for (int k = 0; k <= steps; ++k) {
    const RelativePose x{rotation, d * (high - step * k)};
    for (std::size_t i = 0; i < na * nb; ++i) {
      const HullView va = a.patches[i / nb].view(), vb = b.patches[i % nb].view();
      PairMemory& m = memories[i];
      if (!near(va, vb, x)) {
        m.known = false;
        continue;
      }
      const PairContact c =
          pair_contact({va, vb, x}, kTolerance, m.cache, memory && m.known ? &m.last : nullptr, {});
      if (c.status == PairContactStatus::apart) {
        m.known = false;
        continue;
      }
      const Vec3 vector = c.depth * c.normal;
      if (m.known) {
        ++result.pair_steps;
        result.jumps += (vector - m.vector).norm() > 4.0 * step;
        result.turned += c.normal.dot(m.first) < 0.0;
      } else {
        m.first = c.normal;
      }
      result.penetrating += c.depth > 0.0;
      result.deepest = std::max(result.deepest, c.depth);
      m.known = true;
      m.last = c.normal;
      m.vector = vector;
    }
  }
  return result;
}

TEST(PairContact, PressedBallsKeepDirectionAndContinuity) {
  // Single triangles (thickness 0: through at once), small and large patches; fine and coarse.
  struct Case {
    int frequency, max_vertices;
    double cosine;
  };
  for (const Case& c : {Case{8, 3, 0.8}, Case{24, 3, 0.97}, Case{24, 8, 0.96}, Case{48, 8, 0.985},
                        Case{96, 32, 0.99}}) {
    for (const bool memory : {false, true}) {
      Pressing sum;
      for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        Random random(seed);
        const Mat3 rotation = random.orientation().toRotationMatrix();
        const Vec3 d = random.direction();
        const Body a = ball_side(c.frequency, c.max_vertices, d, c.cosine);
        const Body b =
            ball_side(c.frequency, c.max_vertices, -(rotation.transpose() * d), c.cosine);
        const Pressing r = press(a, b, rotation, d, 0.005, 50, memory);
        sum.pair_steps += r.pair_steps;
        sum.jumps += r.jumps;
        sum.turned += r.turned;
        sum.penetrating += r.penetrating;
        sum.deepest = std::max(sum.deepest, r.deepest);
      }
      std::printf(
          "balls %d, %2d vertices, memory %d: %lld pair-steps, %lld jumps (%.3f %%), %lld turned, "
          "deepest %.5f\n",
          c.frequency, c.max_vertices, memory, static_cast<long long>(sum.pair_steps),
          static_cast<long long>(sum.jumps),
          100.0 * static_cast<double>(sum.jumps) / static_cast<double>(sum.pair_steps),
          static_cast<long long>(sum.turned), sum.deepest);
      EXPECT_GT(sum.pair_steps, 300);
      EXPECT_GT(sum.penetrating, 20);
      EXPECT_LE(static_cast<double>(sum.jumps), 0.005 * static_cast<double>(sum.pair_steps));
      EXPECT_EQ(sum.turned, 0);
      EXPECT_LE(sum.deepest, 0.006);
    }
  }
}

}  // namespace
}  // namespace thigma
