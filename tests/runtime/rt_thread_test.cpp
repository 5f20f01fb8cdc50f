#include "thigma/runtime/rt_thread.h"

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
