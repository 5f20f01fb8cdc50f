#pragma once
// What lockstep and threaded sessions share.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "thigma/loop/contact_step.h"
#include "thigma/loop/haptic_step.h"
#include "thigma/session/session.h"
#include "thigma/session/statistics.h"

namespace thigma::detail {

/// Throws std::invalid_argument for numbers that make no sense.
void check_config(const SessionConfig& config);

/// Frames of the whole session; practically endless without a duration.
std::uint64_t frame_limit(const SessionConfig& config) noexcept;

/// Length of the step after `frames` ticks since the last one: late steps catch up, but for at most
/// ten ticks, as a body that has been without control for longer is better advanced too little than
/// too far. [s]
double step_length(const SessionConfig& config, std::uint64_t frames) noexcept;

/// Time without a step that counts as one too many: the limit of the configuration, but never less
/// than three periods, below which an ordinary late tick would be a fault. [s]
double effective_watchdog(const SessionConfig& config) noexcept;

/// contact_step with its CPU time in the sample.
void timed_contact_step(const SessionConfig& config, const StampedBody& at, ContactScratch& scratch,
                        ContactSample& sample) noexcept;

/// What makes a contact deep while its model is old.
struct DeepContactLimits {
  double deep = 0.0;  // from here on [m]
  // more of it than this came since the model was made: farther than it looked [m]
  double unseen = 0.0;
};
DeepContactLimits deep_contact_limits(const SessionConfig& config) noexcept;

/// Turns samples into events, as they change. A fault of the watchdog says how long nothing
/// stepped; a hand that holds the object for a second and never gets a contact model young enough
/// to arm is told so once. A contact that is deep, and came to be so unseen by a model, is told
/// once for as long as it lasts, the first of a session with words. What was late and is ridden out
/// is told each time and only counted in the summary.
class EventDetector {
 public:
  EventDetector(std::function<void(const SessionEvent&)> sink, const DeepContactLimits& limits)
      : sink_(std::move(sink)), deep_limits_(limits) {}
  /// longest_gap: longest time without a step so far [s]
  void observe(const HapticSample& sample, double longest_gap);
  void add(const SessionEvent& event);
  std::vector<SessionEvent> take_safety_events() { return std::move(safety_events_); }
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::function<void(const SessionEvent&)> sink_;
  void look_for_old_models(const HapticSample& sample);
  void look_for_deep_contacts(const HapticSample& sample);
  void look_for_late(const HapticSample& sample);
  void tell_late(const HapticSample& sample, Fault cause, const char* text);

  std::vector<SessionEvent> safety_events_;
  std::vector<std::string> texts_;
  DeepContactLimits deep_limits_;
  bool was_grasped_ = false, was_armed_ = false, has_told_of_old_models_ = false;
  bool is_deep_ = false, has_told_of_depth_ = false;
  std::uint64_t last_model_ = 0;              // of the frame before
  double last_depth_ = 0.0, last_age_ = 0.0;  // [m, s]
  double grasp_time_ = 0.0;                   // [s; session clock]
  double youngest_model_ = 0.0;               // since then, while unarmed: age [s]
  double last_time_ = 0.0;                    // of the frame before [s; session clock]
  double last_weight_ = 1.0;                  // of its model
  Fault last_fault_ = Fault::none;
};

PassivitySummary summarize(const PassivityParams& params, const PassivityControl& control);

/// The summary but for how the session ended, missed ticks, rings, events and notes.
SessionSummary summarize(const SessionConfig& config, const HapticStatistics& haptic,
                         const ContactStatistics& contact, const HapticState& state);

}  // namespace thigma::detail
