#pragma once
// The hammer led around the torus at constant speed, with relief, without it, and without textures.

#include <string>
#include <vector>

#include "experiments/common/textured_session.h"

namespace thigma::experiments::hammer_on_torus {

/// What the hammer and the torus have over their coarse surfaces.
enum class Surface {
  coarse,  // nothing
  smooth,  // their fine surfaces without relief: the control
  relief,  // their fine surfaces
};

/// What of the hammer lies on the torus.
enum class Touch {
  face,  // of the head, a disc of 27 mm
  side,  // of the head, a cylinder across the tube
};

const char* name_of(Surface surface);
const char* name_of(Touch touch);

/// One run, over the part at constant speed.
struct Stroke {
  Touch touch = Touch::side;
  Surface surface = Surface::relief;
  double speed = 0.0;      // of the head around the ring [m/s]
  double mean_force = 0.0, deviation = 0.0;  // fed back [N]
  double band = 0.0;       // of the force between 20 and 300 Hz, root mean square [N]
  double at_waves = 0.0;   // the same within a tenth of the frequency at which the torus' waves pass [N]
  double peak = 0.0;       // where between 0.6 and 1.6 times that frequency the force is strongest [Hz]
  double waves = 0.0;      // that frequency [Hz]
  double faults = 0.0;     // safety events
  std::vector<double> time, force;  // [s, N]
};

/// Thread [offline]; deterministic.
Stroke stroke_torus(Touch touch, Surface surface, double speed, double seconds, int texels);

}  // namespace thigma::experiments::hammer_on_torus
