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

}  // namespace

Growth growth_between(const PoseShare& from, const PoseShare& to, bool is_squared,
                      std::uint64_t seed) {
  const auto growth = [&](const std::vector<std::size_t>& poses) {
    const double ratio = drawn_quotient(to, poses) / drawn_quotient(from, poses);
    return is_squared ? std::sqrt(ratio) : ratio;
  };
  std::vector<std::size_t> poses(from.over.size());
  for (std::size_t i = 0; i < poses.size(); ++i) poses[i] = i;
  Growth result{growth(poses), std::nan(""), std::nan("")};
  if (poses.empty()) return result;
  Random random(seed);
  std::vector<double> drawn;
  for (int k = 0; k < kDraws; ++k) {
    for (std::size_t& i : poses) i = random.below(from.over.size());
    const double one = growth(poses);
    if (std::isfinite(one)) drawn.push_back(one);
  }
  result.low = sample_quantile(drawn, 0.025);
  result.high = sample_quantile(drawn, 0.975);
  return result;
}

}  // namespace thigma::experiments::level_choice
