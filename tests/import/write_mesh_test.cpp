#include "thigma/import/write_mesh.h"

#include <filesystem>

#include "support/mesh_samples.h"
#include <gtest/gtest.h>
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/import/detail/mesh_formats.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

// Positions with all of their bits, so that a lost digit shows.
TriangleMesh rough_ball(double scale) {
  TriangleMesh mesh = make_ball(1.0, 4);
  Random random(5);
  for (Vec3& p : mesh.positions) p = scale * (p + 0.01 * random.in_cube(1.0));
  return mesh;
}

bool is_lossless(MeshFormat f) { return f != MeshFormat::stl_binary; }

TEST(WriteMesh, what_is_written_reads_back_to_the_same_bits) {
  for (const double scale : {1e-9, 1.0, 1e9}) {
    const TriangleMesh mesh = rough_ball(scale);
    for (const detail::MeshFormatRow& row : detail::kMeshFormats) {
      if (row.write == nullptr) continue;
      const MeshFormat format = row.format;
      const MeshFile file = parse_mesh(format_mesh(mesh, format, "x"), "x");
      EXPECT_EQ(file.format, format);
      ASSERT_EQ(file.mesh.positions.size(), mesh.positions.size()) << format_name(format);
      ASSERT_EQ(file.mesh.triangles.size(), mesh.triangles.size());
      EXPECT_TRUE(!row.is_exact || file.mesh.triangles == mesh.triangles);
      for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        for (std::size_t k = 0; k < 3; ++k) {
          Vec3 want = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][k])];
          for (int i = 0; i < 3 && !is_lossless(format); ++i) {
            // Through memory: g++ 12 drops the rounding of a vectorised double to float and back.
            const volatile float single = static_cast<float>(want[i]);
            want[i] = single;
          }
          ASSERT_EQ(file.mesh.positions[static_cast<std::size_t>(file.mesh.triangles[t][k])], want)
              << format_name(format);
        }
      }
    }
  }
}

TEST(WriteMesh, the_ending_chooses_the_format) {
  EXPECT_EQ(format_for_name("a.PLY"), MeshFormat::ply_little);
  EXPECT_EQ(format_for_name("a.b/c.stl"), MeshFormat::stl_binary);
  EXPECT_EQ(format_for_name("x.off"), MeshFormat::off);
  EXPECT_EQ(format_for_name("x.ply/y"), MeshFormat::obj);
  EXPECT_EQ(format_for_name("x"), MeshFormat::obj);
}

TEST(WriteMesh, every_kind_that_is_written_has_one_format_for_its_ending) {
  const std::string help = written_mesh_endings();
  EXPECT_TRUE(help.ends_with(", else OBJ")) << help;
  for (const MeshKind& kind : mesh_kinds()) {
    int written = 0, chosen = 0;
    for (const detail::MeshFormatRow& row : detail::kMeshFormats) {
      if (std::string_view(row.kind) != kind.name) continue;
      EXPECT_STREQ(row.ending, kind.ending);
      written += row.write != nullptr;
      if (!row.is_chosen_by_ending) continue;
      ++chosen;
      EXPECT_NE(row.write, nullptr) << row.name;
      EXPECT_EQ(format_for_name(std::string("x") + row.ending), row.format);
      EXPECT_TRUE(row.format == MeshFormat::obj || help.find(row.ending) != help.npos) << help;
    }
    EXPECT_EQ(chosen, written > 0 ? 1 : 0) << kind.name;
  }
}

TEST(WriteMesh, a_file_is_written_whole_or_not_at_all) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("thigma_write" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const TriangleMesh mesh = rough_ball(1.0);
  for (const char* name : {"a.obj", "a.ply", "a.off"}) {
    write_mesh(mesh, folder / name);
    EXPECT_EQ(read_mesh(folder / name).mesh.positions, mesh.positions);
  }
  EXPECT_THROW(write_mesh(test::moved(mesh, {1e39, 0.0, 0.0}), folder / "b.stl"), InputError);
  EXPECT_FALSE(std::filesystem::exists(folder / "b.stl"));
  EXPECT_THROW(write_mesh(mesh, folder / "none" / "c.obj"), IoError);
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace thigma
