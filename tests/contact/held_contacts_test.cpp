// Queries that hold what is near: the pairs are those that measuring all finds, and the nearest is
// as near.
#include <cmath>

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/math/random.h"
#include "thigma/math/rotation.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

ContactSet room(std::size_t contacts = 4000) {
  ContactSet set;
  set.contacts.reserve(contacts);
  return set;
}

/// One body about another, faster than contacts are carried; it comes from far now and then.
struct Flight {
  double size, step;  // of it and of a frame, times the size
  Random random{7};
  Pose pose{};

  void next(int frame) {
    if (frame % 40 == 0) {
      pose.position = 1.02 * size * Vec3(random.in_cube(1.0)).normalized();
      pose.orientation = random.orientation();
    }
    pose.position += step * size * Vec3(random.in_cube(1.0));
    pose.orientation =
        (rotation_from_vector(step * Vec3(random.in_cube(1.0))) * pose.orientation).normalized();
  }
};

struct Asked {
  const ClodHierarchy object, scene;

  ContactSet ask(const Pose& pose, const ContactQuery& query, ContactFront& front,
                 std::size_t capacity = 4000) const {
    ContactSet set = room(capacity);
    query_contacts({object, pose}, {scene}, query, front, set);
    return set;
  }
};

void expect_same_pairs(const ContactSet& measured, const ContactSet& held, double size) {
  ASSERT_EQ(measured.contacts.size(), held.contacts.size());
  EXPECT_EQ(least_distance(measured), least_distance(held));
  for (std::size_t k = 0; k < held.contacts.size(); ++k) {
    const Contact &truth = measured.contacts[k], &contact = held.contacts[k];
    EXPECT_EQ(truth.object_patch, contact.object_patch);
    EXPECT_EQ(truth.scene_patch, contact.scene_patch);
    EXPECT_LE(std::fabs(truth.depth - contact.depth), contact.bound + 1e-12 * size);
    const double along = contact.normal.dot(contact.point - contact.scene_point);
    EXPECT_NEAR(along, contact.depth, 1e-12 * size);
  }
}

struct Counts {
  int not_measured = 0;  // contacts
  int apart = 0;         // frames in which the bodies are, though near
};

/// Pushes them apart wherever they are near, if that is asked.
Counts compare(const Asked& asked, double size, double step, bool stays_apart) {
  Flight flight{size, step};
  ContactFront measuring, holding;
  Counts counts;
  double tolerance = 0.02 * size;
  for (int i = 0; i < 400; ++i) {
    SCOPED_TRACE("frame " + std::to_string(i));
    flight.next(i);
    if (i % 7 == 0) tolerance = (i % 2 == 0 ? 0.02 : 0.04) * size;
    ContactQuery query{.tolerance = tolerance, .measures_hulls = true};
    const ContactSet measured = asked.ask(flight.pose, query, measuring);
    query.holds_near = true;
    query.resolution.carry = 1e-12;  // nothing is carried
    const ContactSet held = asked.ask(flight.pose, query, holding);
    expect_same_pairs(measured, held, size);
    for (const Contact& contact : held.contacts) counts.not_measured += contact.bound > 0.0 ? 1 : 0;
    const double gap = least_distance(measured);
    counts.apart += !held.contacts.empty() && gap > 0.0 ? 1 : 0;
    // Between near and far, never through.
    if (stays_apart) flight.pose.position *= gap < 0.3 * tolerance ? 1.02 : 0.998;
    if (::testing::Test::HasFailure()) break;
  }
  return counts;
}

Asked ring_on_block(double size) {
  return {build_exact_hierarchy(transformed(make_torus(0.6, 0.25, 32, 16), {}, size)),
          build_exact_hierarchy(transformed(make_box(Vec3(1.0, 1.0, 1.0), {6, 6, 6}), {}, size))};
}

TEST(HeldContacts, AreThePairsThatMeasuringFinds) {
  for (const double size : {1e-9, 1.0, 1e3})
    for (const double step : {1e-4, 3e-3}) {
      SCOPED_TRACE(std::to_string(size) + ", " + std::to_string(step));
      EXPECT_GT(compare(ring_on_block(size), size, step, false).not_measured, 1000);
      const Counts apart = compare(ring_on_block(size), size, step, true);
      EXPECT_GT(apart.not_measured, 300);
      EXPECT_GT(apart.apart, 100);
    }
}

/// The same of fronts with room for so many nodes and sets with room for so many contacts, fewer
/// than there are.
void compare_in_little_room(std::int32_t nodes, std::size_t contacts) {
  const Asked asked = ring_on_block(1.0);
  Flight flight{1.0, 3e-3};
  ContactFront measuring, holding;
  reserve_front(measuring, asked.object, asked.scene, nodes);
  reserve_front(holding, asked.object, asked.scene, nodes);
  int most_dropped = 0;
  for (int i = 0; i < 200; ++i) {
    flight.next(i);
    ContactQuery query{.tolerance = 0.04, .measures_hulls = true};
    const ContactSet measured = asked.ask(flight.pose, query, measuring, contacts);
    query.holds_near = true;
    query.resolution.carry = 1e-12;
    const ContactSet held = asked.ask(flight.pose, query, holding, contacts);
    EXPECT_EQ(measured.dropped, held.dropped) << i;
    most_dropped = std::max(most_dropped, static_cast<int>(held.dropped));
    expect_same_pairs(measured, held, 1.0);
    if (::testing::Test::HasFailure()) break;
  }
  EXPECT_GT(most_dropped, 5);
}

TEST(HeldContacts, OfMoreThanFitTheDeepestStay) { compare_in_little_room(0, 5); }

// Pairs below nodes that the front has no room to divide are found anew each time.
TEST(HeldContacts, WithLittleRoomInFrontAndSetTheDeepestStay) { compare_in_little_room(64, 24); }

}  // namespace
}  // namespace thigma
