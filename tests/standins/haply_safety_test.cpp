// The Inverse Service, pretended: when force ends, and every fault.
#include "haply_client.h"

namespace standin_test {
namespace {

class HaplySafety : public ::testing::Test {
 protected:
  HaplySafety()
      : service("standin_haply", "HAPLY", {"--events-port", "0"}), client(service.port()) {
    EXPECT_TRUE(client.json().is_object());
  }

  Running service;
  HaplyClient client;
};

TEST_F(HaplySafety, a_message_without_a_force_lets_the_device_idle) {
  client.force(2, 0, 0);
  EXPECT_EQ(service.get("applied_fx"), 2.0);
  const Json state = client.ask(Json::object());
  EXPECT_EQ(service.get("applied_fx"), 0.0);
  EXPECT_EQ(state["inverse3"][0]["state"]["control_mode"], "idle");
  EXPECT_EQ(service.get("keepalives"), 1.0);
}

TEST_F(HaplySafety, silence_lets_the_device_idle_after_its_time) {
  service.set("comm_timeout_ms", 50);
  client.force(2, 0, 0);
  EXPECT_TRUE(service.reaches("applied_fx", 0.0));
  EXPECT_GE(service.get("force_off_time") - service.get("last_set_time"), 0.05);
  EXPECT_EQ(service.get("last_fx"), 2.0);
}

TEST_F(HaplySafety, the_end_of_a_session_ends_its_force) {
  service.set("comm_timeout_ms", 0);
  client.force(2, 0, 0);
  EXPECT_EQ(service.get("applied_fx"), 2.0);
  client.wire().close();
  EXPECT_TRUE(service.reaches("applied_fx", 0.0));
  EXPECT_NE(service.log().find("device: session closed"), std::string::npos);
}

TEST_F(HaplySafety, a_killed_client_leaves_no_force) {
  service.set("comm_timeout_ms", 0);
  const int port = service.port();
  const pid_t child = run_child([port] {
    auto* other = new HaplyClient(port);
    other->next();
    other->force(2, 0, 0);
  });
  ASSERT_TRUE(service.reaches("applied_fx", 2.0));
  usleep(50000);
  EXPECT_EQ(service.get("applied_fx"), 2.0);
  kill_child(child);
  EXPECT_TRUE(service.reaches("applied_fx", 0.0));
  EXPECT_GT(service.get("force_off_time"), service.get("last_set_time"));
}

TEST_F(HaplySafety, pulled_out_is_gone_from_the_list_and_told_as_an_event) {
  HaplyClient events(static_cast<int>(service.get("events_port")));
  client.force(2, 0, 0);
  service.set("unplug", 1);
  EXPECT_TRUE(service.reaches("applied_fx", 0.0));
  const Json event = events.json();
  EXPECT_EQ(event["name"], "device-disconnected");
  EXPECT_EQ(event["data"]["device_id"], "049D");
  EXPECT_TRUE(client.force(2, 0, 0)["inverse3"].empty());
  EXPECT_EQ(service.get("applied_fx"), 0.0);
  service.set("unplug", 0);
  EXPECT_EQ(events.json()["name"], "device-connected");
  EXPECT_EQ(client.force(0, 0, 0)["inverse3"].size(), 1U);
}

TEST_F(HaplySafety, the_emergency_brake) {
  HaplyClient events(static_cast<int>(service.get("events_port")));
  client.force(2, 0, 0);
  service.set("cut", 1);
  EXPECT_EQ(events.json()["name"], "device-safety-triggered");
  EXPECT_TRUE(service.reaches("mode", 2.0));
  client.force(2, 0, 0);
  EXPECT_EQ(service.get("applied_fx"), 0.0);
}

TEST_F(HaplySafety, positions_that_are_none_and_jumps) {
  service.set("nan_pose", 1);
  Json state = client.force(0, 0, 0)["inverse3"][0]["state"];
  EXPECT_TRUE(state["cursor_position"]["x"].is_null());
  service.set("nan_pose", 0);
  service.set("null_pose", 1);
  state = client.force(0, 0, 0)["inverse3"][0]["state"];
  EXPECT_FALSE(state.contains("cursor_position"));
  service.set("null_pose", 0);
  service.set("jump_x", 0.5);
  state = client.force(0, 0, 0)["inverse3"][0]["state"];
  EXPECT_GT(state["cursor_position"]["x"], 0.4);
}

TEST_F(HaplySafety, garbage_of_two_kinds) {
  service.set("garbage", 1);
  EXPECT_TRUE(client.force(1, 0, 0).is_discarded());
  service.set("garbage", 2);
  client.say(Json::object());
  client.wire().read(1);
  EXPECT_EQ(client.wire().in().substr(0, 1), "\xff");
}

TEST_F(HaplySafety, half_a_frame_and_then_silence_or_the_end) {
  service.set("half", 1);
  client.say(Json::object());
  EXPECT_TRUE(client.next(0.3).empty());
  EXPECT_GT(client.wire().in().size(), 100U);
  EXPECT_FALSE(client.wire().is_closed(0.1));
  EXPECT_EQ(service.get("silent"), 1.0);
  service.set("silent", 0);
  HaplyClient other(service.port());
  EXPECT_TRUE(other.json().is_object());
  service.set("half", 2);
  other.say(Json::object());
  EXPECT_TRUE(other.wire().is_closed());
}

TEST_F(HaplySafety, silence_still_takes_what_it_is_sent) {
  service.set("silent", 1);
  client.say(HaplyClient::force_message(1, 0, 0, "vector", "049D"));
  EXPECT_TRUE(service.reaches("last_fx", 1.0));
  EXPECT_TRUE(client.next(0.1).empty());
}

TEST_F(HaplySafety, connections_dropped_and_refused) {
  service.set("drop", 1);
  EXPECT_TRUE(client.wire().is_closed());
  service.set("refuse", 1);
  Wire other(si::connect_tcp(service.port()));
  EXPECT_TRUE(other.is_closed());
}

TEST_F(HaplySafety, the_service_is_killed) {
  client.force(1, 0, 0);
  service.set("die", 1);
  EXPECT_TRUE(client.wire().is_closed());
  EXPECT_TRUE(wait_for([&] { return service.has_ended(); }));
  EXPECT_EQ(service.get("last_fx"), 1.0);  // the board lives on
}

TEST_F(HaplySafety, answers_can_be_late) {
  service.set("delay_ms", 30);
  const double start = si::now();
  EXPECT_TRUE(client.force(0, 0, 0).is_object());
  EXPECT_GE(si::now() - start, 0.03);
}

TEST_F(HaplySafety, a_client_that_does_not_mask_is_sent_away) {
  client.wire().send(si::write_frame(si::kText, "{}"));
  EXPECT_TRUE(client.wire().is_closed());
}

}  // namespace
}  // namespace standin_test
