// `thigma contacts`: pose files of every kind, and answers that do not depend on how they were
// found.

#include <algorithm>
#include <cmath>

#include "apps/program.h"
#include <gtest/gtest.h>

namespace thigma::test {
namespace {

const std::string kObject = "procedural:ellipsoid?triangles=500";
const std::string kScene = "procedural:torus?triangles=800";

Ended contacts(const std::string& poses, const std::vector<std::string>& more = {},
               const std::string& object = kBall, const std::string& scene = kBall) {
  std::vector<std::string> arguments = {"contacts", object,        scene,   "--poses",
                                        poses,      "--tolerance", "0.001", "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return run_program(arguments);
}

TEST(ContactsVerb, refuses_wrong_pose_files) {
  const std::string row = "0,0,0.1,0,0,0,1\n";
  const struct {
    const char *name, *says;
    std::string text;
  } wrong[] = {
      {"empty", "no header", ""},
      {"no_header", "line 1", row},
      {"other_header", "line 1", "x,y,z,qw,qx,qy,qz\n" + row},
      {"no_pose", "no pose", kHeader},
      {"few", "line 3", kHeader + row + "0,0,0.1,0,0,0\n"},
      {"many", "line 2", kHeader + "0,0,0.1,0,0,0,1,9\n"},
      {"word", "line 2", kHeader + "0,0,far,0,0,0,1\n"},
      {"nan", "line 2", kHeader + "0,0,nan,0,0,0,1\n"},
      {"inf", "line 2", kHeader + "0,0,inf,0,0,0,1\n"},
      {"overflow", "line 2", kHeader + "0,0,1e999,0,0,0,1\n"},
      {"missing", "line 2", kHeader + "0,,0.1,0,0,0,1\n"},
      {"length", "line 4", kHeader + row + row + "0,0,0.1,0,0,0,1.00001\n"},
      {"zero", "line 2", kHeader + "0,0,0.1,0,0,0,0\n"},
      {"binary", "line 1", std::string("\0\x01\xff\xfe\x1b[31m", 9)},
      {"escape", "line 2", kHeader + "0,0,\x1b[31m,0,0,0,1\n"},
  };
  for (const auto& w : wrong) {
    const std::string path = write_text(std::string(w.name) + ".csv", w.text);
    const Ended e = contacts(path);
    EXPECT_EQ(e.code, 4) << w.name;
    expect_one_line(e, path + ": ");
    EXPECT_NE(e.err.find(w.says), std::string::npos) << w.name << ": " << e.err;
    EXPECT_EQ(e.err.find('\x1b'), std::string::npos);
    EXPECT_TRUE(e.out.empty()) << e.out;
  }
}

TEST(ContactsVerb, reads_the_same_poses_however_they_are_written) {
  const auto plain = json_lines(
      contacts(write_text("plain.csv", kHeader + "0,0,0.1002,0,0,0,1\n0,0,0.0999,0,0,0,1\n")));
  ASSERT_EQ(plain.size(), 2u);
  for (const std::string& text :
       {std::string("x,y,z,qx,qy,qz,qw\r\n0,0,0.1002,0,0,0,1\r\n0,0,0.0999,0,0,0,1\r\n\r\n"),
        std::string("x, y, z, qx, qy, qz, qw\n 0, 0, 0.1002, 0, 0, 0, 1\n+0,0,9.99e-2,0,0,0,1"),
        kHeader + "0,0,0.1002,0,0,0,1\n0,0,0.0999,0,0,0,1\n\n",
        "\xEF\xBB\xBF" + kHeader + "0,0,0.1002,0,0,0,1\n0,0,0.0999,0,0,0,1\n"}) {
    const auto other = json_lines(contacts(write_text("other.csv", text)));
    ASSERT_EQ(other.size(), 2u) << text;
    for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(other[i]["contacts"], plain[i]["contacts"]);
  }
}

/// A path that nears, touches, presses and turns; `count` poses.
std::string path_file(int count) {
  std::string text = kHeader;
  char row[200];
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / count, a = 0.4 * t;
    std::snprintf(row, sizeof row, "%.17g,0,%.17g,0,0,%.17g,%.17g\n", 0.04 + 0.002 * t,
                  0.021 - 0.004 * t, std::sin(a), std::cos(a));
    text += row;
  }
  return write_text("path.csv", text);
}

TEST(ContactsVerb, tracked_equals_fresh) {
  const std::string poses = path_file(120);
  const auto tracked = json_lines(contacts(poses, {}, kObject, kScene));
  const auto fresh = json_lines(contacts(poses, {"--fresh"}, kObject, kScene));
  ASSERT_EQ(tracked.size(), 120u);
  ASSERT_EQ(fresh.size(), 120u);
  std::size_t with_contacts = 0, separate = 0;
  for (std::size_t i = 0; i < tracked.size(); ++i) {
    for (const char* field : {"index", "min_distance", "dropped"})
      EXPECT_EQ(tracked[i][field], fresh[i][field]) << i;
    ASSERT_EQ(tracked[i]["contacts"].size(), fresh[i]["contacts"].size()) << i;
    // The order is the traversal's; what is found is not.
    std::vector<std::string> a, b;
    for (const auto& c : tracked[i]["contacts"]) a.push_back(c.dump());
    for (const auto& c : fresh[i]["contacts"]) b.push_back(c.dump());
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    if (tracked[i]["min_distance"].is_null() || tracked[i]["min_distance"] > 0.0) {
      EXPECT_EQ(a, b)
          << "pose " << i;  // in penetration the last direction is kept, and a fresh query has none
    }
    with_contacts += a.empty() ? 0 : 1;
    separate += a.empty() ? 1 : 0;
  }
  EXPECT_GT(with_contacts, 5u);
  EXPECT_GT(separate, 5u);
}

TEST(ContactsVerb, prints_the_fields_of_the_interface) {
  const Ended e =
      contacts(write_text("fields.csv", kHeader + "0,0,0.1,0,0,0,1\n0,0,0.5,0,0,0,1\n"));
  EXPECT_EQ(e.code, 0);
  EXPECT_TRUE(e.err.empty()) << e.err;
  const auto lines = json_lines(e);
  ASSERT_EQ(lines.size(), 2u);
  for (const auto& line : lines) {
    for (const char* name : {"index", "min_distance", "contacts", "dropped", "tests", "cpu_us"})
      EXPECT_TRUE(line.contains(name)) << name;
  }
  ASSERT_FALSE(lines[0]["contacts"].empty());
  double deepest = -1.0;
  for (const auto& c : lines[0]["contacts"]) {
    for (const char* name : {"point", "scene_point", "normal"}) EXPECT_EQ(c[name].size(), 3u);
    EXPECT_EQ(c["levels"].size(), 2u);
    EXPECT_EQ(c["bound"], 0.0);
    EXPECT_GE(c["depth"].get<double>(), -0.001);
    EXPECT_LT(c["normal"][2].get<double>(), -0.9) << "out of the object, which lies above";
    deepest = std::max(deepest, c["depth"].get<double>());
  }
  EXPECT_EQ(lines[0]["min_distance"].get<double>(), -deepest);
  EXPECT_TRUE(lines[1]["min_distance"].is_null());
  EXPECT_TRUE(lines[1]["contacts"].empty());
}

TEST(ContactsVerb, scales_both_meshes) {
  const auto one = json_lines(contacts(write_text("one.csv", kHeader + "0,0,0.1004,0,0,0,1\n")));
  const auto ten = json_lines(run_program({"contacts", kBall, kBall, "--poses",
                                           write_text("ten.csv", kHeader + "0,0,1.004,0,0,0,1\n"),
                                           "--tolerance", "0.01", "--scale", "10", "--json"}));
  ASSERT_EQ(one.size(), 1u);
  ASSERT_EQ(ten.size(), 1u);
  ASSERT_FALSE(one[0]["min_distance"].is_null());
  EXPECT_NEAR(ten[0]["min_distance"].get<double>(), 10.0 * one[0]["min_distance"].get<double>(),
              1e-12);
  EXPECT_EQ(one[0]["contacts"].size(), ten[0]["contacts"].size());
}

TEST(ContactsVerb, writes_a_row_a_contact) {
  const std::string file = out_file("contacts.csv");
  const std::string poses =
      write_text("rows.csv", kHeader + "0,0,0.1002,0,0,0,1\n0,0,0.5,0,0,0,1\n0,0,0.0999,0,0,0,1\n");
  const auto lines = json_lines(contacts(poses, {"-o", file}));
  ASSERT_EQ(lines.size(), 3u);
  std::size_t wanted = 0;
  for (const auto& line : lines) wanted += line["contacts"].size();
  std::istringstream text(read_text(file));
  std::string row;
  std::getline(text, row);
  EXPECT_EQ(row.rfind("pose,point_x [m],", 0), 0u) << row;
  const auto columns = std::count(row.begin(), row.end(), ',');
  std::size_t found = 0;
  for (; std::getline(text, row); ++found)
    EXPECT_EQ(std::count(row.begin(), row.end(), ','), columns) << row;
  EXPECT_GT(found, 0u);
  EXPECT_EQ(found, wanted);
}

}  // namespace
}  // namespace thigma::test
