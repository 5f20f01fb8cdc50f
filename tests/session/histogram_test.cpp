#include "thigma/session/histogram.h"

#include <algorithm>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "thigma/math/random.h"

namespace thigma {
namespace {

TEST(DurationHistogram, KnowsNothingAtFirst) {
  const DurationHistogram empty;
  EXPECT_EQ(quantile(empty, 0.5), 0.0);
  EXPECT_EQ(summarize(empty).count, 0u);
}

TEST(DurationHistogram, QuantilesAreWithinTwoPercentOfTheSortedOnes) {
  Random random(7);
  for (const double scale : {20.0, 1e3, 1e6, 1e9, 1e15}) {
    DurationHistogram histogram;
    std::vector<std::int64_t> all;
    for (int i = 0; i < 5000; ++i) {
      const double u = random.uniform();
      all.push_back(static_cast<std::int64_t>(scale * (1.0 + 50.0 * u * u * u)));
      record(histogram, all.back());
    }
    std::sort(all.begin(), all.end());
    for (const double q : {0.01, 0.5, 0.99, 0.999}) {
      const auto index = static_cast<std::size_t>(q * 5000.0 + 0.5) - 1;
      const double exact = 1e-9 * static_cast<double>(all[index]);
      EXPECT_NEAR(quantile(histogram, q), exact, 0.02 * exact + 0.5e-9) << scale << ' ' << q;
    }
    EXPECT_DOUBLE_EQ(summarize(histogram).max, 1e-9 * static_cast<double>(all.back()));
  }
}

TEST(DurationHistogram, EveryDurationLiesWithinTheBoundsOfItsBucket) {
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    const auto duration = static_cast<std::int64_t>(1ull << (random.below(40))) +
                          static_cast<std::int64_t>(random.below(1000));
    DurationHistogram histogram;
    record(histogram, duration);
    const auto found = std::find(histogram.counts.begin(), histogram.counts.end(), 1u);
    const BucketBounds bounds = bucket_bounds(static_cast<int>(found - histogram.counts.begin()));
    EXPECT_LE(bounds.from, static_cast<double>(duration));
    EXPECT_LT(static_cast<double>(duration), bounds.to);
  }
  for (int i = 1; i < DurationHistogram::kBuckets; ++i)
    ASSERT_EQ(bucket_bounds(i).from, bucket_bounds(i - 1).to) << i;
}

TEST(DurationHistogram, TakesExtremes) {
  DurationHistogram histogram;
  record(histogram, -5);
  record(histogram, std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(histogram.total, 2u);
  EXPECT_EQ(quantile(histogram, 0.5), 0.0);
  EXPECT_GT(quantile(histogram, 1.0), 9e9);
}

TEST(DurationHistogram, AddedUpItIsAsIfAllHadBeenRecordedInOne) {
  DurationHistogram first, second, both;
  for (const std::int64_t ns : {5, 70, 900'000}) {
    record(first, ns);
    record(second, 3 * ns);
    record(both, ns);
    record(both, 3 * ns);
  }
  add(second, first);
  EXPECT_EQ(first.counts, both.counts);
  EXPECT_EQ(first.total, both.total);
  EXPECT_EQ(first.max_ns, both.max_ns);
}

}  // namespace
}  // namespace thigma
