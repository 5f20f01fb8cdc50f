#include "thigma/multibody/joint.h"

#include <cmath>
#include <limits>

#include "multibody/world_bench.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/elementary.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

using test::WorldBench;

std::vector<BodyState> two_anywhere(Random& random) {
  std::vector<BodyState> bodies(2);
  for (BodyState& y : bodies) {
    y.position = random.in_cube(0.1);
    y.orientation = random.orientation();
  }
  return bodies;
}

TEST(Joint, PlacedWhereBodiesStandIsMet) {
  Random random(3);
  for (const JointKind kind :
       {JointKind::fixed, JointKind::hinge, JointKind::slider, JointKind::ball}) {
    for (const std::int32_t b : {-1, 1}) {
      const std::vector<BodyState> bodies = two_anywhere(random);
      WorldJoint joint{{.kind = kind, .a = 0, .b = b}, "j"};
      place_joint(joint, joint_frame(random.in_cube(0.1), random.direction()), bodies);
      std::array<double, 6> errors{};
      const JointEnds ends = joint_ends(joint, bodies);
      const int count = joint_errors(kind, ends, 0.1, errors);
      EXPECT_EQ(count, kind == JointKind::fixed ? 6 : kind == JointKind::ball ? 3 : 5);
      for (const double e : errors) EXPECT_LT(std::fabs(e), 1e-15);
      EXPECT_NEAR(joint_coordinate(kind, ends), 0.0, 1e-15);
    }
  }
}

TEST(Joint, CoordinatesAreAnglesWaysAndDistances) {
  Random random(4);
  for (const double x : {-2.9, -0.3, 0.0, 1.0, 3.1}) {
    std::vector<BodyState> bodies = two_anywhere(random);
    const Pose frame = joint_frame(random.in_cube(0.1), random.direction());
    const Vec3 axis = frame.orientation * Vec3::UnitZ();
    for (const JointKind kind : {JointKind::hinge, JointKind::slider, JointKind::spring}) {
      WorldJoint joint{{.kind = kind, .a = 0, .b = 1}, "j"};
      place_joint(joint, frame, bodies);
      std::vector<BodyState> moved = bodies;
      if (kind == JointKind::hinge) {
        const Quat turn = rotation_from_vector(x * axis);
        moved[0].orientation = turn * bodies[0].orientation;
        moved[0].position = frame.position + turn * (bodies[0].position - frame.position);
      } else {
        moved[0].position += x * axis;
      }
      const double expected = kind == JointKind::spring ? std::fabs(x) : x;
      EXPECT_NEAR(joint_coordinate(kind, joint_ends(joint, moved)), expected, 1e-14);
      joint.stiffness = 3.0;
      joint.rest = 0.5;
      const double off = coordinate_difference(kind, expected, 0.5);
      EXPECT_NEAR(joint_energy(joint, moved), 1.5 * off * off, 1e-13);
    }
  }
  EXPECT_NEAR(coordinate_difference(JointKind::hinge, 3.0, -3.0), 6.0 - 2.0 * kPi, 1e-15);
  EXPECT_EQ(coordinate_difference(JointKind::slider, 3.0, -3.0), 6.0);
}

/// The line a world with a joint is refused with, "" where it is not.
template <class Spoil>
std::string refusal(Spoil spoil) {
  WorldBench bench;
  const auto block = test::body_mesh(make_box(Vec3(0.04, 0.04, 0.04)));
  bench.add(block, BodyKind::moving, Vec3::Zero());
  bench.add(block, BodyKind::moving, Vec3(0.1, 0.0, 0.0));
  bench.add(block, BodyKind::fixed, Vec3(0.2, 0.0, 0.0));
  bench.add(block, BodyKind::fixed, Vec3(0.3, 0.0, 0.0));
  WorldJoint joint{{.kind = JointKind::hinge, .a = 0, .b = 1}, "lid"};
  std::vector<BodyState> start;
  for (const WorldBody& body : bench.bodies) start.push_back(body.start);
  place_joint(joint, joint_frame(Vec3(0.05, 0.0, 0.0), Vec3::UnitY()), start);
  std::vector<WorldJoint> joints = {joint};
  spoil(joints);
  try {
    make_world(bench.bodies, Vec3::Zero(), joints);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(Joint, RefusesByName) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  using Joints = std::vector<WorldJoint>;
  const struct {
    const char* says;
    void (*spoil)(Joints&);
  } cases[] = {
      {"a body that is not there", [](Joints& j) { j[0].a = 4; }},
      {"a body that is not there", [](Joints& j) { j[0].b = -2; }},
      {"the same body twice", [](Joints& j) { j[0].b = 0; }},
      {"name given twice", [](Joints& j) { j.push_back(j[0]); }},
      {"holds nothing that moves",
       [](Joints& j) {
         j[0].b_from_joint.position = j[0].b_from_joint.position - Vec3(0.2, 0.0, 0.0);
         j[0].a_from_joint.position.x() -= 0.2;
         j[0].a = 2;
         j[0].b = 3;
         j[0].a_from_joint.position = Vec3(0.05, 0.0, 0.0);
         j[0].b_from_joint.position = Vec3(-0.05, 0.0, 0.0);
       }},
      {"its halves start 1 mm apart", [](Joints& j) { j[0].b_from_joint.position.z() += 1e-3; }},
      {"place or axis", [](Joints& j) { j[0].a_from_joint.position.x() = NAN; }},
      {"place or axis", [](Joints& j) { j[0].a_from_joint.orientation.coeffs() *= 2.0; }},
      {"stiffness, damping or rest", [](Joints& j) { j[0].stiffness = -1.0; }},
      {"stiffness, damping or rest", [](Joints& j) { j[0].damping = kNan; }},
      {"turned by half",
       [](Joints& j) {
         j[0].b_from_joint.orientation = j[0].b_from_joint.orientation * Quat(0.0, 1.0, 0.0, 0.0);
       }},
      {"limits 1 to -1", [](Joints& j) { j[0].lower = 1.0, j[0].upper = -1.0; }},
      {"limits nan", [](Joints& j) { j[0].lower = kNan; }},
      {"expected -3 to 3 rad", [](Joints& j) { j[0].upper = 3.5; }},
      {"starts at 0, expected within its limits 0.5 to 1",
       [](Joints& j) { j[0].lower = 0.5, j[0].upper = 1.0; }},
      {"motor, expected", [](Joints& j) { j[0].motor = {.is_on = true, .most = -1.0}; }},
      {"motor, expected", [](Joints& j) { j[0].motor = {.is_on = true, .target = kNan}; }},
      {"limits or a motor, expected them on a hinge",
       [](Joints& j) { j[0].kind = JointKind::ball, j[0].upper = 1.0; }},
      {"stiffness or damping, expected them on",
       [](Joints& j) { j[0].kind = JointKind::fixed, j[0].stiffness = 1.0; }},
      {"a spring without stiffness", [](Joints& j) { j[0].kind = JointKind::spring; }},
  };
  for (const auto& c : cases) {
    const std::string line = refusal(c.spoil);
    EXPECT_EQ(line.find("joint 'lid': "), 0u) << c.says << " | " << line;
    EXPECT_NE(line.find(c.says), std::string::npos) << c.says << " | " << line;
    EXPECT_EQ(line.find('\n'), std::string::npos);
  }
  EXPECT_EQ(refusal([](Joints&) {}), "");
}

}  // namespace
}  // namespace thigma
