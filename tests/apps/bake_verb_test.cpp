// `thigma bake`: what it prints, what it writes, what it refuses.

#include <algorithm>
#include <filesystem>

#include "apps/program.h"
#include "support/wavy_ball.h"
#include <gtest/gtest.h>

#include "thigma/files/checksum.h"
#include "thigma/import/write_mesh.h"
#include "thigma/mesh/shapes.h"
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
  const std::string fine = mesh_file("round.obj", make_ball(0.02, 24)),
                    clod = out_file("round.clod"), out = out_file("level.tex");
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
  const Ended none =
      run_program({"bake", fine, "--onto", clod, "--level", "999", "-o", out, "--quiet"});
  EXPECT_EQ(none.code, 4);
  EXPECT_NE(none.err.find("no level 999"), std::string::npos) << none.err;
}

TEST(BakeVerb, TakesTheScaleThatTheLevelsWereBuiltWith) {
  // As a scan in units of 0.24 mm.
  const std::string fine = mesh_file("units.obj", make_ball(40.0, 16)),
                    clod = out_file("units.clod"), out = out_file("units.tex");
  ASSERT_EQ(run_program({"build", fine, "-o", clod, "--scale", "0.00024", "--quiet"}).code, 0);
  std::string first;
  for (const std::vector<std::string>& extra :
       {std::vector<std::string>{}, {"--scale", "0.00024"}}) {
    std::vector<std::string> arguments = {"bake", fine,       "--onto", clod,     "-o",
                                          out,    "--texels", "64",     "--json", "--quiet"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    const Ended e = run_program(arguments);
    ASSERT_EQ(e.code, 0) << e.err;
    EXPECT_NEAR(json_line(e)["radius"].get<double>(), 40.0 * 0.00024, 0.1 * 40.0 * 0.00024);
    if (first.empty()) first = read_text(out);
    EXPECT_EQ(read_text(out), first);
  }
}

TEST(BakeVerb, RefusesSurfacesOfOtherSizesWithTheScaleThatFits) {
  const std::string fine = mesh_file("mm.obj", make_ball(20.0, 8)),
                    coarse = mesh_file("m.obj", make_ball(0.02, 2)), out = out_file("sizes.tex");
  const Ended e =
      run_program({"bake", fine, "--onto", coarse, "-o", out, "--texels", "64", "--quiet"});
  EXPECT_EQ(e.code, 4);
  EXPECT_NE(e.err.find("about 0.001"), std::string::npos) << e.err;
  EXPECT_EQ(std::count(e.err.begin(), e.err.end(), '\n'), 1) << e.err;
  EXPECT_FALSE(std::filesystem::exists(out));
  const Ended fits =
      run_program({"bake", fine, "--onto", coarse, "--scale", "0.001", "--onto-scale", "1", "-o",
                   out, "--texels", "64", "--quiet", "--json"});
  EXPECT_EQ(fits.code, 0) << fits.err;
}

/// A ball with bumps that coarse levels of it do not have.
TriangleMesh bumps() { return wavy_ball_of(20, 0.02, 0.05); }

// A .clod with its .tex: a session at any level feels the original, and says so twice in the same
// bits.
TEST(BakeVerb, TexturesAllLevelsForASession) {
  const std::string fine = mesh_file("bumps.obj", bumps()), clod = out_file("bumps.clod"),
                    tex = out_file("bumps.tex");
  ASSERT_EQ(run_program({"build", fine, "-o", clod, "--quiet"}).code, 0);
  const Ended baked = run_program(
      {"bake", fine, "--onto", clod, "-o", tex, "--texels", "256", "--json", "--quiet"});
  ASSERT_EQ(baked.code, 0) << baked.err;
  const nlohmann::json j = json_line(baked);
  ASSERT_GE(j["levels"].size(), 3u);
  EXPECT_EQ(j["levels"][0]["level"], 1) << "level 0 is the fine surface itself";
  double worst = 0.0;
  for (const auto& level : j["levels"])
    worst = std::max(worst, level["fit_error_max"].get<double>());
  EXPECT_EQ(j["fit_error_max"], worst);
  EXPECT_EQ(read_text(tex).size(), j["file_bytes"]);

  const std::string text =
      "[object]\nmesh = \"procedural:ball\"\nposition = [0.0, 0.0, 0.08]\n"
      "[contact]\nthreshold = 0.1\ncapped = false\n"
      "[device]\napproach = [0.0, 0.0, -1.0]\n"
      "[[static]]\nmesh = \"bumps.clod\"\nunit_scale = 1.0\ntexture = \"bumps.tex\"\n";
  const std::string scene = write_text("bumps.toml", text);
  const auto play = [&](std::vector<std::string> more) {
    std::vector<std::string> all = {"run",        scene,        "--device", "hand:",  "--headless",
                                    "--lockstep", "--duration", "1.5",      "--json", "--quiet"};
    all.insert(all.end(), more.begin(), more.end());
    const Ended e = run_program(all);
    EXPECT_EQ(e.code, 0) << e.err;
    return json_line(e);
  };
  const nlohmann::json levels = play({}), again = play({}), exact = play({"--exact"}),
                       plain = play({"--texture", "off"});
  EXPECT_EQ(levels["state_hash"], again["state_hash"]);
  EXPECT_NE(levels["state_hash"], plain["state_hash"]);
  EXPECT_EQ(levels["contact"]["levels"]["scene"][0], 0.0) << "no contact of the finest level";
  EXPECT_TRUE(levels["safety_events"].empty());
  const auto rms = [](const nlohmann::json& run) { return run["force"]["rms"].get<double>(); };
  EXPECT_NEAR(rms(levels), rms(exact), 0.01 * rms(exact));

  const std::string wrong = write_text(
      "wrong.toml", std::string(text).replace(text.find("bumps.clod"), 10, "bumps.obj?"));
  const Ended refused = run_program(
      {"run", wrong, "--device", "null:", "--headless", "--lockstep", "--duration", "0.1"});
  EXPECT_EQ(refused.code, 4) << refused.err;
  // Over the levels of another mesh.
  const std::string other = mesh_file("other.obj", make_ball(0.02, 20));
  ASSERT_EQ(run_program({"build", other, "-o", out_file("other.clod"), "--quiet"}).code, 0);
  const std::string mixed = write_text(
      "mixed.toml", std::string(text).replace(text.find("bumps.clod"), 10, "other.clod"));
  const Ended e = run_program(
      {"run", mixed, "--device", "null:", "--headless", "--lockstep", "--duration", "0.1"});
  EXPECT_EQ(e.code, 4) << e.err;
  EXPECT_NE(e.err.find("bumps.tex"), std::string::npos) << e.err;
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
                    away = mesh_file(
                        "away.obj",
                        transformed(make_ball(0.02, 4), Pose{Vec3(1, 0, 0), Quat::Identity()})),
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
  expect(4, {bare, "--onto", ball}, "--onto-scale");
  expect(4, {away, "--onto", ball}, "expected one that it fits");
  expect(4, {out_file("nowhere.obj"), "--onto", ball}, "nowhere.obj");
}

}  // namespace
}  // namespace thigma::test
