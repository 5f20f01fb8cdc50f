#pragma once
// What a haptic step of a body in a hand leaves: for the next one, and for whoever asks.

#include "thigma/multibody/detail/hand_work.h"

namespace thigma::detail {

/// What the rows did: kept for the next step, and told. Thread: [haptic].
void keep_rows(const HandWork& work, ConstrainedStep& result) THIGMA_RT;

/// Of the world's next step the bodies next to the one in the hand have made this.
///
/// share    of the step that was gone
/// Thread   [haptic]
void keep_bodies(const HandWork& work, double share) THIGMA_RT;

}  // namespace thigma::detail
