#pragma once
// A recorded session as panels against time.

#include <cstddef>
#include <string>

#include "experiments/common/plot.h"

#include "thigma/runtime/recording.h"

namespace thigma::app {

/// At most about `most` points of a curve: of every stretch of equal length the lowest and the highest
/// stay, in their order, so that a peak of one frame is still seen. A value that is not finite
/// interrupts the curve; of such neighbours one stays.
plot::Series thinned(const plot::Series& series, std::size_t most);

/// Eight panels: force, torque, penetration, coupling stretch, rates, contacts, age of the contact
/// model, energy; faults and other events are lines across all of them. Penetration is shown where the
/// object is in touch or near. Units in the labels, millimetres and milliseconds where SI would be small.
///
/// recording   of at least one frame
/// name        for the title
/// Thread      [offline]
plot::Figure session_figure(const Recording& recording, const std::string& name);

}  // namespace thigma::app
