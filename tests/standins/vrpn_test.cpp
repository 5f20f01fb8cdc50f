// The VRPN server, pretended: its bytes, its field of forces, its faults.
#include <cmath>
#include <map>

#include "services.h"
#include "vrpn/wire.h"
#include <netinet/in.h>

namespace standin_test {
namespace {

// A client that reads messages and knows types by their names.
class VrpnClient {
 public:
  explicit VrpnClient(int fd, bool greets = true) : wire(fd) {
    if (greets) {
      wire.send(si::cookie(7, 38));
      wire.send(si::write_message(0, si::kSenderDescription, si::description("Haptic0"), 0));
      wire.send(si::write_message(0, si::kTypeDescription,
                                  si::description("vrpn_ForceDevice Force_Field"), 1));
      wire.send(
          si::write_message(1, si::kTypeDescription, si::description("vrpn_Base ping_message"), 2));
      EXPECT_EQ(wire.read(si::kCookieSize).substr(0, 16), "vrpn: ver. 07.38");
      wire.drop(si::kCookieSize);
    }
  }

  si::VrpnMessage next(double seconds = 10.0) {
    for (double waited = 0.0; waited < seconds; waited += 0.01) {
      bool is_broken = false;
      if (const auto message = si::read_message(wire.in(), &is_broken)) {
        wire.drop(message->size);
        if (message->type == si::kTypeDescription) {
          types[message->sender] = si::described_name(message->payload);
        } else if (message->type == si::kUdpDescription) {
          udp_port = message->sender;
        }
        return *message;
      }
      if (is_broken || wire.is_closed(0.0)) {
        return {};
      }
      wire.read(wire.in().size() + 1, 0.01);
    }
    return {};
  }
  // The next message of a type; an empty one where none comes.
  si::VrpnMessage next_of(const std::string& type) {
    for (int i = 0; i < 5000; ++i) {
      const si::VrpnMessage message = next();
      if (message.size == 0 || (message.type >= 0 && types[message.type] == type)) {
        return message;
      }
    }
    return {};
  }

  static std::string field(float fx, float ox, float stiffness, float radius) {
    std::string payload;
    for (const float v : {ox, 0.0F, 0.0F, fx, 0.0F, 0.0F, -stiffness, 0.0F, 0.0F, 0.0F, -stiffness,
                          0.0F, 0.0F, 0.0F, -stiffness, radius}) {
      si::add_float(&payload, v);
    }
    return payload;
  }
  void say_field(float fx, float ox = 0.0F, float stiffness = 0.0F, float radius = 1.0F) {
    wire.send(si::write_message(0, 0, field(fx, ox, stiffness, radius), 3));
  }

  Wire wire;
  std::map<int, std::string> types;
  int udp_port = 0;
};

class Vrpn : public ::testing::Test {
 protected:
  Vrpn() : server("standin_vrpn", "VRPN", {}) { server.set("hold", 1); }
  Running server;
};

TEST_F(Vrpn, cookie_is_24_bytes_and_comes_first) {
  Wire wire(si::connect_tcp(server.port()));
  const std::string bytes = wire.read(si::kCookieSize);
  EXPECT_EQ(bytes, std::string("vrpn: ver. 07.38  0") + std::string(5, '\0'));
  EXPECT_TRUE(wire.read(25, 0.1).size() == 24U);  // nothing more before the client's
}

TEST_F(Vrpn, bytes_of_a_message_are_as_the_format_says) {
  const std::string bytes = si::write_message(1, 2, "abc", 5);
  EXPECT_EQ(bytes.size(), 32U);
  EXPECT_EQ(bytes.substr(0, 4), std::string("\0\0\0\x1b", 4));  // 24 + 3, without padding
  EXPECT_EQ(bytes.substr(12, 12), std::string("\0\0\0\x01\0\0\0\x02\0\0\0\x05", 12));
  EXPECT_EQ(si::description("ab"), std::string("\0\0\0\x03"
                                               "ab\0",
                                               7));
}

TEST_F(Vrpn, minor_versions_may_differ_major_ones_not) {
  for (const bool fits : {true, false}) {
    VrpnClient client(si::connect_tcp(server.port()), false);
    client.wire.send(si::cookie(fits ? 7 : 6, 12));
    client.wire.read(si::kCookieSize);
    client.wire.drop(si::kCookieSize);
    EXPECT_EQ(client.next().type, fits ? si::kSenderDescription : 0);
    EXPECT_EQ(client.wire.is_closed(fits ? 0.05 : 10.0), !fits);
  }
}

TEST_F(Vrpn, poses_come_in_metres_with_w_last) {
  server.set("target_x", 0.01);
  server.set("target_y", -0.02);
  server.set("target_z", 0.03);
  server.set("target_rx", 3.14159265358979 / 2);
  ASSERT_TRUE(server.reaches("pz", 0.03));
  VrpnClient client(si::connect_tcp(server.port()));
  const si::VrpnMessage pose = client.next_of("vrpn_Tracker Pos_Quat");
  ASSERT_EQ(pose.payload.size(), 64U);
  std::size_t at = 8;
  for (const double expected : {0.01, -0.02, 0.03, 0.70710678, 0.0, 0.0, 0.70710678}) {
    EXPECT_NEAR(si::take_double(pose.payload, &at), expected, 1e-8);
  }
  EXPECT_EQ(client.next_of("vrpn_Tracker Velocity").payload.size(), 72U);
}

TEST_F(Vrpn, buttons_their_state_first_then_their_changes) {
  VrpnClient client(si::connect_tcp(server.port()));
  EXPECT_EQ(client.next_of("vrpn_Button States").payload.size(), 20U);
  server.set("buttons", 2);
  const si::VrpnMessage change = client.next_of("vrpn_Button Change");
  std::size_t at = 0;
  EXPECT_EQ(si::take_int(change.payload, &at), 1);
  EXPECT_EQ(si::take_int(change.payload, &at), 1);
}

TEST_F(Vrpn, the_field_is_felt_where_the_handle_is) {
  VrpnClient client(si::connect_tcp(server.port()));
  server.set("target_x", 0.02);
  ASSERT_TRUE(server.reaches("px", 0.02));
  client.say_field(1.5F, 0.01F, 50.0F, 0.5F);
  ASSERT_TRUE(server.reaches("fields", 1));
  EXPECT_TRUE(wait_for([&] { return std::fabs(server.get("applied_fx") - 1.0) < 1e-6; }));
  EXPECT_EQ(server.get("last_fx"), 1.5);
  EXPECT_EQ(server.get("field_jyy"), -50.0);
  server.set("target_x", 0.03);  // the server's own loop follows the handle
  EXPECT_TRUE(wait_for([&] { return std::fabs(server.get("applied_fx") - 0.5) < 1e-6; }));
  server.set("target_x", 0.6);  // beyond the radius
  EXPECT_TRUE(server.reaches("applied_fx", 0.0));
  EXPECT_GT(server.get("outside_field"), 0.0);
  const si::VrpnMessage report = client.next_of("vrpn_ForceDevice Force");
  EXPECT_EQ(report.payload.size(), 24U);
}

TEST_F(Vrpn, a_field_of_wrong_length_is_refused_and_one_of_nan_moves_nothing) {
  VrpnClient client(si::connect_tcp(server.port()));
  client.wire.send(si::write_message(0, 0, VrpnClient::field(1, 0, 0, 1).substr(4), 3));
  EXPECT_TRUE(server.reaches("bad_messages", 1));
  client.say_field(NAN);
  EXPECT_TRUE(server.reaches("non_finite", 1));
  EXPECT_EQ(server.get("applied_fx"), 0.0);
}

TEST_F(Vrpn, too_much_is_clamped_and_told_as_an_error) {
  server.set("max_force", 3);
  VrpnClient client(si::connect_tcp(server.port()));
  client.say_field(8);
  const si::VrpnMessage error = client.next_of("vrpn_ForceDevice Force_Error");
  std::size_t at = 0;
  EXPECT_EQ(si::take_int(error.payload, &at), 2);
  EXPECT_EQ(server.get("applied_fx"), 3.0);
}

TEST_F(Vrpn, a_ping_is_answered) {
  VrpnClient client(si::connect_tcp(server.port()));
  client.wire.send(si::write_message(0, 1, "", 3));
  EXPECT_GT(client.next_of("vrpn_Base pong_message").size, 0U);
}

TEST_F(Vrpn, a_silent_client_keeps_its_field) {
  VrpnClient client(si::connect_tcp(server.port()));
  client.say_field(2);
  ASSERT_TRUE(server.reaches("applied_fx", 2.0));
  usleep(200000);
  EXPECT_EQ(server.get("applied_fx"), 2.0);
}

TEST_F(Vrpn, a_killed_client_leaves_its_field_or_not_as_servers_do) {
  for (const bool resets : {true, false}) {
    server.set("drop_resets", resets ? 1 : 0);
    const int port = server.port();
    const pid_t child = run_child([port] {
      auto* client = new VrpnClient(si::connect_tcp(port));
      client->say_field(2);
    });
    ASSERT_TRUE(server.reaches("applied_fx", 2.0));
    kill_child(child);
    EXPECT_TRUE(server.reaches("clients", 0));
    if (resets) {
      EXPECT_TRUE(server.reaches("applied_fx", 0.0));
      EXPECT_NE(server.log().find("device: last connection dropped"), std::string::npos);
    } else {
      usleep(100000);
      EXPECT_EQ(server.get("applied_fx"), 2.0);
    }
  }
}

TEST_F(Vrpn, calls_back_who_lobs_a_datagram_and_takes_fields_by_udp) {
  int port = 0;
  const int listener = si::listen_tcp(&port);
  int mine = 0;
  Wire udp(si::bind_udp(&mine));
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(server.port()));
  to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const std::string lob = "127.0.0.1 " + std::to_string(port);
  sendto(udp.fd(), lob.c_str(), lob.size() + 1, 0, reinterpret_cast<sockaddr*>(&to), sizeof(to));
  VrpnClient client(si::take(listener));
  close(listener);
  EXPECT_GT(client.next_of("vrpn_Button States").size, 0U);
  ASSERT_GT(client.udp_port, 0);
  const std::string field = si::write_message(0, 0, VrpnClient::field(1, 0, 0, 1), 9);
  to.sin_port = htons(static_cast<std::uint16_t>(client.udp_port));
  sendto(udp.fd(), field.data(), field.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof(to));
  EXPECT_TRUE(server.reaches("applied_fx", 1.0));
  client.wire.send(si::write_message(mine, si::kUdpDescription, std::string("127.0.0.1\0", 10), 4));
  EXPECT_GE(udp.read(88).size(), 88U);  // a report; it is counted after it was sent
  for (int i = 0; i < 200 && !(server.get("udp_reports") > 0.0); ++i) usleep(5000);
  EXPECT_GT(server.get("udp_reports"), 0.0);
}

TEST_F(Vrpn, pulled_out_it_tells_nothing_more_and_has_no_force) {
  VrpnClient client(si::connect_tcp(server.port()));
  client.say_field(2);
  ASSERT_TRUE(server.reaches("applied_fx", 2.0));
  server.set("unplug", 1);
  EXPECT_TRUE(server.reaches("applied_fx", 0.0));
  usleep(50000);
  client.wire.drop(client.wire.read(1 << 20, 0.2).size());
  EXPECT_EQ(client.wire.read(1, 0.1).size(), 0U);
}

TEST_F(Vrpn, faults_of_bytes) {
  server.set("wrong_cookie", 1);
  EXPECT_EQ(Wire(si::connect_tcp(server.port())).read(24).substr(0, 14), "vrpn: ver. 08.");
  server.set("wrong_cookie", 2);
  EXPECT_EQ(Wire(si::connect_tcp(server.port())).read(24).substr(0, 4), "HTTP");
  server.set("wrong_cookie", 0);
  VrpnClient client(si::connect_tcp(server.port()));
  client.next_of("vrpn_Tracker Pos_Quat");
  server.set("lie_length", 1);
  EXPECT_EQ(client.next_of("vrpn_ForceDevice Force_Error").size, 0U);  // runs into the lie
  client.wire.close();
  server.set("lie_length", 0);
  VrpnClient halved(si::connect_tcp(server.port()));
  halved.next_of("vrpn_Tracker Pos_Quat");
  server.set("half", 2);
  EXPECT_TRUE(halved.wire.is_closed());
  VrpnClient silenced(si::connect_tcp(server.port()));
  server.set("silent", 1);
  usleep(50000);
  silenced.wire.drop(silenced.wire.read(1 << 20, 0.2).size());
  EXPECT_EQ(silenced.wire.read(1, 0.1).size(), 0U);
  server.set("drop", 1);
  EXPECT_TRUE(silenced.wire.is_closed());
}

}  // namespace
}  // namespace standin_test
