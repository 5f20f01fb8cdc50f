#pragma once
// Parameters a page may change while a session runs, and what is safe.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "thigma/dynamics/gains.h"
#include "thigma/session/live_ports.h"
#include "thigma/session/session.h"

namespace thigma::live {

/// How a parameter is set: a number; a number or 0, which turns it off; one of several words, by
/// its index.
enum class ParameterKind : std::uint8_t { number, optional, choice };

/// A parameter as a page shows it.
struct LiveParameter {
  std::string name, label, unit, help;
  ParameterKind kind = ParameterKind::number;
  std::vector<std::string> choices;  // of a choice
  double value = 0.0, min = 0.0, max = 0.0;
  bool is_log = true;
  bool is_replayed = true;    // a recording can be replayed only if it does not change
  bool begins_again = false;  // to change it takes a new session
  std::string locked;         // why it cannot be changed now; "" when it can
  std::string warning{};      // what its value risks; ""
};

/// Gains and resolution of a session that change by name. Dampings follow, so that every damping
/// ratio stays. What the frames cannot follow is refused; what is outside the limits of
/// docs/gains.md gets a warning. Thread: any one at a time.
class Tuner {
 public:
  /// config.haptic.device is the device's; its stiffness limits bind, unless the scene goes beyond
  /// them itself.
  explicit Tuner(const SessionConfig& config);

  const std::vector<LiveParameter>& list() const { return list_; }
  const LiveParameter* find(const std::string& name) const;

  /// Changes a parameter; or returns why not, a sentence that says what would be allowed.
  std::string set(const std::string& name, double value);
  /// Locks those that a recording depends on, or all.
  void lock(const std::string& replayed, const std::string& all);

  /// What gains are judged for from here on: the device and its limits; nothing: no warnings.
  void judge_for(const std::optional<GainTask>& task);

  HapticTuning haptic() const;
  ContactTuning contact() const;
  /// As the running session has them.
  void apply_to(SessionConfig& config) const;

 private:
  double value(const char* name) const;
  void add_resolution(const SessionConfig& config);
  void warn();
  std::string unsafe(const std::string& name, double value) const;

  SessionConfig base_;  // without faults, hierarchies and all that is not a gain
  std::vector<LiveParameter> list_;
  std::optional<GainTask> task_;
  double most_friction_ = 0.0;  // largest kinetic coefficient, as the session began
  ViewThreshold from_afar_;     // of the view metric, where the scene has none
};

}  // namespace thigma::live
