#pragma once
// The summary of a session, of what its threads added up.

#include "thigma/loop/haptic_step.h"
#include "thigma/session/session.h"
#include "thigma/session/statistics.h"

namespace thigma::detail {

PassivitySummary summarize(const PassivityParams& params, const PassivityControl& control);

/// The summary but for how the session ended, missed ticks, rings, events and notes.
SessionSummary summarize(const SessionConfig& config, const HapticStatistics& haptic,
                         const ContactStatistics& contact, const HapticState& state);

}  // namespace thigma::detail
