#include "thigma/scene/write_scene.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

void expect_same_pose(const Pose& a, const Pose& b) {
  EXPECT_EQ(a.position, b.position);
  // Reading normalises: another rounding, where it was not read before.
  EXPECT_LT((a.orientation.coeffs() - b.orientation.coeffs()).norm(), 4e-16);
}

void expect_same_object(const SceneObject& a, const SceneObject& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.mesh, b.mesh);
  EXPECT_EQ(a.is_textured, b.is_textured);
  EXPECT_EQ(a.level_textures, b.level_textures);
  EXPECT_EQ(a.unit_scale, b.unit_scale);
  expect_same_pose(a.world_from_mesh, b.world_from_mesh);
  ASSERT_EQ(a.material.has_value(), b.material.has_value());
  if (!a.material) return;
  EXPECT_EQ(a.material->friction.kinetic, b.material->friction.kinetic);
  EXPECT_EQ(a.material->friction.at_rest, b.material->friction.at_rest);
  EXPECT_EQ(a.material->restitution, b.material->restitution);
  EXPECT_EQ(a.material->tap_frequency, b.material->tap_frequency);
}

void expect_same_scene(const SceneDescription& a, const SceneDescription& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.repairs, b.repairs);
  expect_same_object(a.object, b.object);
  ASSERT_EQ(a.statics.size(), b.statics.size());
  for (std::size_t i = 0; i < a.statics.size(); ++i) expect_same_object(a.statics[i], b.statics[i]);
  EXPECT_EQ(a.mass, b.mass);
  EXPECT_EQ(a.density, b.density);
  EXPECT_EQ(a.grasp_point, b.grasp_point);
  EXPECT_EQ(a.gravity, b.gravity);
  EXPECT_EQ(a.contact.stiffness, b.contact.stiffness);
  EXPECT_EQ(a.contact.tolerance, b.contact.tolerance);
  EXPECT_EQ(a.contact.response, b.contact.response);
  EXPECT_EQ(a.contact.friction.kinetic, b.contact.friction.kinetic);
  EXPECT_EQ(a.contact.resolution.metric.haptic, b.contact.resolution.metric.haptic);
  EXPECT_EQ(a.coupling.linear_stiffness, b.coupling.linear_stiffness);
  EXPECT_EQ(a.device.uri, b.device.uri);
  EXPECT_EQ(a.device.approach, b.device.approach);
  EXPECT_EQ(a.safety.force_slew, b.safety.force_slew);
  EXPECT_EQ(a.safety.max_force, b.safety.max_force);
  EXPECT_EQ(a.is_passive, b.is_passive);
  EXPECT_EQ(a.rate, b.rate);
  EXPECT_EQ(a.simulation.has_value(), b.simulation.has_value());
  if (a.simulation) {
    EXPECT_EQ(a.simulation->spin, b.simulation->spin);
  }
}

TEST(WriteScene, EveryBuiltInSceneComesBack) {
  for (const std::string& name : builtin_scene_names()) {
    SCOPED_TRACE(name);
    const SceneDescription scene = read_scene(name);
    const SceneDescription back = parse_scene(write_scene(scene), name, "");
    expect_same_scene(back, scene);
    EXPECT_EQ(back.object.world_from_mesh.orientation.coeffs(),
              scene.object.world_from_mesh.orientation.coeffs());
  }
}

TEST(WriteScene, AScenePutTogetherInCodeComesBack) {
  const Quat turned = Quat(0.3, -0.1, 0.7, 0.2).normalized();
  SceneDescription scene = scene_from_pair("procedural:ball?triangles=320", "procedural:box", 0.5,
                                           {Vec3(1.0 / 3.0, -0.02, 1e-17), turned});
  scene.object.name = "a \"ball\"\\ of \xC3\xA9";
  scene.object.material = Material{{0.31, 0.42}, 0.25, 3.0, 140.0, 0.01};
  scene.statics[0].world_from_mesh.position = Vec3(0.1, 0.2, 0.3);
  scene.density = 1200.5;
  scene.repairs = true;
  scene.grasp_point = Vec3(0.001, 0.0, -0.002);
  scene.gravity = Vec3(0, 0, -9.81);
  scene.contact.response = ResponseKind::coupled;
  scene.contact.friction = {0.2, 0.2};
  scene.safety.force_slew = 123.5;
  scene.is_passive = true;
  scene.rate = 500.0;
  expect_same_scene(parse_scene(write_scene(scene), "pair", ""), scene);
}

TEST(WriteScene, NamesThatNoSceneMayHaveAreWrittenPlain) {
  SceneDescription scene = read_scene("jaws");
  for (const auto& [given, written] : std::vector<std::pair<std::string, std::string>>{
           {"a\nb\x7f\x1b", "a?b??"},
           {"\xff\xfe", "??"},
           {"cut \xC3", "cut ?"},
           {"\xED\xA0\x80", "???"},
           {"\xC0\xAF", "??"},
           {"\xF0\x9F\x98\x80 is fine", "\xF0\x9F\x98\x80 is fine"}}) {
    scene.title = scene.object.name = given;
    const SceneDescription back = parse_scene(write_scene(scene), "names", "");
    EXPECT_EQ(back.object.name, written);
    EXPECT_EQ(back.title, written);
  }
}

TEST(WriteScene, OtherTablesStayAsTheyWereRead) {
  SceneDescription scene = read_scene("jaws");
  scene.object.world_from_mesh.position = Vec3(0, 0, 0.01);
  scene.mass = 0.02;
  const SceneDescription back = parse_scene(write_scene(scene), "jaws", "");
  expect_same_scene(back, scene);
  EXPECT_EQ(back.contact.stiffness, read_scene("jaws").contact.stiffness);
}

}  // namespace
}  // namespace thigma
