// `thigma bake`: what it prints, what it writes, what it refuses.

#include "apps/program.h"
#include <gtest/gtest.h>

#include "thigma/core/checksum.h"
#include "thigma/mesh/shapes.h"
#include "thigma/mesh/write_mesh.h"
#include "thigma/texture/texture_file.h"

namespace thigma::test {
namespace {

std::string mesh_file(const char* name, const TriangleMesh& mesh) {
  return write_text(name, format_mesh(mesh, MeshFormat::obj, name));
}

constexpr const char* kSquare =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

TEST(BakeVerb, PrintsTheFieldsOfTheInterfaceAndWritesWhatItSays) {
  const std::string fine = mesh_file("fine.obj", make_ball(0.02, 12)),
                    coarse = mesh_file("coarse.obj", make_ball(0.02, 2)),
                    out = out_file("ball.tex");
  const Ended e = run_program(
      {"bake", fine, "--onto", coarse, "-o", out, "--texels", "64", "--json", "--quiet"});
  ASSERT_EQ(e.code, 0) << e.err;
  EXPECT_TRUE(e.err.empty()) << e.err;
  const nlohmann::json j = json_line(e);
  for (const char* name :
       {"file", "texels", "charts", "fit_error_rms", "fit_error_max", "distortion_max"})
    EXPECT_TRUE(j.contains(name)) << name;
  EXPECT_EQ(j["texels"], 64);
  const std::string bytes = read_text(out);
  EXPECT_EQ(j["sha256"], hex_text(sha256(bytes)));
  const TextureAsset asset = parse_texture(bytes, "out");
  EXPECT_EQ(asset.texture.width, 64);
  EXPECT_EQ(j["fit_error_max"], *asset.figures.fit_error_max);
  EXPECT_LT(j["fit_error_rms"].get<double>(), 1e-4);
}

TEST(BakeVerb, BakesOntoLevelsOfDetail) {
  const std::string fine = mesh_file("round.obj", make_ball(0.02, 24)), clod = out_file("round.clod"),
                    out = out_file("level.tex");
  const Ended built = run_program({"build", fine, "-o", clod, "--json", "--quiet"});
  ASSERT_EQ(built.code, 0) << built.err;
  int meshes = 0, last = 0;
  const nlohmann::json report = json_line(built);
  for (const auto& level : report["levels"]) meshes += !level["free"].get<bool>();
  ASSERT_GT(meshes, 2);
  for (const int level : {1, meshes - 1}) {
    const Ended e = run_program({"bake", fine, "--onto", clod, "--level", std::to_string(level),
                                 "-o", out, "--texels", "128", "--json", "--quiet"});
    ASSERT_EQ(e.code, 0) << e.err;
    const TextureAsset asset = parse_texture(read_text(out), "out");
    const int triangles = static_cast<int>(asset.texture.coarse.triangles.size());
    EXPECT_TRUE(last == 0 || triangles < last);
    last = triangles;
    EXPECT_LT(*asset.figures.fit_error_rms, 0.005 * 0.02) << level;
    EXPECT_LT(*asset.figures.fit_error_max, 0.02 * 0.02) << level;
  }
  const Ended none = run_program({"bake", fine, "--onto", clod, "--level", "999", "-o", out, "--quiet"});
  EXPECT_EQ(none.code, 4);
  EXPECT_NE(none.err.find("no level 999"), std::string::npos) << none.err;
}

TEST(BakeVerb, TakesHeightMapsOverTextureCoordinates) {
  const std::string plate = write_text("plate.obj", kSquare),
                    map = write_text("map.pgm", "P2 2 2 4\n0 4 4 0\n"), out = out_file("plate.tex");
  const std::vector<std::string> arguments = {
      "bake", plate, "--height", map, "-o", out, "--amplitude", "0.01", "--json", "--quiet"};
  const Ended e = run_program(arguments);
  ASSERT_EQ(e.code, 0) << e.err;
  EXPECT_TRUE(json_line(e)["fit_error_rms"].is_null());
  EXPECT_NEAR(json_line(e)["amplitude"].get<double>(), 0.01, 1e-8);
  EXPECT_EQ(parse_texture(read_text(out), "out").texture.coarse.triangles.size(), 2u);
}

TEST(BakeVerb, RefusesWithOneLineAndTheRightCode) {
  const std::string plate = write_text("plate2.obj", kSquare),
                    bare = mesh_file("bare.obj", make_box({1, 1, 1})),
                    ball = mesh_file("ball2.obj", make_ball(0.02, 2)),
                    map = write_text("map2.pgm", "P2 2 2 4\n0 4 4 0\n"),
                    cut = write_text("cut.pgm", "P2 2 2 4\n0 4 4\n"), out = out_file("none.tex");
  const auto expect = [&](int code, std::vector<std::string> arguments, const std::string& says) {
    arguments.insert(arguments.begin(), "bake");
    arguments.insert(arguments.end(), {"-o", out, "--quiet"});
    const Ended e = run_program(arguments);
    EXPECT_EQ(e.code, code) << says;
    expect_one_line(e);
    EXPECT_NE(e.err.find(says), std::string::npos) << e.err;
    EXPECT_FALSE(std::filesystem::exists(out)) << says;
  };
  expect(2, {ball}, "--onto or --height");
  expect(2, {plate, "--height", map}, "--amplitude");
  expect(2, {plate, "--height", map, "--amplitude", "0"}, "--amplitude");
  expect(2, {ball, "--onto", ball, "--texels", "4"}, "texels");
  expect(4, {bare, "--height", map, "--amplitude", "0.1"}, "texture coordinates");
  expect(4, {plate, "--height", map, "--amplitude", "1e9"}, "texel 0");
  expect(4, {plate, "--height", cut, "--amplitude", "0.1"}, "cut.pgm");
  expect(4, {plate, "--height", plate, "--amplitude", "0.1"}, "no height map");
  expect(4, {bare, "--onto", ball}, "expected one that it fits");
  expect(4, {out_file("nowhere.obj"), "--onto", ball}, "nowhere.obj");
}

}  // namespace
}  // namespace thigma::test
