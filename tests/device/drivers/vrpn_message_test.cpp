// Bytes of VRPN 07, written by hand after its public source.
#include "thigma/device/detail/vrpn_message.h"

#include <cmath>

#include <gtest/gtest.h>

#include "thigma/device/detail/vrpn_device.h"

namespace thigma::detail {
namespace {

using namespace std::string_literals;

TEST(VrpnMessage, cookies_agree_up_to_the_minor_version) {
  EXPECT_EQ(vrpn_cookie(), "vrpn: ver. 07.38  0\0\0\0\0\0"s);
  EXPECT_EQ(fault_of_vrpn_cookie(vrpn_cookie()), "");
  EXPECT_EQ(fault_of_vrpn_cookie("vrpn: ver. 07.12  0\0\0\0\0\0"s), "");
  EXPECT_EQ(fault_of_vrpn_cookie("vrpn: ver. 06.04  0\0\0\0\0\0"s),
            "it speaks VRPN 06.04, expected 07");
  EXPECT_EQ(fault_of_vrpn_cookie("SSH-2.0-OpenSSH_9.2\r\nxxx"), "it is no VRPN server");
}

// A name: length 24 + 4 + 5, time 2 s and 500000 us, sender 3, type -1, sequence, name, padding.
const std::string kName = "\0\0\0\x21\0\0\0\x02\0\x07\xa1\x20\0\0\0\x03\xff\xff\xff\xff\0\0\0\0"s +
                          "\0\0\0\x05Hand\0"s + "\0\0\0\0\0\0\0"s;

TEST(VrpnMessage, writes_and_reads_a_name) {
  std::string out;
  append_vrpn_message({kVrpnSenderIs, 3, 2.5, vrpn_name_payload("Hand")}, out);
  EXPECT_EQ(out, kName);
  VrpnReader reader;
  VrpnMessage message;
  for (const char c : kName + kName) {
    reader.add({&c, 1});
    if (!reader.next(message)) continue;
    std::string name;
    EXPECT_EQ(message.sender, 3);
    EXPECT_EQ(message.type, kVrpnSenderIs);
    EXPECT_EQ(message.time, 2.5);
    EXPECT_TRUE(read_vrpn_name(message.payload, name));
    EXPECT_EQ(name, "Hand");
    message = {};
  }
  EXPECT_FALSE(reader.is_broken());
}

TEST(VrpnMessage, lengths_that_no_message_has_break_the_connection) {
  for (const std::string& length :
       {"\0\0\0\0"s, "\0\0\0\x17"s, "\xff\xff\xff\xff"s, "\0\x10\0\0"s}) {
    VrpnReader reader;
    VrpnMessage message;
    reader.add(length + std::string(20, 'x'));
    EXPECT_FALSE(reader.next(message));
    EXPECT_TRUE(reader.is_broken());
  }
}

TEST(VrpnMessage, reads_a_pose_and_a_velocity) {
  // sensor 1, filling, (1, -2, 0.5), quaternion x y z w = (0, 0, 1, 0)
  const std::string pose = "\0\0\0\x01\0\0\0\x01"s + "\x3f\xf0\0\0\0\0\0\0"s +
                           "\xc0\0\0\0\0\0\0\0"s + "\x3f\xe0\0\0\0\0\0\0"s + std::string(16, '\0') +
                           "\x3f\xf0\0\0\0\0\0\0"s + std::string(8, '\0');
  VrpnReport report;
  ASSERT_TRUE(read_vrpn_pose(pose, report));
  EXPECT_EQ(report.sensor, 1);
  EXPECT_EQ(report.vector, Vec3(1.0, -2.0, 0.5));
  EXPECT_EQ(report.quaternion.z(), 1.0);
  EXPECT_EQ(report.quaternion.w(), 0.0);
  ASSERT_TRUE(read_vrpn_velocity(pose + "\x3f\xe0\0\0\0\0\0\0"s, report));
  EXPECT_EQ(report.time, 0.5);
  for (std::size_t n = 0; n < pose.size(); ++n)
    EXPECT_FALSE(read_vrpn_pose(pose.substr(0, n), report));
  EXPECT_FALSE(read_vrpn_velocity(pose, report));
}

TEST(VrpnMessage, reads_buttons_one_and_all) {
  std::uint32_t buttons = 0;
  EXPECT_TRUE(read_vrpn_button("\0\0\0\x02\0\0\0\x01"s, buttons));
  EXPECT_EQ(buttons, 4u);
  EXPECT_TRUE(read_vrpn_button("\0\0\0\x02\0\0\0\0"s, buttons));
  EXPECT_EQ(buttons, 0u);
  EXPECT_TRUE(read_vrpn_buttons("\0\0\0\x02\0\0\0\x01\0\0\0\0"s, buttons));
  EXPECT_EQ(buttons, 1u);
  EXPECT_TRUE(read_vrpn_button("\0\0\0\xff\0\0\0\x01"s, buttons));  // beyond what we have
  EXPECT_TRUE(read_vrpn_button("\xff\xff\xff\xff\0\0\0\x01"s, buttons));
  EXPECT_EQ(buttons, 1u);
  EXPECT_FALSE(read_vrpn_buttons("\xff\xff\xff\xff\0\0\0\x01"s, buttons));  // it lies
  EXPECT_FALSE(read_vrpn_button("\0\0\0\x02"s, buttons));
}

TEST(VrpnMessage, writes_a_force_field_as_the_library_does) {
  const std::string field =
      vrpn_force_field({1.0, 0.0, -2.0}, {0.5, 0.0, 0.0}, 2.0 * Mat3::Identity(), 0.25);
  ASSERT_EQ(field.size(), 64u);
  EXPECT_EQ(field.substr(0, 4), "\x3f\x80\0\0"s);  // origin x: 1
  EXPECT_EQ(field.substr(8, 4), "\xc0\0\0\0"s);    // origin z: -2
  EXPECT_EQ(field.substr(12, 4), "\x3f\0\0\0"s);   // force x: 0.5
  EXPECT_EQ(field.substr(24, 4), "\x40\0\0\0"s);   // jacobian: row by row
  EXPECT_EQ(field.substr(28, 4), "\0\0\0\0"s);
  EXPECT_EQ(field.substr(40, 4), "\x40\0\0\0"s);
  EXPECT_EQ(field.substr(60, 4), "\x3e\x80\0\0"s);  // radius: 0.25
}

TEST(VrpnMessage, axes_are_a_turn_or_refused) {
  Mat3 axes;
  ASSERT_EQ(parse_axes("zxy", axes), "");
  EXPECT_EQ(axes * Vec3(1.0, 2.0, 3.0), Vec3(3.0, 1.0, 2.0));
  EXPECT_EQ(axes.determinant(), 1.0);
  ASSERT_EQ(parse_axes("-yxz", axes), "");
  EXPECT_EQ(axes * Vec3(1.0, 2.0, 3.0), Vec3(-2.0, 1.0, 3.0));
  EXPECT_EQ(parse_axes("yxz", axes), "axes = 'yxz' mirror, turn one of them round");
  for (const char* word : {"", "x", "xy", "xyzx", "xxy", "x-", "xy-", "--xyz", "abc", "XYZ"})
    EXPECT_NE(parse_axes(word, axes).find("expected x, y and z"), std::string::npos) << word;
}

}  // namespace
}  // namespace thigma::detail
