// Requests of a page that the program refuses: what runs goes on as it was.

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "viewer/live_program.h"
#include <gtest/gtest.h>

#include "thigma/recording/config_json.h"
#include "thigma/recording/recording.h"

namespace thigma::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kRefused = {
    R"({"type":"open","id":1,"value":"no such scene"})",
    R"({"type":"open","id":2,"value":"/etc/passwd"})",
    R"({"type":"open","id":3,"value":"damaged.mcap"})",
    R"({"type":"place","id":4,"name":"hold","value":0.001,"repair":false})",
    R"({"type":"place","id":5,"name":"throw","value":0.001,"repair":false})",
    R"({"type":"use_device","id":6,"value":"dhd:"})",
    R"({"type":"seek","id":7,"value":1})",
    R"({"type":"record","id":8,"value":false})",
    R"({"type":"set","id":9,"name":"response","value":7})",
    R"({"type":"set","id":10,"name":"response","value":-1})",
    R"({"type":"set","id":11,"name":"response","value":0.5})",
    R"({"type":"compose","id":14,"title":"x","objects":[{"source":"file:1"}]})",
    R"({"type":"compose","id":15,"title":"x","objects":[{"source":"scene:9"}]})",
    R"({"type":"compose","id":16,"title":"x","objects":[{"source":"scene:0","position":[0,0,1e300],"quat_xyzw":[0,0,0,1]}]})",
    R"({"type":"compose","id":17,"title":"x","objects":[{"source":"scene:0","position":[0,0],"quat_xyzw":[0,0,0,1]}]})",
    R"({"type":"compose","id":18,"title":"x","objects":[{"source":"scene:0","position":[0,0,1],"quat_xyzw":[0,0,0,2]}]})",
    R"({"type":"compose","id":19,"title":"x","objects":[{"source":"scene:0","position":[0,0,1],"quat_xyzw":[0,0,0,1],"friction":-1}]})",
    R"({"type":"compose","id":19,"title":"x","objects":[{"source":"scene:0","position":[0,0,1],"quat_xyzw":[0,0,0,1],"mass":1,"density":1}]})",
    R"({"type":"compose","id":19,"title":"x","objects":[{"source":"scene:0","position":[0,0,1],"quat_xyzw":[0,0,0,1],"unit":0}]})",
    R"({"type":"save","id":20,"name":"../evil","value":false})",
    R"({"type":"save","id":21,"name":"","value":true})",
    R"({"type":"cancel","id":12})",
    R"({"type":"speed","id":13,"value":0.5})"};

TEST(LiveRequests, ARefusedRequestLeavesTheSessionOfAPageThatHoldsTheDevice) {
  RunningProgram run("refused_web", {"--device", "web:"}, {{"damaged.mcap", "not a recording"}});
  ASSERT_TRUE(run.client);
  ASSERT_TRUE(ask(*run.client, R"({"type":"hold","id":0,"value":false})")["reason"].is_string());
  run.expect_refused(kRefused);
  EXPECT_EQ(run.end().code, 130);
}

TEST(LiveRequests, ARefusedRequestLeavesTheSessionOfASimulatedHand) {
  RunningProgram run("refused_hand", {"--device", "hand:?path=rest"},
                     {{"damaged.mcap", "not a recording"}});
  ASSERT_TRUE(run.client);
  run.expect_refused(kRefused);
  // A mesh that is there and cannot be placed so.
  upload(*run.client, 20, "four.obj",
         "v 0 0 0\nv 30 0 0\nv 0 30 0\nv 0 0 30\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 1 3 2\n");
  ASSERT_EQ(Json::parse(run.client->read_type("ack", 60.0))["id"], 20);
  run.expect_refused({R"({"type":"place","id":21,"name":"hold","value":0.001,"repair":false})",
                      R"({"type":"place","id":22,"name":"hold","value":-1,"repair":true})",
                      R"({"type":"place","id":23,"name":"throw","value":0.001,"repair":true})"});
  EXPECT_EQ(run.end().code, 130);
}

// Whoever started the program chose them for the hand that is held.
TEST(LiveRequests, ASceneThatAPageOpensLiftsNoLimitOfSafety) {
  const std::string ball = "mesh = \"procedural:ball?triangles=320\"\n";
  const std::string mild = "[object]\n" + ball + "position = [0.0, 0.0, 0.3]\n[[static]]\n" + ball +
                           "[safety]\nmax_force = 2.0\nstart_ramp = 0.75\n";
  RunningProgram run("limits", {"--device", "null:"}, {{"mild.toml", mild}}, "mild.toml");
  ASSERT_TRUE(run.client);
  ASSERT_TRUE(ask(*run.client, R"({"type":"open","id":1,"value":"ellipsoid"})")["ok"].get<bool>());
  ASSERT_TRUE(ask(*run.client, R"({"type":"record","id":2,"value":true})")["ok"].get<bool>());
  const Json recording =
      state_where(*run.client, [](const Json& s) { return !s["recording"].is_null(); });
  ASSERT_FALSE(recording.is_null());
  ASSERT_TRUE(ask(*run.client, R"({"type":"record","id":3,"value":false})")["ok"].get<bool>());
  ASSERT_FALSE(
      state_where(*run.client, [](const Json& s) { return s["recording"].is_null(); }).is_null());
  const std::string file = recording["recording"].get<std::string>();
  const SafetyLimits kept =
      read_config(read_recording((run.folder / file).string()).config).params.safety;
  EXPECT_EQ(kept.max_force, 2.0);
  EXPECT_EQ(kept.start_ramp, 0.75);
  EXPECT_EQ(run.end().code, 130);
}

TEST(LiveRequests, AnotherDeviceIsRefusedUnderTheDirectResponseBeforeAnythingStops) {
  RunningProgram run("refused_direct", {"--device", "hand:?path=rest", "--response", "direct"});
  ASSERT_TRUE(run.client);
  run.expect_refused({R"({"type":"use_device","id":1,"value":"web:"})"});
  EXPECT_EQ(run.end().code, 130);
}

TEST(LiveRequests, AResponseThatTheSceneCannotHaveIsRefusedAndTheSessionGoesOn) {
  // Nobody holds a simulated body: it has neither constraints nor the direct response.
  const std::string scene =
      "[object]\nmesh = \"procedural:ball?triangles=320\"\nposition = [0, 0, 0.2]\nmass = 0.01\n"
      "[[static]]\nmesh = \"procedural:ball?triangles=320\"\n[simulation]\n";
  RunningProgram run("refused_response", {"--device", "null:"}, {{"falls.toml", scene}},
                     "falls.toml");
  ASSERT_TRUE(run.client);
  run.expect_refused({R"({"type":"set","id":1,"name":"response","value":2})",
                      R"({"type":"set","id":2,"name":"response","value":1})"});
  EXPECT_EQ(run.end().code, 130);
}

TEST(LiveRequests, TheResponseIsChangedToConstraintsAndBack) {
  RunningProgram run("constrained", {"--device", "hand:?path=press", "--response", "penalty"});
  ASSERT_TRUE(run.client);
  EXPECT_TRUE(run.running()["constraint"].is_null());
  const auto has = [](const Json& parameters, const char* name) {
    for (const Json& p : parameters["list"])
      if (p["name"] == name) return true;
    return false;
  };
  for (const int wanted : {2, 0}) {
    const bool is_constrained = wanted == 2;
    const std::string message = R"({"type":"set","id":1,"name":"response","value":)";
    EXPECT_TRUE(ask(*run.client, message + std::to_string(wanted) + "}")["ok"].get<bool>());
    const Json parameters = message_where(*run.client, "parameters", [&](const Json& m) {
      return has(m, "contact_stiffness") != is_constrained && has(m, "response");
    });
    ASSERT_FALSE(parameters.is_null()) << wanted;
    EXPECT_TRUE(has(parameters, "coupling_stiffness"));
    const Json state = state_where(*run.client, [&](const Json& s) {
      return s["run"] == "running" && s["constraint"].is_null() != is_constrained;
    });
    ASSERT_FALSE(state.is_null()) << wanted;
    if (is_constrained) {
      EXPECT_EQ(state["constraint"]["left_out"], 0);
    }
  }
  EXPECT_EQ(run.end().code, 130);
}

TEST(LiveRequests, ADeviceThatCannotBeOpenedAgainLeavesTheSession) {
  std::string rows = "t,x,y,z,qx,qy,qz,qw,buttons\n";
  rows += "0,0,0,0,0,0,0,1,0\n600,0,0,0,0,0,0,1,0\n";
  RunningProgram run("refused_script", {"--device", "script:hand.csv"}, {{"hand.csv", rows}});
  ASSERT_TRUE(run.client);
  fs::remove(run.folder / "hand.csv");
  run.expect_refused({R"({"type":"reset","id":1})"});
  EXPECT_EQ(run.end().code, 130);
}

TEST(LiveRequests, UploadsThatNothingIsMadeOfAreRemovedFromTheOldestOn) {
  const fs::path kept = work_folder() / "uploads";
  fs::create_directories(kept);
  const char* before = std::getenv("TMPDIR");
  const std::string restored = before != nullptr ? before : "/tmp";
  setenv("TMPDIR", kept.c_str(), 1);
  RunningProgram run("uploads_of", {"--device", "null:"});
  setenv("TMPDIR", restored.c_str(), 1);
  ASSERT_TRUE(run.client);
  const auto files = [&] {
    int count = 0;
    for (const auto& entry : fs::recursive_directory_iterator(kept))
      count += entry.is_regular_file() ? 1 : 0;
    return count;
  };
  const std::string mesh =
      "v 0 0 0\nv 30 0 0\nv 0 30 0\nv 0 0 30\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n";
  int id = 1;
  const auto send = [&](const std::string& bytes) {
    upload(*run.client, id, "some.obj", bytes);
    EXPECT_EQ(Json::parse(run.client->read_type("ack", 60.0))["id"], id++);
  };
  send("no mesh at all");
  EXPECT_EQ(files(), 0);
  constexpr int kKept = 32;  // for a scene that is put together
  for (int i = 0; i < kKept + 3; ++i) send(mesh);
  EXPECT_EQ(files(), kKept);
  EXPECT_TRUE(ask(*run.client,
                  R"({"type":"place","id":1000,"name":"hold","value":0.001,"repair":false})")["ok"]
                  .get<bool>());
  for (int i = 0; i < kKept + 3; ++i) send(mesh);
  EXPECT_EQ(files(), kKept + 1) << "what runs, and the last";
  EXPECT_EQ(run.end().code, 130);
  EXPECT_EQ(files(), 0);
}

TEST(LiveRequests, ARefusedRequestLeavesARecordingThatIsShown) {
  const Ended recorded =
      run_program(run_arguments({"--lockstep", "--headless", "--duration", "10", "--device",
                                 "null:", "--quiet", "--record", out_file("long.mcap")}));
  ASSERT_EQ(recorded.code, 0) << recorded.err;
  RunningProgram run("refused_replay", {"--replay", out_file("long.mcap")});
  ASSERT_TRUE(run.client);
  run.expect_refused({R"({"type":"open","id":1,"value":"no such scene"})",
                      R"({"type":"place","id":2,"name":"hold","value":0.001,"repair":false})"});
  const Json state = run.running();
  ASSERT_FALSE(state.is_null());
  EXPECT_FALSE(state["replay"].is_null());
  EXPECT_EQ(run.end().code, 130);
}

}  // namespace
}  // namespace thigma::test
