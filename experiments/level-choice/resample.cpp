#include "experiments/level-choice/resample.h"

#include <cmath>

#include "thigma/math/quantile.h"
#include "thigma/math/random.h"

namespace thigma::experiments::level_choice {
namespace {

constexpr int kDraws = 2000;

double drawn_quotient(const PoseShare& share, const std::vector<std::size_t>& poses) {
  double over = 0.0, under = 0.0;
  for (const std::size_t i : poses) {
    over += share.over[i];
    under += share.under[i];
  }
  return over / under;
}

double drawn_spread(const std::vector<std::vector<double>>& values,
                    const std::vector<std::size_t>& poses) {
  std::vector<double> all;
  for (const std::size_t i : poses) all.insert(all.end(), values[i].begin(), values[i].end());
  return sample_quantile(all, 0.9) / sample_quantile(all, 0.1);
}

/// A figure of all poses, and what it is of poses drawn again.
template <class Figure>
Growth over_draws(std::size_t count, std::uint64_t seed, const Figure& figure) {
  std::vector<std::size_t> poses(count);
  for (std::size_t i = 0; i < count; ++i) poses[i] = i;
  Growth result{figure(poses), std::nan(""), std::nan("")};
  if (poses.empty()) return result;
  Random random(seed);
  std::vector<double> drawn;
  for (int k = 0; k < kDraws; ++k) {
    for (std::size_t& i : poses) i = random.below(count);
    const double one = figure(poses);
    if (std::isfinite(one)) drawn.push_back(one);
  }
  result.low = sample_quantile(drawn, 0.025);
  result.high = sample_quantile(drawn, 0.975);
  return result;
}

}  // namespace

Growth growth_between(const PoseShare& from, const PoseShare& to, bool is_squared,
                      std::uint64_t seed) {
  return over_draws(from.over.size(), seed, [&](const std::vector<std::size_t>& poses) {
    const double ratio = drawn_quotient(to, poses) / drawn_quotient(from, poses);
    return is_squared ? std::sqrt(ratio) : ratio;
  });
}

Growth spread_of(const std::vector<std::vector<double>>& values, std::uint64_t seed) {
  return over_draws(values.size(), seed, [&](const std::vector<std::size_t>& poses) {
    return drawn_spread(values, poses);
  });
}

}  // namespace thigma::experiments::level_choice
