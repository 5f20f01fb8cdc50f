// Contacts that are carried along with the bodies: within their bounds, none left out, and the same
// pairs as are found by measuring.

#include <algorithm>
#include <set>

#include "support/level_check.h"
#include <gtest/gtest.h>

#include "thigma/contact/contact_node.h"
#include "thigma/core/index.h"
#include "thigma/mesh/shapes.h"
#include "thigma/models/make_model.h"

namespace thigma {
namespace {

using test::LevelPairCheck;
using test::PatchSurfaces;

TriangleMesh model(const char* name, int triangles) {
  return models::make_model({.name = name, .triangles = triangles});
}

/// Parents of the nodes of one tree.
std::vector<std::int32_t> parents_of(const ClodHierarchy& h) {
  std::vector<std::int32_t> parents(h.nodes.size(), -1);
  for (std::size_t i = 0; i < h.nodes.size(); ++i) {
    for (int c = 0; c < h.nodes[i].child_count; ++c)
      parents[idx(h.nodes[i].first_child + c)] = static_cast<std::int32_t>(i);
  }
  return parents;
}

struct Trees {
  std::vector<std::int32_t> object, scene;
};

bool is_above(const std::vector<std::int32_t>& parents, std::int32_t above, std::int32_t below) {
  while (below >= 0 && below != above) below = parents[idx(below)];
  return below == above;
}

using Nodes = std::pair<std::int32_t, std::int32_t>;

std::set<Nodes> nodes_of(const LevelPairCheck& pair, const ContactSet& set) {
  std::set<Nodes> nodes;
  for (const Contact& c : set.contacts)
    nodes.emplace(contact_node(pair.exact.object, c.object_patch),
                  contact_node(pair.exact.scene, c.scene_patch));
  return nodes;
}

/// Contacts deeper than touch of a query that measures, for which one that carries has neither
/// their pair nor one above or below it.
int count_unreported(const LevelPairCheck& pair, const Trees& trees, const ContactSet& measured,
                     const ContactSet& carried) {
  const std::set<Nodes> found = nodes_of(pair, carried);
  int unreported = 0;
  for (const Contact& c : measured.contacts) {
    if (c.depth + c.bound < 0.0) continue;
    const Nodes wanted(contact_node(pair.exact.object, c.object_patch),
                       contact_node(pair.exact.scene, c.scene_patch));
    if (found.count(wanted) != 0) continue;
    const bool is_there = std::any_of(found.begin(), found.end(), [&](const Nodes& n) {
      return (is_above(trees.object, n.first, wanted.first) ||
              is_above(trees.object, wanted.first, n.first)) &&
             (is_above(trees.scene, n.second, wanted.second) ||
              is_above(trees.scene, wanted.second, n.second));
    });
    unreported += is_there ? 0 : 1;
  }
  return unreported;
}

struct Counts {
  std::int64_t contacts = 0, differ = 0, unreported = 0, kinds = 0;
};

/// Contacts that were carried, and those of another kind than measuring finds.
void compare(const ContactSet& measured, const ContactSet& carried, Counts& counts) {
  std::size_t k = 0;
  for (const Contact& c : carried.contacts) {
    ++counts.contacts;
    const auto is_before = [&](const Contact& m) {
      return m.object_patch != c.object_patch ? m.object_patch < c.object_patch
                                              : m.scene_patch < c.scene_patch;
    };
    while (k < measured.contacts.size() && is_before(measured.contacts[k])) ++k;
    if (k == measured.contacts.size()) continue;
    const Contact& m = measured.contacts[k];
    if (m.object_patch != c.object_patch || m.scene_patch != c.scene_patch) continue;
    counts.differ += m.depth != c.depth || m.bound != c.bound ? 1 : 0;
    // Penetrating and deep differ by how deep, not by where.
    const auto is_through = [](const Contact& x) {
      return x.status == ContactStatus::penetrating || x.status == ContactStatus::deep;
    };
    counts.kinds += is_through(m) != is_through(c) ? 1 : 0;
  }
}

ContactQuery query_for(double d, bool is_exact, SupportReading reading) {
  ContactQuery query{.tolerance = d};
  query.resolution.is_exact = is_exact;
  query.resolution.reading = reading;
  query.resolution.carry = 0.3;
  return query;
}

/// A slow way into contact, a step at a time, and the oracles on some of its poses.
void check_slowly(LevelPairCheck pair, const ContactQuery& query) {
  const int poses = test::is_full() ? 10'000 : 480, stride = test::is_full() ? 10 : 24;
  const double d = query.tolerance;
  PatchSurfaces objects(pair.exact.object, pair.object_mesh),
      scenes(pair.exact.scene, pair.scene_mesh);
  const Trees trees{parents_of(pair.exact.object), parents_of(pair.exact.scene)};
  const test::Approach approach = test::from_above(pair.exact);
  const Pose touch = test::pose_at_gap(pair.exact, approach.start, approach.direction, 0.0);
  ContactQuery measuring = query;
  measuring.resolution.carry = 0.0;
  ContactFront front, other;
  ContactSet set, measured;
  set.contacts.reserve(400'000);
  measured.contacts.reserve(400'000);
  Counts counts;
  for (int i = 0; i < poses; ++i) {
    SCOPED_TRACE("pose " + std::to_string(i));
    const Pose pose = test::on_path(pair.exact, touch, approach.direction, i / (poses - 1.0));
    clear(set);
    query_contacts({pair.exact.object, pose}, {pair.exact.scene}, query, front, set);
    ASSERT_EQ(set.dropped, 0);
    clear(measured);
    query_contacts({pair.exact.object, pose}, {pair.exact.scene}, measuring, other, measured);
    compare(measured, set, counts);
    counts.unreported += count_unreported(pair, trees, measured, set);
    if (i % stride != 0) continue;
    // a depth along a normal may change by three times the way of the bodies, and is off twice that
    test::check_levels(pair, objects, scenes, pose, d, set, 6.0 * query.resolution.carry * d);
    if (::testing::Test::HasFailure()) return;
  }
  std::printf("  %-14s %lld contacts, %lld carried, %lld of another kind, %lld unreported\n",
              pair.name.c_str(), static_cast<long long>(counts.contacts),
              static_cast<long long>(counts.differ), static_cast<long long>(counts.kinds),
              static_cast<long long>(counts.unreported));
  EXPECT_EQ(counts.unreported, 0) << pair.name;
  EXPECT_EQ(counts.kinds, 0) << pair.name;
  EXPECT_GT(counts.differ, counts.contacts / 5) << pair.name << ": next to nothing is carried";
}

void check_carried(bool is_exact, SupportReading reading) {
  const auto check = [&](const char* name, TriangleMesh object, TriangleMesh scene) {
    LevelPairCheck pair = test::make_level_pair(name, std::move(object), std::move(scene));
    const double d = 0.01 * pair.exact.radius;
    check_slowly(std::move(pair), query_for(d, is_exact, reading));
  };
  check("ball on ball", make_ball(1.0, 20), make_ball(1.2, 24));
  check("jaw on jaw", model("jaw_upper", 4'000), model("jaw_lower", 4'000));
  check("spoon in cup", model("spoon", 3'000), model("cup", 4'000));
  check("torus on gear", model("torus", 3'000), model("gear", 4'000));
}

TEST(CarriedQuery, ExactWithinItsBounds) { check_carried(true, SupportReading::flood); }

TEST(CarriedQuery, LevelsWithinTheirBounds) { check_carried(false, SupportReading::flood); }

TEST(CarriedQuery, LevelsOfPairsWithinTheirBounds) { check_carried(false, SupportReading::patch); }

}  // namespace
}  // namespace thigma
