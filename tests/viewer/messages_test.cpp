#include "viewer/server/messages.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/mesh/shapes.h"

namespace thigma::live {
namespace {

using Json = nlohmann::json;

TEST(Messages, CommandsAreRead) {
  const ParsedCommand set =
      parse_command(R"({"type":"set","id":7,"name":"mass","value":0.02,"more":[1]})");
  EXPECT_EQ(set.refusal.code, 0);
  EXPECT_EQ(set.command.kind, Command::Kind::set);
  EXPECT_EQ(set.command.id, 7);
  EXPECT_EQ(set.command.text, "mass");
  EXPECT_EQ(set.command.number, 0.02);
  const ParsedCommand hold = parse_command(R"({"type":"hold","id":0,"value":true})");
  EXPECT_EQ(hold.command.kind, Command::Kind::hold);
  EXPECT_TRUE(hold.command.flag);
  const ParsedCommand device = parse_command(R"({"type":"use_device","id":1,"value":"web:"})");
  EXPECT_EQ(device.command.text, "web:");
  EXPECT_EQ(parse_command(R"({"type":"reset","id":2})").refusal.code, 0);
  EXPECT_EQ(parse_command(R"({"type":"step","id":2,"value":5})").command.number, 5.0);
}

TEST(Messages, AScenePutTogetherIsAListOfObjects) {
  const ParsedCommand good =
      parse_command(R"({"type":"compose","id":1,"title":"Two","objects":[{"source":"scene:0"}]})");
  EXPECT_EQ(good.refusal.code, 0);
  EXPECT_EQ(good.command.text, "Two");
  EXPECT_EQ(good.command.objects, R"([{"source":"scene:0"}])");
  std::string many = R"({"type":"compose","id":1,"title":"x","objects":[{})";
  for (int i = 0; i < 32; ++i) many += ",{}";
  for (const std::string& text :
       {std::string(R"({"type":"compose","id":1,"title":"x"})"),
        std::string(R"({"type":"compose","id":1,"title":"x","objects":[]})"),
        std::string(R"({"type":"compose","id":1,"title":"x","objects":[1]})"),
        std::string(R"({"type":"compose","id":1,"title":"x","objects":{}})"),
        std::string(R"({"type":"compose","id":1,"objects":[{}]})"), many + "]}",
        std::string(R"({"type":"save","id":1,"name":"x"})"),
        std::string(R"({"type":"save","id":1,"value":true})")})
    EXPECT_NE(parse_command(text).refusal.code, 0) << text;
}

TEST(Messages, ABodyIsGrabbedByItsNameAndPerhapsAPoint) {
  const ParsedCommand plain = parse_command(R"({"type":"grab","id":1,"value":"block 7"})");
  EXPECT_EQ(plain.refusal.code, 0);
  EXPECT_EQ(plain.command.kind, Command::Kind::grab);
  EXPECT_EQ(plain.command.text, "block 7");
  EXPECT_FALSE(plain.command.point);
  const ParsedCommand there =
      parse_command(R"({"type":"grab","id":1,"value":"x","point":[1,-2.5,3e-3]})");
  ASSERT_TRUE(there.command.point);
  EXPECT_EQ(*there.command.point, Vec3(1.0, -2.5, 3e-3));
  EXPECT_EQ(parse_command(R"({"type":"grab","id":1,"value":"","point":null})").refusal.code, 0);
  for (const char* text : {R"({"type":"grab","id":1})", R"({"type":"grab","id":1,"value":7})",
                           R"({"type":"grab","id":1,"value":"x","point":7})",
                           R"({"type":"grab","id":1,"value":"x","point":[1,2]})",
                           R"({"type":"grab","id":1,"value":"x","point":[1,2,3,4]})",
                           R"({"type":"grab","id":1,"value":"x","point":[1,2,"3"]})",
                           R"({"type":"grab","id":1,"value":"x","point":[1,2,null]})",
                           R"({"type":"grab","id":1,"value":"x","point":[1,2,1e999]})"})
    EXPECT_NE(parse_command(text).refusal.code, 0) << text;
}

TEST(Messages, WhatIsNoCommandIsRefusedWithItsCode) {
  for (const char* text : {"", "{", "[]", "1", "\"reset\"", "{\"type\":\"reset\",\"id\":1"})
    EXPECT_EQ(parse_command(text).refusal.code, kBadPayload) << text;
  for (const char* text :
       {"{}", R"({"type":"reset"})", R"({"id":1})", R"({"type":1,"id":1})",
        R"({"type":"reset","id":-1})", R"({"type":"reset","id":1.5})",
        R"({"type":"reset","id":99999999999})", R"({"type":"format_disk","id":1})",
        R"({"type":"hold","id":1})", R"({"type":"hold","id":1,"value":1})",
        R"({"type":"set","id":1,"name":"mass"})", R"({"type":"set","id":1,"value":1})",
        R"({"type":"set","id":1,"name":"mass","value":"1"})",
        R"({"type":"set","id":1,"name":"mass","value":1e999})",
        R"({"type":"use_device","id":1,"value":[]})"}) {
    const Refusal refusal = parse_command(text).refusal;
    EXPECT_NE(refusal.code, 0) << text;
    EXPECT_NE(refusal.why, "") << text;
  }
  const std::string deep(5000, '[');
  EXPECT_NE(parse_command(deep).refusal.code, 0);
}

TEST(Messages, SceneTellsWhatAPageNeeds) {
  const TriangleMesh ball = make_ball(0.02, 3);
  const ClodHierarchy h = build_exact_hierarchy(ball);
  SceneView view{"Title \xff", "file.toml", "thigma 9", {"ball", {&ball, 1}, &h, {}}, {}};
  view.statics.push_back({"plate", {&ball, 1}, &h, {{1.0, 2.0, 3.0}, Quat::Identity()}});
  SessionConfig config;
  config.contact.tolerance = 4e-4;
  config.haptic.workspace.motion_scale = 0.5;
  const Json json = Json::parse(scene_message(view, config, {{0.0, 0.0, 0.5}, Quat::Identity()}));
  EXPECT_EQ(json["type"], "scene");
  EXPECT_EQ(json["object"]["mesh"], 0);
  EXPECT_EQ(json["object"]["triangles"], ball.triangles.size());
  EXPECT_EQ(json["statics"][0]["mesh"], 1);
  EXPECT_EQ(json["statics"][0]["position"][2], 3.0);
  EXPECT_EQ(json["start"]["position"][2], 0.5);
  EXPECT_EQ(json["workspace"]["motion_scale"], 0.5);
  EXPECT_EQ(json["tolerance"], 4e-4);
}

TEST(Messages, UnknownNumbersAreNull) {
  const double unknown = std::nan("");
  const Timing timing{unknown, unknown, unknown, unknown, 1e-4, 2e-4, unknown, 480.0, 3};
  RunState state;
  state.run = RunPhase::running;
  const Json json = Json::parse(state_message(state, timing, "you", 1, 2, 3));
  EXPECT_TRUE(json["timing"]["step_cpu_us"]["p50"].is_null());
  EXPECT_NEAR(json["timing"]["query_cpu_us"]["p99"].get<double>(), 200.0, 1e-9);
  EXPECT_TRUE(json["timing"]["haptic_hz"].is_null());
  EXPECT_TRUE(json["recording"].is_null());
  EXPECT_TRUE(json["reason"].is_null());
  EXPECT_EQ(json["holder"], "you");
  EXPECT_EQ(json["dropped"]["yours"], 1);
  EXPECT_TRUE(json["constraint"].is_null());
}

TEST(Messages, StateTellsTheStricterLimitOfDeviceAndSafety) {
  HapticParams params;
  params.device.max_force = 3.3;
  params.safety.max_force = 2.0;
  params.device.max_torque = 0.1;
  RunState state;
  state.limits = wrench_limits(params);
  const Json json = Json::parse(state_message(state, Timing{}, "you", 0, 0, 0))["limits"];
  EXPECT_EQ(json["force"], 2.0);
  EXPECT_EQ(json["torque"], 0.1);
  params.device.actuates_rotation = false;
  state.limits = wrench_limits(params);
  EXPECT_TRUE(
      Json::parse(state_message(state, Timing{}, "you", 0, 0, 0))["limits"]["torque"].is_null());
}

TEST(Messages, StateCountsTheRowsOfASessionUnderConstraints) {
  Timing timing{};
  timing.held_back = 0.25;
  RunState state;
  state.rows = RowsNow{300, 256, 3, 2, std::numeric_limits<double>::infinity(), 2e-4};
  const Json json = Json::parse(state_message(state, timing, "you", 0, 0, 0))["constraint"];
  EXPECT_EQ(json["rows"], 300);
  EXPECT_EQ(json["in_model"], 256);
  EXPECT_EQ(json["halvings"], 3);
  EXPECT_EQ(json["left_out"], 2);
  EXPECT_TRUE(json["travel"].is_null());
  EXPECT_EQ(json["look_ahead"], 2e-4);
  EXPECT_EQ(json["held_back"], 0.25);
  EXPECT_EQ(json["squeezed"], 0.0);
}

TEST(Messages, AStripIsShortAndNamesWhatIsNotKnown) {
  const Json json = Json::parse(strip_message(12.5, {0.0f, 1.23456f, std::nanf("")}));
  EXPECT_EQ(json["type"], "strip");
  EXPECT_EQ(json["seconds"], 12.5);
  EXPECT_EQ(json["force"][0], 0.0);
  EXPECT_NEAR(json["force"][1].get<double>(), 1.2346, 1e-9);
  EXPECT_TRUE(json["force"][2].is_null());
}

TEST(Messages, CancelAndSpeedAreUnderstood) {
  EXPECT_EQ(parse_command(R"({"type":"cancel","id":1})").command.kind, Command::Kind::cancel);
  const ParsedCommand speed = parse_command(R"({"type":"speed","id":2,"value":0.25})");
  EXPECT_EQ(speed.refusal.code, 0);
  EXPECT_EQ(speed.command.number, 0.25);
  EXPECT_NE(parse_command(R"({"type":"speed","id":2})").refusal.code, 0);
}

TEST(Messages, HelloNamesEveryFaultAndChannel) {
  const SceneView view{"", "", "thigma 9", {}, {}};
  const Json json = Json::parse(hello_message(view, {3, false}, 0.2, 4096));
  EXPECT_EQ(json["protocol"], 1);
  EXPECT_EQ(json["page"], 3);
  EXPECT_EQ(json["channels"].size(), 16u);
  EXPECT_EQ(json["channels"][7]["name"], "penetration");
  EXPECT_EQ(json["faults"][static_cast<int>(Fault::device_lost)], "device_lost");
  EXPECT_EQ(json["faults"].back(), "watchdog");
}

TEST(Messages, AcksCarryReasonOrValue) {
  const Json no = Json::parse(ack_message(5, "because"));
  EXPECT_EQ(no["ok"], false);
  EXPECT_EQ(no["reason"], "because");
  const Json yes = Json::parse(ack_message(6, "", 0.5));
  EXPECT_EQ(yes["ok"], true);
  EXPECT_TRUE(yes["reason"].is_null());
  EXPECT_EQ(yes["value"], 0.5);
}

}  // namespace
}  // namespace thigma::live
