#pragma once
// What lockstep and threaded sessions share.

#include <cstdint>
#include <functional>
#include <vector>

#include "thigma/runtime/session.h"
#include "thigma/runtime/tally.h"

namespace thigma::detail {

/// Throws std::invalid_argument for numbers that make no sense.
void check_config(const SessionConfig& config);

/// Frames of the whole session; practically endless without a duration.
std::uint64_t frame_limit(const SessionConfig& config) noexcept;

/// Length of the step after `frames` ticks since the last one: late steps catch up, but for at most
/// ten ticks, as a body that has been without control for longer is better advanced too little than
/// too far. [s]
double step_length(const SessionConfig& config, std::uint64_t frames) noexcept;

/// contact_step with its CPU time in the sample.
void timed_contact_step(const SessionConfig& config, const StampedBody& at, ContactScratch& scratch,
                        ContactSample& sample) noexcept;

/// Turns samples into events, as they change.
class EventDetector {
 public:
  explicit EventDetector(std::function<void(const SessionEvent&)> sink) : sink_(std::move(sink)) {}
  void look_at(const HapticSample& sample);
  void add(const SessionEvent& event);
  std::vector<SessionEvent> take_safety_events() { return std::move(safety_events_); }

 private:
  std::function<void(const SessionEvent&)> sink_;
  std::vector<SessionEvent> safety_events_;
  bool was_grasped_ = false, was_armed_ = false;
  Fault last_fault_ = Fault::none;
};

/// The summary but for how the session ended, missed ticks, rings, events and notes.
SessionSummary summarize(const SessionConfig& config, const HapticTally& haptic,
                         const ContactTally& contact, const HapticState& state);

}  // namespace thigma::detail
