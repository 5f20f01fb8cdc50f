#include "thigma/models/make_model.h"

#include <cstring>

#include "support/closed_surface.h"
#include <gtest/gtest.h>

#include "thigma/core/error.h"
#include "thigma/mesh/self_intersections.h"

namespace thigma::models {
namespace {

struct Expected {
  const char* name;
  long long euler;
};

constexpr Expected kModels[] = {{"jaw_lower", 2},
                                {"jaw_upper", 2},
                                {"cup", 0},
                                {"spoon", 2},
                                {"ellipsoid", 2},
                                {"ball", 2},
                                {"box", 2},
                                {"plate", 2},
                                {"cylinder", 2},
                                {"cone", 2},
                                {"torus", 0},
                                {"ring", 0},
                                {"gear", 0},
                                {"probe", 2},
                                {"peg", 2},
                                {"hole", 0},
                                {"flange_spigot", 2},
                                {"flange_socket", 2},
                                {"joint_ball", 2},
                                {"joint_socket", 2},
                                {"golf_club", 2},
                                {"golf_ball", 2},
                                {"conforming_lower", 2},
                                {"conforming_upper", 2}};

void expect_closed(const TriangleMesh& mesh, long long euler) {
  const test::SurfaceCount count = test::count_surface(mesh);
  EXPECT_EQ(count.boundary, 0);
  EXPECT_EQ(count.repeated, 0);
  EXPECT_EQ(count.unused, 0);
  EXPECT_EQ(count.euler, euler);
  EXPECT_GT(count.volume, 0.0);
  double least = 1.0;  // twice the area of a triangle over its longest edge squared
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double longest =
        std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    least = std::min(least, (b - a).cross(c - a).norm() / longest);
  }
  EXPECT_GT(least, 1e-3) << "a triangle of no area";
}

double off_count(const TriangleMesh& mesh, int wished) {
  return std::abs(static_cast<double>(mesh.triangles.size()) - wished) / wished;
}

bool same_bytes(const TriangleMesh& a, const TriangleMesh& b) {
  return a.triangles == b.triangles && a.positions.size() == b.positions.size() &&
         std::memcmp(a.positions.data(), b.positions.data(), a.positions.size() * sizeof(Vec3)) ==
             0;
}

TEST(MakeModel, EveryModelIsListedHere) { EXPECT_EQ(std::size(kModels), models().size()); }

TEST(MakeModel, DefaultsAreClosedAndWithinOnePercent) {
  for (const Expected& e : kModels) {
    SCOPED_TRACE(e.name);
    const TriangleMesh mesh = make_model({.name = e.name});
    for (const ModelInfo& m : models()) {
      if (std::string(m.name) == e.name) {
        EXPECT_LE(off_count(mesh, m.triangles), 0.01) << mesh.triangles.size();
      }
    }
    expect_closed(mesh, e.euler);
  }
}

TEST(MakeModel, AnyCountWithinOnePercentFromTwoThousand) {
  for (const Expected& e : kModels) {
    for (const int wished : {2000, 2777, 5000, 12345, 30001}) {
      SCOPED_TRACE(std::string(e.name) + " " + std::to_string(wished));
      const TriangleMesh mesh = make_model({.name = e.name, .triangles = wished});
      EXPECT_LE(off_count(mesh, wished), 0.01) << mesh.triangles.size();
      expect_closed(mesh, e.euler);
    }
  }
}

TEST(MakeModel, NothingCrossesItself) {
  for (const ModelInfo& m : models()) {
    for (const int wished : {m.least_triangles, 3001, m.triangles}) {
      SCOPED_TRACE(std::string(m.name) + " " + std::to_string(wished));
      if (wished < m.least_triangles) continue;
      const SelfIntersections found =
          find_self_intersections(make_model({.name = m.name, .triangles = wished}));
      EXPECT_EQ(found.pairs, 0);
      EXPECT_TRUE(found.complete);
    }
  }
}

TEST(MakeModel, JawsOfOtherSeedsDoNotCrossThemselvesEither) {
  for (const std::uint64_t seed : {2u, 3u, 77u}) {
    for (const char* name : {"jaw_lower", "jaw_upper"}) {
      EXPECT_EQ(find_self_intersections(make_model({.name = name, .triangles = 9000, .seed = seed}))
                    .pairs,
                0);
    }
  }
}

TEST(MakeModel, SimplePairOfTheText) {
  EXPECT_LE(off_count(make_model({.name = "cup", .triangles = 4000}), 4000), 0.01);
  EXPECT_LE(off_count(make_model({.name = "spoon", .triangles = 1344}), 1344), 0.01);
}

TEST(MakeModel, LeastCountsAreStillClosed) {
  for (const ModelInfo& m : models()) {
    SCOPED_TRACE(m.name);
    const TriangleMesh mesh = make_model({.name = m.name, .triangles = m.least_triangles});
    const test::SurfaceCount count = test::count_surface(mesh);
    EXPECT_EQ(count.boundary, 0);
    EXPECT_EQ(count.repeated, 0);
    EXPECT_GT(count.volume, 0.0);
    EXPECT_THROW(make_model({.name = m.name, .triangles = m.least_triangles - 1}), InputError);
  }
}

TEST(MakeModel, ModelsOfTheTextHaveItsTriangles) {
  const std::pair<const char*, std::size_t> table[] = {{"joint_ball", 137'060},
                                                       {"joint_socket", 137'060},
                                                       {"golf_club", 104'888},
                                                       {"golf_ball", 177'876}};
  for (const auto& [name, triangles] : table) {
    EXPECT_EQ(make_model({.name = name}).triangles.size(), triangles) << name;
  }
}

TEST(MakeModel, AMillionTriangles) {
  for (const char* name : {"joint_ball", "golf_ball", "conforming_lower", "jaw_upper"}) {
    SCOPED_TRACE(name);
    const TriangleMesh mesh = make_model({.name = name, .triangles = 1'000'000});
    EXPECT_LE(off_count(mesh, 1'000'000), 0.01) << mesh.triangles.size();
    expect_closed(mesh, 2);
  }
}

TEST(MakeModel, SeedsShapeSomeModelsAndNotTheOthers) {
  for (const char* name : {"jaw_lower", "jaw_upper", "joint_ball", "joint_socket", "golf_club",
                           "conforming_lower", "conforming_upper"}) {
    SCOPED_TRACE(name);
    const TriangleMesh one = make_model({.name = name, .triangles = 4000, .seed = 1});
    EXPECT_TRUE(same_bytes(one, make_model({.name = name, .triangles = 4000, .seed = 1})));
    EXPECT_FALSE(same_bytes(one, make_model({.name = name, .triangles = 4000, .seed = 2})));
  }
  for (const char* name : {"cup", "golf_ball"}) {
    EXPECT_TRUE(same_bytes(make_model({.name = name, .triangles = 4000}),
                           make_model({.name = name, .triangles = 4000, .seed = 2})));
  }
}

TEST(ModelUri, ReadsNameCountAndSeed) {
  const ModelRequest all = parse_model_uri("procedural:jaw_lower?triangles=40180&seed=7", "F");
  EXPECT_EQ(all.name, "jaw_lower");
  EXPECT_EQ(all.triangles, 40180);
  EXPECT_EQ(all.seed, 7u);
  EXPECT_EQ(parse_model_uri("procedural:cup", "F").triangles, 0);
}

TEST(ModelUri, RefusesEverythingElseAndSaysWhatWasMeant) {
  const std::pair<const char*, const char*> bad[] = {
      {"jaw_lower", "procedural:NAME"},
      {"procedural:", "expected one of"},
      {"procedural:jaw_lowr", "'jaw_lower'"},
      {"procedural:cup?", "expected one of"},
      {"procedural:cup?triangle=4000", "'triangles'"},
      {"procedural:cup?triangles", "no value"},
      {"procedural:cup?triangles=", "whole number"},
      {"procedural:cup?triangles=4e3", "whole number"},
      {"procedural:cup?triangles=-1", "expected 1500 to"},
      {"procedural:cup?triangles=99999999999", "whole number"},
      {"procedural:cup?triangles=4000&triangles=4000", "twice"},
      {"procedural:cup?seed=-1", "whole number"},
      {"procedural:cup?seed=1&", "expected one of"},
  };
  for (const auto& [uri, says] : bad) {
    try {
      parse_model_uri(uri, "F");
      ADD_FAILURE() << uri << " was accepted";
    } catch (const InputError& error) {
      const std::string text = error.what();
      EXPECT_EQ(text.find("F: "), 0u) << text;
      EXPECT_NE(text.find(says), std::string::npos) << uri << " -> " << text;
      EXPECT_EQ(text.find('\n'), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace thigma::models
