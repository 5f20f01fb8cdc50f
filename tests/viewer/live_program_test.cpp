// thigma run with its page, as a process.

#include <csignal>
#include <cstdlib>
#include <filesystem>

#include "apps/program.h"
#include "viewer/web_client.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "thigma/runtime/recording.h"

namespace thigma::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kBall = "procedural:ball?triangles=320";

std::vector<std::string> run_arguments(const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"run", "--object", kBall, "--against", kBall, "--exact"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Port that the program says its page is at; 0 when it does not.
std::uint16_t port_of(Program& program) {
  const std::string start = "the page is at http://127.0.0.1:";
  if (!program.waits_for("Ctrl-C ends it")) return 0;
  const std::string said = program.said();
  const std::size_t at = said.find(start);
  return at == std::string::npos
             ? std::uint16_t{0}
             : static_cast<std::uint16_t>(std::atoi(said.c_str() + at + start.size()));
}

/// The next `state` that fulfils the condition; null when none comes.
template <class Condition>
Json state_where(WebClient& client, Condition condition) {
  for (int i = 0; i < 60; ++i) {
    const std::string text = client.read_type("state", 20.0);
    if (text.empty()) break;
    Json state = Json::parse(text);
    if (condition(state)) return state;
  }
  return {};
}

Json ask(WebClient& client, const std::string& message) {
  client.send_text(message);
  const std::string text = client.read_type("ack", 20.0);
  return text.empty() ? Json{} : Json::parse(text);
}

TEST(LiveProgram, AWatchedLockstepRunHasTheBitsOfAHeadlessOne) {
  const auto hash = [](const std::vector<std::string>& how) {
    std::vector<std::string> all = {"--lockstep", "--duration", "1", "--json", "--quiet"};
    all.insert(all.end(), how.begin(), how.end());
    const Ended e = run_program(run_arguments(all));
    EXPECT_EQ(e.code, 0) << e.err;
    return json_line(e)["state_hash"];
  };
  EXPECT_EQ(hash({"--port", "0"}), hash({"--headless"}));
}

TEST(LiveProgram, APortInUseIsUnavailableInOneLine) {
  Program first(run_arguments({"--device", "web:"}));
  const std::uint16_t port = port_of(first);
  ASSERT_NE(port, 0) << first.said();
  const Ended second =
      run_program(run_arguments({"--device", "web:", "--quiet", "--port", std::to_string(port)}));
  EXPECT_EQ(second.code, 3) << second.err;
  expect_one_line(second, "port " + std::to_string(port));
}

TEST(LiveProgram, ThePageTakesOverBeginsAgainAndRecordsUntilCtrlC) {
  const fs::path here = fs::current_path();
  fs::current_path(work_folder());
  Program program(run_arguments({"--device", "null:"}));
  fs::current_path(here);
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  ASSERT_EQ(client.status(), 101) << client.response();
  ASSERT_EQ(state_where(client, [](const Json& s) { return s["run"] == "running"; })["device"],
            "null:");

  EXPECT_TRUE(ask(client, R"({"type":"use_device","id":1,"value":"web:"})")["ok"].get<bool>());
  const Json taken = state_where(client, [](const Json& s) { return s["device"] == "web:"; });
  ASSERT_FALSE(taken.is_null());
  EXPECT_EQ(taken["holder"], "you");

  EXPECT_TRUE(ask(client, R"({"type":"record","id":2,"value":true})")["ok"].get<bool>());
  const Json recording =
      state_where(client, [](const Json& s) { return !s["recording"].is_null(); });
  ASSERT_FALSE(recording.is_null());
  const int session = recording["session"];
  EXPECT_TRUE(ask(client, R"({"type":"record","id":3,"value":false})")["ok"].get<bool>());
  const Json after = state_where(client, [&](const Json& s) { return s["session"] > session; });
  ASSERT_FALSE(after.is_null());
  EXPECT_TRUE(after["recording"].is_null());
  const Recording kept =
      read_recording((work_folder() / recording["recording"].get<std::string>()).string());
  EXPECT_TRUE(kept.has_end);
  EXPECT_EQ(kept.frames.size(), kept.end.frames);

  program.send(SIGINT);
  EXPECT_EQ(client.close_code(10.0), 1001);
  const Ended e = program.finish();
  EXPECT_EQ(e.code, 130) << e.err;
}

TEST(LiveProgram, AFaultNobodyLooksAtEndsTheProgram) {
  const Ended e = run_program(
      run_arguments({"--device", "hand:?path=rest", "--fault", "unplug@0.2", "--quiet"}));
  EXPECT_EQ(e.code, 6) << e.err;
}

TEST(LiveProgram, AFaultThatIsLookedAtMayBeBegunAgainFrom) {
  Program program(run_arguments({"--device", "hand:?path=rest", "--fault", "unplug@3"}));
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  const Json ended = state_where(client, [](const Json& s) { return s["run"] == "ended"; });
  ASSERT_FALSE(ended.is_null());
  EXPECT_EQ(ended["reason"], "fault");
  EXPECT_TRUE(ask(client, R"({"type":"reset","id":1})")["ok"].get<bool>());
  EXPECT_FALSE(state_where(client, [&](const Json& s) {
                 return s["run"] == "running" && s["session"] > ended["session"];
               }).is_null());
  program.send(SIGINT);
  EXPECT_EQ(program.finish().code, 130);
}

}  // namespace
}  // namespace thigma::test
