// Queries that measure hulls instead of triangles: nothing near is missing, nothing is farther.
#include <cmath>
#include <cstring>
#include <map>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

using Pairs = std::map<std::pair<std::int32_t, std::int32_t>, Contact>;

ContactSet room() {
  ContactSet set;
  set.contacts.reserve(4000);
  return set;
}

struct Asked {
  const ClodHierarchy& object;
  const ClodHierarchy& scene;

  ContactSet ask(const Pose& pose, double tolerance, bool by_hulls, ContactFront& front) const {
    ContactSet set = room();
    query_contacts({object, pose}, {scene}, {.tolerance = tolerance, .measures_hulls = by_hulls},
                   front, set);
    return set;
  }
};

Pairs by_patches(const ContactSet& set) {
  Pairs pairs;
  for (const Contact& c : set.contacts) pairs[{c.object_patch, c.scene_patch}] = c;
  return pairs;
}

bool are_same(const ContactSet& a, const ContactSet& b) {
  const auto same = [](const Contact& x, const Contact& y) {
    return x.object_patch == y.object_patch && x.scene_patch == y.scene_patch &&
           std::memcmp(&x.depth, &y.depth, sizeof x.depth) == 0 && x.normal == y.normal &&
           x.point == y.point && x.scene_point == y.scene_point;
  };
  return std::equal(a.contacts.begin(), a.contacts.end(), b.contacts.begin(), b.contacts.end(),
                    same);
}

/// Moves one about the other, often near; returns how many contacts hulls alone told.
int compare(const TriangleMesh& a, const TriangleMesh& b, double size, bool lies_flat) {
  const ClodHierarchy object = build_exact_hierarchy(a), scene = build_exact_hierarchy(b);
  const Asked asked{object, scene};
  ContactFront exact, hulls;  // go along
  Random random{5};
  Pose pose;
  int by_hulls = 0;
  for (int i = 0; i < 120; ++i) {
    if (i % 30 == 0) {
      pose.position = lies_flat ? Vec3(0.0, 0.0, 1.003 * size) : Vec3(random.in_cube(1.5 * size));
      pose.orientation = lies_flat ? Quat::Identity() : random.orientation();
    }
    pose.position += lies_flat ? Vec3(0.01 * size * random.normal(), 0.0, 0.0)
                               : Vec3(0.01 * size * random.in_cube(1.0));
    const double tolerance = 0.02 * size;
    const Pairs truth = by_patches(asked.ask(pose, tolerance, false, exact));
    const ContactSet quick = asked.ask(pose, tolerance, true, hulls);
    const Pairs told = by_patches(quick);
    for (const auto& [patches, contact] : truth) {
      const auto at = told.find(patches);
      EXPECT_NE(at, told.end()) << i;
      if (at == told.end()) continue;
      if (contact.depth <= 0.0 && at->second.depth <= 0.0) {
        EXPECT_GE(at->second.depth, contact.depth - 1e-9 * size) << i;
      }
      by_hulls += at->second.depth != contact.depth ? 1 : 0;
    }
    for (const auto& [patches, contact] : told)
      EXPECT_GE(contact.depth, -tolerance * (1.0 + 1e-9)) << i;
    ContactFront fresh;
    EXPECT_TRUE(are_same(quick, asked.ask(pose, tolerance, true, fresh))) << i;
  }
  return by_hulls;
}

/// The same where contacts are carried, one moving slowly; returns how many were.
int compare_carried(const TriangleMesh& a, const TriangleMesh& b, double size, double carry) {
  const ClodHierarchy object = build_exact_hierarchy(a), scene = build_exact_hierarchy(b);
  const Asked asked{object, scene};
  const double tolerance = 0.02 * size;
  ContactQuery query{.tolerance = tolerance, .measures_hulls = true};
  query.resolution.carry = carry;
  ContactFront exact, hulls, front;
  Random random{6};
  Pose pose;
  int carried = 0;
  for (int i = 0; i < 1000; ++i) {
    if (i % 50 == 0) {
      pose.position = 1.01 * size * Vec3(random.in_cube(1.0)).normalized();
      pose.orientation = random.orientation();
    }
    // The distance by a fixed normal is never too far where nothing turns.
    pose.position += 2e-4 * size * Vec3(random.in_cube(1.0));
    pose.orientation =
        (rotation_from_vector(6e-3 * Vec3(random.in_cube(1.0))) * pose.orientation).normalized();
    const Pairs truth = by_patches(asked.ask(pose, tolerance, false, exact));
    const Pairs of_hulls = by_patches(asked.ask(pose, tolerance, true, hulls));
    ContactSet told = room();
    query_contacts({object, pose}, {scene}, query, front, told);
    const Pairs pairs = by_patches(told);
    for (const auto& [patches, contact] : truth) EXPECT_TRUE(pairs.contains(patches)) << i;
    for (const Contact& contact : told.contacts) {
      carried += contact.bound > 0.0 ? 1 : 0;
      EXPECT_GE(contact.depth, -tolerance * (1.0 + 1e-9)) << i;
      const auto at = of_hulls.find({contact.object_patch, contact.scene_patch});
      // Rows are of what is apart.
      if (at == of_hulls.end() || contact.bound == 0.0 || contact.depth > 0.0) continue;
      EXPECT_LE(std::fabs(contact.depth - at->second.depth), contact.bound + 1e-9 * size) << i;
    }
  }
  return carried;
}

TEST(HullContacts, MissNothingWhereTheyAreCarried) {
  for (const double size : {1e-9, 1.0, 1e3}) {
    const TriangleMesh block = transformed(make_box(Vec3(1.0, 1.0, 1.0), {6, 6, 6}), {}, size);
    const TriangleMesh ring = transformed(make_torus(0.6, 0.25, 32, 16), {}, size);
    for (const double carry : {0.1, 1.0})
      EXPECT_GT(compare_carried(ring, block, size, carry), 50) << size << ", " << carry;
  }
}

TEST(HullContacts, MissNothingAndAreOfThePoseAlone) {
  for (const double size : {1e-9, 1.0, 1e3}) {
    const auto of_size = [&](const TriangleMesh& mesh) { return transformed(mesh, {}, size); };
    const TriangleMesh block = of_size(make_box(Vec3(1.0, 1.0, 1.0), {6, 6, 6}));
    const TriangleMesh ring = of_size(make_torus(0.7, 0.3, 24, 12));
    EXPECT_GT(compare(block, block, size, true), 100);
    compare(ring, block, size, false);
    compare(block, of_size(make_l_shape(1.0, 0.3)), size, false);
  }
}

}  // namespace
}  // namespace thigma
