#pragma once
// How the hand moves in each scene of Sec. 3.5.3: the same motion for every experiment on it.

#include "experiments/common/replay.h"

namespace thigma::experiments {

/// Jaws: pressed with about 1 N, ground to and fro and rocked, as in chewing. 0.9 s
/// (docs/sources.md, E7).
HandScript jaws_hand(double radius);
/// Golf: the club taps and rubs the ball. 0.45 s, 300 frames and more of them in contact.
HandScript golf_hand(double radius);
/// Spoon in the cup: 0.65 s along the wall.
HandScript spoon_hand(double radius);
/// Ball joint: turned under light pressure.
HandScript joint_hand(double radius);

}  // namespace thigma::experiments
