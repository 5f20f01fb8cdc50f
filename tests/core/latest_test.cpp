#include "thigma/core/latest.h"

#include <array>
#include <thread>

#include <gtest/gtest.h>

namespace thigma {
namespace {

struct Numbered {
  std::array<std::uint64_t, 64> words{};
};

TEST(Latest, IsEmptyUntilPublished) {
  Latest<int> latest;
  EXPECT_FALSE(latest.fetch());
  EXPECT_EQ(latest.value(), 0);
}

TEST(Latest, GivesTheNewestOnce) {
  Latest<int> latest;
  latest.publish(1);
  latest.publish(2);
  EXPECT_TRUE(latest.fetch());
  EXPECT_EQ(latest.value(), 2);
  EXPECT_FALSE(latest.fetch());
  EXPECT_EQ(latest.value(), 2);
  latest.draft() = 3;
  latest.publish();
  EXPECT_TRUE(latest.fetch());
  EXPECT_EQ(latest.value(), 3);
}

TEST(Latest, OffersTheNewestUntilItIsTaken) {
  Latest<int> latest;
  EXPECT_EQ(latest.offered(), nullptr);
  latest.publish(1);
  ASSERT_NE(latest.offered(), nullptr);
  EXPECT_EQ(*latest.offered(), 1);
  EXPECT_EQ(latest.value(), 0);
  EXPECT_EQ(*latest.offered(), 1);  // not taken: offered again
  latest.publish(2);
  latest.publish(3);
  EXPECT_EQ(*latest.offered(), 3);
  latest.take();
  EXPECT_EQ(latest.value(), 3);
  EXPECT_EQ(latest.offered(), nullptr);
  latest.publish(4);
  EXPECT_EQ(*latest.offered(), 4);
  EXPECT_EQ(latest.value(), 3);  // what it has stays whole beside
  EXPECT_TRUE(latest.fetch());
  EXPECT_EQ(latest.value(), 4);
}

TEST(Latest, NeverTearsAndNeverGoesBack) {
  Latest<Numbered> latest;
  constexpr std::uint64_t kLast = 20000;
  std::thread writer([&latest] {
    for (std::uint64_t k = 1; k <= kLast; ++k) {
      latest.draft().words.fill(k);
      latest.publish();
    }
  });
  std::uint64_t seen = 0;
  bool is_whole = true, is_ordered = true;
  while (seen < kLast) {
    if (!latest.fetch()) continue;
    const Numbered& value = latest.value();
    for (const std::uint64_t word : value.words) is_whole = is_whole && word == value.words[0];
    is_ordered = is_ordered && value.words[0] > seen;
    seen = value.words[0];
  }
  writer.join();
  EXPECT_TRUE(is_whole);
  EXPECT_TRUE(is_ordered);
}

}  // namespace
}  // namespace thigma
