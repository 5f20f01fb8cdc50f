#include <algorithm>
#include <sstream>

#include "recording/recording_samples.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"

namespace thigma {
namespace {

TEST(ExportCsv, every_row_has_the_columns_of_the_header) {
  const Recording recording = read_recording(test::write_recording("export.mcap", 100));
  const std::string path = ::testing::TempDir() + "thigma_export.csv";
  export_csv(recording, path);
  std::istringstream in(read_file(path));
  std::string line;
  std::getline(in, line);
  EXPECT_NE(line.find("device x [m]"), std::string::npos);
  EXPECT_NE(line.find("command fx [N]"), std::string::npos);
  const auto columns = std::count(line.begin(), line.end(), ',');
  int rows = 0;
  while (std::getline(in, line)) {
    ++rows;
    ASSERT_EQ(std::count(line.begin(), line.end(), ','), columns) << line;
  }
  EXPECT_EQ(rows, 100);
}

TEST(ExportCsv, numbers_read_back_exactly) {
  const Recording recording = read_recording(test::write_recording("export2.mcap", 3));
  const std::string path = ::testing::TempDir() + "thigma_export2.csv";
  export_csv(recording, path);
  const std::string text = read_file(path);
  std::istringstream row(text.substr(text.find('\n') + 1));
  std::string cell;
  std::getline(row, cell, ',');
  EXPECT_EQ(cell, "0");
  std::getline(row, cell, ',');
  std::getline(row, cell, ',');
  EXPECT_EQ(std::stod(cell), recording.frames[0].device.motion.pose.position.x());
}

TEST(ExportCsv, a_place_that_cannot_be_written_is_said) {
  EXPECT_THROW(export_csv({}, "/nonexistent-folder/x.csv"), IoError);
}

}  // namespace
}  // namespace thigma
