// `thigma run` of a world with its page: grabbing, refused requests, a page that is lost.

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "support/copy_recording.h"
#include "viewer/live_program.h"
#include <gtest/gtest.h>

#include "thigma/recording/mcap_file.h"

namespace thigma::test {
namespace {

std::string scene(const char* name) {
  return std::string(THIGMA_SOURCE_DIR) + "/scenes/" + name + ".toml";
}

template <class T>
T at(const std::string& message, std::size_t offset) {
  T value;
  std::memcpy(&value, message.data() + offset, sizeof value);
  return value;
}

/// The next binary message of a kind that fulfils the condition; "" when none comes.
template <class Condition>
std::string binary_where(WebClient& client, std::uint8_t kind, Condition condition) {
  for (int i = 0; i < 20000; ++i) {
    const auto message = client.read(20.0);
    if (!message) return {};
    if (message->is_binary && at<std::uint8_t>(message->data, 0) == kind &&
        condition(message->data))
      return message->data;
  }
  return {};
}

/// The next `bodies` that fulfils it.
template <class Condition>
std::string bodies_where(WebClient& client, Condition condition) {
  return binary_where(client, 6, condition);
}

/// Of the last hand, the page's.
std::int32_t held_by_page(const std::string& bodies) {
  return at<std::int32_t>(bodies, bodies.size() - 64 + 52);
}

/// A sample of the hand as docs/protocol.md has it.
void send_hand(WebClient& client, double time, double z, bool is_pressed) {
  std::string message(16 + 40, '\0');
  const auto put = [&](std::size_t at, auto value) {
    std::memcpy(message.data() + at, &value, sizeof value);
  };
  put(0, std::uint8_t{32});
  put(1, std::uint8_t{1});
  put(4, std::uint32_t{1});
  put(8, time);
  put(16, time);
  put(32, static_cast<float>(z));
  put(48, 1.0f);
  put(52, std::uint32_t{is_pressed ? 1u : 0u});
  client.send_binary(message);
}

const auto kAny = [](const std::string&) { return true; };

/// Takes hold of a body as a page does, and waits until it has it; its number, -1 where it did not.
std::int32_t grab(WebClient& client, const std::string& name) {
  if (!ask(client, R"({"type":"hold","id":1,"value":true})")["ok"].get<bool>()) return -1;
  if (!ask(client, R"({"type":"grab","id":2,"value":")" + name + R"("})")["ok"].get<bool>())
    return -1;
  send_hand(client, 1.0, 0.0, false);
  send_hand(client, 1.01, 0.0, true);
  const std::string held =
      bodies_where(client, [](const std::string& m) { return held_by_page(m) >= 0; });
  return held.empty() ? -1 : held_by_page(held);
}

TEST(LiveWorld, ALostPageLetsGoOfItsBodyAndTheWorldGoesOn) {
  Program program({"run", scene("tower"), "--port", "0", "--json"});
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient watching(port);
  std::int32_t body = -1;
  {
    WebClient holding(port);
    const Json scene = Json::parse(holding.read_type("scene", 20.0));
    EXPECT_EQ(scene["world"]["bodies"], 31);
    body = grab(holding, "block 30");
    ASSERT_GE(body, 0);
    EXPECT_EQ(body, scene["statics"][29]["body"].get<std::int32_t>());
    EXPECT_EQ(scene["statics"][29]["name"], "block 30");
    const std::string seen =
        bodies_where(watching, [&](const std::string& m) { return held_by_page(m) == body; });
    ASSERT_FALSE(seen.empty());
  }  // it hangs up without a word
  const std::string free = bodies_where(watching, [](const std::string& m) {
    return held_by_page(m) < 0 && at<double>(m, 16) > 0.0;
  });
  ASSERT_FALSE(free.empty());
  const double frame = at<double>(free, 16);
  EXPECT_FALSE(bodies_where(watching, [&](const std::string& m) {
                 return at<double>(m, 16) > frame;
               }).empty());
  // Another page may take it up.
  EXPECT_EQ(grab(watching, "block 30"), body);
  program.send(SIGINT);
  const Ended ended = program.finish();
  EXPECT_EQ(ended.code, 130);
  const Json summary = json_line(ended);
  EXPECT_TRUE(summary["clock"]["late_frames"].is_number());
  EXPECT_EQ(summary["hands"].back()["device"], "web:");
  EXPECT_TRUE(summary["hands"].back()["fault"].is_null());
}

TEST(LiveWorld, ThePageSeesWhatKeepsBodiesApart) {
  Program program({"run", scene("row_of_blocks"), "--port", "0", "--json"});
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  const std::string snapshot =
      binary_where(client, 3, [](const std::string& m) { return at<std::uint32_t>(m, 236) > 0; });
  ASSERT_FALSE(snapshot.empty());
  EXPECT_NE(at<std::uint16_t>(snapshot, 2) & 256, 0);  // contacts are constraints
  const auto rows = at<std::uint32_t>(snapshot, 236);
  ASSERT_GT(rows, 0u);
  EXPECT_LE(rows, 64u);
  EXPECT_GE(at<std::uint32_t>(snapshot, 220), rows);  // in all
  program.send(SIGINT);
  EXPECT_EQ(program.finish().code, 130);
}

TEST(LiveWorld, HandsHaveAThreadOfTheirOwnWhichThePageAndTheSummaryTellOf) {
  Program program({"run", scene("tower"), "--port", "0", "--json"});
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  ASSERT_EQ(grab(client, "block 30"), 30);
  const Json state = state_where(client, [](const Json& s) {
    const Json& timing = s["timing"];
    return timing["haptic_hz"].is_number() && timing["contact_hz"].is_number() &&
           timing["query_cpu_us"]["p50"].is_number() && timing["step_cpu_us"]["p50"].is_number();
  });
  ASSERT_FALSE(state.is_null());
  EXPECT_GT(state["timing"]["haptic_hz"].get<double>(), 0.0);
  EXPECT_GT(state["timing"]["contact_hz"].get<double>(), 0.0);  // steps of the world
  program.send(SIGINT);
  const Ended ended = program.finish();
  EXPECT_EQ(ended.code, 130);
  const Json summary = json_line(ended);
  const Json& haptic = summary["hands"].back()["haptic"];
  ASSERT_TRUE(haptic.is_object()) << summary;
  EXPECT_GE(haptic["frames"].get<std::uint64_t>(), summary["frames"].get<std::uint64_t>());
  EXPECT_GE(haptic["bodies_max"].get<int>(), 2);
  EXPECT_TRUE(summary["haptic"]["missed"].is_number());
  EXPECT_TRUE(summary["haptic"]["step_cpu_us"]["p50"].is_number());
}

TEST(LiveWorld, WhatIsRefusedEndsNothing) {
  Program program({"run", scene("row_of_blocks"), "--port", "0"});
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  for (const char* text :
       {R"({"type":"grab","id":1,"value":"block 1"})",  // it does not hold the device
        R"({"type":"set","id":2,"name":"mass","value":1})",
        R"({"type":"open","id":3,"value":"jaws"})", R"({"type":"record","id":4,"value":false})",
        R"({"type":"save","id":5,"name":"x","value":false})",
        R"({"type":"level","id":6,"mesh":0,"value":1})",
        R"({"type":"use_device","id":7,"value":"dhd:"})",
        R"({"type":"compose","id":8,"title":"x","objects":[{"source":"scene:0"}]})"}) {
    const Json answer = ask(client, text);
    ASSERT_FALSE(answer.is_null()) << text;
    EXPECT_FALSE(answer["ok"].get<bool>()) << text;
    EXPECT_TRUE(answer["reason"].is_string()) << text;
  }
  ASSERT_TRUE(ask(client, R"({"type":"hold","id":9,"value":true})")["ok"].get<bool>());
  for (const char* name : {"nobody", "table", "block 1 "}) {
    const Json answer =
        ask(client, std::string(R"({"type":"grab","id":10,"value":")") + name + R"("})");
    ASSERT_FALSE(answer.is_null()) << name;
    EXPECT_FALSE(answer["ok"].get<bool>()) << name;
  }
  const std::string now = bodies_where(client, kAny);
  ASSERT_FALSE(now.empty());
  EXPECT_FALSE(bodies_where(client, [&](const std::string& m) {
                 return at<double>(m, 16) > at<double>(now, 16);
               }).empty());
  program.send(SIGINT);
  EXPECT_EQ(program.finish().code, 130);
}

TEST(LiveWorld, BeginsAgainOnTheSamePage) {
  Program program({"run", scene("drawer"), "--port", "0"});
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  const Json before = state_where(client, [](const Json& s) { return s["run"] == "running"; });
  ASSERT_FALSE(before.is_null());
  EXPECT_EQ(before["device"], "web:");
  EXPECT_TRUE(ask(client, R"({"type":"reset","id":1})")["ok"].get<bool>());
  const Json after = state_where(client, [&](const Json& s) {
    return s["run"] == "running" && s["session"] > before["session"];
  });
  EXPECT_FALSE(after.is_null());
  // The scene's own hand holds its body again.
  EXPECT_FALSE(bodies_where(client, [](const std::string& m) {
                 return at<std::int32_t>(m, m.size() - 2 * 64 + 52) == 0;
               }).empty());
  program.send(SIGINT);
  EXPECT_EQ(program.finish().code, 130);
}

TEST(LiveWorld, BodiesComeAndGoWhileItRuns) {
  Program program({"run", scene("tower"), "--port", "0"});
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  const auto wait_for = [&](std::uint32_t count) {
    return bodies_where(client,
                        [&](const std::string& m) { return at<std::uint32_t>(m, 4) == count; });
  };
  ASSERT_FALSE(wait_for(31).empty());
  const Json before = state_where(client, [](const Json& s) { return s["run"] == "running"; });
  client.send_text(R"({"type":"add","id":1,"value":"block 7"})");
  const Json scene =
      message_where(client, "scene", [](const Json& m) { return m["world"]["bodies"] == 32; });
  ASSERT_FALSE(scene.is_null());
  EXPECT_EQ(scene["statics"].back()["name"], "block 31");
  EXPECT_EQ(scene["statics"].back()["mesh"], scene["object"]["mesh"]);
  const std::string more = wait_for(32);
  ASSERT_FALSE(more.empty());
  EXPECT_GT(at<float>(more, 32 + 31 * 32 + 8), 0.5f);  // above the tower
  const auto refused = [&](const std::string& text) {
    const Json answer = ask(client, text);
    EXPECT_FALSE(answer.is_null() || answer["ok"].get<bool>()) << text;
    return answer.value("reason", "");
  };
  EXPECT_NE(refused(R"({"type":"add","id":2,"value":"block 7","position":[0,0,0.1]})")
                .find("inside body 'block"),
            std::string::npos);
  refused(R"({"type":"add","id":3,"value":"nobody"})");
  refused(R"({"type":"add","id":4,"value":"table"})");
  refused(R"({"type":"remove","id":5,"value":"table"})");
  client.send_text(R"({"type":"remove","id":6,"value":"block 1"})");
  ASSERT_FALSE(wait_for(31).empty());
  refused(R"({"type":"remove","id":7,"value":"block 1"})");
  const Json now = state_where(client, [](const Json& s) { return s["run"] == "running"; });
  EXPECT_EQ(now["session"], before["session"]);  // it went on
  EXPECT_GT(now["time"].get<double>(), before["time"].get<double>());
  EXPECT_TRUE(ask(client, R"({"type":"reset","id":8})")["ok"].get<bool>());
  const Json again =
      message_where(client, "scene", [](const Json& m) { return m["world"]["bodies"] == 31; });
  ASSERT_FALSE(again.is_null());
  EXPECT_EQ(again["object"]["name"], "block 1");
  program.send(SIGINT);
  EXPECT_EQ(program.finish().code, 130);
}

TEST(LiveWorld, WhilePausedBodiesComeAndGoAndAHandKeepsTheOneItWasAimedAt) {
  Program program({"run", scene("tower"), "--port", "0", "--json"});
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  ASSERT_FALSE(bodies_where(client, kAny).empty());
  ASSERT_TRUE(ask(client, R"({"type":"pause","id":1,"value":true})")["ok"].get<bool>());
  const auto change = [&](const char* text, std::uint32_t count) {
    client.send_text(text);
    Json told = message_where(client, "scene",
                              [&](const Json& m) { return m["world"]["bodies"] == count; });
    EXPECT_FALSE(
        bodies_where(client, [&](const std::string& m) { return at<std::uint32_t>(m, 4) == count; })
            .empty())
        << text;
    return told;
  };
  change(R"({"type":"add","id":2,"value":"block 7"})", 32);
  change(R"({"type":"add","id":3,"value":"block 7"})", 33);
  ASSERT_TRUE(ask(client, R"({"type":"hold","id":4,"value":true})")["ok"].get<bool>());
  ASSERT_TRUE(ask(client, R"({"type":"grab","id":5,"value":"block 32"})")["ok"].get<bool>());
  const Json now = change(R"({"type":"remove","id":6,"value":"block 31"})", 32);
  ASSERT_FALSE(now.is_null());
  ASSERT_EQ(now["statics"].back()["name"], "block 32");
  ASSERT_TRUE(ask(client, R"({"type":"pause","id":7,"value":false})")["ok"].get<bool>());
  send_hand(client, 1.0, 0.0, false);
  send_hand(client, 1.01, 0.0, true);
  const std::string held =
      bodies_where(client, [](const std::string& m) { return held_by_page(m) >= 0; });
  ASSERT_FALSE(held.empty());
  EXPECT_EQ(held_by_page(held), now["statics"].back()["body"].get<std::int32_t>());
  program.send(SIGINT);
  const Ended ended = program.finish();
  EXPECT_EQ(ended.code, 130);
  EXPECT_EQ(json_line(ended)["bodies"], 32);  // of the world that ended
}

TEST(LiveWorld, AFolderThatTakesNoFilesRefusesTheRecordingAndTheSessionGoesOn) {
  write_text("world_data", "a file in the place of the folder");
  ::setenv("XDG_DATA_HOME", (work_folder() / "world_data").c_str(), 1);
  Program program({"run", scene("row_of_blocks"), "--port", "0"});
  ::setenv("XDG_DATA_HOME", (work_folder() / "data").c_str(), 1);
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  const Json before = state_where(client, [](const Json& s) { return s["run"] == "running"; });
  const Json answer = ask(client, R"({"type":"record","id":1,"value":true})");
  ASSERT_FALSE(answer.is_null());
  EXPECT_FALSE(answer["ok"].get<bool>());
  EXPECT_NE(answer.value("reason", "").find(".mcap: "), std::string::npos) << answer;
  const Json after = state_where(client, [&](const Json& s) { return s["time"] > before["time"]; });
  ASSERT_FALSE(after.is_null());
  EXPECT_EQ(after["session"], before["session"]);
  program.send(SIGINT);
  EXPECT_EQ(program.finish().code, 130);
}

TEST(LiveWorld, WhatAPageDidIsReplayedBitForBit) {
  const std::string recording = (work_folder() / "grabbed.mcap").string();
  Program program({"run", scene("tower"), "--port", "0", "--record", recording});
  const std::uint16_t port = port_of(program);
  ASSERT_NE(port, 0) << program.said();
  WebClient client(port);
  const Json state = state_where(client, [](const Json& s) { return s["run"] == "running"; });
  EXPECT_EQ(state["recording"], recording);
  EXPECT_FALSE(ask(client, R"({"type":"add","id":3,"value":"block 7"})")["ok"].get<bool>());
  const std::int32_t body = grab(client, "block 30");
  ASSERT_GE(body, 0);
  const auto height = [&](const std::string& m) {
    return at<float>(m, 32 + 32 * static_cast<std::size_t>(body) + 8);
  };
  const float low = height(bodies_where(client, kAny));
  for (int i = 1; i <= 40; ++i) send_hand(client, 1.01 + 0.005 * i, 1e-3 * i, true);
  EXPECT_FALSE(
      bodies_where(client, [&](const std::string& m) { return height(m) > low + 0.02f; }).empty());
  send_hand(client, 1.3, 0.04, false);
  EXPECT_FALSE(
      bodies_where(client, [](const std::string& m) { return held_by_page(m) < 0; }).empty());
  EXPECT_TRUE(ask(client, R"({"type":"record","id":4,"value":false})")["ok"].get<bool>());
  EXPECT_FALSE(
      state_where(client, [](const Json& s) { return s["recording"].is_null(); }).is_null());
  program.send(SIGINT);
  EXPECT_EQ(program.finish().code, 130);
  const Ended replayed = run_program({"replay", recording, "--json"});
  EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
  const Json result = json_line(replayed);
  EXPECT_TRUE(result["identical"].get<bool>()) << result;
  EXPECT_GE(result["haptic"]["frames"].get<int>(), result["frames"].get<int>());
  EXPECT_GE(result["frames"].get<int>(), 17);  // 20 mm at the 1.2 m/s of a page at most
}

/// A copy without its end, and without haptic steps of such a number or more.
void cut_off(const std::string& from, const std::string& to, std::uint32_t steps) {
  copy_recording(from, to, [&](const std::string& topic, const McapMessage& message) {
    const bool is_left_out =
        topic == "/events" || (topic.ends_with("/haptic") && message.sequence >= steps);
    return is_left_out ? std::nullopt : std::optional(std::string(message.data));
  });
}

TEST(LiveWorld, ARecordingWhoseHapticStepsAreGoneIsNotIdentical) {
  const std::string recording = (work_folder() / "whole.mcap").string();
  const std::string cut = (work_folder() / "cut.mcap").string();
  ASSERT_EQ(run_program({"run", scene("row_of_blocks"), "--headless", "--duration", "0.2",
                         "--quiet", "--record", recording})
                .code,
            0);
  // All of them are there, but not the end.
  cut_off(recording, cut, 1'000'000);
  Ended replayed = run_program({"replay", cut, "--json"});
  EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
  EXPECT_EQ(json_line(replayed)["recorded_frames"], 200);
  // A hundred frames of the world have nothing to be compared with.
  cut_off(recording, cut, 100);
  replayed = run_program({"replay", cut, "--json"});
  EXPECT_EQ(replayed.code, 5) << replayed.out << replayed.err;
  const Json result = json_line(replayed);
  EXPECT_FALSE(result["identical"].get<bool>()) << result;
  EXPECT_LT(result["frames"].get<int>(), 150);
  EXPECT_EQ(result["recorded_frames"], 200);
  cut_off(recording, cut, 0);
  replayed = run_program({"replay", cut, "--json"});
  EXPECT_EQ(replayed.code, 4) << replayed.out;
  EXPECT_NE(replayed.err.find("has no haptic step of hand 1"), std::string::npos) << replayed.err;
}

TEST(LiveWorld, ARecordingByTheClockWithoutAPageReplaysWithEachHapticStep) {
  const std::string recording = (work_folder() / "clock.mcap").string();
  const std::vector<std::string> how = {"--headless", "--duration", "0.6", "--quiet"};
  const auto run = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), how.begin(), how.end());
    const Ended ended = run_program(arguments);
    EXPECT_EQ(ended.code, 0) << ended.err;
    return json_line(ended);
  };
  EXPECT_TRUE(run({"run", scene("row_of_blocks"), "--lockstep"})["clock"].is_null());
  for (const char* name : {"row_of_blocks", "two_hands"}) {
    const Json clock = run({"run", scene(name), "--record", recording});
    EXPECT_EQ(clock["frames"], 600);
    EXPECT_TRUE(clock["clock"].is_object());
    std::uint64_t steps = 0;
    for (const Json& hand : clock["hands"]) steps += hand["haptic"]["frames"].get<std::uint64_t>();
    const Ended replayed = run_program({"replay", recording, "--json"});
    EXPECT_EQ(replayed.code, 0) << replayed.err;
    const Json replay = json_line(replayed);
    EXPECT_TRUE(replay["identical"].get<bool>());
    EXPECT_EQ(replay["state_hash"], clock["state_hash"]);
    // Each haptic step with what it sent, however late the world was for it.
    EXPECT_EQ(replay["haptic"]["frames"], steps);
    EXPECT_TRUE(replay["haptic"]["first_difference"].is_null());
  }
  for (const std::vector<std::string>& wrong :
       {std::vector<std::string>{"run", scene("tower"), "--lockstep", "--port", "0"},
        {"run", scene("tower"), "--headless", "--device", "web:"},
        {"run", scene("tower"), "--headless", "--device", "hand:"}})
    EXPECT_EQ(run_program(wrong).code, 2) << wrong[2];
}

TEST(LiveWorld, OptionsThatWorldsDoNotHaveAreRefusedByName) {
  const std::vector<std::vector<std::string>> all = {{"--exact"},
                                                     {"--threshold", "0.1"},
                                                     {"--budget-us", "200"},
                                                     {"--texture", "off"},
                                                     {"--repair"},
                                                     {"--spin", "10"},
                                                     {"--histograms", "steps.csv"},
                                                     {"--passivity"},
                                                     {"--fault", "nan@1"}};
  for (const std::vector<std::string>& option : all) {
    std::vector<std::string> arguments = {
        "run", scene("row_of_blocks"), "--lockstep", "--duration", "0.01", "--headless"};
    arguments.insert(arguments.end(), option.begin(), option.end());
    const Ended ended = run_program(arguments);
    EXPECT_EQ(ended.code, 2) << option[0];
    EXPECT_NE(ended.err.find(option[0]), std::string::npos) << ended.err;
  }
}

TEST(LiveWorld, ASceneOfThePagesHandNeedsThePage) {
  const std::string known = read_text(scene("row_of_blocks"));
  const std::string hand = "uri = \"hand:\"";
  const std::size_t begin = known.find(hand);
  ASSERT_NE(begin, std::string::npos);
  const std::string file =
      write_text("webs.toml", std::string(known).replace(begin, hand.size(), "uri = \"web:\""));
  const std::vector<std::string> run = {"run", file, "--headless", "--duration", "0.01"};
  const Ended ended = run_program(run);
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.err.find("the page's hand"), std::string::npos) << ended.err;
  std::vector<std::string> other = run;
  other.insert(other.end(), {"--device", "null:"});
  EXPECT_EQ(run_program(other).code, 0);
}

}  // namespace
}  // namespace thigma::test
