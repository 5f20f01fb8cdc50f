#include "thigma/contact/front.h"

#include <gtest/gtest.h>

#include "thigma/clod/build_hierarchy.h"
#include "thigma/contact/query_contacts.h"
#include "thigma/mesh/shapes.h"

namespace thigma {
namespace {

TEST(Front, TakesMemoryOnceAndForgetsOnRequest) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 6));
  ContactFront front;
  reserve_front(front, ball, ball);
  EXPECT_EQ(front.capacity, default_front_capacity(ball, ball));
  const FrontNode* nodes = front.nodes.get();
  ContactSet set;
  set.contacts.reserve(10'000);
  Pose pose;
  pose.position = Vec3(2.01, 0, 0);
  query_contacts({ball, pose}, {ball}, {.tolerance = 0.05}, front, set);
  EXPECT_GT(front.alive, 1);
  clear_front(front);
  EXPECT_EQ(front.alive, 0);
  EXPECT_EQ(front.nodes.get(), nodes);
  const std::size_t before = set.contacts.size();
  query_contacts({ball, pose}, {ball}, {.tolerance = 0.05}, front, set);
  EXPECT_EQ(set.contacts.size(), 2 * before);
  EXPECT_EQ(front.nodes.get(), nodes);
}

TEST(Front, OfOtherBodiesIsStartedAfresh) {
  const ClodHierarchy ball = build_exact_hierarchy(make_ball(1.0, 6));
  const ClodHierarchy box = build_exact_hierarchy(make_box(Vec3(2, 2, 2), {3, 3, 3}));
  ContactFront used, fresh;
  ContactSet set, want;
  set.contacts.reserve(1000);
  want.contacts.reserve(1000);
  Pose pose;
  pose.position = Vec3(2.01, 0, 0);
  query_contacts({ball, pose}, {ball}, {.tolerance = 0.05}, used, set);
  clear(set);
  query_contacts({ball, pose}, {box}, {.tolerance = 0.05}, used, set);
  query_contacts({ball, pose}, {box}, {.tolerance = 0.05}, fresh, want);
  ASSERT_EQ(set.contacts.size(), want.contacts.size());
  for (std::size_t i = 0; i < set.contacts.size(); ++i) {
    EXPECT_EQ(set.contacts[i].depth, want.contacts[i].depth);
    EXPECT_EQ(set.contacts[i].scene_patch, want.contacts[i].scene_patch);
  }
}

}  // namespace
}  // namespace thigma
