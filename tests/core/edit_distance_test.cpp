#include "thigma/core/edit_distance.h"

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(EditDistance, CountsLettersPutInLeftOutAndChanged) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("", "abc"), 3u);
  EXPECT_EQ(edit_distance("tabel", "table"), 2u);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("sitting", "kitten"), 3u);
}

}  // namespace
}  // namespace thigma
