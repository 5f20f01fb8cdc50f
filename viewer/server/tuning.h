#pragma once
// Parameters a page may change while a session runs, and what is safe.

#include <optional>
#include <string>
#include <vector>

#include "thigma/runtime/session.h"

namespace thigma::live {

/// A parameter as a page shows it.
struct LiveParameter {
  std::string name, label, unit, help;
  double value = 0.0, min = 0.0, max = 0.0;
  bool is_log = true;
  bool is_replayed = true;  // a recording can be replayed only if it does not change
  std::string locked;       // why it cannot be changed now; "" when it can
};

/// Gains of a session that change by name. Dampings follow, so that every damping ratio stays.
/// Thread: any one at a time.
class Tuner {
 public:
  /// config.haptic.device is the device's; its stiffness limits bind, unless the scene goes beyond them
  /// itself.
  explicit Tuner(const SessionConfig& config);

  const std::vector<LiveParameter>& list() const { return list_; }
  const LiveParameter* find(const std::string& name) const;

  /// Changes a parameter; or returns why not, a sentence that says what would be allowed.
  std::string set(const std::string& name, double value);
  /// Locks those that a recording depends on, or all.
  void lock(const std::string& replayed, const std::string& all);

  HapticTuning haptic() const;
  ContactTuning contact() const;
  /// As the running session has them.
  void apply_to(SessionConfig& config) const;

 private:
  double value(const char* name) const;
  std::string unsafe(const std::string& name, double value) const;

  SessionConfig base_;  // without faults, hierarchies and all that is not a gain
  std::vector<LiveParameter> list_;
};

}  // namespace thigma::live
