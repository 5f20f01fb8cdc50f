#include "thigma/runtime/rt_thread.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <thread>

#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>
#include <time.h>

namespace thigma {
namespace {

std::int64_t clock_ns(clockid_t id) noexcept {
  timespec t{};
  clock_gettime(id, &t);
  return static_cast<std::int64_t>(t.tv_sec) * 1'000'000'000 + t.tv_nsec;
}

timespec to_timespec(std::int64_t ns) noexcept {
  return {static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)};
}

}  // namespace

RtGrant request_real_time(const RtRequest& request) {
  RtGrant grant;
  if (request.priority > 0) {
    sched_param param{};
    param.sched_priority = request.priority;
    const int error = pthread_setschedparam(pthread_self(), SCHED_FIFO, &param);
    grant.is_fifo = error == 0;
    if (error != 0) {
      grant.refused = std::string("no real-time priority (") + std::strerror(error) +
                      "): frames will be late under load; run as root or set `ulimit -r 99`";
    }
  }
  if (request.cpu >= 0) {
    cpu_set_t set;
    CPU_ZERO(&set);
    CPU_SET(static_cast<unsigned>(request.cpu), &set);
    const int error = pthread_setaffinity_np(pthread_self(), sizeof set, &set);
    grant.is_pinned = error == 0;
    if (error != 0) {
      if (!grant.refused.empty()) grant.refused += "; ";
      grant.refused += "not pinned to processor " + std::to_string(request.cpu) + " (" +
                       std::strerror(error) + ")";
    }
  }
  return grant;
}

std::string lock_process_memory() {
  if (mlockall(MCL_CURRENT | MCL_FUTURE) == 0) return {};
  return std::string("memory not locked (") + std::strerror(errno) +
         "): a page fault may delay a frame; run as root or set `ulimit -l unlimited`";
}

std::int64_t monotonic_ns() noexcept { return clock_ns(CLOCK_MONOTONIC); }
std::int64_t thread_cpu_ns() noexcept { return clock_ns(CLOCK_THREAD_CPUTIME_ID); }

void start_clock(DeadlineClock& clock) noexcept {
  clock.tick = 0;
  clock.missed = 0;
  clock.start_ns = monotonic_ns() + clock.period_ns;
}

std::int64_t wait_for_tick(DeadlineClock& clock) noexcept {
  std::int64_t now = monotonic_ns();
  std::int64_t deadline = clock.start_ns + clock.tick * clock.period_ns;
  if (now >= deadline + clock.period_ns) {
    const std::int64_t passed = (now - deadline) / clock.period_ns;
    clock.missed += static_cast<std::uint64_t>(passed);
    clock.tick += passed;
    deadline += passed * clock.period_ns;
  }
  const timespec wake = to_timespec(deadline - clock.spin_ns);
  if (now < deadline - clock.spin_ns) {
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) {
    }
  }
  do {
    now = monotonic_ns();
  } while (now < deadline);
  ++clock.tick;
  return now - deadline;
}

EmptyLoop measure_empty_loop(const RtRequest& request, double rate, double seconds) {
  EmptyLoop loop;
  std::thread([&] {
    request_real_time(request);
    DeadlineClock clock;
    clock.period_ns = static_cast<std::int64_t>(1e9 / rate);
    clock.spin_ns = std::min(clock.spin_ns, clock.period_ns / 4);
    const auto last = static_cast<std::int64_t>(seconds * rate);
    start_clock(clock);
    while (clock.tick < last) record(loop.wake_late, wait_for_tick(clock));
    loop.ticks = static_cast<std::uint64_t>(clock.tick);
    loop.missed = clock.missed;
  }).join();
  return loop;
}

void sleep_ns(std::int64_t nanoseconds) noexcept {
  const timespec t = to_timespec(nanoseconds);
  clock_nanosleep(CLOCK_MONOTONIC, 0, &t, nullptr);
}

}  // namespace thigma
