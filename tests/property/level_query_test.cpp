// The query with levels of detail: bounds against the original triangles, nothing left out, memory
// without a trace.

#include <numeric>

#include "support/level_check.h"
#include <gtest/gtest.h>

#include "thigma/contact/least_separation.h"
#include "thigma/math/quantile.h"
#include "thigma/mesh/shapes.h"
#include "thigma/models/make_model.h"

namespace thigma {
namespace {

using test::Approach;
using test::LevelPairCheck;
using test::PatchSurfaces;

constexpr double kThresholds[] = {0.0025, 0.01, 0.025, 0.05};

/// triangles 0: as many as the model ships with.
TriangleMesh model(const char* name, int triangles) {
  return models::make_model({.name = name, .triangles = triangles});
}

// Every contact is compared with every original triangle near it: a thousand poses want models of
// thousands of triangles.
int pose_count() { return test::is_full() ? 1000 : 12; }

ContactQuery query_at(double tolerance, double threshold) {
  ContactQuery query{.tolerance = tolerance};
  query.resolution.is_exact = false;
  query.resolution.metric.haptic = threshold;
  return query;
}

void ask(const LevelPairCheck& pair, const Pose& pose, const ContactQuery& query,
         ContactFront& front, ContactSet& set) {
  clear(set);
  query_contacts({pair.exact.object, pose}, {pair.exact.scene}, query, front, set);
  ASSERT_EQ(set.dropped, 0);
}

/// What the contacts are narrowed to holds the distance of the original triangles.
void check_interval(const test::CheckedPair& pair, const Pose& pose, double d,
                    const ContactSet& set, SeparationScratch& scratch) {
  const double truth =
      test::least_triangle_distance(test::placed(pair.object_tree, pose), pair.scene_tree);
  const double eps = 1e-9 * pair.radius;
  for (const double width : {0.0, 0.01}) {
    const SeparationInterval found =
        least_separation({pair.object, pose}, {pair.scene}, set,
                         {.tolerance = d, .body = 0, .width = width}, scratch);
    EXPECT_TRUE(found.is_narrow) << pair.name;
    EXPECT_LE(found.low, truth + eps) << pair.name;
    if (found.low >= d) continue;
    EXPECT_LE(found.high - found.low, width * pair.radius + eps) << pair.name;
    if (truth > 0.0) EXPECT_GE(found.high, std::min(truth, d) - eps) << pair.name;
    if (truth == 0.0) EXPECT_LE(found.low, eps) << pair.name;
  }
}

/// The whole check of a pair along one path into contact, threshold by threshold.
void check_path(LevelPairCheck pair, const Approach& approach, int poses) {
  const double d = 0.01 * pair.exact.radius;
  PatchSurfaces objects(pair.exact.object, pair.object_mesh),
      scenes(pair.exact.scene, pair.scene_mesh);
  const Pose touch = test::pose_at_gap(pair.exact, approach.start, approach.direction, 0.0);
  SeparationScratch separation;
  ContactSet set, other;
  set.contacts.reserve(400'000);
  other.contacts.reserve(400'000);
  for (const double threshold : kThresholds) {
    for (const bool has_cap : {true, false}) {
      ContactFront front, fresh;
      ContactQuery query = query_at(d, threshold);
      if (!has_cap) query.resolution.deviation_cap = kNoCap;
      query.resolution.interpolates = threshold > 0.02;
      pair.ratios.clear();
      pair.contacts = pair.coarse = pair.poses = pair.true_pairs = 0;
      for (int i = 0; i < poses; ++i) {
        SCOPED_TRACE("threshold " + std::to_string(threshold) + " pose " + std::to_string(i));
        const Pose pose = test::on_path(pair.exact, touch, approach.direction, i / (poses - 1.0));
        ask(pair, pose, query, front, set);
        clear_front(fresh);
        ask(pair, pose, query, fresh, other);
        EXPECT_EQ(test::first_difference(set, other), -1)
            << pair.name << ": remembering changed the answer";
        test::check_levels(pair, objects, scenes, pose, d, set);
        check_interval(pair.exact, pose, d, set, separation);
        if (::testing::Test::HasFailure()) return;
      }
      const double median = sample_quantile(pair.ratios, 0.5);
      std::printf(
          "  %-14s s0 %.4f cap %-3s %6lld contacts, %6lld coarse, %6lld true pairs; bound/error p5 "
          "%.2f p25 %.2f "
          "median %.2f p75 %.1f p95 %.1f; bound/(s+s+h+h) up to %.3f\n",
          pair.name.c_str(), threshold, has_cap ? "on" : "off",
          static_cast<long long>(pair.contacts), static_cast<long long>(pair.coarse),
          static_cast<long long>(pair.true_pairs), sample_quantile(pair.ratios, 0.05),
          sample_quantile(pair.ratios, 0.25), median, sample_quantile(pair.ratios, 0.75),
          sample_quantile(pair.ratios, 0.95), pair.worst_promise);
      if (pair.ratios.size() > 100) {
        // up to 35 at 12 poses; least_separation narrows what needs less
        EXPECT_LE(median, 50.0) << pair.name << ": bounds are not tight";
      }
    }
  }
}

void check_above(LevelPairCheck pair, int poses = pose_count()) {
  const Approach approach = test::from_above(pair.exact);
  check_path(std::move(pair), approach, poses);
}

/// From any side: what is within d has a contact, of its own patches in an exact query, of patches
/// above them with levels.
void check_nothing_is_pruned(LevelPairCheck pair) {
  const int poses = test::is_full() ? 10'000 : 50;
  const double d = 0.01 * pair.exact.radius, eps = 1e-9 * pair.exact.radius;
  const PatchSurfaces objects(pair.exact.object, pair.object_mesh),
      scenes(pair.exact.scene, pair.scene_mesh);
  ContactQuery exact = query_at(d, 0.0), coarse = query_at(d, 0.025);
  exact.resolution.is_exact = true;
  coarse.resolution.deviation_cap = kNoCap;
  ContactFront front;
  ContactSet set;
  set.contacts.reserve(400'000);
  Random random(29);
  int missed = 0, missed_coarse = 0;
  std::int64_t true_pairs = 0, ignored = 0;
  for (int i = 0; i < poses; ++i) {
    const Pose pose = test::random_pose_near(pair.exact, random);
    clear_front(front);
    ask(pair, pose, exact, front, set);
    missed += test::count_missed(pair, objects, scenes, pose, d - eps, set, true_pairs);
    for (const Contact& c : set.contacts) ASSERT_EQ(c.object_level + c.scene_level, 0);
    clear_front(front);
    ask(pair, pose, coarse, front, set);
    missed_coarse += test::count_missed(pair, objects, scenes, pose, d - eps, set, ignored);
  }
  std::printf(
      "  %-14s %d random poses, %lld true pairs of finest patches, missed %d exact, %d with "
      "levels\n",
      pair.name.c_str(), poses, static_cast<long long>(true_pairs), missed, missed_coarse);
  std::fflush(stdout);
  EXPECT_GT(true_pairs, poses / 4);
  EXPECT_EQ(missed, 0);
  EXPECT_EQ(missed_coarse, 0);
}

TEST(LevelQuery, PrunesNothingFromAnySide) {
  check_nothing_is_pruned(
      test::make_level_pair("ball on ball", make_ball(1.0, 20), make_ball(1.2, 24)));
  check_nothing_is_pruned(
      test::make_level_pair("jaw on jaw", model("jaw_upper", 4'000), model("jaw_lower", 4'000)));
  check_nothing_is_pruned(
      test::make_level_pair("spoon and cup", model("spoon", 3'000), model("cup", 4'000)));
  check_nothing_is_pruned(
      test::make_level_pair("golf", model("golf_ball", 4'000), model("golf_club", 4'000)));
  check_nothing_is_pruned(test::make_level_pair("ball joint", model("joint_ball", 4'000),
                                                model("joint_socket", 4'000)));
  check_nothing_is_pruned(
      test::make_level_pair("torus and gear", model("torus", 3'000), model("gear", 4'000)));
}

TEST(LevelQuery, BallOnBall) {
  check_above(test::make_level_pair("ball on ball", make_ball(1.0, 20), make_ball(1.2, 24)));
}

TEST(LevelQuery, JawOnJaw) {
  check_above(
      test::make_level_pair("jaw on jaw", model("jaw_upper", 4'000), model("jaw_lower", 4'000)));
}

TEST(LevelQuery, JawsAsTheyShip) {
  if (!test::is_full()) GTEST_SKIP() << "with THIGMA_FULL=1 only: 40,180 on 47,340 triangles";
  check_above(test::make_level_pair("jaws", model("jaw_upper", 0), model("jaw_lower", 0)), 8);
}

TEST(LevelQuery, SpoonInCup) {
  check_above(test::make_level_pair("spoon in cup", model("spoon", 3'000), model("cup", 4'000)));
}

TEST(LevelQuery, GolfBallOnClub) {
  check_above(test::make_level_pair("golf", model("golf_ball", 4'000), model("golf_club", 4'000)));
}

TEST(LevelQuery, BallInSocket) {
  check_above(test::make_level_pair("ball joint", model("joint_ball", 4'000),
                                    model("joint_socket", 4'000)));
}

TEST(LevelQuery, TorusOnGear) {
  check_above(test::make_level_pair("torus on gear", model("torus", 3'000), model("gear", 4'000)));
}

}  // namespace
}  // namespace thigma
