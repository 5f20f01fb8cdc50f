#pragma once
// Impacts at the end of a haptic step of a body in a hand.

#include "thigma/multibody/detail/hand_work.h"

namespace thigma::detail {

/// Surfaces that met in the step stop each other at its end and spring back by Poisson's law, as in
/// the world's step. The bodies that are solved have never more energy after a bounce than before
/// the step; what is not solved gives none. Among joints nothing springs back.
///
/// work     after the step, nothing of which was held back
/// Thread   [haptic]
void collide(const HandWork& work) THIGMA_RT;

}  // namespace thigma::detail
