#pragma once
// A world whose hands are stepped apart from it: haptic steps at their own rate, however long a
// step of the world takes.

#include <atomic>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "thigma/core/spsc_ring.h"
#include "thigma/session/world_hand.h"
#include "thigma/session/world_session.h"

namespace thigma {

/// The hands of a world on both sides.
struct WorldApart {
  /// devices   of the hands; null: nobody holds it
  /// errors    as of WorldRun, for these devices
  WorldApart(const WorldSessionConfig& config, std::span<HapticDevice* const> devices);
  ~WorldApart();  // leaves zero force, whatever a device does
  WorldApart(const WorldApart&) = delete;
  WorldApart& operator=(const WorldApart&) = delete;

  const WorldSessionConfig* config;                   // outlives this
  std::vector<HapticDevice*> devices;                 // as given
  std::vector<std::unique_ptr<WorldHandLoop>> loops;  // null without a device
  std::vector<std::unique_ptr<HandRelay>> relays;     // likewise
  std::vector<HapticDevice*> world_devices;           // what the world reads

  // The world's side.
  std::unique_ptr<WorldRun> run;
  std::vector<HandModelScratchPtr> scratch;
  std::vector<double> last;    // time of each hand's last news [s; hand's]
  std::vector<Wrench> sent;    // by each hand's last step that the world knows [device frame]
  std::vector<HandSeen> seen;  // of each hand, by the last frame
  std::vector<std::uint32_t> changes;  // by hand: of the world that its scratch is for

  // hands -> whoever records their steps, by hand; none: nobody does. What does not fit is left
  // out.
  std::vector<std::unique_ptr<SpscRing<HandTick>>> ticks;
};

/// Tells all hands what the world has after a frame.
/// Thread    [contact]; throws std::bad_alloc where memory grows.
void publish_news(const WorldFrame& frame, double step, WorldApart& apart);
/// Tells one.
void publish_news(const WorldFrame& frame, double step, std::size_t hand, WorldApart& apart);

/// Sends zero force to all devices, whatever one of them does.
/// Thread    [haptic], or where its thread has ended.
void let_go(const WorldApart& apart);

/// Makes a haptic step of a hand that has a device; the fault that ends the session, or none.
/// Thread    [haptic]; several hands may be stepped at once.
Fault step_hand(const HapticTick& tick, std::size_t hand, WorldApart& apart) THIGMA_RT;

/// What the haptic side adds to a summary once both have ended, with the fault that ended it.
void add_haptic(const WorldApart& apart, Fault fault, WorldSummary& summary);

/// The same in lockstep: what happens when, in haptic frames.
struct ApartLockstep {
  // from the beginning of a world's step to that of the next, as if it took so long; what came of
  // it is known at the end of it
  int world_every = 1;
  std::function<int(std::uint64_t frame)> lasts{};  // the same by frame of the world; may be empty
  std::function<void(std::size_t hand, const HapticSample&)> haptic{};  // may be empty
  std::function<void(const WorldFrame&)> world{};                       // may be empty
  // Before a step of the world begins: what happens between two of its frames; may be empty.
  std::function<void(WorldRun&)> between{};
};

/// Runs a world in lockstep with its hands apart from it: config.duration in haptic frames of
/// 1 / config.rate. Bit-reproducible.
///
/// errors   as of run_world; also what a sink throws
/// Thread   [offline]
WorldSummary run_world_apart(const WorldSessionConfig& config,
                             std::span<HapticDevice* const> devices, const ApartLockstep& how = {});

}  // namespace thigma
