#pragma once
// `thigma run` of a world with its page: sessions by the clock, one after the other.

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "run_options.h"
#include "world_summary.h"

#include "thigma/scene/world_scene.h"

namespace thigma::app {

/// What a live run of a world needs of the program around it.
struct WorldLiveProgram {
  // The page's hand is added to its hands; afterwards the one that ended, with its bodies.
  LoadedWorld* world = nullptr;
  const RunOptions* options = nullptr;
  std::uint64_t seed = 1;
  std::vector<std::string> devices;         // addresses, by hand; one of web: is the page's hand
  const std::atomic<bool>* stop = nullptr;  // set by Ctrl-C
  Log log;                                  // lines for people
};

/// Serves the page and runs sessions until the time is over, a device has finished, a fault has
/// ended one with nobody there to begin again, or it is told to stop. Pages hold a hand of their
/// own, beside the devices of the scene, that takes hold of any body which moves.
///
/// facts    devices and time of the processor
/// returns  of the last session
/// errors   PortUnavailable, and as run_world_by_clock
/// Thread   [offline]
WorldSummary run_world_live(const WorldLiveProgram& program, WorldRunFacts& facts);

}  // namespace thigma::app
