#pragma once
// A session of several moving bodies, one of which a hand may hold: on a virtual clock, bit for bit
// the same every time.

#include <atomic>
#include <cstdint>
#include <functional>
#include <span>

#include "thigma/device/haptic_device.h"
#include "thigma/device/workspace.h"
#include "thigma/multibody/step_world.h"

namespace thigma {

/// What a world session is.
struct WorldSessionConfig {
  World world;
  WorldState start;
  std::int32_t held = -1;  // body in the hand; -1: none
  Coupling coupling;       // of the hand; taken hold of at the first sample
  Workspace workspace;
  std::vector<BodyDrive> drives;  // of prescribed bodies
  double rate = 1000.0;           // of steps [Hz]
  double duration = 10.0;         // [s]
};

/// One frame of it.
struct WorldFrame {
  std::uint64_t frame = 0;
  double time = 0.0;  // at its end [s]
  std::span<const BodyState> bodies;
  std::span<const JointReading> joints;
  Motion handle;   // [world]
  Wrench command;  // sent [N, N m; device frame]
  WorldStep step;
};

/// How it went.
struct WorldSummary {
  std::uint64_t frames = 0;
  std::uint64_t state_hash = 0;                 // of all bodies and what was sent, of all frames
  double force_max = 0.0;                       // sent [N]
  double energy_start = 0.0, energy_end = 0.0;  // mechanical_energy [J]
  // that the hand has put in since the start, least and at the end [J]; energy_min < 0: it was
  // handed out
  double port_energy = 0.0, port_energy_min = 0.0;
  // most that there was of bodies' and springs' energy beyond that of the start and what the hand
  // had put in, at least 0 [J]; motors and prescribed bodies count as well
  double energy_made = 0.0;
  double joint_error = 0.0;   // by which a joint was not met, at most [m]
  double residual_max = 0.0;  // of a solve [m/s]
  double waited = 0.0;        // [s]
  double gap_min = 0.0;       // least gap of a row [m]
  std::int64_t rows_max = 0, queries = 0, impacts = 0, newton = 0;
  std::int32_t pairs_max = 0, largest_island = 0, pressing_max = 0, parts_max = 0;
  std::uint64_t not_whole = 0;  // steps in which rows contradicted each other
  std::int32_t awake = 0;       // at the end
  bool was_stopped = false;
};

/// Runs a world: each frame reads the device, makes a step of 1 / rate with all bodies in one solve
/// an island, and sends the coupling's reaction, cut at the device's limits.
///
/// config   constant
/// device   null where nobody holds a body
/// sink     called after every frame; may be empty
/// stop     null, or looked at every frame
/// errors   std::invalid_argument for a device that holds a person, as nothing here keeps a hand
///          safe; what a sink throws
/// Thread   [offline]
WorldSummary run_world(const WorldSessionConfig& config, HapticDevice* device,
                       const std::function<void(const WorldFrame&)>& sink = {},
                       const std::atomic<bool>* stop = nullptr);

}  // namespace thigma
