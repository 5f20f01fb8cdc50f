#include "viewer/server/live_server.h"

#include <atomic>
#include <cmath>
#include <cstring>
#include <memory>
#include <thread>

#include "support/mesh_session.h"
#include "viewer/server/protocol.h"
#include "web_client.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/clod_asset.h"

namespace thigma::live {
namespace {

using test::MeshSession;
using test::WebClient;
using test::WebMessage;
using Json = nlohmann::json;

double wall() { return 1e-9 * static_cast<double>(monotonic_ns()); }

/// A ball over a rippled sheet and the server it is shown by.
struct Bench {
  MeshSession scene;
  TriangleMesh ball = make_ball(0.015, 4), ground = MeshSession::rippled_sheet();
  WebDeviceChannel link;
  std::unique_ptr<LiveServer> server;

  explicit Bench(const WebLimits& limits = {}) {
    SceneView view{"Ball", "test", "thigma test", {"ball", {&ball, 1}, &scene.object, {}}, {}};
    view.statics.push_back({"ground", {&ground, 1}, &scene.ground, {}});
    scene.config.haptic.device = make_web_device(link)->limits();
    server = std::make_unique<LiveServer>(view, scene.config, scene.config.world_from_body,
                                          std::vector<std::string>{"hand:", "web:"},
                                          std::vector<WebFile>{}, WebAddress{}, link, limits);
  }

  SessionSinks sinks() {
    return {[this](const HapticSample& s) { server->observe(s); },
            [this](const ContactSample& s) { server->observe(s); },
            [this](const SessionEvent& e) { server->observe(e); }};
  }

  /// A configuration that no late frame of this machine can end.
  SessionConfig patient() {
    SessionConfig config = scene.config;
    config.haptic.resumes_lost_device = true;
    config.haptic.safety.start_ramp = 0.05;
    config.haptic.safety.watchdog = 5.0;
    config.haptic.safety.model_full_age = 5.0;
    config.haptic.safety.model_stale_age = 10.0;
    config.haptic.safety.pose_jump = 0.1;
    config.haptic.safety.max_speed = 100.0;
    config.haptic.safety.silent_device = 5.0;
    server->prepare_session(config);
    return config;
  }
};

Json ack_of(WebClient& client, const std::string& message) {
  client.send_text(message);
  return Json::parse(client.read_type("ack"), nullptr, false);
}

template <class T>
T at(const std::string& message, std::size_t offset) {
  T value;
  std::memcpy(&value, message.data() + offset, sizeof value);
  return value;
}

/// The next snapshot; "" when none comes.
std::string next_snapshot(WebClient& client, double patience = 5.0) {
  const double deadline = wall() + patience;
  while (const auto message = client.read(deadline - wall())) {
    if (message->is_binary && at<std::uint8_t>(message->data, 0) == 3) return message->data;
  }
  return {};
}

float field(const std::string& snapshot, std::size_t i) { return at<float>(snapshot, 24 + 4 * i); }

std::string samples(double time, const Vec3& position, bool is_pressed) {
  const WebSample sample{time, {position, Quat::Identity()}, is_pressed ? kClutchButton : 0u};
  return encode_device(time, {&sample, 1});
}

TEST(LiveServer, APageIsToldEverythingInTheOrderOfTheProtocol) {
  Bench b;
  WebClient client(b.server->port());
  ASSERT_EQ(client.status(), 101) << client.response();
  std::vector<std::string> types;
  for (int i = 0; i < 7; ++i) {
    const auto message = client.read();
    ASSERT_TRUE(message) << i;
    types.push_back(message->is_binary
                        ? "mesh " + std::to_string(at<std::uint32_t>(message->data, 4))
                        : Json::parse(message->data)["type"].get<std::string>());
  }
  EXPECT_EQ(types, (std::vector<std::string>{"hello", "scene", "mesh 0", "mesh 1", "parameters",
                                             "menu", "state"}));
}

TEST(LiveServer, WatchersChangeNothingOfALockstepSession) {
  const MeshSession alone;
  SessionConfig config = alone.config;
  config.duration = 1.0;
  const auto first = make_hand(alone.hand(HandPath::press));
  const std::uint64_t hash = run_lockstep(config, *first).state_hash;

  Bench b;
  WebClient deaf(b.server->port());  // never reads
  WebClient watching(b.server->port());
  ASSERT_EQ(watching.status(), 101);
  config = b.scene.config;
  config.duration = 1.0;
  b.server->prepare_session(config);
  b.server->begin_session({.device = "hand:", .is_simulated = true, .is_lockstep = true});
  const auto second = make_hand(b.scene.hand(HandPath::press));
  std::atomic<std::size_t> binaries{0};
  std::atomic<bool> is_over{false};
  std::thread reader([&] {
    while (!is_over) {
      const auto message = watching.read(0.05);
      if (message && message->is_binary) ++binaries;
    }
  });
  const SessionSummary s = run_lockstep(config, *second, b.sinks());
  watching.send_text(R"({"type":"set","id":1,"name":"mass","value":0.02})");
  for (int i = 0; i < 3000 && binaries < 4; ++i) sleep_ns(1'000'000);
  is_over = true;
  reader.join();
  EXPECT_EQ(s.state_hash, hash);
  EXPECT_GE(binaries, 4u);  // two meshes, rows, a snapshot
}

TEST(LiveServer, DragPressesTheObjectOntoTheSurfaceAndLosingThePageIsZeroForce) {
  Bench b;
  const SessionConfig config = b.patient();
  const auto device = make_web_device(b.link);
  auto client = std::make_unique<WebClient>(b.server->port());
  Session session(config, *device, b.sinks());
  session.start();
  b.server->begin_session({.device = "web:", .is_web = true, .is_simulated = true});
  ASSERT_NE(client->read_type("state"), "");
  while (Json::parse(client->read_type("state"))["device"] != "web:") {
  }
  ASSERT_TRUE(ack_of(*client, R"({"type":"hold","id":1,"value":true})")["ok"].get<bool>());

  // Down by twice the way there is, and on until the force is there.
  const double begin = wall(), way = 2.0 * b.scene.start.clearance + 0.004;
  std::string snapshot;
  bool has_pressed = false;
  while (wall() - begin < 20.0 && !has_pressed) {
    const double t = wall() - begin;
    client->send_binary(samples(t, {0.0, 0.0, -way * std::min(1.0, t)}, t > 0.1));
    const std::string next = next_snapshot(*client, 0.02);
    if (!next.empty()) snapshot = next;
    has_pressed = !snapshot.empty() && t > 1.2 && field(snapshot, 26) > 0.5f;
  }
  ASSERT_TRUE(has_pressed);
  EXPECT_EQ(at<std::uint16_t>(snapshot, 2) & 7, kGrasped | kArmed);
  const float object_z = field(snapshot, 2), ghost_z = field(snapshot, 9);
  EXPECT_GT(object_z, 0.0135f);  // the ball of 15 mm rests on the sheet, pressed in a little
  EXPECT_LT(ghost_z, object_z - 0.001f);            // the ghost goes on
  EXPECT_GE(at<std::uint32_t>(snapshot, 4), 1u);    // contacts ...
  EXPECT_GE(at<std::uint32_t>(snapshot, 216), 1u);  // ... and clusters
  EXPECT_GE(at<std::int32_t>(snapshot, 240 + 36), 0);
  EXPECT_LT(std::abs(field(snapshot, 39)), 0.0015f);

  WebClient other(b.server->port());
  client.reset();  // the browser is gone
  bool is_lost = false;
  for (const double deadline = wall() + 10.0; !is_lost && wall() < deadline;) {
    snapshot = next_snapshot(other);
    ASSERT_NE(snapshot, "");
    is_lost = at<std::uint32_t>(snapshot, 232) == static_cast<std::uint32_t>(Fault::device_lost);
  }
  ASSERT_TRUE(is_lost);
  for (std::size_t i = 24; i < 30; ++i) EXPECT_EQ(field(snapshot, i), 0.0f);
  EXPECT_TRUE(session.is_running());

  // Another page takes the device up again: by a new press of the clutch.
  ASSERT_TRUE(ack_of(other, R"({"type":"hold","id":2,"value":true})")["ok"].get<bool>());
  bool is_back = false;
  const double again = wall();
  while (!is_back && wall() - again < 10.0) {
    const double t = wall() - again;
    other.send_binary(samples(100.0 + t, {0.0, 0.0, std::min(0.02, 0.02 * t)}, t > 0.2));
    snapshot = next_snapshot(other, 0.02);
    is_back = !snapshot.empty() && (at<std::uint16_t>(snapshot, 2) & 7) == (kGrasped | kArmed);
  }
  EXPECT_TRUE(is_back);
  session.request_stop();
  const SessionSummary s = session.finish();
  EXPECT_EQ(s.end, SessionEnd::stopped);
  ASSERT_EQ(s.safety_events.size(), 1u);
  EXPECT_EQ(s.safety_events[0].detail, "device_lost");
}

TEST(LiveServer, OnePageHoldsTheDeviceAndOthersAreTold) {
  Bench b;
  b.server->begin_session({.device = "web:", .is_web = true, .is_simulated = true});
  WebClient first(b.server->port()), second(b.server->port());
  ASSERT_NE(first.read_type("state"), "");
  ASSERT_NE(second.read_type("state"), "");
  EXPECT_TRUE(ack_of(first, R"({"type":"hold","id":1,"value":true})")["ok"].get<bool>());
  const Json refused = ack_of(second, R"({"type":"hold","id":2,"value":true})");
  EXPECT_FALSE(refused["ok"].get<bool>());
  EXPECT_NE(refused["reason"].get<std::string>().find("another page"), std::string::npos);
  second.send_binary(samples(1.0, Vec3::Zero(), true));  // without effect, without a scene
  EXPECT_FALSE(ack_of(second, R"({"type":"hold","id":3,"value":false})")["ok"].get<bool>());
  EXPECT_FALSE(ack_of(second, R"({"type":"use_device","id":4,"value":"hand:"})")["ok"].get<bool>());
  EXPECT_TRUE(ack_of(first, R"({"type":"hold","id":4,"value":false})")["ok"].get<bool>());
  EXPECT_TRUE(ack_of(second, R"({"type":"hold","id":5,"value":true})")["ok"].get<bool>());
  EXPECT_EQ(Json::parse(second.read_type("state"))["holder"], "you");
}

TEST(LiveServer, DamagedMessagesOfAPageCloseIt) {
  Bench b;
  b.server->begin_session({.device = "web:", .is_web = true, .is_simulated = true});
  const auto code_of = [&](auto misbehave) {
    WebClient client(b.server->port());
    EXPECT_NE(client.read_type("state"), "");
    misbehave(client);
    return client.close_code();
  };
  EXPECT_EQ(code_of([](WebClient& c) { c.send_text("{"); }), 1007);
  EXPECT_EQ(code_of([](WebClient& c) { c.send_text(R"({"type":"fly","id":1})"); }), 1008);
  EXPECT_EQ(code_of([](WebClient& c) { c.send_binary("short"); }), 1008);
  EXPECT_EQ(code_of([](WebClient& c) {
              c.send_binary(samples(0.0, {std::nan(""), 0.0, 0.0}, true));
            }),
            1008);
  EXPECT_EQ(code_of([](WebClient& c) {
              c.send_text(R"({"type":"hold","id":1,"value":true})");
              c.send_binary(samples(5.0, Vec3::Zero(), true));
              c.send_binary(samples(4.0, Vec3::Zero(), true));
            }),
            1008);
  EXPECT_EQ(code_of([](WebClient& c) { c.send_binary(std::string(70000, 'x')); }), 1009);
}

TEST(LiveServer, LevelsAreSentWhenAskedForAndUploadsReachTheProgram) {
  Bench b;
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  WebClient client(b.server->port());
  ASSERT_NE(client.read_type("state"), "");
  // The ball of this bench has its original surface alone.
  for (const char* wrong : {R"({"type":"level","id":1,"mesh":0,"value":1})",
                            R"({"type":"level","id":1,"mesh":0,"value":0})",
                            R"({"type":"level","id":1,"mesh":7,"value":1})",
                            R"({"type":"level","id":1,"mesh":-1,"value":1})"})
    EXPECT_FALSE(ack_of(client, wrong)["ok"].get<bool>()) << wrong;

  const ClodAsset asset = build_clod_asset(make_ball(0.015, 4));
  ASSERT_GT(asset.meshes.size(), 1u);
  SceneView view{"Ball", "test", "thigma test", {"ball", asset.meshes, &asset.hierarchy, {}}, {}};
  b.server->show(view, b.scene.config, {});
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  ASSERT_NE(client.read_type("scene"), "");
  client.send_text(R"({"type":"level","id":2,"mesh":0,"value":1})");
  std::string level;
  for (auto message = client.read(); message && level.empty(); message = client.read()) {
    if (message->is_binary && message->data[0] == 4) level = message->data;
  }
  EXPECT_EQ(level, encode_level(0, 1, asset.meshes[1], asset.hierarchy));

  client.send_text(R"({"type":"upload","id":3,"name":"ball.stl","value":5})");
  client.send_binary(std::string("\x21\x01\0\0\3\0\0\0\0\0\0\0\0\0\0\0abc", 19));
  client.send_binary(std::string("\x21\x01\0\0\2\0\0\0\0\0\0\0\0\0\0\0de", 18));
  std::optional<LiveRequest> request;
  for (int i = 0; i < 5000 && !request; ++i) {
    request = b.server->take_request();
    sleep_ns(1'000'000);
  }
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, LiveRequest::Kind::inspect);
  EXPECT_EQ(request->text, "ball.stl");
  EXPECT_EQ(request->data, "abcde");
  b.server->answer(*request, "no mesh");
  EXPECT_EQ(Json::parse(client.read_type("ack"))["id"], 3);
  EXPECT_FALSE(
      ack_of(client, R"({"type":"upload","id":4,"name":"x","value":1e12})")["ok"].get<bool>());
  EXPECT_FALSE(ack_of(client, R"({"type":"seek","id":5,"value":1})")["ok"].get<bool>());
  client.send_binary(std::string("\x21\x01\0\0\2\0\0\0\0\0\0\0\0\0\0\0de", 18));
  EXPECT_EQ(client.close_code(), 1008);  // nobody asked for it
  b.server->show(SceneView{"", "", "", {"ball", {&b.ball, 1}, &b.scene.object, {}}, {}},
                 b.scene.config, {});
}

TEST(LiveServer, NothingOfTheSceneBeforeIsShownInTheNext) {
  Bench b;
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  WebClient client(b.server->port());
  b.server->observe(HapticSample{});
  ASSERT_NE(next_snapshot(client), "");
  b.server->show(SceneView{"", "", "", {"ball", {&b.ball, 1}, &b.scene.object, {}}, {}},
                 b.scene.config, {});
  ASSERT_NE(client.read_type("scene"), "");
  int states = 0, snapshots = 0;
  while (states < 3) {  // one a second
    const auto message = client.read();
    ASSERT_TRUE(message);
    snapshots += message->is_binary && at<std::uint8_t>(message->data, 0) == 3;
    states += !message->is_binary && Json::parse(message->data)["type"] == "state";
  }
  EXPECT_EQ(snapshots, 0);
  b.server->observe(HapticSample{});
  EXPECT_NE(next_snapshot(client), "");
}

// In a recording that stands still nothing comes after them that would fill the plots.
TEST(LiveServer, APageThatIsBusyGetsTheRowsOfAJumpLater) {
  Bench b;
  b.server->begin_session({.device = "hand:", .is_simulated = true, .replay = "a.mcap"});
  WebClient slow(b.server->port(), {.receive_buffer = 4096});
  ASSERT_EQ(slow.status(), 101);
  const auto observe = [&](double from, int count) {
    for (int i = 0; i < count; ++i) {
      HapticSample sample;
      sample.frame = static_cast<std::uint64_t>(i);
      sample.time = from + 1e-3 * i;
      b.server->observe(sample);
    }
  };
  for (int i = 0; i < 20; ++i) {  // until its line is full
    observe(0.3 * i, 250);
    sleep_ns(40'000'000);
  }
  constexpr double kTo = 100.0;
  constexpr int kRows = 200;
  b.server->rewind();
  observe(kTo, kRows);
  LiveRequest seek;
  seek.kind = LiveRequest::Kind::seek;
  b.server->answer(seek, "");
  sleep_ns(200'000'000);
  std::uint32_t rows = 0;
  bool has_dropped = false;
  for (const double deadline = wall() + 5.0; rows < kRows && wall() < deadline;) {
    const auto message = slow.read(0.2);
    if (!message) continue;
    if (!message->is_binary) {
      const Json json = Json::parse(message->data);
      has_dropped = has_dropped || (json["type"] == "state" && json["dropped"]["yours"] > 0);
    } else if (at<std::uint8_t>(message->data, 0) == 2 && at<double>(message->data, 8) >= kTo) {
      rows += at<std::uint32_t>(message->data, 4);
    }
  }
  EXPECT_TRUE(has_dropped) << "the page was not busy";
  EXPECT_EQ(rows, kRows);
}

TEST(LiveServer, ChoicesOfTheProgramAreShownAndAskedForThere) {
  Bench b;
  LiveParameter response;
  response.name = "response";
  response.kind = ParameterKind::choice;
  response.choices = {"coupled", "direct"};
  b.server->begin_session({.device = "hand:", .is_simulated = true, .choices = {response}});
  WebClient client(b.server->port());
  bool is_told = false;
  for (std::string text = client.read_type("parameters"); !text.empty() && !is_told;
       text = is_told ? text : client.read_type("parameters")) {
    const Json message = Json::parse(text);
    for (const Json& p : message["list"])
      is_told = is_told || (p["name"] == "response" && p["choices"][1] == "direct");
  }
  EXPECT_TRUE(is_told);
  client.send_text(R"({"type":"set","id":9,"name":"response","value":1})");
  std::optional<LiveRequest> request;
  for (int i = 0; i < 5000 && !request; ++i) {
    request = b.server->take_request();
    sleep_ns(1'000'000);
  }
  ASSERT_TRUE(request);
  EXPECT_EQ(request->kind, LiveRequest::Kind::choose);
  EXPECT_EQ(request->text, "response");
  EXPECT_EQ(request->number, 1.0);
}

TEST(LiveServer, ParametersAreChangedAnsweredAndToldToAll) {
  Bench b;
  const SessionConfig config = b.patient();
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  WebClient first(b.server->port()), second(b.server->port());
  ASSERT_NE(second.read_type("parameters"), "");
  ASSERT_NE(first.read_type("state"), "");
  ASSERT_NE(second.read_type("state"), "");
  const Json done = ack_of(first, R"({"type":"set","id":3,"name":"mass","value":0.02})");
  EXPECT_TRUE(done["ok"].get<bool>()) << done;
  EXPECT_EQ(done["value"], 0.02);
  bool is_told = false;
  while (!is_told) {
    const std::string text = second.read_type("parameters");
    ASSERT_NE(text, "");
    const Json parameters = Json::parse(text);
    for (const Json& p : parameters["list"])
      is_told = is_told || (p["name"] == "mass" && p["value"] == 0.02);
  }
  EXPECT_TRUE(config.live->haptic_tuning.fetch());
  EXPECT_EQ(config.live->haptic_tuning.value().body.mass, 0.02);
  const Json unsafe = ack_of(first, R"({"type":"set","id":4,"name":"mass","value":0.0011})");
  EXPECT_FALSE(unsafe["ok"].get<bool>());
  EXPECT_NE(unsafe["reason"].get<std::string>().find("at least"), std::string::npos) << unsafe;

  SessionConfig next = b.scene.config;
  b.server->prepare_session(next);
  EXPECT_EQ(next.haptic.body.mass, 0.02);
  EXPECT_FALSE(ack_of(first, R"({"type":"set","id":5,"name":"mass","value":0.03})")["ok"]);
  b.server->begin_session({.device = "hand:", .is_simulated = true, .recording = "x.mcap"});
  while (Json::parse(first.read_type("state"))["recording"] != "x.mcap") {
  }
  EXPECT_FALSE(ack_of(first, R"({"type":"set","id":6,"name":"mass","value":0.03})")["ok"]);
  EXPECT_TRUE(
      ack_of(first, R"({"type":"set","id":7,"name":"contact_stiffness","value":1000})")["ok"]);
}

TEST(LiveServer, PauseStepAndWhatTheProgramIsAsked) {
  Bench b;
  SessionConfig config = b.patient();
  b.server->begin_session({.device = "hand:", .is_simulated = true});
  WebClient client(b.server->port());
  ASSERT_NE(client.read_type("state"), "");
  EXPECT_FALSE(ack_of(client, R"({"type":"step","id":1,"value":1})")["ok"]);  // runs
  EXPECT_TRUE(ack_of(client, R"({"type":"pause","id":2,"value":true})")["ok"]);
  EXPECT_TRUE(config.live->is_paused);
  EXPECT_TRUE(ack_of(client, R"({"type":"step","id":3,"value":5})")["ok"]);
  EXPECT_EQ(config.live->steps, 5);
  EXPECT_FALSE(ack_of(client, R"({"type":"step","id":4,"value":0.5})")["ok"]);
  EXPECT_TRUE(ack_of(client, R"({"type":"pause","id":5,"value":false})")["ok"]);
  EXPECT_FALSE(config.live->is_paused);
  EXPECT_FALSE(ack_of(client, R"({"type":"use_device","id":6,"value":"dhd:"})")["ok"]);
  EXPECT_FALSE(ack_of(client, R"({"type":"hold","id":7,"value":true})")["ok"]);  // moved by a hand

  client.send_text(R"({"type":"use_device","id":8,"value":"web:"})");
  std::optional<LiveRequest> request;
  for (int i = 0; i < 5000 && !request; ++i) {
    request = b.server->take_request();
    sleep_ns(1'000'000);
  }
  ASSERT_TRUE(request);
  EXPECT_EQ(request->text, "web:");
  b.server->answer(*request, "not now");
  const Json answer = Json::parse(client.read_type("ack"));
  EXPECT_EQ(answer["id"], 8);
  EXPECT_EQ(answer["reason"], "not now");
  b.server->begin_session(
      {.device = "web:", .is_web = true, .is_simulated = true, .holder = request->page});
  for (Json state; state["holder"] != "you";) {
    const std::string text = client.read_type("state");
    ASSERT_NE(text, "");
    state = Json::parse(text);
  }
  b.server->begin_session({.device = "dhd:"});
  while (Json::parse(client.read_type("state"))["device"] != "dhd:") {
  }
  EXPECT_FALSE(ack_of(client, R"({"type":"pause","id":9,"value":true})")["ok"]);
}

}  // namespace
}  // namespace thigma::live
