#include "thigma/import/load_mesh.h"

#include <filesystem>
#include <limits>

#include <gtest/gtest.h>
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/files/file.h"
#include "thigma/import/write_mesh.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

class LoadMesh : public ::testing::Test {
 protected:
  void SetUp() override { std::filesystem::create_directories(folder_); }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string write(const TriangleMesh& mesh) {
    write_mesh(mesh, folder_ / "m.obj");
    return folder_ / "m.obj";
  }
  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("thigma_load" + std::to_string(::getpid()));
};

TEST_F(LoadMesh, scales_to_metres) {
  MeshReport report;
  const TriangleMesh mesh = load_usable_mesh(write(make_ball(20.0, 6)), 0.001, false, &report);
  EXPECT_NEAR(report.radius, 0.02, 1e-12);
  EXPECT_NEAR(mesh.positions[3].norm(), 0.02, 1e-12);
  EXPECT_TRUE(report.self_intersections_counted);
}

TEST_F(LoadMesh, refuses_a_repairable_mesh_and_says_how_to_take_it) {
  const std::string path = write(flipped(make_ball(1.0, 4)));
  try {
    load_usable_mesh(path);
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--repair"), std::string::npos) << error.what();
    EXPECT_EQ(std::string(error.what()).rfind(path + ": ", 0), 0u);
  }
  MeshReport report;
  std::vector<std::string> repairs;
  load_usable_mesh(path, 1.0, true, &report, &repairs);
  EXPECT_EQ(report.verdict, MeshVerdict::usable);
  EXPECT_EQ(report.file, path);
  EXPECT_EQ(repairs.size(), 1u);
}

TEST_F(LoadMesh, refuses_what_repair_cannot_help) {
  EXPECT_THROW(load_usable_mesh(write(make_moebius(1.0, 0.3, 20)), 1.0, true), InputError);
  write_file(folder_ / "empty", "");
  EXPECT_THROW(load_usable_mesh(folder_ / "empty"), InputError);
}

TEST_F(LoadMesh, refuses_scales_that_make_no_sense) {
  const std::string path = write(make_ball(1.0, 2));
  for (const double scale : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), 1e60, 1e-60}) {
    EXPECT_THROW(load_usable_mesh(path, scale), InputError) << scale;
  }
}

}  // namespace
}  // namespace thigma
