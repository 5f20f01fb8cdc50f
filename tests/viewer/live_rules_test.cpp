// What pages may do to a session that another one holds, that begins, that is over; and what a page
// that does not read can make the server keep.

#include <memory>
#include <string>
#include <vector>

#include "support/mesh_session.h"
#include "viewer/server/live_server.h"
#include "web_client.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/clod_asset.h"

namespace thigma::live {
namespace {

using test::MeshSession;
using test::WebClient;
using Json = nlohmann::json;

/// A ball with levels of detail over a rippled sheet, on a server without a session.
struct RuleBench {
  MeshSession scene;
  ClodAsset ball = build_clod_asset(make_ball(0.015, 16));
  TriangleMesh ground = MeshSession::rippled_sheet();
  WebDeviceChannel link;
  std::unique_ptr<LiveServer> server;

  explicit RuleBench(const WebLimits& limits = {}, const WebAddress& address = {}) {
    SceneView view{"Ball", "test", "thigma test", {"ball", ball.meshes, &ball.hierarchy, {}}, {}};
    view.statics.push_back({"ground", {&ground, 1}, &scene.ground, {}});
    scene.config.haptic.device = make_web_device(link)->limits();
    server = std::make_unique<LiveServer>(view, scene.config, scene.config.world_from_body,
                                          std::vector<std::string>{"hand:", "web:"},
                                          std::vector<WebFile>{}, address, link, limits);
  }
};

Json answer_to(WebClient& client, const std::string& message) {
  client.send_text(message);
  return Json::parse(client.read_type("ack"), nullptr, false);
}

/// The next `state` that fulfils the condition; discarded when none comes.
template <class Condition>
Json wait_for_state(WebClient& client, Condition condition) {
  for (int i = 0; i < 20; ++i) {
    Json state = Json::parse(client.read_type("state"), nullptr, false);
    if (state.is_discarded() || condition(state)) return state;
  }
  return Json::parse("", nullptr, false);
}

TEST(LiveRules, APageThatDoesNotHoldTheDeviceChangesNothingForTheOneThatDoes) {
  RuleBench b;
  b.server->begin_session({.device = "web:", .is_web = true, .is_simulated = true});
  WebClient holder(b.server->port()), watcher(b.server->port());
  ASSERT_NE(watcher.read_type("state"), "");
  ASSERT_TRUE(answer_to(holder, R"({"type":"hold","id":1,"value":true})")["ok"].get<bool>());
  for (const char* request :
       {R"({"type":"pause","id":2,"value":true})", R"({"type":"reset","id":3})",
        R"({"type":"set","id":4,"name":"mass","value":0.02})",
        R"({"type":"record","id":5,"value":true})", R"({"type":"step","id":6,"value":1})",
        R"({"type":"open","id":7,"value":"jaws"})",
        R"({"type":"upload","id":17,"name":"mine.mcap","value":3})"}) {
    const Json refused = answer_to(watcher, request);
    ASSERT_TRUE(refused.is_object()) << request;
    EXPECT_FALSE(refused["ok"].get<bool>()) << request;
    EXPECT_EQ(refused["reason"], "another page holds the device") << request;
  }
  EXPECT_FALSE(b.server->ports().is_paused);
  EXPECT_FALSE(b.server->take_request());
  EXPECT_TRUE(
      answer_to(watcher, R"({"type":"level","id":8,"mesh":0,"value":1})")["ok"].get<bool>());
  EXPECT_TRUE(answer_to(holder, R"({"type":"pause","id":9,"value":true})")["ok"].get<bool>());
}

TEST(LiveRules, APageWithoutTheTokenSeesEverythingAndChangesNothing) {
  RuleBench b({}, {.token = "5ec12e7"});
  b.server->begin_session({.device = "web:", .is_web = true, .is_simulated = true});
  WebClient watcher(b.server->port()), holder(b.server->port(), {.token = "5ec12e7"});
  EXPECT_FALSE(Json::parse(watcher.read_type("hello"))["may_control"].get<bool>());
  EXPECT_TRUE(Json::parse(holder.read_type("hello"))["may_control"].get<bool>());
  int id = 10;
  for (const char* rest :
       {R"("type":"hold","value":true})", R"("type":"pause","value":true})",
        R"("type":"step","value":1})", R"("type":"reset"})",
        R"("type":"set","name":"tolerance","value":1e-4})",
        R"("type":"use_device","value":"hand:"})", R"("type":"record","value":true})",
        R"("type":"open","value":"jaws"})", R"("type":"seek","value":0})",
        R"("type":"upload","name":"a.obj","value":10})"}) {
    const Json answer =
        answer_to(watcher, "{\"id\":" + std::to_string(++id) + "," + std::string(rest));
    EXPECT_EQ(answer["id"], id) << rest;
    EXPECT_FALSE(answer["ok"].get<bool>()) << rest;
    EXPECT_NE(answer["reason"].get<std::string>().find("watches"), std::string::npos) << answer;
  }
  EXPECT_FALSE(b.server->take_request());
  EXPECT_TRUE(
      answer_to(watcher, R"({"type":"level","id":2,"mesh":0,"value":1})")["ok"].get<bool>());
  EXPECT_TRUE(answer_to(holder, R"({"type":"hold","id":3,"value":true})")["ok"].get<bool>());
}

TEST(LiveRules, APauseWhileASessionBeginsAnewLeavesTimeRunning) {
  RuleBench b;
  SessionConfig config = b.scene.config;
  b.server->prepare_session(config);
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  WebClient client(b.server->port());
  ASSERT_NE(client.read_type("state"), "");
  b.server->prepare_session(config);  // the next one; pages have not heard of it
  const Json refused = answer_to(client, R"({"type":"pause","id":1,"value":true})");
  EXPECT_FALSE(refused["ok"].get<bool>());
  EXPECT_FALSE(b.server->ports().is_paused);
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  EXPECT_TRUE(wait_for_state(client, [](const Json& s) { return s["session"] == 2; }).is_object());
  EXPECT_TRUE(answer_to(client, R"({"type":"pause","id":2,"value":true})")["ok"].get<bool>());
  EXPECT_TRUE(b.server->ports().is_paused);
}

TEST(LiveRules, TheCauseOfAFaultIsKnownToPagesThatComeLaterUntilTheNextSession) {
  RuleBench b;
  SessionConfig config = b.scene.config;
  b.server->prepare_session(config);
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  b.server->observe(
      SessionEvent{1.5, 1500, EventKind::late, "watchdog", "30.0 ms without a haptic step"});
  b.server->observe(SessionEvent{2.0, 2000, EventKind::fault, "contact_stale", "a sentence"});
  b.server->end_session(SessionEnd::fault, 0);
  for (int page = 0; page < 2; ++page) {  // and after a reload
    WebClient client(b.server->port());
    const Json state = wait_for_state(client, [](const Json& s) { return s["run"] == "ended"; });
    ASSERT_TRUE(state.is_object());
    EXPECT_EQ(state["fault"],
              (Json{{"name", "contact_stale"}, {"time", 2.0}, {"text", "a sentence"}}));
    EXPECT_EQ(state["late"]["count"], 1);
    EXPECT_EQ(state["late"]["name"], "watchdog");
  }
  b.server->prepare_session(config);
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  WebClient client(b.server->port());
  const Json state = wait_for_state(client, [](const Json& s) { return s["run"] == "running"; });
  ASSERT_TRUE(state.is_object());
  EXPECT_TRUE(state["fault"].is_null());
  EXPECT_TRUE(state["late"].is_null());
}

TEST(LiveRules, APageThatAsksAndDoesNotReadIsNotKeptMoreThanAFewAnswersFor) {
  WebLimits limits;
  limits.waiting_bytes = 1u << 16;
  RuleBench b(limits);
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  WebClient client(b.server->port());
  ASSERT_NE(client.read_type("state"), "");
  constexpr int kRequests = 120;
  for (int i = 0; i < kRequests; ++i)
    client.send_text(R"({"type":"level","id":)" + std::to_string(i) + R"(,"mesh":0,"value":1})");
  int done = 0, refused = 0;
  std::size_t bytes = 0;
  while (done + refused < kRequests) {
    const auto message = client.read();
    ASSERT_TRUE(message) << "closed after " << done + refused;
    if (message->is_binary) {
      bytes += message->data.size();
      continue;
    }
    const Json json = Json::parse(message->data);
    if (json["type"] == "ack") ++(json["ok"].get<bool>() ? done : refused);
  }
  EXPECT_GT(done, 0);
  EXPECT_GT(refused, 0) << bytes << " bytes were sent";
}

}  // namespace
}  // namespace thigma::live
