#pragma once
// A session without a hand: the body falls, collides and comes to rest by itself (Sec. 3.5.4),
// frame by frame as recordings, tables and the page know it.

#include <atomic>
#include <cstdint>

#include "thigma/session/session.h"
#include "thigma/simulation/simulate.h"

namespace thigma {

/// How a simulated session went.
struct SimulatedSummary {
  SessionSummary session;     // of what a hand would feel, all is 0
  SimulationCounts counts;    // of all frames
  bool is_resting = false;    // at the end
  double energy_start = 0.0;  // mechanical_energy [J]
  double energy_end = 0.0;
  double growth_max = 0.0;  // of the energy over a frame, at most; 0: it never grew [J]
  BodyState body;           // at the end
};

/// Runs a simulation as a session: one frame of 1 / config.rate after the other. Each has a
/// HapticSample (the body, the mean contact wrench on it over the frame, penetration) and a
/// ContactSample of the simulation's own last query. Events: `impact` for impacts faster than a
/// fall over the tolerance, and `at_rest`.
///
/// config    contact (world and clusters), rate, duration, live are used; there is no device.
///           Without a duration, and with nobody watching, it ends when the body rests
/// start     its world as config.contact; outlives the session
/// is_paced  false: as fast as it goes, nothing can interfere, bit-reproducible; true: a frame each
///           1 / rate, or as soon as it is done, so that slow queries slow the motion down;
///           LivePorts::is_paused holds it
/// sinks     called by this thread
/// stop      null, or looked at every frame
/// errors    std::invalid_argument as run_lockstep, InputError as reserve_simulation
/// Thread    [offline]; any, alone.
SimulatedSummary run_simulated(const SessionConfig& config, const SimulatedStart& start,
                               bool is_paced, const SessionSinks& sinks = {},
                               const std::atomic<bool>* stop = nullptr);

}  // namespace thigma
