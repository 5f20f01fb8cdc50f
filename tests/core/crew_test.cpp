#include "thigma/core/crew.h"

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace thigma {
namespace {

TEST(Crew, DoesEachPieceOnceInManyRounds) {
  for (const int threads : {1, 2, 5}) {
    Crew crew(threads);
    EXPECT_EQ(crew.threads(), threads);
    std::vector<int> done;
    std::vector<std::atomic<int>> inside(static_cast<std::size_t>(threads));
    std::atomic<bool> is_shared{false};
    for (std::size_t count = 0; count < 400; ++count) {
      done.assign(count, 0);
      crew.for_each(count, [&](std::size_t piece, std::size_t thread) {
        if (++inside.at(thread) > 1) is_shared = true;
        ++done[piece];
        --inside[thread];
      });
      ASSERT_EQ(done, std::vector<int>(count, 1)) << threads;
    }
    EXPECT_FALSE(is_shared) << "a thread had two pieces at a time";
  }
}

TEST(Crew, SharesPiecesThatTakeLong) {
  Crew crew(3);
  std::atomic<int> inside{0}, most{0};
  crew.for_each(3, [&](std::size_t, std::size_t) {
    const int now = ++inside;
    for (int seen = most; seen < now && !most.compare_exchange_weak(seen, now);) {
    }
    // Until others have come too, or for as long as no machine is busy.
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (most < 2 && std::chrono::steady_clock::now() < end) std::this_thread::yield();
    --inside;
  });
  EXPECT_GE(most, 2);
}

TEST(Crew, SleepsBetweenRoundsAndWakes) {
  Crew crew(4);
  std::atomic<int> sum{0};
  for (int round = 0; round < 5; ++round) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    crew.for_each(100, [&](std::size_t piece, std::size_t) { sum += static_cast<int>(piece); });
  }
  EXPECT_EQ(sum, 5 * 4950);
}

TEST(Crew, EndsWithoutHavingWorked) { EXPECT_EQ(Crew(8).threads(), 8); }

}  // namespace
}  // namespace thigma
