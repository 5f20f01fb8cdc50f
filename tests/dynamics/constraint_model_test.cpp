#include "thigma/dynamics/constraint_model.h"

#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "thigma/math/random.h"
#include "thigma/math/rotation.h"

namespace thigma {
namespace {

Vec3 random_vector(Random& random) { return {random.normal(), random.normal(), random.normal()}; }

ContactRow random_row(Random& random, RowKind kind) {
  ContactRow row = make_row(kind);
  row.object_point = random_vector(random);
  row.scene_point = random_vector(random);
  row.object_direction = random_vector(random).normalized();
  row.scene_direction = random_vector(random).normalized();
  return row;
}

TEST(ConstraintModel, GradientsAreThoseOfTheGap) {
  Random random(5);
  for (const RowKind kind : {RowKind::scene_plane, RowKind::object_plane, RowKind::edges}) {
    for (int trial = 0; trial < 50; ++trial) {
      const ContactRow row = random_row(random, kind);
      const Vec3 x = random_vector(random);
      const Mat3 rotation = rotation_matrix(rotation_from_vector(random_vector(random)));
      const RowAtState at = row_at(row, x, rotation);
      EXPECT_NEAR(at.normal.norm(), 1.0, 1e-12);
      const Vec3 v = random_vector(random), omega = random_vector(random);
      const double h = 1e-6;
      const auto gap = [&](double t) {
        const Mat3 turn = rotation_matrix(rotation_from_vector(t * omega));
        return row_at(row, x + t * v, turn * rotation).gap;
      };
      const double rate = (gap(h) - gap(-h)) / (2.0 * h);
      const double expected = -(at.normal.dot(v) + at.arm.cross(at.normal).dot(omega));
      EXPECT_NEAR(rate, expected, 1e-6 * (1.0 + std::fabs(expected) + std::fabs(at.gap)))
          << static_cast<int>(kind) << " " << trial;
    }
  }
}

TEST(ConstraintModel, GradientsOfReliefAreThoseOfTheGapWhereItIsZero) {
  Random random(6);
  for (int trial = 0; trial < 50; ++trial) {
    ContactRow row = random_row(random, RowKind::relief);
    row.object_direction = 0.1 * random_vector(random);
    if (trial % 2 == 1)
      row.plane = (row.scene_direction + 0.5 * random_vector(random)).normalized();
    const Mat3 rotation = rotation_matrix(rotation_from_vector(random_vector(random)));
    Vec3 x = row.scene_point - rotation * row.object_point;
    x += 0.5 * tangents_of(row.scene_direction).first;
    for (int k = 0; k < 30; ++k) {
      const RowAtState at = row_at(row, x, rotation);
      x += at.gap * at.normal;
    }
    const RowAtState at = row_at(row, x, rotation);
    EXPECT_NEAR(at.gap, 0.0, 1e-9);
    EXPECT_NEAR(at.normal.norm(), 1.0, 1e-12);
    const Vec3 v = random_vector(random), omega = random_vector(random);
    const double h = 1e-6;
    const auto gap = [&](double t) {
      const Mat3 turn = rotation_matrix(rotation_from_vector(t * omega));
      return row_at(row, x + t * v, turn * rotation).gap;
    };
    const double expected = -(at.normal.dot(v) + at.arm.cross(at.normal).dot(omega));
    EXPECT_NEAR((gap(h) - gap(-h)) / (2.0 * h), expected, 1e-6 * (1.0 + std::fabs(expected)));
  }
}

TEST(ConstraintModel, ReliefWithoutBendIsAPlane) {
  Random random(8);
  for (int trial = 0; trial < 50; ++trial) {
    ContactRow plane = random_row(random, RowKind::scene_plane);
    ContactRow relief = plane;
    relief.kind = RowKind::relief;
    relief.object_direction.setZero();
    const Vec3 x = random_vector(random);
    const Mat3 rotation = rotation_matrix(rotation_from_vector(random_vector(random)));
    EXPECT_NEAR(row_at(plane, x, rotation).gap, row_at(relief, x, rotation).gap, 1e-12);
  }
}

TEST(ConstraintModel, ParallelEdgesForbidNothing) {
  ContactRow row = make_row(RowKind::edges);
  row.object_direction = row.scene_direction = Vec3::UnitX();
  EXPECT_TRUE(std::isinf(row_at(row, Vec3::Zero(), Mat3::Identity()).gap));
}

TEST(ConstraintModel, TravelBoundsTheWayOfEveryPoint) {
  Random random(9);
  for (int trial = 0; trial < 200; ++trial) {
    BodyState a, b;
    a.position = random_vector(random);
    b.position = a.position + 0.1 * random_vector(random);
    a.orientation = rotation_from_vector(random_vector(random));
    b.orientation = rotation_from_vector(0.5 * random_vector(random)) * a.orientation;
    const double reach = 0.7;
    const Vec3 point = reach * random_vector(random).normalized();
    const Vec3 from = a.position + a.orientation * point, to = b.position + b.orientation * point;
    EXPECT_LE((to - from).norm(), travel_between(a, b, reach) * (1.0 + 1e-12));
  }
}

/// A model made at a state, with one row: the origin of the body stays below a height.
std::unique_ptr<ConstraintModel> below(double height, const BodyState& state, double travel) {
  auto model = std::make_unique<ConstraintModel>();
  model->state = state;
  model->travel = travel;
  model->reach = 0.02;
  ContactRow row = make_row(RowKind::scene_plane);
  row.scene_point = {0.0, 0.0, height};
  row.scene_direction = Vec3::UnitZ();
  model->rows.push_back(row);
  return model;
}

TEST(ConstraintModel, IsTakenWhereTheBodyHasPassedNoneOfItsRows) {
  BodyState then, now;
  now.position = {0.0, 0.0, 1e-3};  // since the offered model was made
  const auto held = below(0.1, then, 0.01);
  EXPECT_TRUE(may_take(*below(2e-3, then, 0.01), *held, now));
  EXPECT_FALSE(may_take(*below(0.5e-3, then, 0.01), *held, now));  // passed
  EXPECT_FALSE(may_take(*below(2e-3, then, 0.5e-3), *held, now));  // says nothing here
  EXPECT_TRUE(may_take(*below(0.5e-3, now, 0.01), *held, now));    // made here: nothing is newer
  EXPECT_TRUE(may_take(*below(0.5e-3, then, 0.01), *below(0.1, then, 0.5e-3), now));
  EXPECT_TRUE(may_take(*below(0.7e-3, then, 0.01), *below(0.6e-3, then, 0.01), now));
  auto relief = below(0.5e-3, then, 0.01);
  relief->rows[0].kind = RowKind::relief;
  EXPECT_TRUE(may_take(*relief, *held, now));
}

}  // namespace
}  // namespace thigma
