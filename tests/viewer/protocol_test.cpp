#include "viewer/server/protocol.h"

#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/clod/clod_asset.h"
#include "thigma/mesh/shapes.h"

namespace thigma::live {
namespace {

std::string hex(std::string_view bytes) {
  std::string text;
  char two[4];
  for (const char c : bytes) {
    std::snprintf(two, sizeof two, "%02x", static_cast<unsigned char>(c));
    text += two;
  }
  return text;
}

template <class T>
T at(std::string_view message, std::size_t offset) {
  T value;
  std::memcpy(&value, message.data() + offset, sizeof value);
  return value;
}

ChannelRow row(double time, float first) {
  ChannelRow r;
  r.time = time;
  for (std::size_t i = 0; i < r.values.size(); ++i) r.values[i] = first + static_cast<float>(i);
  return r;
}

// The bytes of docs/protocol.md, so that no page of another build reads them otherwise.
TEST(Protocol, ChannelsAreTheseBytes) {
  const ChannelRow rows[] = {row(1.5, 1.0f)};
  EXPECT_EQ(hex(encode_channels(rows)),
            "02011000"                    // type, layout, channels
            "01000000"                    // rows
            "000000000000f83f"            // 1.5 s
            "00000000"                    // t
            "0000803f0000004000004040"    // 1 2 3
            "000080400000a0400000c040"    // 4 5 6
            "0000e0400000004100001041"    // 7 8 9
            "000020410000304100004041"    // 10 11 12
            "000050410000604100007041");  // 13 14 15
}

TEST(Protocol, RowsOfABatchAreRelativeToItsFirst) {
  const ChannelRow rows[] = {row(1e6, 0.0f), row(1e6 + 0.001, 0.0f), row(1e6 + 0.002, 0.0f)};
  const std::string message = encode_channels(rows);
  ASSERT_EQ(message.size(), 16u + 3u * 64u);
  EXPECT_EQ(at<double>(message, 8), 1e6);
  EXPECT_NEAR(at<float>(message, 16 + 2 * 64), 0.002f, 1e-8f);
}

TEST(Protocol, WhatIsNotFiniteIsUnknownNeverANumber) {
  ChannelRow r = row(0.0, 0.0f);
  r.values[6] = -std::numeric_limits<float>::infinity();
  const ChannelRow rows[] = {r};
  EXPECT_TRUE(std::isnan(at<float>(encode_channels(rows), 16 + 4 * 7)));
}

Snapshot example() {
  Snapshot s;
  s.time = 2.25;
  s.frame = 2250;
  s.bits = kGrasped | kArmed;
  s.fault = Fault::none;
  s.object.position = {1, 2, 3};
  s.ghost.position = {4, 5, 6};
  s.handle.position = {7, 8, 9};
  s.grasp_point = {10, 11, 12};
  s.on_hand = {{13, 14, 15}, {16, 17, 18}};
  s.contact = {{19, 20, 21}, {22, 23, 24}};
  s.center = {25, 26, 27};
  s.penetration = -std::numeric_limits<double>::infinity();
  s.stretch = 28;
  s.newton_length = 0.5;
  s.found = 300;
  s.front = 77;
  return s;
}

TEST(Protocol, SnapshotLiesAsTheTableSays) {
  Snapshot s = example();
  ViewedContact contact;
  contact.point = {0.5, 0.25, 0.125};
  contact.depth = -2.0;
  contact.body = 1;
  contact.object_node = 42;
  contact.scene_node = 43;
  contact.object_level = 3;
  contact.scene_level = 2;
  contact.status = ContactStatus::deep;
  contact.decided_by = LevelDecision::velocity;
  const ViewedContact contacts[] = {contact, contact};
  const ViewedCluster cluster{{1, 0, 0}, {0, 0, 1}, 0.75, {0, 0, -8}, 9};
  const ViewedCluster clusters[] = {cluster};
  ViewedRow row{{1, 2, 3}, {0, 1, 0}, 0.25, {4, 5, 6}, 0.5, RowKind::edges, true};
  const ViewedRow rows[] = {row, {.kind = RowKind::object_plane}};
  s.contacts = contacts;
  s.clusters = clusters;
  s.rows = rows;
  const std::string m = encode_snapshot(s);
  ASSERT_EQ(m.size(), 240u + 2u * 48u + 48u + 2u * 48u);
  EXPECT_EQ(hex(m.substr(0, 8)), "0301030002000000");
  EXPECT_EQ(at<double>(m, 8), 2.25);
  EXPECT_EQ(at<double>(m, 16), 2250.0);
  const auto field = [&](std::size_t i) { return at<float>(m, 24 + 4 * i); };
  EXPECT_EQ(field(0), 1.0f);
  EXPECT_EQ(field(6), 1.0f);  // w of the object's orientation
  EXPECT_EQ(field(7), 4.0f);
  EXPECT_EQ(field(14), 7.0f);
  EXPECT_EQ(field(21), 10.0f);
  EXPECT_EQ(field(24), 13.0f);
  EXPECT_EQ(field(27), 16.0f);
  EXPECT_EQ(field(30), 19.0f);
  EXPECT_EQ(field(33), 22.0f);
  EXPECT_EQ(field(36), 25.0f);
  EXPECT_TRUE(std::isnan(field(39)));
  EXPECT_EQ(field(40), 28.0f);
  EXPECT_EQ(field(47), 0.5f);
  EXPECT_EQ(at<std::uint32_t>(m, 216), 1u);
  EXPECT_EQ(at<std::uint32_t>(m, 220), 300u);
  EXPECT_EQ(at<std::uint32_t>(m, 228), 77u);
  const std::size_t first = 240;
  EXPECT_EQ(at<float>(m, first), 0.5f);
  EXPECT_EQ(at<float>(m, first + 24), -2.0f);
  EXPECT_EQ(at<std::int32_t>(m, first + 32), 1);
  EXPECT_EQ(at<std::int32_t>(m, first + 36), 42);
  EXPECT_EQ(at<std::int32_t>(m, first + 40), 43);
  EXPECT_EQ(at<std::uint32_t>(m, first + 44), 0x01020203u);
  const std::size_t last = 240 + 96;
  EXPECT_EQ(at<float>(m, last + 24), 0.75f);
  EXPECT_EQ(at<float>(m, last + 36), -8.0f);
  EXPECT_EQ(at<std::int32_t>(m, last + 40), 9);
  EXPECT_EQ(at<std::uint32_t>(m, 236), 2u);
  const std::size_t of_rows = last + 48;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(at<float>(m, of_rows + 4 * i), static_cast<float>(i + 1));
    EXPECT_EQ(at<float>(m, of_rows + 28 + 4 * i), static_cast<float>(i + 4));
  }
  EXPECT_EQ(at<float>(m, of_rows + 16), 1.0f);
  EXPECT_EQ(at<float>(m, of_rows + 24), 0.25f);
  EXPECT_EQ(at<float>(m, of_rows + 40), 0.5f);
  EXPECT_EQ(at<std::uint32_t>(m, of_rows + 44), 2u | 4u);
  EXPECT_EQ(at<std::uint32_t>(m, of_rows + 48 + 44), 1u);
}

TEST(Protocol, SnapshotHoldsNoMoreThanTheProtocolAllows) {
  Snapshot s = example();
  const std::vector<ViewedContact> contacts(500);
  const std::vector<ViewedCluster> clusters(40);
  s.contacts = contacts;
  s.clusters = clusters;
  EXPECT_EQ(encode_snapshot(s).size(), 240u + 128u * 48u + 16u * 48u);
  const std::vector<ViewedRow> rows(256);
  s.rows = rows;
  EXPECT_EQ(encode_snapshot(s).size(), 240u + (128u + 16u + 64u) * 48u);
}

TEST(Protocol, MeshCarriesItsPatchesAndTheTreeAboveThem) {
  const TriangleMesh ball = make_ball(0.02, 4);
  const ClodHierarchy h = build_exact_hierarchy(ball);
  const std::string m = encode_mesh(7, ball, &h);
  EXPECT_EQ(hex(m.substr(0, 8)), "0101000007000000");
  const auto v = at<std::uint32_t>(m, 16), t = at<std::uint32_t>(m, 20);
  const auto p = at<std::uint32_t>(m, 24), n = at<std::uint32_t>(m, 28);
  EXPECT_EQ(v, ball.positions.size());
  EXPECT_EQ(t, ball.triangles.size());
  EXPECT_EQ(p, h.patches.size());
  EXPECT_EQ(n, h.nodes.size());
  ASSERT_EQ(m.size(), 32u + 12u * v + 12u * t + 4u * t + 4u * p + 8u * n);
  const std::size_t patches = 32 + 12 * v + 12 * t, nodes = patches + 4 * t;
  const std::size_t parents = nodes + 4 * p;
  for (std::uint32_t i = 0; i < t; ++i) {
    const auto patch = at<std::uint32_t>(m, patches + 4 * i);
    ASSERT_LT(patch, p);
    // Up from any triangle's patch one comes to the root.
    auto node = at<std::int32_t>(m, nodes + 4 * patch);
    for (int steps = 0; node != 0 && steps < 100; ++steps)
      node = at<std::int32_t>(m, parents + 4 * static_cast<std::size_t>(node));
    ASSERT_EQ(node, 0);
  }
  EXPECT_EQ(at<std::int32_t>(m, parents), -1);
}

TEST(Protocol, LevelCarriesItsPatchesAndTheNodesTheyAreNamedBy) {
  const ClodAsset asset = build_clod_asset(make_ball(0.02, 4));
  ASSERT_GT(asset.meshes.size(), 1u);
  const TriangleMesh& mesh = asset.meshes[1];
  const std::string message = encode_level(3, 1, mesh, asset.hierarchy);
  EXPECT_EQ(at<std::uint8_t>(message, 0), 4);
  EXPECT_EQ(at<std::uint16_t>(message, 2), 1);
  EXPECT_EQ(at<std::uint32_t>(message, 4), 3u);
  const std::size_t v = at<std::uint32_t>(message, 16), t = at<std::uint32_t>(message, 20),
                    p = at<std::uint32_t>(message, 24);
  EXPECT_EQ(v, mesh.positions.size());
  EXPECT_EQ(t, mesh.triangles.size());
  ASSERT_EQ(message.size(), 32 + 12 * v + 16 * t + 4 * p);
  EXPECT_EQ(static_cast<std::int32_t>(p), asset.hierarchy.levels[1].patch_count);
  EXPECT_EQ(at<float>(message, 32 + 12), static_cast<float>(mesh.positions[1].x()));
  const std::vector<std::int32_t> patches = patches_of_triangles(asset, 1);
  std::size_t first = 0;  // of the level among all contact patches
  while (asset.hierarchy.level_patches[first].level != 1) ++first;
  for (std::size_t i = 0; i < t; ++i) {
    const auto patch = at<std::uint32_t>(message, 32 + 12 * (v + t) + 4 * i);
    ASSERT_EQ(patch == 0xffffffffu ? -1 : static_cast<std::int32_t>(first + patch), patches[i]);
    if (patch == 0xffffffffu) continue;
    ASSERT_EQ(at<std::int32_t>(message, 32 + 12 * v + 16 * t + 4 * patch),
              asset.hierarchy.level_patches[first + patch].patch.node);
  }
}

TEST(Protocol, UploadsHaveExactlyTheBytesTheySay) {
  const std::string message("\x21\x01\0\0\3\0\0\0\0\0\0\0\0\0\0\0abc", 19);
  EXPECT_EQ(decode_upload(message), "abc");
  for (std::size_t length = 0; length < message.size(); ++length)
    EXPECT_FALSE(decode_upload(std::string_view(message).substr(0, length))) << length;
  EXPECT_FALSE(decode_upload(message + "d"));
  EXPECT_FALSE(decode_upload("\x20" + message.substr(1)));
  EXPECT_FALSE(decode_upload(message.substr(0, 1) + "\2" + message.substr(2)));
}

TEST(Protocol, DeviceMessagesComeBackAsTheyWent) {
  std::vector<WebSample> samples(3);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i].time = 12.0 + 0.001 * static_cast<double>(i);
    samples[i].pose.position = {0.5, -0.25, 0.125};
    samples[i].buttons = kClutchButton;
  }
  const std::string bytes = encode_device(12.5, samples);
  EXPECT_EQ(hex(bytes.substr(0, 16)), "20010000030000000000000000002940");
  EXPECT_EQ(hex(bytes.substr(16, 40)),
            "0000000000002840"          // 12 s
            "0000003f000080be0000003e"  // position
            "0000000000000000000000000000803f"
            "01000000");
  const DeviceMessage back = decode_device(bytes);
  EXPECT_EQ(back.problem, "");
  ASSERT_EQ(back.samples.size(), 3u);
  EXPECT_EQ(back.samples[2].time, samples[2].time);
  EXPECT_EQ(back.samples[2].pose.position, samples[2].pose.position);
  EXPECT_EQ(back.samples[2].buttons, kClutchButton);
}

TEST(Protocol, DamagedDeviceMessagesAreRefusedWithAReason) {
  std::vector<WebSample> samples(2);
  samples[1].time = 1.0;
  const std::string good = encode_device(0.0, samples);
  ASSERT_EQ(decode_device(good).problem, "");
  const auto broken = [&](auto change) {
    std::string bytes = good;
    change(bytes);
    return decode_device(bytes);
  };
  const auto put_float = [](std::string& b, std::size_t offset, float value) {
    std::memcpy(b.data() + offset, &value, sizeof value);
  };
  for (std::size_t n = 0; n < good.size(); ++n)
    ASSERT_NE(decode_device(std::string_view(good).substr(0, n)).problem, "") << n;
  EXPECT_NE(broken([](std::string& b) { b += '\0'; }).problem, "");
  EXPECT_NE(broken([](std::string& b) { b[0] = 3; }).problem, "");
  EXPECT_NE(broken([](std::string& b) { b[1] = 2; }).problem, "");
  EXPECT_NE(broken([](std::string& b) { b[4] = 0; }).problem, "");
  EXPECT_NE(broken([](std::string& b) { b[7] = '\x7f'; }).problem, "");
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NE(broken([&](std::string& b) { put_float(b, 24, nan); }).problem, "");
  EXPECT_NE(broken([&](std::string& b) { put_float(b, 24, 11.0f); }).problem, "");
  EXPECT_NE(broken([&](std::string& b) { put_float(b, 48, 0.9f); }).problem, "");
  samples[1].time = -1.0;
  EXPECT_NE(decode_device(encode_device(0.0, samples)).problem, "");
  samples[1].time = std::numeric_limits<double>::infinity();
  EXPECT_NE(decode_device(encode_device(0.0, samples)).problem, "");
}

}  // namespace
}  // namespace thigma::live
