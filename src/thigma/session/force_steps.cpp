#include "thigma/session/force_steps.h"

#include <algorithm>

namespace thigma {
namespace {

void note(double& largest, const Vec3& now, const Vec3& before) noexcept {
  largest = std::max(largest, (now - before).norm());
}

}  // namespace

void ForceSteps::observe(const ContactSample& sample) noexcept {
  known_[sample.model.sequence % kModels] = {sample.model.sequence, sample.pressing_changes};
}

void ForceSteps::observe(const HapticSample& sample) noexcept {
  const bool counts = sample.is_grasped && sample.is_armed && sample.fault == Fault::none;
  if (counts && has_last_) {
    // Models that came and went between two frames changed levels on the way as well.
    bool has_change = false;
    const std::uint64_t first = std::max(
        last_.model_sequence + 1,
        sample.model_sequence - std::min<std::uint64_t>(sample.model_sequence, kModels - 1));
    for (std::uint64_t s = first; s <= sample.model_sequence; ++s) {
      const Known& known = known_[s % kModels];
      has_change = has_change || (known.sequence == s && known.changes > 0);
    }
    if (has_change) ++level_change_frames;
    note(has_change ? contact.level_change : contact.other, sample.contact.force,
         last_.contact.force);
    note(has_change ? device.level_change : device.other, sample.command.force,
         last_.command.force);
  }
  last_ = sample;
  has_last_ = counts;
}

}  // namespace thigma
