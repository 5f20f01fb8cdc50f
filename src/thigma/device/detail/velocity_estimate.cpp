#include "thigma/device/detail/velocity_estimate.h"

#include <algorithm>
#include <limits>

#include "thigma/math/rotation.h"

namespace thigma::detail {
namespace {

// One axis: slopes that pass within `step` of every sample seen so far, and the longest window's
// slope among them.
struct SlopeCone {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  double slope = 0.0;
  bool is_open = true;

  // drop: newest value minus that of `age` seconds before.
  void add(double drop, double age, double step) THIGMA_RT {
    if (!is_open) return;
    const double candidate = drop / age;
    if (candidate < low || candidate > high) {
      is_open = false;
      return;
    }
    slope = candidate;
    low = std::max(low, (drop - step) / age);
    high = std::min(high, (drop + step) / age);
  }
};

}  // namespace

const Twist& VelocityEstimate::update(double time, const Pose& pose) THIGMA_RT {
  if (count_ > 0 && time < back(0).time) count_ = 0;
  if (count_ > 0 && !(time > back(0).time)) return twist_;
  newest_ = (newest_ + 1) % kSamples;
  samples_[newest_] = {time, pose};
  count_ = std::min(count_ + 1, kSamples);

  SlopeCone linear[3];
  SlopeCone angular[3];
  for (std::size_t i = 1; i < count_; ++i) {
    const Sample& old = back(i);
    const double age = time - old.time;
    // The first difference always counts, however slowly samples come.
    const bool in_linear = i == 1 || age <= window_;
    const bool in_angular = i == 1 || age <= angular_window_;
    if (!in_linear && !in_angular) break;
    const Vec3 drop = pose.position - old.pose.position;
    for (int k = 0; in_linear && k < 3; ++k) linear[k].add(drop[k], age, step_);
    if (!in_angular) continue;
    if (!(angular[0].is_open || angular[1].is_open || angular[2].is_open)) continue;
    const Vec3 turn = vector_from_rotation(pose.orientation * old.pose.orientation.conjugate());
    for (int k = 0; k < 3; ++k) angular[k].add(turn[k], age, angular_step_);
  }
  for (int k = 0; k < 3; ++k) {
    twist_.linear[k] = linear[k].slope;
    twist_.angular[k] = angular[k].slope;
  }
  return twist_;
}

}  // namespace thigma::detail
