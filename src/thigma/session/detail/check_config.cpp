#include "thigma/session/detail/check_config.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "thigma/loop/safety_fields.h"

namespace thigma::detail {

void check_config(const SessionConfig& config) {
  const auto refuse = [](const char* text) {
    throw std::invalid_argument(std::string("session: ") + text);
  };
  if (!(config.rate >= 1.0 && config.rate <= 1e5)) refuse("rate must be 1 to 100000 Hz");
  if (!(config.duration >= 0.0 && config.duration < 1e9)) refuse("duration must be 0 s or more");
  if (!(config.after_fault >= 0.0)) refuse("after_fault must be 0 s or more");
  if (!(config.deep_contact >= 0.0)) refuse("deep_contact must be 0 m or more");
  if (config.contact_every < 1) refuse("contact_every must be 1 frame or more");
  if (config.contact_latency < 1) refuse("contact_latency must be 1 frame or more");
  if (!(config.haptic.body.mass > 0.0)) refuse("the body has no mass");
  if (!(config.contact.tolerance >= 0.0)) refuse("the contact tolerance must be 0 m or more");
  if (!config.contact.scene.empty() && config.contact.object == nullptr)
    refuse("there is no grasped object");
  visit_safety_limits(config.haptic.safety, [&](const char* key, double limit) {
    if (std::isnan(limit) || limit < 0.0)
      throw std::invalid_argument("session: safety." + std::string(key) + " must be 0 or more");
  });
  const auto& friction = config.contact.friction;
  if (!std::all_of(friction.begin(), friction.end(), [](const Friction& f) { return is_valid(f); }))
    refuse("friction must be 0 or more, and no less at rest than sliding");
  const auto& impacts = config.haptic.impacts;
  if (!std::all_of(impacts.begin(), impacts.end(), [](const ImpactPair& p) { return is_valid(p); }))
    refuse("restitution must be 0 to 1, a tap's amplitude 0 or more, frequency and decay above 0");
}

void check_coupling(const SessionConfig& config) {
  const Coupling& coupling = config.haptic.coupling;
  const double stiffness = coupling.linear_saturation ? coupling.linear_saturation->stiffness
                                                      : coupling.linear_stiffness;
  if (config.haptic.response == ResponseKind::direct || !coupling.is_grasped || stiffness > 0.0)
    return;
  throw std::invalid_argument(
      "session: the coupling's linear_stiffness is not above 0 N/m: nothing holds the object");
}

double effective_watchdog(const SessionConfig& config) noexcept {
  constexpr double kLeastPeriods = 3.0;
  const double wanted = std::max(config.haptic.safety.watchdog, kLeastPeriods / config.rate);
  return std::min(wanted, kLongestWatchdog);
}

}  // namespace thigma::detail
