#include "scenes/textured_sheet.h"

#include <cmath>
#include <iostream>
#include <map>

#include <gtest/gtest.h>

#include "scenes/ridge_profile.h"
#include "scenes/textured_parts.h"
#include "thigma/math/random.h"
#include "thigma/mesh/inspect.h"
#include "thigma/mesh/measure.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma::scenes {
namespace {

constexpr const char* kParts[] = {"gear", "hammer", "cad_part", "file", "helicoidal_torus"};

/// A place on a triangle of a textured surface.
Vec3 fine_point(const HapticTexture& t, std::size_t triangle, const Vec3& weights) {
  Vec3 p = Vec3::Zero();
  Vec2 at = Vec2::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    p += weights[static_cast<int>(k)] *
         t.coarse.positions[static_cast<std::size_t>(t.coarse.triangles[triangle][k])];
    at += weights[static_cast<int>(k)] * t.corners[triangle][k];
  }
  return p + displacement_at(t, at);
}

TEST(TexturedSheet, parts_have_about_the_counts_of_the_text) {
  const std::map<std::string, std::pair<int, int>> wanted = {{"gear", {25600, 1600}},
                                                             {"hammer", {433152, 518}},
                                                             {"cad_part", {658432, 720}},
                                                             {"file", {285824, 632}},
                                                             {"helicoidal_torus", {128000, 532}}};
  for (const char* name : kParts) {
    int fine = 0, coarse = 0;
    for (const TexturedSheet& sheet : textured_part(name)) {
      fine += fine_triangles(sheet);
      coarse += coarse_triangles(sheet);
    }
    EXPECT_EQ(fine, wanted.at(name).first) << name;
    EXPECT_NEAR(coarse, wanted.at(name).second, 0.03 * wanted.at(name).second) << name;
  }
  EXPECT_TRUE(textured_part("teapot").empty());
}

TEST(TexturedSheet, fine_surfaces_are_usable_meshes) {
  for (const char* name : kParts) {
    std::vector<TexturedSheet> sheets = textured_part(name);
    int count = 0;
    for (TexturedSheet& sheet : sheets) {
      sheet.fine_around = 48;
      sheet.fine_along = 40;
      count += fine_triangles(sheet);
    }
    const TriangleMesh fine = make_fine_sheets(sheets);
    EXPECT_EQ(static_cast<int>(fine.triangles.size()), count);
    EXPECT_EQ(inspect_mesh(fine).verdict, MeshVerdict::usable) << name;
  }
}

// Two triangles that share an edge have the same fine points along it, at the poles and where sheets close too.
TEST(TexturedSheet, fine_surfaces_have_no_cracks) {
  for (const char* name : kParts) {
    const std::vector<TexturedSheet> sheets = textured_part(name);
    const HapticTexture t = make_texture(make_textured_sheets(sheets, 800), name);
    std::map<std::pair<int, int>, std::pair<std::size_t, int>> edges;
    double crack = 0.0;
    int shared = 0;
    for (std::size_t i = 0; i < t.coarse.triangles.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const int a = t.coarse.triangles[i][static_cast<std::size_t>(k)],
                  b = t.coarse.triangles[i][static_cast<std::size_t>((k + 1) % 3)];
        edges[{a, b}] = {i, k};
        const auto other = edges.find({b, a});
        if (other == edges.end()) continue;
        ++shared;
        for (const double way : {0.1, 0.37, 0.5, 0.9}) {
          Vec3 here = Vec3::Zero(), there = Vec3::Zero();
          here[k] = 1.0 - way;
          here[(k + 1) % 3] = way;
          there[other->second.second] = way;
          there[(other->second.second + 1) % 3] = 1.0 - way;
          crack = std::max(crack, (fine_point(t, i, here) -
                                   fine_point(t, other->second.first, there)).norm());
        }
      }
    }
    EXPECT_EQ(2 * shared, 3 * static_cast<int>(t.coarse.triangles.size())) << name;
    EXPECT_LT(crack, 0.05 * t.amplitude) << name;
    std::cout << name << ": cracks " << crack / t.amplitude << " of the amplitude, "
              << t.width << " x " << t.height << " texels\n";
  }
}

// Table 4.1: "the block and gear models are fully convex at coarse resolution", with the teeth in the texture.
TEST(TexturedSheet, coarse_gear_is_convex_and_its_teeth_are_relief) {
  const HapticTexture gear = make_texture(make_textured_sheets(textured_part("gear"), 1024), "gear");
  const double radius = enclosing_ball(gear.coarse.positions).radius;
  for (const auto& t : gear.coarse.triangles) {
    const auto corner = [&](std::size_t k) -> const Vec3& { return gear.coarse.positions[static_cast<std::size_t>(t[k])]; };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    for (const Vec3& p : gear.coarse.positions) ASSERT_LE(normal.dot(p - corner(0)), 1e-9 * radius);
  }
  EXPECT_NEAR(gear.amplitude, 0.5 * kRidgeHeight, 0.05 * 0.5 * kRidgeHeight);
}

// On a ring without poles every texel is the fine surface itself.
TEST(TexturedSheet, texels_of_a_ring_are_its_fine_surface) {
  const std::vector<TexturedSheet> sheets = textured_part("helicoidal_torus");
  const HapticTexture t = make_texture(make_textured_sheets(sheets, 200), "torus");
  const int per_cell = 200 / 19;
  Random random(1);
  for (int n = 0; n < 200; ++n) {
    const int x = static_cast<int>(random.uniform(0.0, 19.0 * per_cell)),
              y = static_cast<int>(random.uniform(0.0, 14.0 * per_cell));
    const Vec3 want = sheets[0].fine(x / (19.0 * per_cell), y / (14.0 * per_cell));
    // The triangle the texel is of.
    const Vec2 at(x + 2, y + 2);
    double best = 1.0;
    for (std::size_t i = 0; i < t.corners.size(); ++i) {
      const auto& c = t.corners[i];
      Eigen::Matrix2d edges;
      edges << c[1] - c[0], c[2] - c[0];
      const Vec2 w = edges.inverse() * (at - c[0]);
      if (w.minCoeff() < -1e-9 || w.sum() > 1.0 + 1e-9) continue;
      best = std::min(best, (fine_point(t, i, {1.0 - w.sum(), w.x(), w.y()}) - want).norm());
    }
    EXPECT_LT(best, 1e-8);
  }
}

}  // namespace
}  // namespace thigma::scenes
