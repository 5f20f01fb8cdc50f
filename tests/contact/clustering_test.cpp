#include "thigma/contact/clustering.h"

#include <algorithm>
#include <fstream>
#include <set>

#include "support/shared.h"
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "thigma/math/random.h"

namespace thigma {
namespace {

Vec3 vec(const nlohmann::json& j) {
  return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()};
}

std::vector<Contact> blob(Random& random, const Vec3& center, double size, int count) {
  std::vector<Contact> contacts;
  for (int i = 0; i < count; ++i) {
    Contact c;
    c.point = center + random.in_cube(size);
    c.normal = (Vec3::UnitZ() + random.in_cube(0.2)).normalized();
    c.depth = random.uniform(-1e-3, 1e-3);
    c.scene_point = c.point - c.depth * c.normal;
    contacts.push_back(c);
  }
  return contacts;
}

void expect_near(double got, double want, double scale) {
  EXPECT_NEAR(got, want, 1e-12 + 1e-9 * std::abs(scale));
}

TEST(Clustering, MatchesTheReferenceVectors) {
  THIGMA_NEEDS_SHARED(shared);
  std::ifstream file(shared / "reference" / "vectors" / "clustering.json");
  if (!file) GTEST_SKIP() << "the shared folder has no reference/vectors/clustering.json";
  const auto all = nlohmann::json::parse(file);
  ClusterScratch scratch;
  for (const auto& test : all["cases"]) {
    SCOPED_TRACE(test["name"].get<std::string>());
    std::vector<Contact> contacts;
    for (const auto& j : test["in"]["contacts"]) {
      Contact c;
      c.point = vec(j["p"]);
      c.scene_point = vec(j["p0"]);
      c.normal = vec(j["n"]);
      c.depth = j["delta"].get<double>();
      contacts.push_back(c);
    }
    ContactClusters old;
    for (const auto& j : test["in"]["old_clusters"]) {
      ContactCluster c;
      c.point = vec(j["p"]);
      c.depth = j["delta"].get<double>();
      c.id = old.next_id++;
      old.clusters.push_back(c);
    }
    ContactClusters got;
    const ClusterParams params{.max_clusters = test["in"]["K"], .tolerance = test["in"]["d"]};
    cluster_contacts(contacts, old, params, scratch, got);
    const auto& want = test["out"];
    EXPECT_EQ(std::vector<int>(scratch.seeds.begin(), scratch.seeds.end()),
              want["initial_seeds"].get<std::vector<int>>());
    EXPECT_EQ(scratch.assignment, want["assignment"].get<std::vector<std::int32_t>>());
    EXPECT_EQ(got.iterations, want["iterations"].get<int>());
    expect_near(got.cost, want["cost"].get<double>(), want["cost"].get<double>());
    ASSERT_EQ(got.clusters.size(), want["clusters"].size());
    for (std::size_t k = 0; k < got.clusters.size(); ++k) {
      const auto& w = want["clusters"][k];
      expect_near((got.clusters[k].point - vec(w["p"])).cwiseAbs().maxCoeff(), 0.0,
                  vec(w["p"]).cwiseAbs().maxCoeff());
      expect_near((got.clusters[k].scene_point - vec(w["p0"])).cwiseAbs().maxCoeff(), 0.0,
                  vec(w["p0"]).cwiseAbs().maxCoeff());
      expect_near((got.clusters[k].normal - vec(w["n"])).cwiseAbs().maxCoeff(), 0.0, 1.0);
      expect_near(got.clusters[k].depth, w["delta"].get<double>(), w["delta"].get<double>());
      expect_near(got.clusters[k].weight, w["w"].get<double>(), w["w"].get<double>());
      EXPECT_EQ(got.clusters[k].member_count, static_cast<int>(w["members"].size()));
    }
  }
}

TEST(Clustering, SeparatedGroupsAreFoundWhateverTheStart) {
  Random random(3);
  std::vector<Contact> contacts;
  for (int g = 0; g < 4; ++g) {
    const auto group = blob(random, Vec3(g, 0, 0), 0.05, 50);
    contacts.insert(contacts.end(), group.begin(), group.end());
  }
  ClusterScratch scratch;
  ContactClusters clusters;
  cluster_contacts(contacts, {}, {.max_clusters = 4, .tolerance = 2e-3}, scratch, clusters);
  ASSERT_EQ(clusters.clusters.size(), 4u);
  for (int g = 0; g < 4; ++g) {
    std::set<int> used(scratch.assignment.begin() + 50 * g,
                       scratch.assignment.begin() + 50 * (g + 1));
    EXPECT_EQ(used.size(), 1u) << "group " << g << " was split";
  }
}

TEST(Clustering, IdsFollowTheirClustersAndNewClustersGetNewOnes) {
  Random random(5);
  const auto left = blob(random, Vec3(0, 0, 0), 0.05, 30);
  const auto right = blob(random, Vec3(1, 0, 0), 0.05, 30);
  ClusterScratch scratch;
  ContactClusters clusters;
  const ClusterParams params{.max_clusters = 2, .tolerance = 2e-3};
  auto id_near = [&](double x) {
    for (const ContactCluster& c : clusters.clusters) {
      if (std::abs(c.point.x() - x) < 0.3) return c.id;
    }
    return -1;
  };
  std::vector<Contact> both = left;
  both.insert(both.end(), right.begin(), right.end());
  cluster_contacts(both, {}, params, scratch, clusters);
  const int left_id = id_near(0.0), right_id = id_near(1.0);
  ASSERT_NE(left_id, right_id);
  // depths change at will, so the order of the output does too
  for (int frame = 0; frame < 20; ++frame) {
    for (Contact& c : both) c.depth = random.uniform(-1e-3, 1e-3);
    cluster_contacts(both, clusters, params, scratch, clusters);
    ASSERT_EQ(id_near(0.0), left_id);
    ASSERT_EQ(id_near(1.0), right_id);
  }
  // One region leaves and another appears: the survivor keeps its name, the newcomer's was never
  // used.
  cluster_contacts(left, clusters, {.max_clusters = 1, .tolerance = 2e-3}, scratch, clusters);
  ASSERT_EQ(clusters.clusters.size(), 1u);
  const int kept = clusters.clusters[0].id;
  cluster_contacts(both, clusters, params, scratch, clusters);
  EXPECT_EQ(id_near(0.0), kept);
  EXPECT_GT(id_near(1.0), std::max(left_id, right_id));
}

TEST(Clustering, WeightlessAndOpposingContactsStayFinite) {
  ClusterScratch scratch;
  ContactClusters clusters;
  std::vector<Contact> contacts(2);
  contacts[0].point = Vec3(0, 0, 1);
  contacts[0].normal = Vec3::UnitX();
  contacts[1].point = Vec3(0, 0, 3);
  contacts[1].normal = -Vec3::UnitX();
  for (Contact& c : contacts) c.depth = -1e-3;
  cluster_contacts(contacts, {}, {.max_clusters = 1, .tolerance = 1e-3}, scratch, clusters);
  ASSERT_EQ(clusters.clusters.size(), 1u);
  EXPECT_EQ(clusters.clusters[0].weight, 0.0);
  EXPECT_EQ(clusters.clusters[0].point, Vec3(0, 0, 2));         // unit weights
  EXPECT_EQ(clusters.clusters[0].normal, Vec3(Vec3::UnitX()));  // of the deepest, ties to the first
}

TEST(Clustering, DuplicatesOfOnePointGiveOneCluster) {
  std::vector<Contact> contacts(7);
  ClusterScratch scratch;
  ContactClusters clusters;
  cluster_contacts(contacts, {}, {.max_clusters = 5, .tolerance = 1e-3}, scratch, clusters);
  ASSERT_EQ(clusters.clusters.size(), 1u);
  EXPECT_EQ(clusters.clusters[0].member_count, 7);
}

TEST(Clustering, EveryContactIsInOneClusterAndMomentsAgree) {
  Random random(11);
  ClusterScratch scratch;
  ContactClusters clusters;
  for (int round = 0; round < 200; ++round) {
    const auto contacts = blob(random, Vec3::Zero(), 1.0, 1 + static_cast<int>(random.below(300)));
    const ClusterParams params{.max_clusters = 1 + static_cast<int>(random.below(16)),
                               .tolerance = 5e-4};
    cluster_contacts(contacts, clusters, params, scratch, clusters);
    ASSERT_EQ(scratch.assignment.size(), contacts.size());
    ASSERT_LE(clusters.clusters.size(), static_cast<std::size_t>(params.max_clusters));
    std::vector<int> members(clusters.clusters.size(), 0);
    for (std::size_t i = 0; i < contacts.size(); ++i)
      ++members[static_cast<std::size_t>(scratch.assignment[i])];
    std::set<int> ids;
    for (std::size_t k = 0; k < members.size(); ++k) {
      const ContactCluster& c = clusters.clusters[k];
      EXPECT_EQ(members[k], c.member_count);
      EXPECT_GT(c.member_count, 0);
      EXPECT_NEAR(c.normal.norm(), 1.0, 1e-14);
      EXPECT_NEAR(c.normal.dot(c.point - c.scene_point), c.depth, 1e-15);
      if (k > 0) {
        EXPECT_GE(clusters.clusters[k - 1].depth, c.depth);
      }
      ids.insert(c.id);
    }
    EXPECT_EQ(ids.size(), members.size()) << "two clusters share an id";
  }
}

}  // namespace
}  // namespace thigma
