#pragma once
// Distribution of durations, recorded without allocating.

#include <array>
#include <cstdint>

#include "thigma/core/rt.h"

namespace thigma {

/// Counts of durations in buckets of 1/32 octave from 1 ns to 584 years: percentiles good to 2 %,
/// maximum exact. Thread: one writer; read after it has stopped.
struct DurationHistogram {
  static constexpr int kSubBits = 5;  // 32 buckets an octave
  static constexpr int kBuckets = (64 - kSubBits + 1) << kSubBits;
  std::array<std::uint32_t, kBuckets> counts{};
  std::uint64_t total = 0;
  std::uint64_t max_ns = 0;
};

/// Adds a duration [ns]; negative ones count as 0.
/// Thread    [haptic].
void record(DurationHistogram& histogram, std::int64_t nanoseconds) THIGMA_RT;

/// Adds all durations of one to another.
/// Thread    [offline].
void add(const DurationHistogram& from, DurationHistogram& to) noexcept;

/// The value that a share `quantile` (0..1) of the durations does not exceed [s]: middle of its
/// bucket, never above the maximum; 0 without one.
/// Thread    [any].
double quantile(const DurationHistogram& histogram, double quantile) noexcept;

/// What summaries report of a distribution [s].
struct DurationSummary {
  double p50 = 0.0, p99 = 0.0, p999 = 0.0, p9999 = 0.0, max = 0.0;
  std::uint64_t count = 0;
};
DurationSummary summarize(const DurationHistogram& histogram) noexcept;

/// Where a haptic frame's time goes, by the clock; nothing in lockstep [s].
struct StageSummary {
  DurationSummary device_read, compute, device_write, whole;
};

/// Wake-ups later than these are counted [ns].
inline constexpr std::array<std::int64_t, 3> kLateBounds = {100'000, 200'000, 1'000'000};

/// How punctual the haptic thread was; nothing in lockstep.
struct DeadlineSummary {
  // frames that ended after the next deadline
  std::uint64_t overruns = 0;
  std::array<std::uint64_t, kLateBounds.size()> late{};  // wake-ups later than each of kLateBounds
  double polled_share = 0.0;  // of the time: processor spent on being punctual
};

/// All durations of a stage.
struct StageHistogram {
  const char* name;
  DurationHistogram histogram;
};

/// Durations as lists of numbers tell them.
struct Quantiles {
  const DurationSummary& durations;  // null where there are none
  double unit;                       // [s]
  bool has_tail = true;              // p999 and p9999 as well
};

/// Bounds of a bucket: durations from `from` up to, not including, `to` are counted in it [ns].
/// bucket    0 to kBuckets - 1
struct BucketBounds {
  double from = 0.0, to = 0.0;
};
BucketBounds bucket_bounds(int bucket) noexcept;

}  // namespace thigma
