#include "thigma/core/spsc_ring.h"

#include <thread>

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(SpscRing, KeepsOrderDropsAndCounts) {
  SpscRing<int> ring(3);
  ASSERT_EQ(ring.capacity(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.push(i));
  EXPECT_FALSE(ring.push(4));
  EXPECT_FALSE(ring.push(5));
  EXPECT_EQ(ring.dropped(), 2u);
  for (int i = 0; i < 4; ++i) {
    ASSERT_NE(ring.front(), nullptr);
    EXPECT_EQ(*ring.front(), i);
    ring.pop();
  }
  EXPECT_EQ(ring.front(), nullptr);
  EXPECT_TRUE(ring.push(6));
  EXPECT_EQ(*ring.front(), 6);
}

TEST(SpscRing, LosesNothingItDidNotCount) {
  SpscRing<std::uint64_t> ring(64);
  constexpr std::uint64_t kCount = 100000;
  std::thread writer([&ring, kCount] {
    for (std::uint64_t k = 0; k < kCount; ++k) {
      ring.push(k);
      if (k % 64 == 0) std::this_thread::yield();
    }
    while (!ring.push(kCount)) std::this_thread::yield();  // the end mark gets through
  });
  std::uint64_t received = 0, expected = 0;
  bool is_ordered = true;
  for (;;) {
    const std::uint64_t* value = ring.front();
    if (value == nullptr) {
      std::this_thread::yield();
      continue;
    }
    if (*value == kCount) break;
    is_ordered = is_ordered && *value >= expected;
    expected = *value + 1;
    ring.pop();
    ++received;
  }
  writer.join();
  EXPECT_TRUE(is_ordered);
  EXPECT_GE(received + ring.dropped(), kCount);  // end marks that did not fit count as dropped too
  EXPECT_GT(received, 0u);
}

}  // namespace
}  // namespace thigma
