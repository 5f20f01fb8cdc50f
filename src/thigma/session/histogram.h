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

/// Bounds of a bucket: durations from `from` up to, not including, `to` are counted in it [ns].
/// bucket    0 to kBuckets - 1
struct BucketBounds {
  double from = 0.0, to = 0.0;
};
BucketBounds bucket_bounds(int bucket) noexcept;

}  // namespace thigma
