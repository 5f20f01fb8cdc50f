#include "thigma/recording/config_json.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/math/random.h"

namespace thigma {
namespace {

RecordedConfig example() {
  Random random(5);
  RecordedConfig c;
  Mat3 inertia = Vec3(2e-6, 3e-6, 4e-6).asDiagonal();
  inertia(0, 1) = inertia(1, 0) = 1.23456789e-7;
  c.params.body = make_body(0.01, inertia, Vec3(0, 0, -9.81));
  c.params.coupling.linear_stiffness = 1.0 / 3.0 * 1000.0;
  c.params.coupling.linear_damping = 1.1;
  c.params.coupling.angular_stiffness = 0.6;
  c.params.coupling.angular_damping = 0.0021;
  c.params.coupling.linear_saturation = Saturation{333.0, 0.01, 0.02, 3.3};
  c.params.workspace.world_from_device = {random.in_cube(1.0), random.orientation()};
  c.params.workspace.motion_scale = 0.4;
  c.params.workspace.force_scale = 2.5;
  c.params.safety.force_slew = 123.0;
  c.params.device.actuates_rotation = false;
  c.params.grasp_place = GraspPlace::handle;
  c.params.grasp_point = random.in_cube(0.1);
  c.params.resumes_lost_device = true;
  c.params.device.holds_person = false;
  c.params.safety.rides_out_gaps = true;
  c.params.device.delay = 0.0123;
  c.params.passivity = passivity_for(300.0, 0.2, 1e-3, 0.0123);
  c.params.passivity.credit = 2e-5;
  c.world_from_body = {random.in_cube(1.0), random.orientation()};
  c.params.response = ResponseKind::direct;
  c.resolution.is_exact = false;
  c.resolution.metric = {.haptic = 0.01, .velocity = 0.5, .view = {2.0, 0.5, 0.1, 0.2, 1024.0}};
  c.resolution.deviation_cap = kNoCap;
  c.resolution.coarsest_level = 4;
  c.resolution.reading = SupportReading::one_ring;
  c.resolution.area = SupportArea::smaller;
  c.resolution.interpolates = false;
  c.resolution.budget_tests = 500;
  c.resolution.budget_cpu = 2e-4;
  c.resolution.carry = 0.15;
  c.friction = {{0.1, 1.0 / 3.0}, {0.0, 0.0}};
  c.params.impacts = {{1.0 / 3.0, {0.1, 150.0, 0.7}}, {}};
  c.rate_hz = 2000.0;
  c.is_lockstep = true;
  c.seed = 18446744073709551615ull;
  c.scene = "a \"quoted\" path/with\nnewline";
  c.device = "hand:";
  return c;
}

// Writing what was read gives the same line: nothing is lost, to the last bit.
TEST(ConfigJson, round_trip_loses_nothing) {
  const RecordedConfig config = example();
  const std::string text = write_config(config);
  const RecordedConfig back = read_config(text);
  EXPECT_EQ(write_config(back), text);
  EXPECT_EQ(back.scene, config.scene);
  EXPECT_EQ(back.seed, config.seed);
  EXPECT_EQ(back.params.body.inertia, config.params.body.inertia);
  EXPECT_EQ(back.params.body.inverse_inertia, config.params.body.inverse_inertia);
  EXPECT_EQ(back.params.workspace.world_from_device.position,
            config.params.workspace.world_from_device.position);
  EXPECT_EQ(back.params.safety.force_slew, 123.0);
  EXPECT_EQ(back.params.device.delay, 0.0123);
  EXPECT_TRUE(back.params.passivity.is_on);
  EXPECT_EQ(back.params.passivity.credit, 2e-5);
  EXPECT_FALSE(back.params.device.actuates_rotation);
  EXPECT_TRUE(back.params.resumes_lost_device);
  EXPECT_FALSE(back.params.device.holds_person);
  EXPECT_TRUE(back.params.safety.rides_out_gaps);
  EXPECT_EQ(back.params.response, ResponseKind::direct);
  const Resolution& r = back.resolution;
  EXPECT_FALSE(r.is_exact);
  EXPECT_EQ(r.metric.haptic, 0.01);
  EXPECT_EQ(r.metric.velocity, 0.5);
  EXPECT_EQ(r.metric.view.pixels, 2.0);
  EXPECT_EQ(r.metric.view.image_size, 1024.0);
  EXPECT_EQ(r.deviation_cap, kNoCap);
  EXPECT_EQ(r.coarsest_level, 4);
  EXPECT_EQ(r.reading, SupportReading::one_ring);
  EXPECT_EQ(r.area, SupportArea::smaller);
  EXPECT_FALSE(r.interpolates);
  EXPECT_EQ(r.budget_tests, 500);
  EXPECT_EQ(r.budget_cpu, 2e-4);
  EXPECT_EQ(r.carry, 0.15);
  EXPECT_EQ(back.friction, config.friction);
  EXPECT_EQ(back.params.impacts, config.params.impacts);
  EXPECT_TRUE(back.params.coupling.linear_saturation.has_value());
  EXPECT_FALSE(back.params.coupling.angular_saturation.has_value());
  EXPECT_EQ(text.find('\n'), std::string::npos);
}

TEST(ConfigJson, every_field_is_asked_for) {
  const std::string whole = write_config(example());
  int keys = 0;
  for (std::size_t at = whole.find("\":"); at != std::string::npos;
       at = whole.find("\":", at + 1)) {
    const std::size_t begin = whole.rfind('"', at - 1) + 1;
    const std::string key = whole.substr(begin, at - begin);
    if (key == "passivity" || key == "friction" || key == "impacts" || key == "carry")
      continue;  // where there is any
    std::string text = whole;
    text[begin] = '?';
    EXPECT_THROW(read_config(text), InputError) << key;
    ++keys;
  }
  EXPECT_GT(keys, 80);
}

TEST(ConfigJson, an_unknown_word_is_refused) {
  std::string text = write_config(example());
  const std::size_t at = text.find("\"one_ring\"");
  ASSERT_NE(at, std::string::npos);
  text[at + 1] = 'O';
  EXPECT_THROW(read_config(text), InputError);
}

TEST(ConfigJson, damage_is_refused_with_a_reason) {
  const std::string text = write_config(example());
  for (std::size_t size = 0; size + 1 < text.size(); size += 7) {
    EXPECT_THROW(read_config(text.substr(0, size)), InputError) << size;
  }
  EXPECT_THROW(read_config("{}"), InputError);
  std::string newer = text;
  newer.replace(newer.find("\"version\":1"), 11, "\"version\":9");
  EXPECT_THROW(read_config(newer), InputError);
}

}  // namespace
}  // namespace thigma
