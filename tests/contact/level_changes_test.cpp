#include "thigma/contact/level_changes.h"

#include <gtest/gtest.h>

#include "thigma/contact/contact_node.h"

namespace thigma {
namespace {

/// A tree of seven nodes: the root, two contact patches below it, four finest patches below those.
ClodHierarchy small_tree() {
  ClodHierarchy h;
  h.nodes.resize(7);
  h.nodes[0].first_child = 1;
  h.nodes[0].child_count = 2;
  h.nodes[1].first_child = 3;
  h.nodes[1].child_count = 2;
  h.nodes[2].first_child = 5;
  h.nodes[2].child_count = 2;
  h.patches.resize(4);
  for (int i = 0; i < 4; ++i) h.patches[static_cast<std::size_t>(i)].node = 3 + i;
  h.level_patches.resize(2);
  for (int i = 0; i < 2; ++i) h.level_patches[static_cast<std::size_t>(i)].patch.node = 1 + i;
  return h;
}

constexpr std::int32_t kFine = 0;    // patches 0..3
constexpr std::int32_t kCoarse = 4;  // contact patches 4, 5

Contact touching(std::int32_t object, std::int32_t scene) {
  Contact c;
  c.object_patch = object;
  c.scene_patch = scene;
  return c;
}

struct Frames {
  ClodHierarchy tree = small_tree();
  std::vector<SceneBody> scene{{&tree, Pose{}}};
  LevelHistory history;

  Frames() { reserve_level_history(tree, scene, 16, history); }
  std::int32_t next(const std::vector<Contact>& contacts) { return changes(contacts).all; }
  LevelChanges changes(const std::vector<Contact>& contacts) {
    return count_level_changes(tree, scene, contacts, 1e-3, history);
  }
};

TEST(ContactNode, IsThatOfTheFinestOrTheContactPatch) {
  const ClodHierarchy tree = small_tree();
  EXPECT_EQ(contact_node(tree, 2), 5);
  EXPECT_EQ(contact_node(tree, kCoarse + 1), 2);
  EXPECT_EQ(contact_node(tree, -1), -1);
  EXPECT_EQ(contact_node(tree, 6), -1);
}

TEST(LevelChanges, NothingChangesWhereContactsStayBeginOrEnd) {
  Frames f;
  EXPECT_EQ(f.next({touching(kCoarse, kCoarse)}), 0);
  EXPECT_EQ(f.next({touching(kCoarse, kCoarse)}), 0);
  EXPECT_EQ(f.next({touching(kCoarse, kCoarse), touching(kFine + 2, kFine + 3)}), 0);
  EXPECT_EQ(f.next({touching(kFine + 2, kFine + 3)}), 0);
  EXPECT_EQ(f.next({}), 0);
}

TEST(LevelChanges, RefiningAndCoarseningOfEitherSideCount) {
  Frames f;
  f.next({touching(kCoarse, kCoarse)});
  EXPECT_EQ(f.next({touching(kFine, kCoarse), touching(kFine + 1, kCoarse)}), 2);
  EXPECT_EQ(f.next({touching(kFine, kCoarse), touching(kFine + 1, kCoarse)}), 0);
  EXPECT_EQ(f.next({touching(kFine, kFine + 1), touching(kFine + 1, kCoarse)}), 1);
  EXPECT_EQ(f.next({touching(kCoarse, kCoarse)}), 2);
  EXPECT_EQ(f.next({touching(kFine, kFine)}), 1);  // both sides at once
}

TEST(LevelChanges, OfPressingContactsAreThoseThatPressBeforeOrAfter) {
  const auto apart = [](Contact c) {
    c.depth = -1.1e-3;
    return c;
  };
  const Contact coarse = touching(kCoarse, kCoarse), fine = touching(kFine, kCoarse);
  for (const bool is_refined : {true, false}) {
    const Contact &before = is_refined ? coarse : fine, &after = is_refined ? fine : coarse;
    Frames f;
    f.next({apart(before)});
    const LevelChanges far = f.changes({apart(after)});
    EXPECT_GT(far.all, 0);
    EXPECT_EQ(far.pressing, 0);
    f.next({});
    f.next({before});
    EXPECT_GT(f.changes({apart(after)}).pressing, 0);
    f.next({});
    f.next({apart(before)});
    EXPECT_GT(f.changes({after}).pressing, 0);
  }
}

TEST(LevelChanges, BlendsCountWhereTheyBeginAndWhereTheyEnd) {
  Frames f;
  f.next({touching(kCoarse, kCoarse)});
  EXPECT_EQ(f.next({touching(kCoarse, kCoarse), touching(kFine, kCoarse)}), 1);
  EXPECT_EQ(f.next({touching(kCoarse, kCoarse), touching(kFine, kCoarse)}), 0);
  EXPECT_EQ(f.next({touching(kFine, kCoarse)}), 1);
  EXPECT_EQ(f.next({touching(kCoarse, kCoarse), touching(kFine, kCoarse)}), 1);
  EXPECT_EQ(f.next({touching(kCoarse, kCoarse)}), 1);
}

}  // namespace
}  // namespace thigma
