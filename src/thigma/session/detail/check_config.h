#pragma once
// What every kind of session asks of its configuration.

#include "thigma/session/session.h"

namespace thigma::detail {

/// Throws std::invalid_argument for numbers that make no sense.
void check_config(const SessionConfig& config);

/// Throws std::invalid_argument where a hand holds the object by a coupling without stiffness, as
/// it is by default: the object would stay where it is, and nothing be felt.
void check_coupling(const SessionConfig& config);

inline constexpr double kLongestWatchdog = 3600.0;  // [s]; no watchdog at all, for a person

/// Time without a step that counts as one too many: the limit of the configuration, but never less
/// than three periods, below which an ordinary late tick would be a fault. [s]
double effective_watchdog(const SessionConfig& config) noexcept;

}  // namespace thigma::detail
