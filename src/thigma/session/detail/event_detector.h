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

/// Something that comes and goes from frame to frame. It lasts once it has been there for kPatience
/// longer than not.
struct Lasting {
  static constexpr double kPatience = 0.1;  // [s]
  double seconds = 0.0;
  bool is_told = false;

  /// Whether this is the frame to tell of it, once.
  bool begins(bool is_there, double elapsed) noexcept;
};

/// Turns samples into events, as they change. A fault of the watchdog has a text with the longest
/// gap. A hand that holds the object for a second and never gets a contact model young enough to
/// arm raises one event; so does a contact that is deep and became so unseen by a model, for as
/// long as it lasts, the first of a session with a text. Lateness that is ridden out raises an
/// event each time; the summary only counts it. An object that the constrained response lets wait
/// or that is squeezed raises one event a session each, with what to do.
class EventDetector {
 public:
  EventDetector(std::function<void(const SessionEvent&)> sink, const DeepContactLimits& limits)
      : sink_(std::move(sink)), deep_limits_(limits) {}
  /// longest_gap: longest time without a step so far [s]; trouble: of the device, as it says it
  void observe(const HapticSample& sample, double longest_gap, const char* trouble = "");
  /// Of the model that comes into use next.
  void observe(const ContactSample& sample);
  void add(const SessionEvent& event);
  std::vector<SessionEvent> take_safety_events() { return std::move(safety_events_); }
  const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::function<void(const SessionEvent&)> sink_;
  void look_for_old_models(const HapticSample& sample);
  void look_for_deep_contacts(const HapticSample& sample);
  void look_for_waiting(const HapticSample& sample);
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
  Lasting held_back_, squeezed_;
  // Of the last contact frame: from the one before, its model's travel, what had no room.
  double contact_time_ = 0.0, contact_period_ = 0.0, travel_ = 0.0;  // [s, s, m]
  std::int32_t halvings_ = 0;
  std::int64_t left_out_ = 0;
  Fault last_fault_ = Fault::none;
};

/// Replaces the note that says only `known` by `text`, or adds it.
void add_note(const std::string& text, const std::string& known, std::vector<std::string>& notes);

}  // namespace thigma::detail
