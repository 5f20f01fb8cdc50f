// Random sequences of a page's requests: whatever is asked in whatever order, forces stay within
// the limits, a refused request changes no session, and the program goes on.

#include <cmath>
#include <cstring>

#include "support/full.h"
#include "viewer/live_program.h"
#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma::test {
namespace {

constexpr double kMostForce = 8.5;  // of the simulated hand's actuators [N]

template <std::size_t N>
const char* any_of(Random& random, const char* const (&words)[N]) {
  return words[random.below(N)];
}

/// A request as a page may send it, right or wrong.
std::string random_request(Random& random, int id) {
  static constexpr const char* kDevices[] = {
      "hand:?path=rest", "hand:", "web:", "null:", "dhd:", ""};
  static constexpr const char* kNames[] = {"response",  "resolution",       "exact",
                                           "s0",        "linear_stiffness", "texture",
                                           "budget_us", "nothing"};
  static constexpr const char* kThings[] = {"blocks", "no such scene", "/etc/passwd",
                                            "damaged.mcap", ""};
  static constexpr const char* kPlaces[] = {"hold", "touch", "throw"};
  static constexpr double kNumbers[] = {0.0, 1.0, -1.0, 0.5, 7.0, 1e-9, 1e9, 300.0};
  const bool yes = random.below(2) == 0;
  const double number = kNumbers[random.below(std::size(kNumbers))];
  Json json = {{"id", id}};
  const auto form = [&](const char* type, const Json& value) {
    json["type"] = type;
    json["value"] = value;
  };
  switch (random.below(10)) {
    case 0:
      form("hold", yes);
      break;
    case 1:
      form("use_device", any_of(random, kDevices));
      break;
    case 2:
      form("pause", yes);
      break;
    case 3:
      form("step", number);
      break;
    case 4:
      json["type"] = "reset";
      break;
    case 5:
      form("record", yes);
      break;
    case 6:
      form("open", any_of(random, kThings));
      break;
    case 7:
      form("seek", number);
      break;
    case 8:
      form("place", number);
      json["name"] = any_of(random, kPlaces);
      json["repair"] = yes;
      break;
    default:
      form("set", number);
      json["name"] = any_of(random, kNames);
      break;
  }
  // Opening takes long, as levels are built; one in four of them.
  if (json["type"] == "open" && json["value"] == "blocks" && random.below(4) != 0)
    json["value"] = "nowhere";
  return json.dump();
}

/// Checks the forces of a `channels` message.
void check_forces(const std::string& message) {
  if (message.size() < 16 || message[0] != 2) return;
  std::uint16_t columns = 0;
  std::uint32_t rows = 0;
  std::memcpy(&columns, message.data() + 2, 2);
  std::memcpy(&rows, message.data() + 4, 4);
  ASSERT_EQ(message.size(), 16 + 4 * std::size_t{columns} * rows);
  for (std::uint32_t i = 0; i < rows; ++i) {
    float force[3];
    std::memcpy(force, message.data() + 16 + 4 * (std::size_t{columns} * i + 1), sizeof force);
    const double size = std::hypot(force[0], force[1], force[2]);
    ASSERT_TRUE(size <= kMostForce * (1.0 + 1e-6)) << size;
  }
}

/// Reads until the answer to a request comes, and looks at all that comes before it.
Json answer_to(WebClient& client, int id) {
  for (int i = 0; i < 20000; ++i) {
    const std::optional<WebMessage> message = client.read(60.0);
    if (!message) return {};
    if (message->is_binary) {
      check_forces(message->data);
      continue;
    }
    Json json = Json::parse(message->data);
    if (json["type"] == "ack" && json["id"] == id) return json;
  }
  return {};
}

/// The next state, forces looked at meanwhile.
Json next_state(WebClient& client) {
  for (int i = 0; i < 20000; ++i) {
    const std::optional<WebMessage> message = client.read(20.0);
    if (!message) return {};
    if (message->is_binary) {
      check_forces(message->data);
    } else if (Json json = Json::parse(message->data); json["type"] == "state") {
      return json;
    }
  }
  return {};
}

/// What was done may begin a session anew, after its answer.
void settle(WebClient& client, const Json& before) {
  constexpr int kStates = 10;
  for (int i = 0; i < kStates; ++i) {
    const Json state = next_state(client);
    if (state.is_null() || state["session"] != before["session"]) return;
  }
}

TEST(LiveSequences, RandomRequestsKeepForcesWithinLimitsAndSessionsThatRefuseThem) {
  const std::uint64_t seeds = is_full() ? 10 : 1;
  const int requests = is_full() ? 200 : 25;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RunningProgram run("sequences" + std::to_string(seed), {"--device", "hand:"},
                       {{"damaged.mcap", "not a recording"}});
    ASSERT_TRUE(run.client);
    WebClient& client = *run.client;
    ASSERT_FALSE(run.running().is_null());
    Random random(seed);
    int refused = 0;
    for (int id = 1; id <= requests && !::testing::Test::HasFailure(); ++id) {
      const std::string request = random_request(random, id);
      SCOPED_TRACE(request);
      const Json before = next_state(client);
      ASSERT_FALSE(before.is_null()) << run.program->said();
      client.send_text(request);
      const Json answer = answer_to(client, id);
      ASSERT_FALSE(answer.is_null()) << run.program->said();
      if (answer["ok"].get<bool>()) {
        settle(client, before);
        continue;
      }
      ++refused;
      const Json after = next_state(client);
      ASSERT_FALSE(after.is_null());
      EXPECT_EQ(after["session"], before["session"]) << answer;
      EXPECT_EQ(after["device"], before["device"]) << answer;
      if (before["run"] == "running") {
        EXPECT_NE(after["run"], "ended") << answer << after;
      }
    }
    EXPECT_GT(refused, requests / 10);
    EXPECT_EQ(run.end().code, 130) << run.program->said();
  }
}

}  // namespace
}  // namespace thigma::test
