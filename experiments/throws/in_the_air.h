#pragma once
// What bounding the motion between contact models costs a hand that moves fast where nothing is.

#include "experiments/common/table.h"

namespace thigma::experiments {

/// A hand that comes down from 60 mm at a speed, touches, goes back, twice; or sums of such.
struct AirRun {
  int air_frames = 0, air_held = 0;    // farther than 5 mm from touching
  int near_frames = 0, near_held = 0;  // within 5 mm, nothing pressing yet
  double lag = 0.0;      // in the air, behind the same hand without a scene, over its speed [s]
  double phantom = 0.0;  // largest difference of the force from that hand's, in the air [N]
};

/// pair    of kAirPairs: jaws of 4,000 triangles, discs of 12,000
/// every   haptic frames from one contact frame to the next
/// ahead   how far a query looks at most, over what the engine allows
/// late    how much later than after 20 ms the hand sets out, over the time between two contact
///         frames; the run is no longer for it
AirRun run_in_the_air(int pair, double speed, int every, double ahead = 1.0, double late = 0.0);

/// Counts add up, of lag and force the largest stays.
void add_air_run(const AirRun& run, AirRun& sum);

inline constexpr const char* kAirPairs[] = {"cube over plate", "ball over ball", "jaws",
                                            "conforming discs"};

}  // namespace thigma::experiments
