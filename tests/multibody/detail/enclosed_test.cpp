#include "thigma/multibody/detail/enclosed.h"

#include <cmath>

#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

using test::WorldBench;

TriangleMesh scaled(const TriangleMesh& mesh, double by) { return transformed(mesh, {}, by); }

/// Van Oosterom and Strackee's solid angles of all triangles, over the whole: plain sums.
double winding_number(const TriangleMesh& mesh, const Vec3& point) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    std::array<Vec3, 3> r;
    for (std::size_t k = 0; k < 3; ++k)
      r[k] = mesh.positions[static_cast<std::size_t>(t[k])] - point;
    const double a = r[0].norm(), b = r[1].norm(), c = r[2].norm();
    sum +=
        2.0 * std::atan2(r[0].dot(r[1].cross(r[2])),
                         a * b * c + r[0].dot(r[1]) * c + r[1].dot(r[2]) * a + r[2].dot(r[0]) * b);
  }
  return sum / (4.0 * M_PI);
}

/// Whether any corner of one mesh has the other about it; surfaces apart.
bool has_corner_inside(const TriangleMesh& inner, const Pose& outer_from_inner,
                       const TriangleMesh& outer) {
  for (const Vec3& p : inner.positions)
    if (winding_number(outer, transform_point(outer_from_inner, p)) > 0.5) return true;
  return false;
}

WorldBench two(const TriangleMesh& a, const TriangleMesh& b, const Vec3& place,
               const Quat& turn = Quat::Identity()) {
  WorldBench bench;
  bench.add(test::body_mesh(a), BodyKind::moving, Vec3::Zero()).name = "outer";
  bench.add(test::body_mesh(b), BodyKind::moving, place, turn).name = "inner";
  bench.make(Vec3::Zero());
  return bench;
}

std::string refusal(WorldBench& bench) {
  try {
    require_apart(bench.world, bench.state, *bench.scratch);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool is_in(const WorldBench& bench, std::int32_t inner, std::int32_t outer) {
  detail::PartsOfShapes parts(bench.world);
  return detail::is_enclosed(bench.world, bench.state, inner, outer, parts);
}

TEST(Enclosed, RandomPlacesAreAsTheWindingNumberSays) {
  const TriangleMesh shell = make_hollow_ball(1.0, 0.7, 4);
  const TriangleMesh ring = make_torus(1.0, 0.35, 24, 12);
  const TriangleMesh brick = make_box(Vec3(1.6, 1.2, 1.0));
  const TriangleMesh bits =
      joined(make_box(Vec3(0.1, 0.1, 0.1)),
             transformed(make_box(Vec3(0.05, 0.1, 0.05)), {Vec3(0.5, 0.3, 0.1), Quat::Identity()}));
  const TriangleMesh inner[] = {make_box(Vec3(0.12, 0.1, 0.08)), make_torus(0.1, 0.03, 12, 8),
                                bits};
  Random random(24);
  int inside = 0, outside = 0;
  for (const double size : {1e-9, 1.0, 1e3}) {
    for (const TriangleMesh& outer : {shell, ring, brick}) {
      for (int turn = 0; turn < 60; ++turn) {
        const TriangleMesh a = scaled(outer, size),
                           b = scaled(inner[turn % std::size(inner)], size);
        Vec3 place;
        for (int k = 0; k < 3; ++k) place[k] = random.uniform(-1.0, 1.0) * size;
        const Vec3 axis(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0), 1.0);
        WorldBench bench =
            two(a, b, place, Quat(Eigen::AngleAxisd(random.uniform(0.0, 3.0), axis.normalized())));
        if (!(bench.distance(0, 1) > 0.0)) continue;
        const Pose outer_from_inner = inverse(bench.world_from_mesh(0)) * bench.world_from_mesh(1);
        const bool is_inside = has_corner_inside(b, outer_from_inner, a);
        ++(is_inside ? inside : outside);
        EXPECT_EQ(is_in(bench, 1, 0), is_inside) << size << " " << turn;
        EXPECT_FALSE(is_in(bench, 0, 1)) << size << " " << turn;
        EXPECT_EQ(refusal(bench) != "", is_inside) << size << " " << turn << refusal(bench);
      }
    }
  }
  EXPECT_GT(inside, 50);
  EXPECT_GT(outside, 100);
}

TEST(Enclosed, IsRefusedByBothNames) {
  for (const bool is_first : {true, false}) {
    const TriangleMesh large = make_box(Vec3(0.2, 0.2, 0.2)),
                       small = make_box(Vec3(0.02, 0.02, 0.02));
    WorldBench bench = is_first ? two(large, small, Vec3(0.01, 0.0, 0.02))
                                : two(small, large, Vec3(0.01, 0.0, 0.02));
    const std::string line = is_first ? "body 'inner': starts inside body 'outer'"
                                      : "body 'outer': starts inside body 'inner'";
    EXPECT_NE(refusal(bench).find(line), std::string::npos) << refusal(bench);
  }
}

TEST(Enclosed, WhatTouchesIsToldByWhatDoesNot) {
  // In a tray that it fits on five sides; in a block, on the same ground.
  TriangleMesh tray = make_box(Vec3(0.3, 0.3, 0.3));
  const TriangleMesh cube = make_box(Vec3(0.1, 0.1, 0.1));
  WorldBench ground = two(tray, cube, Vec3(0.0, 0.0, -0.1));
  EXPECT_TRUE(is_in(ground, 1, 0));
  WorldBench corner = two(tray, cube, Vec3(0.1, 0.1, -0.1));
  EXPECT_TRUE(is_in(corner, 1, 0));
  for (const Vec3& place : {Vec3(0.2, 0.0, 0.0), Vec3(0.0, -0.2, 0.0), Vec3(0.0, 0.0, 0.2),
                            Vec3(0.2, 0.2, 0.0), Vec3(0.2, 0.2, 0.2), Vec3(0.2, 0.05, 0.1)}) {
    WorldBench bench = two(tray, cube, place);
    EXPECT_FALSE(is_in(bench, 1, 0)) << place.transpose();
    EXPECT_EQ(refusal(bench), "") << place.transpose();
  }
}

TEST(Enclosed, OpenSurfacesAndThoseInsideOutHaveNoInside) {
  TriangleMesh cup = make_box(Vec3(0.2, 0.2, 0.2));
  cup.triangles.pop_back();
  const TriangleMesh ball = make_ball(0.02, 2);
  WorldBench bench;
  bench.add(test::body_mesh(cup), BodyKind::fixed, Vec3::Zero());
  bench.add(test::body_mesh(ball), BodyKind::moving, Vec3(0.01, 0.0, 0.0));
  bench.make();
  EXPECT_EQ(refusal(bench), "");
  WorldBench room;
  room.add(test::body_mesh(flipped(make_box(Vec3(0.2, 0.2, 0.2)))), BodyKind::fixed, Vec3::Zero());
  room.add(test::body_mesh(ball), BodyKind::moving, Vec3(0.01, 0.0, 0.0));
  room.make();
  EXPECT_EQ(refusal(room), "");
  // What is open itself may lie in a closed one.
  WorldBench swallowed;
  swallowed.add(test::body_mesh(make_box(Vec3(0.6, 0.6, 0.6))), BodyKind::moving, Vec3::Zero());
  swallowed.add(test::body_mesh(cup), BodyKind::fixed, Vec3(0.01, 0.0, 0.0));
  swallowed.make();
  EXPECT_NE(refusal(swallowed), "");
}

}  // namespace
}  // namespace thigma
