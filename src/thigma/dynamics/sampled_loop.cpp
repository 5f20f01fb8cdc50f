#include "thigma/dynamics/sampled_loop.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "thigma/math/types.h"

namespace thigma {
namespace {

// grown by this within an eighth of the frames, nothing is left to measure
constexpr double kFar = 1e200;

// Position and velocity of handle and arm after a period under a constant force: (x, v, f) -> (x',
// v', f).
Mat3 held_force_step(const SampledLoop& loop) {
  const double mass = loop.handle_mass + loop.arm_mass;
  Mat3 rate = Mat3::Zero();
  rate(0, 1) = 1.0;
  rate.row(1) << -loop.arm_stiffness / mass, -(loop.arm_damping + loop.handle_damping) / mass,
      1.0 / mass;
  // Scaling and squaring: after it the series needs few terms.
  const double size = loop.period * rate.cwiseAbs().rowwise().sum().maxCoeff();
  const int halvings = size > 0.25 ? static_cast<int>(std::ceil(std::log2(size / 0.25))) : 0;
  const Mat3 step = std::ldexp(loop.period, -halvings) * rate;
  constexpr int kTerms = 12;  // 0.25^13 / 13! is far below rounding
  Mat3 sum = Mat3::Identity(), term = Mat3::Identity();
  for (int i = 1; i <= kTerms; ++i) {
    term = Mat3(term * step) / i;
    sum += term;
  }
  for (int i = 0; i < halvings; ++i) sum = Mat3(sum * sum);
  return sum;
}

// Samples of the handle's position as they arrive, linear between frames.
class LateSamples {
 public:
  explicit LateSamples(double delay_in_frames)
      : whole_(static_cast<std::size_t>(delay_in_frames)),
        part_(delay_in_frames - static_cast<double>(whole_)),
        ring_(whole_ + 2, 0.0) {}

  double arrive(double position) {
    ring_[newest_] = position;
    const std::size_t n = ring_.size();
    const double late = ring_[(newest_ + n - whole_) % n];
    const double later = ring_[(newest_ + n - whole_ - 1) % n];
    newest_ = (newest_ + 1) % n;
    return (1.0 - part_) * late + part_ * later;
  }
  void scale(double factor) {
    for (double& each : ring_) each *= factor;
  }

 private:
  std::size_t whole_;
  double part_;
  std::vector<double> ring_;
  std::size_t newest_ = 0;
};

}  // namespace

double loop_growth(const SampledLoop& loop, int frames) {
  assert(loop.period > 0.0 && loop.handle_mass + loop.arm_mass > 0.0 && loop.body_mass > 0.0);
  assert(frames >= 16);
  const double T = loop.period, k_c = loop.coupling_stiffness, b_c = loop.coupling_damping;
  const double k = loop.contact_stiffness, b = loop.contact_damping;
  const Mat3 held = held_force_step(loop);
  const bool is_held = std::isinf(loop.body_mass);
  const double inertia = is_held ? 0.0 : loop.body_mass / T;
  const double resistance = inertia + b_c + b + T * (k_c + k);
  LateSamples samples(loop.delay / T);

  double x = 1.0, v = 0.0, body_x = 0.0, body_v = 0.0, last = 0.0;
  // The largest swing of each eighth, after which everything is brought to the size of one again:
  // whatever a loop does, it neither overflows nor dies to nothing.
  constexpr int kBlocks = 8;
  double log_size[kBlocks] = {}, log_scale = 0.0;
  for (int block = 0; block < kBlocks; ++block) {
    double most = 0.0;
    for (int n = 0; n < frames / kBlocks && most < kFar; ++n) {
      const double sample = samples.arrive(x);
      const double rate = (sample - last) / T;
      last = sample;
      // Backward Euler of the body with the sample just read (Eq. 5.7 on one axis).
      if (!is_held) {
        body_v =
            (inertia * body_v + k_c * (sample - body_x) + b_c * rate - k * body_x) / resistance;
        body_x += T * body_v;
      }
      const double pull = k_c * (sample - body_x) + b_c * (rate - body_v);
      const double next_x = held(0, 0) * x + held(0, 1) * v - held(0, 2) * pull;
      v = held(1, 0) * x + held(1, 1) * v - held(1, 2) * pull;
      x = next_x;
      most = std::max({most, std::fabs(x), std::fabs(body_x)});
    }
    if (!(most < kFar)) return 2.0;
    if (!(most > 0.0)) return 0.0;
    log_size[block] = std::log(most) + log_scale;
    log_scale = log_size[block];
    for (double* each : {&x, &v, &body_x, &body_v, &last}) *each /= most;
    samples.scale(1.0 / most);
  }
  const int distance = (kBlocks / 2) * (frames / kBlocks);
  return std::exp((log_size[kBlocks - 1] - log_size[kBlocks / 2 - 1]) / distance);
}

}  // namespace thigma
