#include "thigma/session/histogram.h"

#include <algorithm>
#include <bit>

namespace thigma {
namespace {

constexpr int kSub = 1 << DurationHistogram::kSubBits;

// Values below 32 have a bucket each; above, the five bits after the leading one choose within the
// octave.
int bucket_of(std::uint64_t v) THIGMA_RT {
  if (v < kSub) return static_cast<int>(v);
  const int shift = static_cast<int>(std::bit_width(v)) - 1 - DurationHistogram::kSubBits;
  return ((shift + 1) << DurationHistogram::kSubBits) + static_cast<int>((v >> shift) - kSub);
}

double middle_of(int bucket) {
  const BucketBounds bounds = bucket_bounds(bucket);
  return bucket < kSub ? bounds.from : 0.5 * (bounds.from + bounds.to);
}

}  // namespace

BucketBounds bucket_bounds(int bucket) noexcept {
  if (bucket < kSub) return {static_cast<double>(bucket), static_cast<double>(bucket + 1)};
  const int shift = (bucket >> DurationHistogram::kSubBits) - 1;
  const double width = static_cast<double>(std::uint64_t{1} << shift);
  const double from = static_cast<double>(kSub + (bucket & (kSub - 1))) * width;
  return {from, from + width};
}

void record(DurationHistogram& histogram, std::int64_t nanoseconds) THIGMA_RT {
  const std::uint64_t v = nanoseconds > 0 ? static_cast<std::uint64_t>(nanoseconds) : 0;
  ++histogram.counts[static_cast<std::size_t>(bucket_of(v))];
  ++histogram.total;
  histogram.max_ns = std::max(histogram.max_ns, v);
}

void add(const DurationHistogram& from, DurationHistogram& to) noexcept {
  for (std::size_t i = 0; i < to.counts.size(); ++i) to.counts[i] += from.counts[i];
  to.total += from.total;
  to.max_ns = std::max(to.max_ns, from.max_ns);
}

double quantile(const DurationHistogram& histogram, double quantile) noexcept {
  if (histogram.total == 0) return 0.0;
  const double target = quantile * static_cast<double>(histogram.total);
  std::uint64_t seen = 0;
  for (int i = 0; i < DurationHistogram::kBuckets; ++i) {
    seen += histogram.counts[static_cast<std::size_t>(i)];
    if (static_cast<double>(seen) >= target && seen > 0) {
      return 1e-9 * std::min(middle_of(i), static_cast<double>(histogram.max_ns));
    }
  }
  return 1e-9 * static_cast<double>(histogram.max_ns);
}

DurationSummary summarize(const DurationHistogram& histogram) noexcept {
  return {quantile(histogram, 0.5),
          quantile(histogram, 0.99),
          quantile(histogram, 0.999),
          quantile(histogram, 0.9999),
          1e-9 * static_cast<double>(histogram.max_ns),
          histogram.total};
}

}  // namespace thigma
