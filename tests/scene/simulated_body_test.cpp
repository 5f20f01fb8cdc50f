#include "thigma/scene/simulated_body.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/scene/scene_file.h"

namespace thigma {
namespace {

std::string scene_with(const std::string& keys) {
  return "[object]\nmesh = \"procedural:ellipsoid\"\n[[static]]\nmesh = "
         "\"procedural:ellipsoid\"\n" +
         keys;
}

TEST(SimulatedBody, IsReadFromItsTable) {
  const std::string text = scene_with(
      "[simulation]\nrestitution = 0.25\nfriction = 0.5\nrolling = 0.001\nspin = [1.0, 2.0, "
      "3.0]\nscatter = 0.01\n");
  const auto body = parse_simulated_body(text, "s.toml");
  ASSERT_TRUE(body.has_value());
  EXPECT_EQ(body->law.restitution, 0.25);
  EXPECT_EQ(body->law.friction, 0.5);
  EXPECT_EQ(body->law.rolling, 0.001);
  EXPECT_EQ(body->spin, Vec3(1, 2, 3));
  EXPECT_EQ(body->scatter, 0.01);
  EXPECT_FALSE(body->has_tolerance);
  EXPECT_NO_THROW(parse_scene(text, "s.toml", ""));
  EXPECT_FALSE(parse_simulated_body(scene_with(""), "s.toml").has_value());
}

TEST(SimulatedBody, IsReadBehindAByteOrderMark) {
  const auto body =
      parse_simulated_body("\xEF\xBB\xBF" + scene_with("[simulation]\nfriction = 0.5\n"), "s.toml");
  ASSERT_TRUE(body.has_value());
  EXPECT_EQ(body->law.friction, 0.5);
}

TEST(SimulatedBody, RefusesWhatItDoesNotKnow) {
  for (const char* keys : {"restitution = 1.5", "restitution = -0.1", "friction = -1.0",
                           "rolling = -1.0", "bounce = 1.0", "spin = 3.0"}) {
    EXPECT_THROW(
        parse_simulated_body(scene_with("[simulation]\n" + std::string(keys) + "\n"), "s.toml"),
        InputError)
        << keys;
  }
}

TEST(SimulatedBody, OfTheBuiltInSceneFalls) {
  const auto body = read_scene("spoon_in_cup").simulation;
  ASSERT_TRUE(body.has_value());
  EXPECT_GT(body->scatter, 0.0);
  EXPECT_LT(read_scene("spoon_in_cup").gravity.z(), 0.0);
  EXPECT_FALSE(read_scene("jaws").simulation.has_value());
}

}  // namespace
}  // namespace thigma
