// `thigma run` of a world with its page and a person's device: the stand-in of its service.

#include <csignal>
#include <string>

#include "standins/services.h"
#include "viewer/live_program.h"
#include <gtest/gtest.h>

namespace thigma::test {
namespace {

/// A world whose only hand is that of a device; limits of time that a loaded machine keeps.
const char* const kScene = R"(
gravity = [0.0, 0.0, 0.0]
[safety]
watchdog = 5.0
model_full_age = 5.0
model_stale_age = 10.0
rows_full_age = 5.0
rows_stale_age = 10.0
max_speed = 5.0
pose_jump = 0.03
[object]
name = "block"
mesh = "procedural:box?triangles=12"
density = 500.0
[[body]]
name = "other"
mesh = "procedural:box?triangles=12"
position = [0.2, 0.0, 0.0]
density = 500.0
)";

TEST(LivePeople, ADeviceThatIsGoneIsToldOnThePageUntilItIsBack) {
  standin_test::Running service("standin_haply", "HAPLY", {"--events-port", "0"});
  service.set("buttons", 1);
  const std::string device = "haply:?port=" + std::to_string(service.port());
  const std::string scene = write_text("people.toml", kScene);
  Program program({"run", scene, "--port", "0", "--json", "--device", device});
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  const auto runs = [](const Json& s) {
    return s["run"] == "running" && s["fault"].is_null() && s["simulated"] == false;
  };
  ASSERT_FALSE(state_where(client, runs).is_null());
  const Json paused = ask(client, R"({"type":"pause","id":1,"value":true})");
  EXPECT_EQ(paused["ok"], false);
  EXPECT_NE(paused.dump().find("motors"), std::string::npos) << paused;

  service.set("unplug", 1);
  const auto says = [](const char* word) {
    return [word](const Json& s) {
      return !s["fault"].is_null() && s["fault"].dump().find(word) != std::string::npos;
    };
  };
  const Json lost = state_where(client, says("unplugged"));
  ASSERT_FALSE(lost.is_null());
  EXPECT_NE(lost["fault"].dump().find("hand 1 (haply:"), std::string::npos) << lost["fault"];
  EXPECT_EQ(service.get("applied_fz"), 0.0);

  // Begun again without its device nothing ends, and the page is told.
  EXPECT_EQ(ask(client, R"({"type":"reset","id":2})")["ok"], true);
  const Json gone = state_where(client, [](const Json& s) {
    return !s["fault"].is_null() && s["fault"].dump().find("hand 1") == std::string::npos;
  });
  ASSERT_FALSE(gone.is_null()) << program.said();

  service.set("unplug", 0);
  EXPECT_EQ(ask(client, R"({"type":"reset","id":3})")["ok"], true);
  EXPECT_FALSE(state_where(client, runs).is_null()) << program.said();
  program.send(SIGINT);
  const Ended ended = program.finish();
  EXPECT_EQ(ended.code, 130) << ended.err;
  EXPECT_EQ(service.get("applied_fz"), 0.0);
}

}  // namespace
}  // namespace thigma::test
