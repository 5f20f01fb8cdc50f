// The Inverse Service, pretended: what it says, what it understands.
#include "haply_client.h"

namespace standin_test {
namespace {

class Haply : public ::testing::Test {
 protected:
  void start(std::vector<std::string> keys = {}) {
    service = std::make_unique<Running>(
        "standin_haply", "HAPLY", std::vector<std::string>{"--events-port", "0"}, std::move(keys));
    client = std::make_unique<HaplyClient>(service->port());
    inventory = client->json();
    ASSERT_TRUE(inventory.is_object());
  }
  Json position(const Json& message) { return message["inverse3"][0]["state"]["cursor_position"]; }

  std::unique_ptr<Running> service;
  std::unique_ptr<HaplyClient> client;
  Json inventory;
};

TEST_F(Haply, shakes_hands_as_the_example_of_the_protocol) {
  start();
  EXPECT_NE(client->head.find("101"), std::string::npos);
  EXPECT_NE(client->head.find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo="), std::string::npos);
}

TEST_F(Haply, first_message_has_configuration_later_ones_only_state) {
  start();
  EXPECT_TRUE(inventory.contains("session_id"));
  const Json& device = inventory["inverse3"][0];
  EXPECT_EQ(device["device_id"], "049D");
  EXPECT_EQ(device["config"]["handedness"], "right");
  EXPECT_EQ(device["config"]["basis"]["permutation"], "XYZ");
  EXPECT_EQ(device["state"]["control_mode"], "idle");
  EXPECT_TRUE(device["status"]["calibrated"].get<bool>());
  const Json later = client->ask({{"inverse3", Json::array()}});
  EXPECT_FALSE(later.contains("session_id"));
  EXPECT_FALSE(later["inverse3"][0].contains("config"));
  const Json full = client->ask({{"session", {{"force_render_full_state", Json::object()}}}});
  EXPECT_TRUE(full["inverse3"][0].contains("config"));
}

TEST_F(Haply, one_state_for_each_message_and_none_without) {
  start();
  for (int i = 0; i < 50; ++i) {
    EXPECT_TRUE(client->force(0, 0, 0).is_object());
  }
  EXPECT_TRUE(service->reaches("answers", 51.0));  // counted after it was sent
  EXPECT_EQ(service->get("messages"), 50.0);
  EXPECT_TRUE(client->next(0.1).empty());
}

TEST_F(Haply, force_is_taken_in_newtons_as_it_came) {
  start();
  const Json state = client->force(1.25, -0.5, 1e-7)["inverse3"][0]["state"];
  EXPECT_EQ(service->get("last_fx"), 1.25);
  EXPECT_EQ(service->get("last_fy"), -0.5);
  EXPECT_EQ(service->get("last_fz"), 1e-7);
  EXPECT_EQ(service->get("applied_fx"), 1.25);
  EXPECT_EQ(state["current_cursor_force"]["x"], 1.25);
  EXPECT_EQ(state["control_mode"], "force");
  EXPECT_EQ(service->get("torque_nonzero"), 0.0);
  EXPECT_NE(service->log().find(",set_cursor_force,0,1.25,-0.5,"), std::string::npos);
}

TEST_F(Haply, version_3_5_reads_vector_only) {
  start();
  client->force(1, 0, 0, "values");
  EXPECT_EQ(service->get("applied_fx"), 0.0);
  EXPECT_EQ(service->get("wrong_form"), 1.0);
  client->force(1, 0, 0, "vector");
  EXPECT_EQ(service->get("applied_fx"), 1.0);
}

TEST_F(Haply, version_3_1_reads_values_only) {
  start({"SDK_MINOR=1", "SDK_RELEASE=2"});
  client->force(1, 0, 0, "vector");
  EXPECT_EQ(service->get("applied_fx"), 0.0);
  EXPECT_EQ(service->get("wrong_form"), 1.0);
  client->force(1, 0, 0, "values");
  EXPECT_EQ(service->get("applied_fx"), 1.0);
}

TEST_F(Haply, tells_its_version_by_http) {
  start({"SDK_MINOR=1", "SDK_RELEASE=2"});
  for (const bool knows : {true, false}) {
    service->set("no_version", knows ? 0 : 1);
    HaplyClient http(service->port(), false);
    http.wire().send("GET /version HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
    EXPECT_TRUE(http.wire().is_closed());
    const std::string& answer = http.wire().in();
    EXPECT_EQ(answer.substr(9, 3), knows ? "200" : "404");
    EXPECT_EQ(answer.find("\"project_version\":\"3.1.2.0\"") != std::string::npos, knows);
  }
}

TEST_F(Haply, handle_and_grip_are_where_the_hand_holds_them) {
  start();
  service->set("hold", 1);
  service->set("target_x", 0.02);
  service->set("target_y", -0.1);
  service->set("target_z", 0.2);
  service->set("target_rz", 3.14159265358979 / 2);
  service->set("buttons", 5);
  EXPECT_TRUE(service->reaches("pz", 0.2));
  const Json state = client->force(0, 0, 0);
  EXPECT_NEAR(position(state)["x"], 0.02, 1e-7);
  EXPECT_NEAR(position(state)["y"], -0.1, 1e-7);
  EXPECT_NEAR(position(state)["z"], 0.2, 1e-7);
  const Json grip = state["wireless_verse_grip"][0]["state"];
  EXPECT_NEAR(grip["orientation"]["w"], 0.70710678, 1e-6);
  EXPECT_NEAR(grip["orientation"]["z"], 0.70710678, 1e-6);
  EXPECT_EQ(grip["buttons"], Json({{"a", true}, {"b", false}, {"c", true}}));
}

TEST_F(Haply, grips_of_every_kind_and_none) {
  start({"VERSE_GRIP=1", "BUTTONS=1"});
  EXPECT_TRUE(inventory["verse_grip"][0]["state"]["button"].get<bool>());
  EXPECT_TRUE(inventory["wireless_verse_grip"].empty());
  service->set("verse_grip", 3);
  EXPECT_EQ(client->force(0, 0, 0)["custom_verse_grip"].size(), 1U);
  service->set("verse_grip", 0);
  const Json none = client->force(0, 0, 0);
  EXPECT_TRUE(none["verse_grip"].empty() && none["custom_verse_grip"].empty());
}

TEST_F(Haply, uncalibrated_gives_no_force_and_another_position) {
  start({"CALIBRATED=0", "HOLD=1"});
  EXPECT_FALSE(inventory["inverse3"][0]["status"]["calibrated"].get<bool>());
  EXPECT_NEAR(position(client->force(1, 0, 0))["y"], -0.10, 1e-6);
  EXPECT_EQ(service->get("applied_fx"), 0.0);
  EXPECT_EQ(service->get("last_fx"), 1.0);
  EXPECT_EQ(service->get("set_while_off"), 1.0);
  service->set("calibrated", 1);
  EXPECT_NEAR(position(client->force(1, 0, 0))["y"], -0.12, 1e-6);
  EXPECT_EQ(service->get("applied_fx"), 1.0);
}

TEST_F(Haply, force_beyond_the_device_is_clamped_along_its_direction) {
  start({"MAX_FORCE=5"});
  client->force(6, 8, 0);
  EXPECT_NEAR(service->get("applied_fx"), 3.0, 1e-12);
  EXPECT_NEAR(service->get("applied_fy"), 4.0, 1e-12);
  EXPECT_EQ(service->get("last_fy"), 8.0);
  EXPECT_EQ(service->get("saturations"), 1.0);
}

TEST_F(Haply, joint_torques_are_seen) {
  start();
  const Json command = {
      {"set_angular_torques", {{"torques", {{"a0", 0.1}, {"a1", 0}, {"a2", 0}}}}}};
  client->ask({{"inverse3", Json::array({{{"device_id", "049D"}, {"commands", command}}})}});
  EXPECT_EQ(service->get("torque_sets"), 1.0);
  EXPECT_EQ(service->get("torque_nonzero"), 1.0);
}

TEST_F(Haply, two_devices_have_their_own_forces) {
  start({"COUNT=2", "1_TYPE=1"});
  ASSERT_EQ(inventory["inverse3"].size(), 2U);
  EXPECT_EQ(inventory["inverse3"][1]["config"]["handedness"], "left");
  Json both = HaplyClient::force_message(1, 0, 0, "vector", "049D");
  both["inverse3"].push_back(HaplyClient::force_message(2, 0, 0, "vector", "04C3")["inverse3"][0]);
  client->ask(both);
  EXPECT_EQ(service->get("0.applied_fx"), 1.0);
  EXPECT_EQ(service->get("1.applied_fx"), 2.0);
}

TEST_F(Haply, profile_and_configuration_are_recorded) {
  start();
  client->ask({{"session", {{"configure", {{"profile", {{"name", "org.thigma"}}}}}}}});
  EXPECT_EQ(service->get("configures"), 1.0);
  EXPECT_NE(service->log().find("session.configure.profile"), std::string::npos);
  EXPECT_NE(service->record().find("org.thigma"), std::string::npos);
}

TEST_F(Haply, a_message_in_several_frames_and_a_ping) {
  start();
  const std::string text = HaplyClient::force_message(1, 0, 0, "vector", "049D").dump();
  client->wire().send(masked(si::kText, text.substr(0, 20), false));
  client->wire().send(masked(si::kPing, "x"));
  client->wire().send(masked(si::kContinued, text.substr(20)));
  EXPECT_EQ(client->next(), "x");
  EXPECT_TRUE(client->json().is_object());
  EXPECT_EQ(service->get("applied_fx"), 1.0);
}

TEST_F(Haply, what_is_wrong_is_counted_and_gives_no_force) {
  start();
  client->wire().send(masked(si::kText, "{\"inverse3\":["));
  EXPECT_TRUE(client->json().is_object());
  EXPECT_EQ(service->get("bad_messages"), 1.0);
  client->force(1, 0, 0, "vector", "FFFF");
  client->force(1, 0, 0, "forces");
  Json text = HaplyClient::force_message(1, 0, 0, "vector", "049D");
  text["inverse3"][0]["commands"]["set_cursor_force"]["vector"]["y"] = "1";
  client->ask(text);
  for (const char* command : {"set_angular_torques", "set_cursor_force", "set_cursor_position"}) {
    const Json commands = {{command, 5}};  // no object
    EXPECT_TRUE(
        client->ask({{"inverse3", Json::array({{{"device_id", "049D"}, {"commands", commands}}})}})
            .is_object());
  }
  EXPECT_EQ(service->get("errors"), 5.0);
  EXPECT_EQ(service->get("sets"), 0.0);
  EXPECT_EQ(service->get("applied_fx"), 0.0);
}

}  // namespace
}  // namespace standin_test
