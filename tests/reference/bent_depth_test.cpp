#include "reference/bent_depth.h"

#include "depth/textured_plates.h"
#include "reference/depth_hessian.h"
#include "support/jacobian.h"
#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/loop/contact_step.h"
#include "thigma/response/texture_contacts.h"

namespace thigma {
namespace {

DepthTerm any_depth(Random& random) {
  DepthTerm t;
  t.depth = random.uniform(0.0, 1e-3);
  t.linear = random.direction() + random.in_cube(0.3);
  t.angular = random.in_cube(0.05);
  t.stiffness = 2000.0;
  t.damping = random.uniform(0.0, 20.0);
  t.tolerance = 1e-3;
  return t;
}

/// With derivatives by a way of some 1/mm, and of both signs.
GradientByMotion any_bend(Random& random) {
  GradientByMotion bend;
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      bend(i, j) = random.uniform(-1.0, 1.0) * (i < 3 ? 30.0 : 1.5) * (j < 3 ? 30.0 : 1.5);
  return bend;
}

// The depth of a point of the object over a bowl, to second order, against the bowl.
TEST(BentDepth, follows_a_curved_depth) {
  Random random(14);
  constexpr double kCurvature = 40.0;  // [1/m]
  for (int i = 0; i < 100; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState state = test::random_state(random, body, random.orientation());
    state.linear_momentum.setZero();
    state.angular_momentum.setZero();
    const Vec3 arm_body = random.in_cube(0.05), bottom = state.position + random.in_cube(0.05);
    const Mat3 bowl = kCurvature * Vec3(1.0, 0.5, 0.2).asDiagonal();
    const Vec3 n = random.direction();
    // depth(p) = n . (p - bottom) + (p - bottom)^T bowl (p - bottom) / 2 at the point p = x + R
    // arm.
    struct Exact {
      double depth = 0.0;
      Vec6 gradient;
    };
    const auto exact = [&](const BodyState& y) {
      const Vec3 arm = y.orientation * arm_body, p = y.position + arm - bottom,
                 by_point = n + bowl * p;
      Exact e{n.dot(p) + 0.5 * p.dot(bowl * p), {}};
      e.gradient << by_point, arm.cross(by_point);
      return e;
    };
    const Exact here = exact(state);
    const Vec3 arm = state.orientation * arm_body, by_point = here.gradient.head<3>();
    Eigen::Matrix<double, 3, 6> point_by_motion;
    point_by_motion << Mat3::Identity(), -skew(arm);
    GradientByMotion bend = point_by_motion.transpose() * bowl * point_by_motion;
    // the arm turns: d(arm x g) = -g x (w x arm)
    bend.bottomRightCorner<3, 3>() += skew(by_point) * skew(arm);
    DepthTerm term;
    term.depth = here.depth;
    term.linear = here.gradient.head<3>();
    term.angular = here.gradient.tail<3>();
    term.stiffness = 1.0;
    term.tolerance = 10.0;
    const auto errors = [&](double step) {
      BodyState moved = state;
      moved.position += step * Vec3(0.3, -0.5, 0.7);
      moved.orientation =
          rotation_from_vector(20.0 * step * Vec3(-0.4, 0.8, 0.2)) * moved.orientation;
      const Exact want = exact(moved);
      const PlaneForce f = bent_depth_force(term, state, bend, at_state(body, moved));
      EXPECT_EQ(f.depth, bent_depth_at(term, state, bend, moved));
      Vec6 gradient;
      gradient << f.wrench.force, f.wrench.torque;
      gradient /= -f.magnitude;
      return Vec2(std::fabs(f.depth - want.depth), (gradient - want.gradient).norm());
    };
    const Vec2 coarse = errors(2e-4), fine = errors(1e-4);
    EXPECT_LT(fine[0], 0.2 * coarse[0] + 1e-13);  // third order: an eighth
    EXPECT_LT(fine[1], 0.4 * coarse[1] + 1e-11);  // second order: a quarter
  }
}

TEST(BentDepth, never_pulls) {
  Random random(15);
  int bent_over = 0;
  for (int i = 0; i < 2000; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState state = test::random_state(random, body, random.orientation());
    const DepthTerm term = any_depth(random);
    const GradientByMotion bend = any_bend(random);
    const BodyState taken_at = state;
    state.position += random.in_cube(i % 2 == 0 ? 1e-3 : 1e-2);
    const PlaneForce f = bent_depth_force(term, taken_at, bend, at_state(body, state));
    EXPECT_LE(f.wrench.force.dot(term.linear), 0.0);
    bent_over += !f.is_active && f.depth + term.tolerance > 0.0 && f.magnitude > 0.0;
  }
  EXPECT_GT(bent_over, 20);
}

TEST(BentDepth, jacobian_is_its_derivative) {
  Random random(11);
  for (int i = 0; i < 40; ++i) {
    const RigidBody body = test::random_body(random);
    const test::NamedState at{"random", test::random_state(random, body, random.orientation())};
    BodyState taken_at = at.state;
    taken_at.position += random.in_cube(1e-4);
    taken_at.orientation = rotation_from_vector(random.in_cube(1e-2)) * taken_at.orientation;
    if (i % 2 == 1) taken_at.orientation.coeffs() *= -1.0;
    DepthTerm term = any_depth(random);
    term.depth += 3e-3;                                    // far from the clamp's kink
    const GradientByMotion bend = 0.3 * any_bend(random);  // well away from turning over
    ASSERT_TRUE(bent_depth_force(term, taken_at, bend, at_state(body, at.state)).is_active);
    test::expect_jacobian(
        [&](const BodyState& y, WrenchJacobian* J) {
          if (J) J->setZero();
          return bent_depth_force(term, taken_at, bend, at_state(body, y), J).wrench;
        },
        body, at, 1e-7);
  }
}

TEST(BentDepth, without_a_bend_is_the_depth_term) {
  Random random(16);
  for (int i = 0; i < 100; ++i) {
    const RigidBody body = test::random_body(random);
    BodyState state = test::random_state(random, body, random.orientation());
    const BodyState taken_at = state;
    const DepthTerm term = any_depth(random);
    state.position += random.in_cube(1e-3);
    const BodyAtState at = at_state(body, state);
    WrenchJacobian J = WrenchJacobian::Zero(), J_bent = J;
    const PlaneForce plain = depth_force(term, taken_at, at, 1.0, &J),
                     bent = bent_depth_force(term, taken_at, GradientByMotion::Zero(), at, &J_bent);
    EXPECT_EQ(plain.depth, bent.depth);
    EXPECT_EQ(plain.wrench.torque, bent.wrench.torque);
    EXPECT_EQ(J, J_bent);
  }
}

/// One hill under another.
struct HillUnderHill {
  HillUnderHill()
      : object(build_exact_hierarchy(hills.object.coarse)),
        scene(build_exact_hierarchy(hills.scene.coarse)) {
    world.object = &object;
    world.scene = {{&scene, Pose{}}};
    world.tolerance = 1e-4;
    world.max_clusters = 1;
    world.response = {.stiffness = 5000.0, .damping = 0.0};
    world.textures.object = make_textured_body(hills.object, object);
    world.textures.scene = {make_textured_body(hills.scene, scene)};
    world.textures.params = {.gradient = GradientKind::envelope};
    reserve_contact_scratch(world, scratch);
  }
  LinearContactModel at(const BodyState& state) {
    ContactSample sample;
    StampedBody body;
    body.state = state;
    contact_step(world, body, scratch, sample);
    return sample.model;
  }
  test::Hills hills;
  ClodHierarchy object, scene;
  ContactWorld world;
  ContactScratch scratch;
};

// The wrench away from where the model was taken, against that of a model taken
// there: the error falls with the square of the way instead of the way itself.
TEST(BentDepth, follows_the_gradient_of_a_session) {
  HillUnderHill pair;
  RigidBody body;
  body.mass = 0.01;
  BodyState state;
  state.position = {4e-4, -7e-4, 1e-4};
  state.orientation = rotation_from_vector(Vec3(0.01, 0.02, 0.4));
  const LinearContactModel model = pair.at(state);
  ASSERT_EQ(model.depths.size(), 1u);
  GradientScratch scratch;
  const TextureScratch& found = *pair.scratch.textures;
  const DepthHessian hessian = depth_hessian(found.contacts[0], found.samples[0], scratch);
  ASSERT_TRUE(hessian.is_valid);
  EXPECT_NEAR(hessian.gradient_by_motion.trace(), -24.0, 1.0);  // of 20 and 30 1/m, each way: 12
  const auto six = [](const Wrench& w) {
    Vec6 v;
    v << w.force, w.torque;
    return v;
  };
  BodyState moved = state;
  moved.position += Vec3(5e-4, 3e-4, 5e-5);
  moved.orientation = rotation_from_vector(Vec3(0.0, 0.0, 4e-3)) * moved.orientation;
  const BodyAtState there = at_state(body, moved);
  const Vec6 want = six(contact_wrench(pair.at(moved), there));
  const Vec6 first_order = six(contact_wrench(model, there));
  const Vec6 second_order =
      six(bent_depth_force(model.depths[0], model.state, hessian.gradient_by_motion, there).wrench);
  EXPECT_GT(want.head<3>().norm(), 0.3);
  EXPECT_GT((first_order - want).norm(), 4e-3);
  EXPECT_LT((second_order - want).norm(), 5e-5);
}

}  // namespace
}  // namespace thigma
