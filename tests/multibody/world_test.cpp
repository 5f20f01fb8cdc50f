#include "thigma/multibody/world.h"

#include <limits>

#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/multibody/detail/pair_kinds.h"

namespace thigma {
namespace {

using test::WorldBench;

/// The line a start is refused with, empty where it is not.
std::string refusal(WorldBench& bench) {
  try {
    bench.make();
    require_apart(bench.world, bench.state, *bench.scratch);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

WorldBench two_blocks(double apart) {
  WorldBench bench;
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
  bench.add(block, BodyKind::moving, Vec3::Zero()).name = "left";
  bench.add(block, BodyKind::moving, Vec3(0.04 + apart, 0.0, 0.0)).name = "right";
  return bench;
}

TEST(World, RefusesBadBodiesByName) {
  struct Case {
    const char* says;
    void (*spoil)(WorldBody&);
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  const Case cases[] = {
      {"body 'right': mass 0.000000", [](WorldBody& b) { b.mass = 0.0; }},
      {"body 'right': mass -1", [](WorldBody& b) { b.mass = -1.0; }},
      {"body 'right': inertia", [](WorldBody& b) { b.inertia = -b.inertia; }},
      {"body 'right': pose", [](WorldBody& b) { b.start.position.x() = kNan; }},
      {"body 'right': pose", [](WorldBody& b) { b.start.orientation.coeffs() *= 2.0; }},
      {"body 'right': friction",
       [](WorldBody& b) {
         b.friction = {0.5, 0.1};
       }},
      {"body 'right': restitution", [](WorldBody& b) { b.restitution = 1.5; }},
      {"body 'right': no surface", [](WorldBody& b) { b.shape.hierarchy = nullptr; }},
      {"body 'left': name given twice", [](WorldBody& b) { b.name = "left"; }},
  };
  for (const Case& c : cases) {
    WorldBench bench = two_blocks(0.01);
    c.spoil(bench.bodies[1]);
    EXPECT_NE(refusal(bench).find(c.says), std::string::npos) << c.says << " | " << refusal(bench);
  }
  WorldBench good = two_blocks(0.01);
  EXPECT_EQ(refusal(good), "");
}

TEST(World, FixedBodiesNeedNoMass) {
  WorldBench bench = two_blocks(0.01);
  bench.bodies[1].kind = BodyKind::fixed;
  bench.bodies[1].mass = 0.0;
  EXPECT_EQ(refusal(bench), "");
}

TEST(World, RefusesBodiesThatStartInEachOtherByName) {
  WorldBench bench = two_blocks(-0.002);
  const std::string line = refusal(bench);
  EXPECT_NE(line.find("body 'right': starts 2 mm inside body 'left'"), std::string::npos) << line;
  WorldBench touching = two_blocks(0.0);
  EXPECT_EQ(refusal(touching), "");
}

TEST(World, EqualShapesAreKnownOnce) {
  WorldBench bench = two_blocks(0.01);
  test::add_floor(bench);
  bench.bodies[2].start.position.z() -= 0.1;
  bench.make();
  EXPECT_EQ(bench.world.shapes.size(), 2u);
  EXPECT_EQ(bench.world.pair_kinds->list.size(), 2u);  // block on block, block on floor
}

TEST(World, FrictionOfTwoIsTheGeometricMean) {
  WorldBody a, b;
  a.friction = {0.2, 0.4};
  b.friction = {0.8, 0.9};
  EXPECT_DOUBLE_EQ(friction_between(a, b).kinetic, 0.4);
  EXPECT_DOUBLE_EQ(friction_between(a, b).at_rest, 0.6);
}

}  // namespace
}  // namespace thigma
