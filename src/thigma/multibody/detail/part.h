#pragma once
// A part of a step: bodies go as far as their rows hold, or the part was too long.

#include "thigma/multibody/detail/world_work.h"

namespace thigma::detail {

/// Makes one part of a step.
///
/// is_last  false: where a body would go farther than any query looks ahead nothing is done; true:
///          the bodies go as far as they may and wait for the rest
/// returns  the share of the part that was made, 0 where nothing was done
double make_part(Part& part, bool is_last);

}  // namespace thigma::detail
