#include "thigma/import/read_texture_coordinates.h"

#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/import/read_mesh.h"

namespace thigma {
namespace {

constexpr const char* kSquare =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 1 0 -0.0\n"
    "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 0.5\n"
    "f 1/1 2/2 3/3 4/4\n";

TEST(TextureCoordinates, GoWithTheTrianglesOfTheMesh) {
  const auto found = read_texture_coordinates(kSquare, "a.obj");
  ASSERT_EQ(found.size(), parse_mesh(kSquare, "a.obj").mesh.triangles.size());
  EXPECT_EQ(found[0], (std::array<Vec2, 3>{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}));
  EXPECT_EQ(found[1], (std::array<Vec2, 3>{Vec2(0, 0), Vec2(1, 1), Vec2(0, 1)}));
}

TEST(TextureCoordinates, GoWithAMeshBehindAByteOrderMark) {
  // The mark stands before the first vertex: without it all indices would be one off.
  const std::string text = std::string("\xEF\xBB\xBF") + kSquare;
  EXPECT_EQ(read_texture_coordinates(text, "a.obj"), read_texture_coordinates(kSquare, "a.obj"));
}

TEST(TextureCoordinates, LeaveOutWhatTheMeshLeavesOut) {
  // Vertices 2 and 5 are one position: the second face is no triangle.
  const std::string text = std::string(kSquare) + "f 2/1 5/2 3/3\nf -5/-5/1 \\\n -4/-4 -2/-2\n";
  const auto found = read_texture_coordinates(text, "a.obj");
  ASSERT_EQ(found.size(), parse_mesh(text, "a.obj").mesh.triangles.size());
  EXPECT_EQ(found.back(), (std::array<Vec2, 3>{Vec2(0, 0), Vec2(1, 0), Vec2(0, 1)}));
}

TEST(TextureCoordinates, SayWhatIsMissing) {
  const auto complaint = [](const std::string& text) -> std::string {
    try {
      read_texture_coordinates(text, "a.obj");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\n";
  EXPECT_EQ(complaint(corners + "f 1 2 3\n"),
            "a.obj: a corner without texture coordinates, line 5, expected i/t or i/t/n for every "
            "corner");
  EXPECT_NE(complaint(corners + "f 1//1 2//1 3//1\n"), "");
  EXPECT_NE(complaint(corners + "f 1/1 2/1 3/9\n"), "");
  EXPECT_NE(complaint(corners + "f 1/1 2/1 3/-9\n"), "");
  EXPECT_NE(complaint("vt nan 0\n" + corners + "f 1/1 2/1 3/1\n"), "");
  EXPECT_NE(complaint("solid a\n"), "");
}

}  // namespace
}  // namespace thigma
