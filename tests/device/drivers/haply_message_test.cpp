// Messages in the forms that the Inverse Service documents.
#include "thigma/device/detail/haply_message.h"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "thigma/device/detail/haply_device.h"

namespace thigma::detail {
namespace {

// After the documentation of 3.5, "WebSocket Protocol", step 1, shortened.
constexpr const char* kFirst = R"({"session_id":7,"inverse3":[{"device_id":"049D","config":{
 "type":"inverse3","handedness":"right","basis":{"permutation":"XYZ"},
 "mount":{"position":{"x":0,"y":0,"z":0},"rotation":{"w":1,"x":0,"y":0,"z":0},
 "scale":{"x":1,"y":1,"z":1}}},"state":{"cursor_position":{"x":0.01,"y":-0.12,"z":0.15},
 "cursor_velocity":{"x":0.1,"y":0.2,"z":0.3},"control_mode":"idle"},
 "status":{"calibrated":true,"in_use":false,"power_supply":true,"ready":true,"started":true}}],
 "verse_grip":[],"wireless_verse_grip":[{"device_id":"61","state":{
 "orientation":{"w":0.7071067811865476,"x":0,"y":0,"z":0.7071067811865476},
 "buttons":{"a":true,"b":false,"c":true}}}]})";

TEST(HaplyMessage, reads_the_first_message) {
  HaplyFrame frame;
  ASSERT_EQ(read_haply_frame(kFirst, frame), "");
  ASSERT_EQ(frame.arms.size(), 1u);
  const HaplyArm& arm = frame.arms[0];
  EXPECT_EQ(arm.id, "049D");
  EXPECT_EQ(arm.type, "inverse3");
  EXPECT_EQ(arm.position, Vec3(0.01, -0.12, 0.15));
  EXPECT_EQ(arm.velocity, Vec3(0.1, 0.2, 0.3));
  EXPECT_TRUE(arm.is_calibrated && arm.is_ready && arm.has_power);
  EXPECT_FALSE(arm.has_own_axes);
  ASSERT_EQ(frame.grips.size(), 1u);
  EXPECT_EQ(frame.grips[0].buttons, 5u);
  EXPECT_NEAR(frame.grips[0].orientation.z(), std::sqrt(0.5), 1e-15);
}

TEST(HaplyMessage, other_axes_or_units_are_seen) {
  const auto is_own = [](const char* from, const char* to) {
    std::string text = kFirst;
    text.replace(text.find(from), std::string(from).size(), to);
    HaplyFrame frame;
    EXPECT_EQ(read_haply_frame(text, frame), "");
    return frame.arms.at(0).has_own_axes;
  };
  EXPECT_FALSE(is_own("XYZ", "XYZ"));
  EXPECT_TRUE(is_own("XYZ", "XZY"));
  EXPECT_TRUE(is_own("\"scale\":{\"x\":1,", "\"scale\":{\"x\":100,"));
  EXPECT_TRUE(is_own("\"w\":1,\"x\":0", "\"w\":0,\"x\":1"));
}

TEST(HaplyMessage, what_is_no_frame_is_refused_in_one_line) {
  const char* const cases[] = {
      "",
      "{",
      "[]",
      "7",
      "\"inverse3\"",
      R"({"inverse3":7})",
      R"({"inverse3":[7]})",
      R"({"inverse3":[{"device_id":5,"state":{}}]})",
      R"({"inverse3":[{"device_id":"A"}]})",
      R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0,"y":0}}}]})",
      R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0,"y":0,"z":null},
          "cursor_velocity":{"x":0,"y":0,"z":0}}}]})",
      R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0,"y":0,"z":NaN}}}]})",
      R"({"inverse3":[{"device_id":"A","state":{"cursor_position":{"x":0,"y":0,"z":1e999}}}]})",
      R"({"verse_grip":[{"device_id":"A","state":{"orientation":{"w":0,"x":0,"y":0,"z":0}}}]})"};
  for (const char* text : cases) {
    HaplyFrame frame;
    const std::string fault = read_haply_frame(text, frame);
    EXPECT_NE(fault, "") << text;
    EXPECT_EQ(fault.find('\n'), std::string::npos);
  }
  HaplyFrame frame;
  EXPECT_NE(read_haply_frame(std::string(1 << 20, '['), frame), "");  // deep
  EXPECT_EQ(read_haply_frame("{}", frame), "");                       // no device is no nonsense
}

TEST(HaplyMessage, every_beginning_of_a_message_is_refused) {
  const std::string whole = kFirst;
  for (std::size_t n = 0; n + 1 < whole.size(); ++n) {
    HaplyFrame frame;
    ASSERT_NE(read_haply_frame(std::string_view(whole).substr(0, n), frame), "") << n;
  }
}

TEST(HaplyMessage, the_version_says_how_a_force_is_named) {
  const auto form = [](const char* answer) {
    HaplyForm found = HaplyForm::values;
    const std::string fault = haply_form_of(answer, found);
    const std::string name = found == HaplyForm::vector ? "vector" : "values";
    return fault.empty() ? name : fault;
  };
  EXPECT_EQ(form(R"({"version":"3.1.2"})"), "values");
  EXPECT_EQ(form(R"({"project_version":"3.1.2.0"})"), "values");
  EXPECT_EQ(form(R"({"version":"3.4.0","build_time":"2025"})"), "values");
  EXPECT_EQ(form(R"({"version":"3.5.0"})"), "vector");
  EXPECT_EQ(form("3.12.1\n"), "vector");
  EXPECT_EQ(form("\"v3.5\""), "vector");
  EXPECT_EQ(form(R"({"version":"3.0.5"})"), "it is version 3.0, expected 3.1 to 3.x");
  EXPECT_EQ(form(R"({"version":"4.0.0"})"), "it is version 4.0, expected 3.1 to 3.x");
  EXPECT_EQ(form("<html>hello</html>"), "it does not say its version");
  EXPECT_EQ(form(""), "it does not say its version");
}

TEST(HaplyMessage, forces_are_told_to_the_last_bit_in_both_forms) {
  const Vec3 force(1.0 / 3.0, -2.0e-7, 0.0);
  for (const HaplyForm form : {HaplyForm::values, HaplyForm::vector}) {
    const auto message =
        nlohmann::json::parse(haply_force_message(form, "049D", force, form == HaplyForm::vector));
    const auto& command = message.at("inverse3").at(0);
    EXPECT_EQ(command.at("device_id"), "049D");
    const auto& v = command.at("commands")
                        .at("set_cursor_force")
                        .at(form == HaplyForm::vector ? "vector" : "values");
    EXPECT_EQ(v.at("x").get<double>(), force.x());
    EXPECT_EQ(v.at("y").get<double>(), force.y());
    EXPECT_EQ(v.at("z").get<double>(), force.z());
    EXPECT_EQ(message.contains("session"), form == HaplyForm::vector);
  }
}

TEST(HaplyMessage, axes_are_a_turn) {
  Mat3 m;
  for (int i = 0; i < 3; ++i) m.col(i) = ours_from_haply(Vec3(Vec3::Unit(i)));
  EXPECT_EQ(m.determinant(), 1.0);
  EXPECT_EQ(ours_from_haply(Vec3(Vec3::UnitY())), -Vec3::UnitX());  // away from the person
  EXPECT_EQ(ours_from_haply(Vec3(Vec3::UnitX())), Vec3::UnitY());   // right
  const Vec3 v(0.1, -0.2, 0.3);
  EXPECT_EQ(haply_from_ours(ours_from_haply(v)), v);
  const Quat q = Quat(0.5, -0.5, 0.1, 0.2).normalized();
  const Vec3 turned = ours_from_haply(Vec3(q._transformVector(v)));
  EXPECT_LT((ours_from_haply(q)._transformVector(ours_from_haply(v)) - turned).norm(), 1e-15);
}

}  // namespace
}  // namespace thigma::detail
