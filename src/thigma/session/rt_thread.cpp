#include "thigma/session/rt_thread.h"

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

DeadlineClock clock_of(double rate, double margin) noexcept {
  DeadlineClock clock;
  clock.period_ns = std::max<std::int64_t>(1, static_cast<std::int64_t>(1e9 / rate));
  if (margin >= 0.0) {
    clock.margin_ns = std::min(static_cast<std::int64_t>(1e9 * margin), clock.period_ns);
    clock.least_margin_ns = clock.most_margin_ns = clock.margin_ns;
    return clock;
  }
  // More than half a period were a thread that never sleeps, which the kernel throttles.
  clock.most_margin_ns = std::min(clock.most_margin_ns, clock.period_ns / 2);
  clock.least_margin_ns = std::min(clock.least_margin_ns, clock.most_margin_ns);
  clock.margin_ns = std::min(clock.margin_ns, clock.most_margin_ns);
  return clock;
}

std::int64_t next_margin(std::int64_t margin_ns, std::int64_t overslept_ns, std::int64_t least_ns,
                         std::int64_t most_ns) noexcept {
  constexpr std::int64_t kSafety = 2, kMemory = 256;
  const std::int64_t wanted = std::clamp(kSafety * overslept_ns, least_ns, most_ns);
  if (wanted >= margin_ns) return wanted;
  return std::clamp(margin_ns - (margin_ns - wanted + kMemory - 1) / kMemory, least_ns, most_ns);
}

std::int64_t look_again_in(std::int64_t now_ns, std::int64_t expected_ns,
                           std::int64_t period_ns) noexcept {
  constexpr std::int64_t kLook = 50'000, kRarer = 4;
  const std::int64_t early = expected_ns - kLook - now_ns;
  if (early > kLook) return std::min(early, period_ns);
  const std::int64_t most = std::max(kLook, period_ns);
  return std::clamp((now_ns - expected_ns) / kRarer, kLook, most);
}

void start_clock(DeadlineClock& clock) noexcept {
  clock.tick = 0;
  clock.missed = 0;
  clock.polled_ns = 0;
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
  const std::int64_t wake_ns = deadline - clock.margin_ns;
  if (now < wake_ns) {
    const timespec wake = to_timespec(wake_ns);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) == EINTR) {
    }
    now = monotonic_ns();
    clock.margin_ns =
        next_margin(clock.margin_ns, now - wake_ns, clock.least_margin_ns, clock.most_margin_ns);
  }
  const std::int64_t polls_from = now;
  while (now < deadline) now = monotonic_ns();
  clock.polled_ns += now - polls_from;
  ++clock.tick;
  return now - deadline;
}

std::uint64_t come_to_tick(std::int64_t now_ns, bool has_begun, DeadlineClock& clock) THIGMA_RT {
  const std::int64_t period = clock.period_ns;
  if (!has_begun) clock.start_ns = now_ns;
  const std::int64_t due = clock.start_ns + clock.tick * period;
  std::int64_t passed = 0;
  if (now_ns - due >= period) {
    passed = (now_ns - due) / period;
    clock.missed += static_cast<std::uint64_t>(passed);
    clock.tick += passed;
  } else if (due - now_ns > period / 2) {
    clock.start_ns -= due - now_ns - period / 2;
  }
  ++clock.tick;
  return static_cast<std::uint64_t>(passed);
}

EmptyLoop measure_empty_loop(const RtRequest& request, double rate, double seconds, double margin) {
  EmptyLoop loop;
  std::thread([&] {
    request_real_time(request);
    DeadlineClock clock = clock_of(rate, margin);
    const auto last = static_cast<std::int64_t>(seconds * rate);
    start_clock(clock);
    while (clock.tick < last) record(loop.wake_late, wait_for_tick(clock));
    loop.ticks = static_cast<std::uint64_t>(clock.tick);
    loop.missed = clock.missed;
    const std::int64_t whole = std::max<std::int64_t>(1, clock.tick * clock.period_ns);
    loop.polled_share = static_cast<double>(clock.polled_ns) / static_cast<double>(whole);
  }).join();
  return loop;
}

void sleep_ns(std::int64_t nanoseconds) noexcept {
  const timespec t = to_timespec(nanoseconds);
  clock_nanosleep(CLOCK_MONOTONIC, 0, &t, nullptr);
}

}  // namespace thigma
