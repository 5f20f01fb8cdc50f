#include <map>
#include <optional>
#include <sstream>

#include "recording/written_worlds.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/recording/world_frames.h"

namespace thigma {
namespace {

using namespace test;

/// The cells of a row as RFC 4180 has them.
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] == '"' && is_quoted && i + 1 < row.size() && row[i + 1] == '"') {
      cells.back() += row[++i];
    } else if (row[i] == '"') {
      is_quoted = !is_quoted;
    } else if (row[i] == ',' && !is_quoted) {
      cells.emplace_back();
    } else {
      cells.back() += row[i];
    }
  }
  return cells;
}

/// A table by the names of its columns.
std::map<std::string, std::vector<std::string>> table_of(const std::string& path) {
  std::istringstream in(read_file(path));
  std::string line;
  std::getline(in, line);
  const std::vector<std::string> names = cells_of(line);
  std::map<std::string, std::vector<std::string>> table;
  for (const std::string& name : names) table[name];
  EXPECT_EQ(table.size(), names.size()) << "two columns have one name: " << line;
  while (std::getline(in, line)) {
    const std::vector<std::string> cells = cells_of(line);
    EXPECT_EQ(cells.size(), names.size()) << line;
    for (std::size_t i = 0; i < cells.size() && i < names.size(); ++i)
      table[names[i]].push_back(cells[i]);
  }
  return table;
}

std::string export_world(const std::string& path, const char* name) {
  const std::string out = path_of(name);
  std::optional<WorldCsvExport> csv;
  stream_world_recording(path, {[&](const WorldRecordingInfo& info) { csv.emplace(out, info); },
                                [&](const RecordedWorldFrame& frame) { csv->add(frame); },
                                {}});
  csv->keep();
  return out;
}

TEST(ExportWorldCsv, frames_have_a_column_for_each_number_of_a_body_joint_and_hand) {
  const std::string path = path_of("table.mcap");
  write_world(path, false);
  auto table = table_of(export_world(path, "table.csv"));
  EXPECT_EQ(table.size(), 2u + 2 * 14 + 4 + 2 * 15);
  for (const auto& [name, cells] : table) EXPECT_EQ(cells.size(), kFrames) << name;
  EXPECT_EQ(table["time [s]"][29], "0.03");
  EXPECT_EQ(std::stod(table["body ring z [m]"][3]), 0.25);
  EXPECT_EQ(std::stod(table["body block, \"red\" z [m]"][3]), 1.0 / 3.0);
  EXPECT_EQ(table["body ring qw"][3], "1");
  EXPECT_EQ(table["body ring Py [kg m/s]"][3], "1e+300");
  EXPECT_EQ(table["body ring asleep"][9], "0");
  EXPECT_EQ(table["body ring asleep"][10], "1");
  EXPECT_EQ(table["joint hinge coordinate [m or rad]"][3], "0.75");
  EXPECT_EQ(table["device command fy [N]"][3], "2");
  EXPECT_EQ(table["device z [m]"][3], "3");
  EXPECT_EQ(table["device energy [J]"][3], "0.003");
  EXPECT_EQ(table["device 2 command fz [N]"][3], "0");
  EXPECT_EQ(table["device 2 buttons"][3], "100000");
  EXPECT_EQ(table["device 2 energy [J]"][3], "") << "it was not recorded";
}

TEST(ExportWorldCsv, what_an_older_recording_does_not_have_is_empty) {
  const std::string path = path_of("older.mcap");
  {
    WorldRecordingWriter writer(path, info_of(false));
    const std::vector<BodyState> bodies(2);
    const RecordedJoint joint;
    writer.write(0, 1e-3, bodies, {&joint, 1}, std::vector<Wrench>(2));
    writer.close(1, 1);
  }
  auto table = table_of(export_world(path, "older.csv"));
  EXPECT_EQ(table["body ring asleep"].at(0), "");
  EXPECT_EQ(table["device qw"].at(0), "");
  EXPECT_EQ(table["device energy [J]"].at(0), "");
  EXPECT_EQ(table["device command fx [N]"].at(0), "0");
}

TEST(ExportWorldCsv, haptic_steps_have_a_table_of_their_own) {
  const std::string path = path_of("steps.mcap"), out = path_of("steps.csv");
  write_world(path, true);
  HapticCsvExport csv(out);
  stream_world_recording(path, {{}, {}, [&](const HandTick& tick) { csv.add(tick); }});
  csv.keep();
  auto table = table_of(out);
  ASSERT_EQ(table["step"].size(), 2 * kSteps * kFrames);
  EXPECT_EQ(table["device number"][1], "2");
  EXPECT_EQ(table["step"][6], "3");
  EXPECT_EQ(std::stod(table["time [s]"][6]), 1.5e-3);
  EXPECT_EQ(table["device command fz [N]"][3], "3");
  EXPECT_EQ(table["device energy [J]"][3], "-1");
  EXPECT_EQ(table["external fault"][0], "watchdog");
}

}  // namespace
}  // namespace thigma
