// Random sequences of pages' requests: whatever is asked in whatever order, forces stay within the
// limits, a refused request changes no session, and the program goes on. Some here;
// THIGMA_SEQUENCES=COUNT runs so many of those that do not wait for answers, and goes on from the
// number in the file THIGMA_SEQUENCES_STATE.

#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "attack/cases.h"
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

/// Two pages of one program that ask without waiting for answers.
class Pages {
 public:
  explicit Pages(RunningProgram& run) : run_(run), other_(run.port) {
    if (other_.status() != 101) ADD_FAILURE() << "the second page was refused";
  }

  /// What both ask for, all of it on its way before the first answer is read. How many sessions
  /// that begins is told by the answers.
  int ask_all(Random& random) {
    const std::uint64_t count = 1 + random.below(6);
    int begun = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const bool is_other = random.below(3) == 0;
      std::string request = random_request(random, ++last_id_);
      // Opening takes as long as all else together.
      if (request.find("\"blocks\"") != std::string::npos && random.below(8) != 0)
        request = Json{{"id", last_id_}, {"type", "reset"}}.dump();
      pending_[is_other][last_id_] = request;
      (is_other ? other_ : *run_.client).send_text(request);
      if (random.below(6) == 0) begun += read_answers();
    }
    return begun + read_answers();
  }

  /// Whether the number of the session comes to this; what was done may begin one after its answer.
  bool session_becomes(int wanted) {
    constexpr int kStates = 100;
    int number = -1;
    for (int i = 0; i < kStates && number != wanted; ++i) {
      const Json state = next_state(*run_.client);
      if (state.is_null()) return false;
      note(state);
      number = state["session"].get<int>();
      if (number > wanted) break;
    }
    EXPECT_EQ(number, wanted);
    return number == wanted;
  }

  void note(const Json& state) {
    if (state["recording"].is_string() && state["recording"] != "")
      recordings.insert(state["recording"].get<std::string>());
  }

  std::set<std::string> recordings;

 private:
  static bool begins_a_session(const std::string& request) {
    const Json json = Json::parse(request);
    static const std::set<std::string> kTypes = {"reset", "use_device", "record", "open", "place"};
    const bool is_choice =
        json["type"] == "set" && (json["name"] == "response" || json["name"] == "texture");
    return is_choice || kTypes.contains(json["type"]);
  }

  int read_answers() {
    int begun = 0;
    for (const bool is_other : {false, true}) {
      WebClient& client = is_other ? other_ : *run_.client;
      std::map<int, std::string>& pending = pending_[is_other];
      while (!pending.empty()) {
        const std::optional<WebMessage> message = client.read(120.0);
        if (!message) {
          ADD_FAILURE() << "no answer to " << pending.begin()->second << run_.program->said();
          return begun;
        }
        if (message->is_binary) {
          check_forces(message->data);
          continue;
        }
        const Json json = Json::parse(message->data);
        if (json["type"] == "state") note(json);
        if (json["type"] != "ack") continue;
        const auto found = pending.find(json["id"].get<int>());
        if (found == pending.end()) continue;
        begun += json["ok"].get<bool>() && begins_a_session(found->second);
        pending.erase(found);
      }
    }
    return begun;
  }

  RunningProgram& run_;
  WebClient other_;
  std::map<int, std::string> pending_[2];
  int last_id_ = 0;
};

/// What was recorded is whole and replays to the same bits.
void check_recordings(const RunningProgram& run, const std::set<std::string>& recordings) {
  for (const std::string& name : recordings) {
    const std::filesystem::path path = run.folder / name;
    Program replay({"replay", path.string(), "--json"});
    const Ended ended = replay.finish();
    EXPECT_EQ(ended.code, 0) << path << ended.err;
  }
}

/// Sequences [first, end) by one program.
void attack(std::uint64_t first, std::uint64_t end) {
  const std::string folder = "requests" + std::to_string(first);
  RunningProgram run(folder, {"--device", "hand:"}, {{"damaged.mcap", "not a recording"}});
  ASSERT_TRUE(run.client);
  const Json begun = run.running();
  ASSERT_FALSE(begun.is_null());
  int session = begun["session"].get<int>();
  Pages pages(run);
  for (std::uint64_t number = first; number < end && !::testing::Test::HasFailure(); ++number) {
    SCOPED_TRACE("sequence " + std::to_string(number));
    Random random(0x70616765 + number);
    session += pages.ask_all(random);
    // Waiting for a state takes longer than many sequences.
    if (number % 10 == 9 || number + 1 == end) {
      ASSERT_TRUE(pages.session_becomes(session)) << run.program->said();
    }
  }
  EXPECT_EQ(run.end().code, 130) << run.program->said();
  check_recordings(run, pages.recordings);
  std::filesystem::remove_all(run.folder);
}

TEST(LiveSequences, WhatIsAcceptedBeginsASessionAndWhatIsRefusedNone) {
  const Cases cases("THIGMA_SEQUENCES", 40);
  constexpr std::uint64_t kOfOneProgram = 100;
  for (std::uint64_t at = cases.first; at < cases.end && !::testing::Test::HasFailure();) {
    const std::uint64_t end = std::min(at + kOfOneProgram, cases.end);
    attack(at, end);
    at = end;
    if (!::testing::Test::HasFailure()) cases.done(at);
  }
}

}  // namespace
}  // namespace thigma::test
