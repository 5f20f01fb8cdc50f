#include "thigma/models/textured_sheet.h"

#include <cmath>
#include <iostream>
#include <map>

#include <gtest/gtest.h>

#include "thigma/convex/count_patches.h"
#include "thigma/import/inspect.h"
#include "thigma/math/random.h"
#include "thigma/mesh/measure.h"
#include "thigma/models/ridge_profile.h"
#include "thigma/models/textured_parts.h"
#include "thigma/texture/detail/surface_search.h"
#include "thigma/texture/texel_lookup.h"

namespace thigma::models {
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

// Two triangles that share an edge have the same fine points along it, at the poles and where
// sheets close too.
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
          crack = std::max(
              crack, (fine_point(t, i, here) - fine_point(t, other->second.first, there)).norm());
        }
      }
    }
    EXPECT_EQ(2 * shared, 3 * static_cast<int>(t.coarse.triangles.size())) << name;
    EXPECT_LT(crack, 0.05 * t.amplitude) << name;
    std::cout << name << ": cracks " << crack / t.amplitude << " of the amplitude, " << t.width
              << " x " << t.height << " texels\n";
  }
}

// Table 4.1: 210, 390, 113 and 114 volumes over the coarse models of hammer, CAD part, file and
// torus. On smooth corners the file was convex.
TEST(TexturedSheet, coarse_models_are_about_as_far_from_convex_as_the_texts) {
  const std::map<std::string, int> volumes = {
      {"hammer", 210}, {"cad_part", 390}, {"file", 113}, {"helicoidal_torus", 114}};
  for (const auto& [name, wanted] : volumes) {
    const TriangleMesh coarse =
        make_texture(make_textured_sheets(textured_part(name), 200), name).coarse;
    const int nodes = 2 * count_convex_patches(coarse) - 1;
    EXPECT_GE(2 * nodes, wanted) << name;
    EXPECT_LE(nodes, 2 * wanted) << name;
  }
  EXPECT_EQ(count_convex_patches(
                make_texture(make_textured_sheets(textured_part("gear"), 200), "gear").coarse),
            1);
}

// The control of experiments: the same surface without its relief.
TEST(TexturedSheet, smooth_surfaces_lie_within_the_relief_of_the_fine_ones) {
  for (const char* name : kParts) {
    for (const TexturedSheet& sheet : textured_part(name)) {
      double off = 0.0;
      Random random(3);
      for (int i = 0; i < 2000; ++i) {
        const double u = random.uniform(), v = random.uniform();
        off = std::max(off, (sheet.fine(u, v) - sheet.smooth(u, v)).norm());
      }
      EXPECT_GT(off, 1e-4) << name;
      EXPECT_LE(off, 1.001e-3) << name;
    }
  }
}

// Table 4.1: "the block and gear models are fully convex at coarse resolution", with the teeth in
// the texture.
TEST(TexturedSheet, coarse_gear_is_convex_and_its_teeth_are_relief) {
  const HapticTexture gear =
      make_texture(make_textured_sheets(textured_part("gear"), 1024), "gear");
  const double radius = enclosing_ball(gear.coarse.positions).radius;
  for (const auto& t : gear.coarse.triangles) {
    const auto corner = [&](std::size_t k) -> const Vec3& {
      return gear.coarse.positions[static_cast<std::size_t>(t[k])];
    };
    const Vec3 normal = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    for (const Vec3& p : gear.coarse.positions) ASSERT_LE(normal.dot(p - corner(0)), 1e-9 * radius);
  }
  EXPECT_NEAR(gear.amplitude, 0.5 * kRidgeHeight, 0.05 * 0.5 * kRidgeHeight);
}

/// Places over a textured surface, texel by texel where texels lie on a triangle: what is added
/// there, and the distance of the fine point from the fine triangles.
struct TexelPlace {
  Vec3 displacement, normal;  // normal of the coarse triangle, unit
  double off = 0.0;           // [m]
};

std::vector<TexelPlace> places_of(const std::vector<TexturedSheet>& sheets, int texels, int count) {
  const HapticTexture t = make_texture(make_textured_sheets(sheets, texels), "sheet");
  const TriangleMesh fine = make_fine_sheets(sheets);
  const detail::SurfaceSearch search = detail::build_surface_search(fine);
  Random random(1);
  std::vector<TexelPlace> places;
  while (static_cast<int>(places.size()) < count) {
    const std::size_t i = random.below(t.corners.size());
    const std::array<Vec2, 3>& c = t.corners[i];
    const Vec2 in(random.uniform(), random.uniform());
    const Vec2 at =
        (c[0] + in.x() * (c[1] - c[0]) + in.y() * (c[2] - c[0])).array().round().matrix();
    Eigen::Matrix2d edges;
    edges << c[1] - c[0], c[2] - c[0];
    const Vec2 w = edges.inverse() * (at - c[0]);
    if (w.minCoeff() < 0.0 || w.sum() > 1.0) continue;
    const auto p = [&](std::size_t k) {
      return t.coarse.positions[static_cast<std::size_t>(t.coarse.triangles[i][k])];
    };
    const Vec3 there = fine_point(t, i, {1.0 - w.sum(), w.x(), w.y()});
    places.push_back({displacement_at(t, at), (p(1) - p(0)).cross(p(2) - p(0)).normalized(),
                      detail::nearest_point(search, there).distance});
  }
  return places;
}

double largest_sideways(const std::vector<TexelPlace>& places) {
  double most = 0.0;
  for (const TexelPlace& p : places)
    most = std::max(most, (p.displacement - p.normal.dot(p.displacement) * p.normal).norm());
  return most;
}

// The fine surface is the one of triangles that depths are judged against, not what its triangles
// stand for.
TEST(TexturedSheet, texels_lie_on_the_fine_triangles) {
  for (const char* name : kParts) {
    double worst = 0.0;
    for (const TexelPlace& p : places_of(textured_part(name), 300, 300))
      worst = std::max(worst, p.off);
    EXPECT_LT(worst, 1e-7) << name;  // floats of a displacement
  }
}

// Looked for along normals, the fine points of a ring lie sideways by what normals lean on the
// triangles, not by what (u, v) is stretched over coarse cells.
TEST(TexturedSheet, fine_points_lie_along_the_normals) {
  std::vector<TexturedSheet> ring = textured_part("helicoidal_torus");
  const double along = largest_sideways(places_of(ring, 200, 400));
  ring[0].is_paired = true;
  const std::vector<TexelPlace> paired = places_of(ring, 200, 400);
  EXPECT_LT(along, 0.35 * largest_sideways(paired));
  for (const TexelPlace& p : paired) ASSERT_LT(p.off, 1e-7);
}

// Cells of a part differ in size by ten times; their texels do not.
TEST(TexturedSheet, texels_have_one_size) {
  for (const char* name : kParts) {
    const HapticTexture t = make_texture(make_textured_sheets(textured_part(name), 500), name);
    double largest = 0.0;  // of a texel's sides along the edges of charts
    for (std::size_t i = 0; i < t.corners.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t n = (k + 1) % 3;
        const Vec2 way = t.corners[i][n] - t.corners[i][k];
        const Vec3 edge = t.coarse.positions[static_cast<std::size_t>(t.coarse.triangles[i][n])] -
                          t.coarse.positions[static_cast<std::size_t>(t.coarse.triangles[i][k])];
        if (way.x() == 0.0 || way.y() == 0.0) largest = std::max(largest, edge.norm() / way.norm());
      }
    }
    EXPECT_LE(static_cast<double>(t.width) * t.height, 500.0 * 500.0) << name;
    EXPECT_GE(static_cast<double>(t.width) * t.height, 0.85 * 500.0 * 500.0) << name;
    EXPECT_LE(largest, 2.0 * t.texel_size) << name;
  }
}

}  // namespace
}  // namespace thigma::models
