#include "benchmarks/probe.h"

#include <algorithm>
#include <cstddef>
#include <ctime>

#include "thigma/core/cpu_clock.h"
#include "thigma/math/quantile.h"

namespace thigma::bench {

double thread_cpu() { return thread_cpu_seconds(); }

double dependent_adds() {
  constexpr std::uint64_t kAdds = 20'000'000;
  double best = 0.0;
  for (int run = 0; run < 9; ++run) {
    std::uint64_t sum = 0;
    const double start = thread_cpu();
    for (std::uint64_t i = 0; i < kAdds; i += 10) {
      // Ten in a row that wait for each other; the compiler must not fold them.
      asm volatile(
          "add $1, %0\n add $1, %0\n add $1, %0\n add $1, %0\n add $1, %0\n"
          "add $1, %0\n add $1, %0\n add $1, %0\n add $1, %0\n add $1, %0"
          : "+r"(sum));
    }
    const double rate = static_cast<double>(kAdds) / (thread_cpu() - start) * 1e-9;
    best = std::max(best, rate);
  }
  return best;
}

std::vector<double> empty_loop_lateness(double duration) {
  std::vector<double> late;
  const std::size_t ticks = static_cast<std::size_t>(duration * 1000.0);
  late.reserve(ticks);
  timespec next{};
  clock_gettime(CLOCK_MONOTONIC, &next);
  for (std::size_t i = 0; i < ticks; ++i) {
    next.tv_nsec += 1'000'000;
    if (next.tv_nsec >= 1'000'000'000) {
      next.tv_nsec -= 1'000'000'000;
      ++next.tv_sec;
    }
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &next, nullptr);
    const double due = static_cast<double>(next.tv_sec) + 1e-9 * static_cast<double>(next.tv_nsec);
    late.push_back(std::max(0.0, clock_seconds(CLOCK_MONOTONIC) - due));
  }
  return late;
}

Figure figure_of(const std::vector<double>& samples, double factor) {
  return {factor * sample_quantile(samples, 0.5), factor * sample_quantile(samples, 0.99),
          factor * sample_quantile(samples, 0.999), factor * sample_quantile(samples, 1.0)};
}

}  // namespace thigma::bench
