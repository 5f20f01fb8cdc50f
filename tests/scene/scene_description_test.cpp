#include "thigma/scene/scene_description.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/random.h"
#include "thigma/mesh/self_intersections.h"
#include "thigma/mesh/shapes.h"
#include "thigma/models/make_model.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

SceneDescription ball_scene(const std::string& rest = "") {
  return parse_scene("[object]\nmesh = \"procedural:ball?triangles=2000\"\n" + rest, "S.toml", "");
}

TEST(BuiltinScenes, LoadAndStandApart) {
  for (const std::string& name : builtin_scene_names()) {
    SCOPED_TRACE(name);
    const SceneDescription scene = read_scene(name);
    const LoadedObject object = load_object(scene.object);
    TriangleMesh all = transformed(object.mesh, scene.object.world_from_mesh);
    ASSERT_GE(scene.statics.size(), 1u);
    // A hammer's head and handle are two components that lie in each other.
    auto own = find_self_intersections(object.mesh).pairs;
    for (const SceneObject& other : scene.statics) {
      const TriangleMesh mesh = load_object(other).mesh;
      own += find_self_intersections(mesh).pairs;
      all = joined(all, transformed(mesh, other.world_from_mesh));
    }
    EXPECT_EQ(find_self_intersections(all).pairs, own) << "objects overlap as given";
    const SessionConfig config = make_session_config(scene, object);
    EXPECT_GT(config.contact.tolerance, 0.0);
    EXPECT_LT(config.contact.tolerance, 0.05 * object.ball.radius);
    EXPECT_NE(config.haptic.body.inertia.trace(), 0.0);
  }
}

TEST(BuiltinScenes, JawsBiteInManyPlacesAndNotAsGiven) {
  // Closed they are apart; three tenths of a millimetre further they touch all along the arch.
  const TriangleMesh lower = models::make_model({.name = "jaw_lower"});
  const TriangleMesh upper = models::make_model({.name = "jaw_upper"});
  EXPECT_EQ(find_self_intersections(joined(lower, upper)).pairs, 0);
  Pose pressed;
  pressed.position = {0.0, 0.0, -0.3e-3};
  const TriangleMesh both = joined(lower, transformed(upper, pressed));
  const SelfIntersections bite = find_self_intersections(both, true);
  bool left = false, right = false, front = false;
  for (const auto& pair : bite.found) {
    const Vec3& p = both.positions[both.triangles[pair[0]][0]];
    left = left || p.x() < -0.015;
    right = right || p.x() > 0.015;
    front = front || p.y() > 0.035;
  }
  EXPECT_GE(bite.pairs, 50);
  EXPECT_TRUE(left && right && front);
}

TEST(SessionConfig, FollowsTheSceneWhereItSpeaks) {
  const SceneDescription scene = ball_scene(R"(mass = 0.05
position = [1, 2, 3]
grasp_point = [0.01, 0, 0]
[contact]
stiffness = 5000
damping = 9
tolerance = 0.001
clusters = 3
[coupling]
linear_stiffness = 500
angular_stiffness = 2
linear_damping = 4
angular_damping = 0.02
saturated = false
[device]
motion_scale = 0.4
[solver]
rate = 4000
)");
  const SessionConfig config = make_session_config(scene, load_object(scene.object));
  EXPECT_EQ(config.haptic.body.mass, 0.05);
  EXPECT_LT((config.world_from_body.position - Vec3(1, 2, 3)).norm(), 1e-9);
  EXPECT_LT((config.haptic.grasp_point - Vec3(0.01, 0, 0)).norm(), 1e-9);
  EXPECT_EQ(config.contact.response.stiffness, 5000.0);
  EXPECT_EQ(config.contact.response.damping, 9.0);
  EXPECT_EQ(config.contact.tolerance, 0.001);
  EXPECT_EQ(config.contact.max_clusters, 3);
  EXPECT_EQ(config.haptic.coupling.linear_stiffness, 500.0);
  EXPECT_EQ(config.haptic.coupling.linear_damping, 4.0);
  EXPECT_EQ(config.haptic.coupling.angular_stiffness, 2.0);
  EXPECT_EQ(config.haptic.coupling.angular_damping, 0.02);
  EXPECT_FALSE(config.haptic.coupling.linear_saturation.has_value());
  EXPECT_EQ(config.haptic.workspace.motion_scale, 0.4);
  EXPECT_EQ(config.haptic.workspace.force_scale, 2.5);  // keeps the stiffness felt
  EXPECT_EQ(config.rate, 4000.0);
}

TEST(SessionConfig, DampingRatiosBecomeDampings) {
  const SceneDescription scene = ball_scene(
      "mass = 0.04\n[contact]\nstiffness = 2500\ndamping_ratio = 0.5\n"
      "[coupling]\nlinear_stiffness = 400\ndamping_ratio = 0.25\n");
  const SessionConfig config = make_session_config(scene, load_object(scene.object));
  EXPECT_DOUBLE_EQ(config.contact.response.damping, 2.0 * 0.5 * std::sqrt(2500 * 0.04));
  EXPECT_DOUBLE_EQ(config.haptic.coupling.linear_damping, 2.0 * 0.25 * std::sqrt(400 * 0.04));
}

TEST(SessionConfig, BodySitsAtTheCentreOfMassWithItsInertia) {
  SceneDescription scene =
      scene_from_pair("procedural:cup?triangles=4000", "procedural:ball?triangles=320");
  scene.object.world_from_mesh.position = {0.1, 0.2, 0.3};
  scene.object.world_from_mesh.orientation = Quat(0.5, 0.5, 0.5, 0.5);
  const LoadedObject cup = load_object(scene.object);
  const SessionConfig config = make_session_config(scene, cup);
  const Vec3 world = transform_point(scene.object.world_from_mesh, cup.measure.center_of_mass);
  EXPECT_LT((config.world_from_body.position - world).norm(), 1e-15);
  // Any mesh point reaches the same place through the body.
  const Vec3 p(0.03, -0.02, 0.05);
  const Vec3 through =
      transform_point(config.world_from_body, transform_point(config.contact.body_from_mesh, p));
  EXPECT_LT((through - transform_point(scene.object.world_from_mesh, p)).norm(), 1e-15);
  EXPECT_NEAR(config.haptic.body.inertia.trace() / cup.measure.inertia.trace(),
              kDefaultMass / cup.measure.volume, 1e-9 * kDefaultMass / cup.measure.volume);
}

TEST(SessionConfig, DensityNeedsAVolume) {
  const SceneDescription scene = ball_scene("density = 1000\n");
  const LoadedObject ball = load_object(scene.object);
  EXPECT_DOUBLE_EQ(make_session_config(scene, ball).haptic.body.mass, 1000.0 * ball.measure.volume);
  LoadedObject open = ball;
  open.mesh = make_sheet(0.1, 0.1, 4, 4);
  open.measure = mass_properties(open.mesh);
  open.ball = enclosing_ball(open.mesh.positions);
  EXPECT_THROW(make_session_config(scene, open), InputError);
  // With a mass an open sheet can be held.
  EXPECT_EQ(make_session_config(ball_scene("mass = 0.02\n"), open).haptic.body.mass, 0.02);
}

TEST(DefaultGains, StiffnessAndMassStayWhereLengthsScale) {
  for (const double radius : {1e-9, 1e-3, 0.02, 0.06, 0.5, 1e3}) {
    SCOPED_TRACE(radius);
    const DefaultGains gains = default_gains(radius);
    const double s = gains.motion_scale;
    EXPECT_GE(radius / s, 0.025 * (1 - 1e-12));  // of the object as the device sees it
    EXPECT_LE(radius / s, 0.10 * (1 + 1e-12));
    EXPECT_DOUBLE_EQ(gains.tolerance / radius, 0.01);
    EXPECT_DOUBLE_EQ(gains.max_force / s, 4.0);
    EXPECT_GE(gains.contact_stiffness, 2000.0);
    EXPECT_LE(gains.contact_stiffness, 5000.0);
    // Pressed with 1 N at the device the surfaces stay apart.
    EXPECT_GE(gains.contact_stiffness * gains.tolerance, 1.0 * s);
    EXPECT_GE(gains.linear_stiffness, 200.0);  // the text's range
    EXPECT_LE(gains.linear_stiffness, 500.0);
    EXPECT_GT(gains.max_torque / s / s, 0.0);
    const SceneDescription scene = scene_from_pair("procedural:ball?triangles=320",
                                                   "procedural:ball?triangles=320", radius / 0.05);
    const SessionConfig config = make_session_config(scene, load_object(scene.object));
    // The device feels the same stiffness at every size.
    EXPECT_DOUBLE_EQ(config.haptic.workspace.motion_scale * config.haptic.workspace.force_scale,
                     1.0);
  }
  EXPECT_EQ(default_gains(0.05).motion_scale, 1.0);
}

TEST(SceneFromPair, TakesModelsAndRefusesNonsense) {
  Pose pose;
  pose.position = {1, 2, 3};
  const SceneDescription scene = scene_from_pair("procedural:spoon?triangles=1344",
                                                 "procedural:cup?triangles=4000", 0.5, pose);
  EXPECT_EQ(scene.object.name, "spoon");
  EXPECT_EQ(scene.object.unit_scale, 0.5);
  EXPECT_EQ(scene.object.world_from_mesh.position, Vec3(1, 2, 3));
  ASSERT_EQ(scene.statics.size(), 1u);
  EXPECT_EQ(scene.statics[0].unit_scale, 0.5);
  EXPECT_EQ(scene.statics[0].world_from_mesh.position, Vec3(0, 0, 0));
  EXPECT_THROW(scene_from_pair("gone.obj", "procedural:ball"), InputError);
  EXPECT_THROW(scene_from_pair("procedural:ball", "procedural:bal"), InputError);
  EXPECT_THROW(scene_from_pair("procedural:ball", "procedural:ball", 0.0), InputError);
  EXPECT_THROW(scene_from_pair("procedural:ball", "procedural:ball", std::nan("")), InputError);
}

constexpr CombineRule kRules[] = {CombineRule::geometric, CombineRule::average,
                                  CombineRule::minimum, CombineRule::maximum};

TEST(Friction, PairsAreBetweenTheirMaterialsAndTheSameEitherWay) {
  Random random(5);
  for (int trial = 0; trial < 1000; ++trial) {
    const double a = random.uniform(0.0, 2.0), b = random.uniform(0.0, 2.0);
    const Friction first{a, a * random.uniform(1.0, 3.0)}, second{b, b * random.uniform(1.0, 3.0)};
    for (const CombineRule rule : kRules) {
      const Friction pair = combined(first, second, rule);
      EXPECT_EQ(pair, combined(second, first, rule));
      EXPECT_TRUE(is_valid(pair)) << pair.kinetic << " " << pair.at_rest;
      EXPECT_GE(pair.kinetic, std::min(a, b) * (1.0 - 1e-15));
      EXPECT_LE(pair.kinetic, std::max(a, b) * (1.0 + 1e-15));
      EXPECT_EQ(combined(first, first, rule), first);  // to the last bit
    }
  }
}

TEST(Friction, RulesAreWhatTheirNamesSay) {
  const Friction a{0.2, 0.45}, b{0.8, 0.8};
  EXPECT_NEAR(combined(a, b, CombineRule::geometric).kinetic, 0.4, 1e-15);
  EXPECT_NEAR(combined(a, b, CombineRule::geometric).at_rest, 0.6, 1e-15);
  EXPECT_NEAR(combined(a, b, CombineRule::average).kinetic, 0.5, 1e-15);
  EXPECT_EQ(combined(a, b, CombineRule::minimum).at_rest, 0.45);
  EXPECT_EQ(combined(a, b, CombineRule::maximum).kinetic, 0.8);
  // What has no friction slides on everything.
  EXPECT_EQ(combined(Friction{}, b, CombineRule::geometric), Friction{});
  // Out of range only where the materials are.
  const double large = 1e300;
  EXPECT_TRUE(is_valid(combined({large, large}, {0.5 * large, large}, CombineRule::geometric)));
}

TEST(Friction, KnowsWhatMakesNoSense) {
  EXPECT_TRUE(is_valid(Friction{0.0, 0.0}));
  EXPECT_TRUE(is_valid(Friction{0.0, 0.5}));
  EXPECT_FALSE(is_valid(Friction{-0.1, 0.5}));
  EXPECT_FALSE(is_valid(Friction{0.5, 0.4}));
  EXPECT_FALSE(is_valid(Friction{std::nan(""), 0.5}));
  EXPECT_FALSE(is_valid(Friction{0.5, std::nan("")}));
  EXPECT_FALSE(is_valid(Friction{0.5, std::numeric_limits<double>::infinity()}));
}

TEST(Friction, OfASceneMadeInCodeIsRefusedWhereItMakesNoSense) {
  for (const Friction bad :
       {Friction{-0.1, 0.5}, Friction{0.5, 0.4}, Friction{0.5, std::nan("")}}) {
    SceneDescription scene = ball_scene("[[static]]\nmesh = \"procedural:ball?triangles=2000\"\n");
    scene.statics[0].material = Material{bad};
    try {
      make_session_config(scene, load_object(scene.object));
      FAIL() << bad.kinetic << " " << bad.at_rest;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("S.toml: friction"), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("of ball, expected"), std::string::npos);
    }
  }
}

TEST(PairImpacts, LargerRestitutionAndTheMeanOfTaps) {
  SceneDescription scene = ball_scene("[[static]]\nmesh = \"procedural:ball?triangles=2000\"\n");
  scene.taps.usual = {4.0, 200.0, 0.01};
  EXPECT_TRUE(pair_impacts(scene).empty());
  scene.object.material = Material{{0.0, 0.0}, 0.2, 9.0, 100.0, 0.02};
  scene.statics[0].material = Material{{0.0, 0.0}, 0.5, {}, {}, {}};
  ASSERT_EQ(pair_impacts(scene).size(), 1u);
  EXPECT_EQ(pair_impacts(scene)[0], (ImpactPair{0.5, Tap{}}));  // taps are off
  scene.taps.is_on = true;
  const ImpactPair pair = pair_impacts(scene)[0];
  EXPECT_NEAR(pair.tap.amplitude, 6.0, 1e-12);
  EXPECT_NEAR(pair.tap.frequency, std::sqrt(2e4), 1e-9);
  EXPECT_NEAR(pair.tap.decay, std::sqrt(2e-4), 1e-12);
  EXPECT_EQ(make_session_config(scene, load_object(scene.object)).haptic.impacts,
            pair_impacts(scene));
  scene.statics[0].material->tap_amplitude = 0.0;  // it rings with nothing
  EXPECT_EQ(pair_impacts(scene)[0].tap.amplitude, 0.0);
  scene.statics[0].material->restitution = 1.5;
  EXPECT_THROW(pair_impacts(scene), InputError);
}

}  // namespace
}  // namespace thigma
