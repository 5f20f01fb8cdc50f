// One support area a patch: SupportReading::patch.

#include <map>
#include <set>
#include <vector>

#include "support/ring_on_ball.h"
#include <gtest/gtest.h>

#include "thigma/contact/contact_node.h"
#include "thigma/contact/multires/measure_pair.h"
#include "thigma/core/index.h"

namespace thigma {
namespace {

const test::RingOnBall& the_pair() {
  static const test::RingOnBall pair;
  return pair;
}

ContactQuery query_at(double threshold, SupportReading reading) {
  ContactQuery query{.tolerance = 0.03};
  query.resolution.is_exact = false;
  query.resolution.metric.haptic = threshold;
  query.resolution.reading = reading;
  return query;
}

ContactSet room() {
  ContactSet set;
  set.contacts.reserve(100'000);
  return set;
}

void ask(const ContactQuery& query, const Pose& pose, ContactFront& front, ContactSet& set) {
  clear(set);
  query_contacts({the_pair().object, pose}, {the_pair().scene}, query, front, set);
}

using Nodes = std::pair<std::int32_t, std::int32_t>;

std::vector<std::int32_t> parents_of(const ClodHierarchy& h) {
  std::vector<std::int32_t> parents(h.nodes.size(), -1);
  for (std::size_t i = 0; i < h.nodes.size(); ++i) {
    for (int c = 0; c < h.nodes[i].child_count; ++c)
      parents[idx(h.nodes[i].first_child + c)] = static_cast<std::int32_t>(i);
  }
  return parents;
}

bool is_above(const std::vector<std::int32_t>& parents, std::int32_t above, std::int32_t below) {
  while (below >= 0 && below != above) below = parents[idx(below)];
  return below == above;
}

/// Pairs of nodes that are a contact at some pose and stand above one that is at another.
int pairs_of_two_levels(SupportReading reading) {
  const ClodHierarchy &object = the_pair().object, &scene = the_pair().scene;
  const std::vector<std::int32_t> up = parents_of(object), down = parents_of(scene);
  std::set<Nodes> all;
  ContactFront front;
  ContactSet set = room();
  ContactQuery query = query_at(0.01, reading);
  for (int i = 0; i <= 120; ++i) {
    ask(query, test::ring_at(i / 120.0), front, set);
    for (const Contact& c : set.contacts) {
      // Turning from beside to through, a pair's bound may not hold; it is refined then.
      if (c.status == ContactStatus::separated)
        all.emplace(contact_node(object, c.object_patch), contact_node(scene, c.scene_patch));
    }
  }
  EXPECT_GT(all.size(), 100u);
  int count = 0;
  for (const Nodes& x : all) {
    for (const Nodes& y : all)
      count += x != y && is_above(up, x.first, y.first) && is_above(down, x.second, y.second);
  }
  return count;
}

TEST(PatchReading, KeepsTheLevelOfAPairAtEveryPose) {
  EXPECT_EQ(pairs_of_two_levels(SupportReading::patch), 0);
  EXPECT_GT(pairs_of_two_levels(SupportReading::flood), 0);
}

TEST(PatchReading, BlendsNothing) {
  ContactFront front, other;
  ContactSet set = room(), plain = room();
  ContactQuery query = query_at(0.01, SupportReading::patch);
  std::size_t coarse = 0;
  for (int i = 0; i <= 40; ++i) {
    query.resolution.interpolates = true;
    ask(query, test::ring_at(i / 40.0), front, set);
    query.resolution.interpolates = false;
    ask(query, test::ring_at(i / 40.0), other, plain);
    ASSERT_EQ(test::first_difference(set, plain), -1) << "pose " << i;
    for (const Contact& c : set.contacts) {
      EXPECT_EQ(c.weight, 1.0);
      coarse += c.object_level > 0 ? 1u : 0u;
    }
  }
  EXPECT_GT(coarse, 100u);
}

// What no pose changes is known before anything is measured: of pairs that did not move, those that
// are split are not looked at, and those that are measured are contacts, or too far to be.
TEST(PatchReading, MeasuresNothingToBeSplit) {
  std::int64_t more[2] = {}, contacts[2] = {};
  const SupportReading readings[2] = {SupportReading::patch, SupportReading::flood};
  for (int k = 0; k < 2; ++k) {
    ContactFront front;
    ContactSet set = room();
    for (int i = 0; i <= 20; ++i) {
      for (int still = 0; still < 2; ++still)
        ask(query_at(0.01, readings[k]), test::ring_at(0.5 + i / 40.0), front, set);
      contacts[k] += static_cast<std::int64_t>(set.contacts.size());
      more[k] += set.stats.tests - static_cast<std::int64_t>(set.contacts.size());
    }
  }
  EXPECT_GT(contacts[0], 100);
  EXPECT_LE(more[0], contacts[0] / 20);
  EXPECT_GT(more[1], contacts[1] / 4);
}

TEST(PatchReading, AnswersAfreshAndWithAnAmpleBudgetAlike) {
  ContactFront front, other;
  ContactSet set = room(), again = room();
  ContactQuery query = query_at(0.01, SupportReading::patch), limited = query;
  limited.resolution.budget_tests = 1'000'000;
  for (int i = 0; i <= 20; ++i) {
    ask(query, test::ring_at(i / 20.0), front, set);
    ContactFront fresh;
    ask(query, test::ring_at(i / 20.0), fresh, again);
    EXPECT_EQ(test::first_difference(set, again), -1) << "pose " << i;
    ask(limited, test::ring_at(i / 20.0), other, again);
    EXPECT_EQ(test::first_difference(set, again), -1) << "pose " << i;
  }
}

// The harmonic mean over the area, from the triangles themselves.
TEST(PatchReading, IsTheHarmonicMeanOverThePatch) {
  const ClodHierarchy& h = the_pair().object;
  const auto of_nodes = detail::support_of_nodes(h);
  ASSERT_EQ(of_nodes.size(), h.nodes.size());
  int patches = 0;
  for (std::size_t i = 0; i < h.nodes.size(); ++i) {
    if (detail::is_free(h.nodes[i])) continue;
    const HullView view = level_surface(h, static_cast<std::int32_t>(i));
    const auto* support = h.support.data() + (view.vertices - h.vertices.data());
    double area = 0.0, over = 0.0;
    for (int t = 0; t < view.triangle_count; ++t) {
      const Vec3 corner[3] = {view.vertices[view.triangles[t].corner[0]],
                              view.vertices[view.triangles[t].corner[1]],
                              view.vertices[view.triangles[t].corner[2]]};
      double mean = 0.0;
      for (int k = 0; k < 3; ++k) mean += support[view.triangles[t].corner[k]][1] / 3.0;
      const double size = 0.5 * (corner[1] - corner[0]).cross(corner[2] - corner[0]).norm();
      area += size;
      over += size / mean;
    }
    EXPECT_NEAR(of_nodes[i][2], area / over, 1e-12 * of_nodes[i][1]);
    EXPECT_LE(of_nodes[i][2], of_nodes[i][1] * (1.0 + 1e-12));
    ++patches;
  }
  EXPECT_GT(patches, 50);
}

}  // namespace
}  // namespace thigma
