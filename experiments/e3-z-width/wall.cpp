#include "experiments/e3-z-width/wall.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

namespace thigma::experiments {
namespace {

// Farther no wall of these holds a handle; two-sided ones are left before the actuators saturate
// [m].
constexpr double kGone = 1.0, kGoneTwoSided = 1e-4;

double force_of(const Wall& wall, double x, double before, double period) {
  if (!wall.is_two_sided && x <= 0.0) return 0.0;
  const double force = wall.stiffness * x + wall.damping * (x - before) / period;
  return wall.is_two_sided ? force : std::max(force, 0.0);
}

double peak_to_peak(const std::vector<double>& x, std::size_t from, std::size_t to) {
  const auto [low, high] = std::minmax_element(x.begin() + static_cast<std::ptrdiff_t>(from),
                                               x.begin() + static_cast<std::ptrdiff_t>(to));
  return *high - *low;
}

}  // namespace

std::vector<double> swing(const WallCase& c) {
  HandDevice hand(c.hand);
  const int ticks = static_cast<int>(std::lround(c.seconds / c.period));
  std::vector<double> positions;
  positions.reserve(static_cast<std::size_t>(ticks));
  double before = 0.0;
  for (int i = 0; i < ticks; ++i) {
    const double x = hand.read(i * c.period).motion.pose.position.x();
    const double blow = c.wall.is_two_sided && i == 0 ? 0.01 : 0.0;
    const double force = c.push + blow - force_of(c.wall, x, before, c.period);
    before = x;
    hand.write({{force, 0.0, 0.0}, Vec3::Zero()});
    positions.push_back(hand.true_motion().pose.position.x());
    if (!(std::fabs(positions.back()) < (c.wall.is_two_sided ? kGoneTwoSided : kGone))) break;
  }
  return positions;
}

double growth(const std::vector<double>& x, double seconds, double period) {
  const auto all = static_cast<std::size_t>(std::lround(seconds / period));
  if (x.size() < all) return std::numeric_limits<double>::infinity();
  const auto size = [&](std::size_t from, std::size_t to) {
    double most = 0.0;
    for (std::size_t i = from; i < to; ++i) most = std::max(most, std::fabs(x[i]));
    return most;
  };
  return size(all - all / 8, all) / size(all / 8, all / 4);
}

bool is_unstable(const WallCase& c) {
  const std::vector<double> x = swing(c);
  const auto all = static_cast<std::size_t>(std::lround(c.seconds / c.period));
  if (x.size() < all) return true;
  const double late = peak_to_peak(x, all - all / 3, all);
  const double least = std::max(2.0 * c.hand.encoder, 1e-6);
  const double half = peak_to_peak(x, all - all / 3, all - all / 6);
  return late > least || (late > 0.5 * least && late > 1.5 * half);
}

HandParams e3_device(char letter) {
  HandParams p;
  p.program.path = HandPath::rest;
  p.arm_mass = p.arm_stiffness = p.arm_damping = 0.0;
  p.max_force = 1000.0;
  if (letter == 'A') {
    p.mass = 0.1;
    p.damping = 0.1;
    p.friction = p.encoder = 0.0;
  } else if (letter == 'C') {
    p.mass = 2.0;
    p.damping = 2.0;
    p.friction = 0.5;
    p.encoder = 5e-6;
  }
  return p;
}

double largest_root(double alpha, double beta, int late) {
  // z^{late+3} - 2 z^{late+2} + z^{late+1} + ((alpha + beta) z^2 + alpha z - beta) / 2.
  const int n = late + 3;
  std::array<double, 16> c{};
  c[static_cast<std::size_t>(n - 1)] -= 2.0;
  c[static_cast<std::size_t>(n - 2)] += 1.0;
  c[2] += 0.5 * (alpha + beta);
  c[1] += 0.5 * alpha;
  c[0] -= 0.5 * beta;
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    companion(i, n - 1) = -c[static_cast<std::size_t>(i)];
    if (i > 0) companion(i, i - 1) = 1.0;
  }
  return companion.eigenvalues().cwiseAbs().maxCoeff();
}

double exact_boundary(double beta, int late) {
  double low = 0.0, high = 4.0;
  // Just above 0 the double root at 1 splits to the inside where there is a stable range at all.
  if (largest_root(1e-4, beta, late) >= 1.0) return 0.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (largest_root(middle, beta, late) < 1.0 ? low : high) = middle;
  }
  return low;
}

bool is_passive(const Wall& wall, double b, double T) {
  // Energy of x_1 .. x_N from rest to rest, sum of F_k (x_{k+1} - x_k) + b (x_{k+1} - x_k)^2 / T,
  // as a symmetric matrix of bandwidth two, of Toeplitz form.
  constexpr int kSamples = 2000;
  const double K = wall.stiffness, B = wall.damping;
  const double diagonal = -K - B / T + 2.0 * b / T;
  const double first = 0.5 * (K + 2.0 * B / T) - b / T;
  const double second = -0.5 * B / T;
  double d1 = 0.0, d2 = 0.0, l1 = 0.0;  // pivots one and two back, and the factor l_{k-1,k-2}
  for (int k = 0; k < kSamples; ++k) {
    const double far = k >= 2 ? second / d2 : 0.0;
    const double near = k >= 1 ? (first - (k >= 2 ? far * d2 * l1 : 0.0)) / d1 : 0.0;
    const double pivot =
        diagonal - (k >= 1 ? near * near * d1 : 0.0) - (k >= 2 ? far * far * d2 : 0.0);
    if (!(pivot > 0.0)) return false;
    d2 = d1;
    d1 = pivot;
    l1 = near;
  }
  return true;
}

}  // namespace thigma::experiments
