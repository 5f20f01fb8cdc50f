#pragma once
// Turns the samples of a session into its events.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "thigma/loop/samples.h"
#include "thigma/session/session.h"

namespace thigma::detail {

/// What makes a contact deep while its model is old.
struct DeepContactLimits {
  double deep = 0.0;  // from here on [m]
  // more of it than this came since the model was made: farther than it looked [m]
  double unseen = 0.0;
};
DeepContactLimits deep_contact_limits(const SessionConfig& config) noexcept;

/// Turns samples into events, as they change. A fault of the watchdog has a text with the longest
/// gap. A hand that holds the object for a second and never gets a contact model young enough to
/// arm raises one event; so does a contact that is deep and became so unseen by a model, for as
/// long as it lasts, the first of a session with a text. Lateness that is ridden out raises an
/// event each time; the summary only counts it.
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
  void add_late(const HapticSample& sample, Fault cause, const char* text);

  std::vector<SessionEvent> safety_events_;
  std::vector<std::string> texts_;
  DeepContactLimits deep_limits_;
  bool was_grasped_ = false, was_armed_ = false, has_reported_old_models_ = false;
  bool is_deep_ = false, has_reported_depth_ = false;
  std::uint64_t last_model_ = 0;              // of the frame before
  double last_depth_ = 0.0, last_age_ = 0.0;  // [m, s]
  double grasp_time_ = 0.0;                   // [s; session clock]
  double youngest_model_ = 0.0;               // since then, while unarmed: age [s]
  double last_time_ = 0.0;                    // of the frame before [s; session clock]
  double last_weight_ = 1.0;                  // of its model
  Fault last_fault_ = Fault::none;
};

}  // namespace thigma::detail
