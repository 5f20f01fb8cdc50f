#pragma once
// `thigma run` with its page, and a client of it.

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "apps/program.h"
#include "viewer/web_client.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace thigma::test {

using Json = nlohmann::json;

inline std::vector<std::string> run_arguments(const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"run", "--object", kBall, "--against", kBall, "--exact"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Port that the program says its page is at; 0 when it does not.
inline std::uint16_t port_of(Program& program) {
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

inline Json ask(WebClient& client, const std::string& message) {
  client.send_text(message);
  // What was given up ends at its next step, which a sanitizer makes ten times as long.
  const std::string text = client.read_type("ack", 120.0);
  return text.empty() ? Json{} : Json::parse(text);
}

/// The next message of a type that fulfils the condition; null when none comes.
template <class Condition>
Json message_where(WebClient& client, const std::string& type, Condition condition) {
  for (int i = 0; i < 2000; ++i) {
    const std::string text = client.read_type(type, 60.0);
    if (text.empty()) break;
    Json message = Json::parse(text);
    if (condition(message)) return message;
  }
  return {};
}

inline void upload(WebClient& client, int id, const std::string& name, const std::string& bytes) {
  client.send_text(
      Json{{"type", "upload"}, {"id", id}, {"name", name}, {"value", bytes.size()}}.dump());
  std::string message("\x21\x01\0\0\0\0\0\0\0\0\0\0\0\0\0\0", 16);
  const auto size = static_cast<std::uint32_t>(bytes.size());
  std::memcpy(message.data() + 4, &size, 4);
  client.send_binary(message + bytes);
}

/// A program in a folder of its own, so that its menu and its recordings are known.
struct RunningProgram {
  std::filesystem::path folder;
  std::unique_ptr<Program> program;
  std::unique_ptr<WebClient> client;
  std::uint16_t port = 0;

  /// files   that lie in the folder before the program starts: names and what is in them
  /// scene   one of these, in place of two balls
  RunningProgram(const std::string& name, const std::vector<std::string>& more,
                 const std::vector<std::pair<std::string, std::string>>& files = {},
                 const std::string& scene = "")
      : folder(work_folder() / name) {
    std::filesystem::create_directories(folder);
    for (const auto& [file, bytes] : files) write_text(name + "/" + file, bytes);
    const std::filesystem::path here = std::filesystem::current_path();
    std::filesystem::current_path(folder);
    std::vector<std::string> arguments = run_arguments(more);
    if (!scene.empty()) {
      arguments = {"run", scene, "--exact"};
      arguments.insert(arguments.end(), more.begin(), more.end());
    }
    ::setenv("XDG_DATA_HOME", (folder / "data").c_str(), 1);
    program = std::make_unique<Program>(arguments);
    ::setenv("XDG_DATA_HOME", (work_folder() / "data").c_str(), 1);
    std::filesystem::current_path(here);
    port = port_of(*program);
    if (port != 0) client = std::make_unique<WebClient>(port);
    EXPECT_TRUE(client && client->status() == 101) << program->said();
  }

  Json running() {
    return state_where(*client, [](const Json& s) { return s["run"] == "running"; });
  }
  /// Whether the session that `before` tells of still runs and has gone on.
  void expect_goes_on(const Json& before) {
    const double time = before["time"].get<double>();
    const Json now = state_where(*client, [&](const Json& s) {
      return s["run"] != "running" || s["session"] != before["session"] ||
             s["time"].get<double>() > time + 0.2;
    });
    ASSERT_FALSE(now.is_null()) << program->said();
    EXPECT_EQ(now["run"], "running") << now;
    EXPECT_EQ(now["session"], before["session"]);
    EXPECT_EQ(now["device"], before["device"]);
    EXPECT_EQ(now["holder"], before["holder"]);
    EXPECT_EQ(now["recording"], before["recording"]);
    EXPECT_GT(now["time"].get<double>(), time);
  }
  void expect_refused(const std::vector<std::string>& requests) {
    const Json before = running();
    ASSERT_FALSE(before.is_null());
    for (const std::string& request : requests) {
      const Json answer = ask(*client, request);
      ASSERT_FALSE(answer.is_null()) << request;
      EXPECT_FALSE(answer["ok"].get<bool>()) << request;
      EXPECT_TRUE(answer["reason"].is_string()) << request;
    }
    expect_goes_on(before);
  }
  Ended end() {
    program->send(SIGINT);
    return program->finish();
  }
};

}  // namespace thigma::test
