#include "thigma/session/rt_thread.h"

#include <thread>

#include <gtest/gtest.h>
#include <sched.h>

namespace thigma {
namespace {

TEST(DeadlineClock, TicksComeInOrderAndNeverEarly) {
  DeadlineClock clock;
  clock.period_ns = 500'000;
  start_clock(clock);
  for (int i = 0; i < 50; ++i) {
    const std::int64_t late = wait_for_tick(clock);
    const std::int64_t deadline = clock.start_ns + (clock.tick - 1) * clock.period_ns;
    EXPECT_GE(late, 0);
    EXPECT_GE(monotonic_ns(), deadline);
  }
  EXPECT_EQ(static_cast<std::uint64_t>(clock.tick), 50u + clock.missed);
}

TEST(DeadlineClock, LeavesOutTicksThatArePast) {
  DeadlineClock clock;
  start_clock(clock);
  wait_for_tick(clock);
  sleep_ns(10'500'000);
  wait_for_tick(clock);
  EXPECT_GE(clock.missed, 9u);
  EXPECT_EQ(static_cast<std::uint64_t>(clock.tick), 2u + clock.missed);
}

TEST(DeadlineClock, TheMarginFollowsHowLateWakeUpsAre) {
  constexpr std::int64_t kLeast = 20'000, kMost = 250'000;
  EXPECT_EQ(next_margin(50'000, 60'000, kLeast, kMost), 120'000);  // at once
  EXPECT_EQ(next_margin(50'000, 900'000, kLeast, kMost), kMost);
  std::int64_t margin = kMost;
  for (int i = 0; i < 5000; ++i) {  // and forgotten slowly
    const std::int64_t next = next_margin(margin, 1'000, kLeast, kMost);
    ASSERT_LE(next, margin);
    ASSERT_GE(next, margin - kMost / 256 - 1);
    margin = next;
  }
  EXPECT_EQ(margin, kLeast);
  EXPECT_EQ(next_margin(100'000, 900'000, 100'000, 100'000), 100'000);  // fixed
}

TEST(LookAgain, IsRareBeforeAndLongAfterSomethingIsDueAndOftenAbout) {
  constexpr std::int64_t kPeriod = 1'000'000;
  const auto looks = [](std::int64_t from, std::int64_t came) {  // until it came, due at 0
    int count = 0;
    for (std::int64_t now = from; now < came; ++count) now += look_again_in(now, 0, kPeriod);
    return count;
  };
  EXPECT_EQ(look_again_in(-900'000, 0, kPeriod), 850'000);
  EXPECT_LE(looks(-900'000, 40'000), 3);  // of 19 that would be by looks every 50 us
  EXPECT_EQ(look_again_in(0, 0, kPeriod), 50'000);
  EXPECT_EQ(look_again_in(1'000'000, 0, kPeriod), 250'000);
  EXPECT_EQ(look_again_in(3'600'000'000'000, 0, kPeriod), kPeriod);  // stands still for an hour
  EXPECT_EQ(look_again_in(0, 3'600'000'000'000, kPeriod), kPeriod);  // and never sleeps as long
  EXPECT_EQ(look_again_in(0, 0, 1), 50'000);                         // at any rate
}

TEST(DeadlineClock, LeavesTheProcessorFreeForHalfAPeriodAtLeast) {
  for (const double rate : {500.0, 1000.0, 5000.0, 10000.0}) {
    const DeadlineClock clock = clock_of(rate);
    EXPECT_EQ(clock.period_ns, static_cast<std::int64_t>(1e9 / rate));
    EXPECT_LE(clock.most_margin_ns, clock.period_ns / 2);
    EXPECT_LE(clock.least_margin_ns, clock.margin_ns);
    EXPECT_LE(clock.margin_ns, clock.most_margin_ns);
  }
  const DeadlineClock fixed = clock_of(1000.0, 3e-5);
  EXPECT_EQ(fixed.margin_ns, 30'000);
  EXPECT_EQ(fixed.least_margin_ns, fixed.most_margin_ns);
}

TEST(EmptyLoop, CountsEveryTickAndWhatItPolled) {
  const EmptyLoop loop = measure_empty_loop({0, -1}, 2000.0, 0.05);
  EXPECT_GE(loop.ticks, 100u);
  EXPECT_EQ(loop.wake_late.total + loop.missed, loop.ticks);
  EXPECT_GE(loop.polled_share, 0.0);
}

TEST(RtThread, AsksForNothingWhenNothingIsWanted) {
  RtGrant grant;
  int policy = -1;
  std::thread([&] {
    grant = request_real_time({0, -1});
    policy = sched_getscheduler(0);
  }).join();
  EXPECT_FALSE(grant.is_fifo);
  EXPECT_FALSE(grant.is_pinned);
  EXPECT_TRUE(grant.refused.empty());
  EXPECT_EQ(policy, SCHED_OTHER);
}

TEST(RtThread, SaysSoWhenTheSystemRefuses) {
  RtGrant grant;
  int policy = -1;
  std::thread([&] {
    grant = request_real_time({10, 100000});  // no such processor
    policy = sched_getscheduler(0);
  }).join();
  EXPECT_FALSE(grant.is_pinned);
  EXPECT_NE(grant.refused.find("processor 100000"), std::string::npos);
  EXPECT_EQ(grant.is_fifo, policy == SCHED_FIFO);
  EXPECT_EQ(grant.is_fifo, grant.refused.find("real-time priority") == std::string::npos);
}

TEST(RtThread, ClocksAdvance) {
  const std::int64_t wall = monotonic_ns(), cpu = thread_cpu_ns();
  volatile double x = 0.0;
  for (int i = 0; i < 100000; ++i) x = x + 1.0;
  EXPECT_GT(thread_cpu_ns(), cpu);
  EXPECT_GT(monotonic_ns(), wall);
}

}  // namespace
}  // namespace thigma
