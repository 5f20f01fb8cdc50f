#pragma once
// How much the force steps from frame to frame, with and without a contact that changes its level
// of detail: whether levels pop (Sec. 3.4.4).

#include <array>
#include <cstdint>

#include "thigma/core/rt.h"
#include "thigma/loop/samples.h"

namespace thigma {

/// Largest steps of a force between successive haptic frames [N].
struct ForceStep {
  // into frames whose model is new and has a pressing contact that changed level
  double level_change = 0.0;
  double other = 0.0;  // into all other frames
};

/// Keeps the largest steps of a session; frames count while the object is held and forces are on.
/// Samples come in the order sinks get them: every model before the first frame that used it.
struct ForceSteps {
  ForceStep contact;  // of the contact force on the object [world, virtual size]
  ForceStep device;   // of the force sent [device frame], after coupling, fade and slew limit
  std::uint64_t level_change_frames = 0;

  void observe(const ContactSample& sample) noexcept;
  void observe(const HapticSample& sample) noexcept;

 private:
  static constexpr std::size_t kModels = 64;  // more than are ever on the way
  struct Known {
    std::uint64_t sequence = 0;
    std::int32_t changes = 0;  // of contacts that press
  };
  std::array<Known, kModels> known_{};  // by sequence modulo kModels
  HapticSample last_;
  bool has_last_ = false;
};

}  // namespace thigma
