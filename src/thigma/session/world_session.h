#pragma once
// A session of several moving bodies, some of which hands may hold: on a virtual clock, bit for bit
// the same every time, or by the clock on the wall, with the same bits for the same samples.

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "thigma/device/haptic_device.h"
#include "thigma/device/workspace.h"
#include "thigma/loop/safety.h"
#include "thigma/multibody/step_world.h"
#include "thigma/session/histogram.h"
#include "thigma/session/live_ports.h"
#include "thigma/session/world_ticks.h"

namespace thigma {

/// Why devices that may hold a person are refused where haptic steps are not apart from the
/// world's.
inline constexpr const char* kNoPersonInLockstep =
    "not in lockstep, where worlds of several bodies have no ramps and no watchdog for a person's "
    "hand, expected hand:, script: or null:";

/// A hand of a session.
struct WorldHand {
  std::int32_t body = -1;  // of kind held; several hands may hold one
  Coupling coupling;       // taken hold of at the first sample
  Workspace workspace;
  std::optional<Vec3> at;  // where it takes hold at the start [m; world]; else the body's centre
  SafetyLimits limits;     // of what its device says and of what is sent; the device's hold as well
  // It holds something only while its clutch is closed: what it is aimed at, `body` at the start
  // (-1: nothing), by the coupling of that body. A device that is lost lets go; that is no fault.
  bool is_free = false;
  std::vector<Coupling> couplings{};  // of a free one: by body
  // It holds `body` only while its clutch is closed, each time at the same place of it, as people
  // do. A device that is lost is a fault.
  bool has_clutch = false;

  /// Whether there are times at which it holds nothing.
  bool may_let_go() const noexcept { return is_free || has_clutch; }
};

/// What a world session is.
struct WorldSessionConfig {
  World world;
  WorldState start;
  std::vector<WorldHand> hands;
  std::vector<BodyDrive> drives;  // of prescribed bodies
  double rate = 1000.0;           // of steps [Hz]
  double duration = 10.0;         // 0: until it is stopped or a device has finished [s]
};

/// Frames of the whole session; practically endless without a duration.
std::uint64_t frames_of(const WorldSessionConfig& config);

/// What a hand does in a frame.
struct WorldGrip {
  std::int32_t body = -1;  // that it holds; -1: none
  Pose body_from_grasp;    // where, see Coupling
  DeviceState device;      // as read [device frame]
  double energy = 0.0;     // that it has put in since the start [J]
  // Counts the bodies that it took hold of; with it what it holds the last one by, and what its
  // device's pose means in the world.
  std::uint64_t number = 0;
  Coupling coupling;
  WorkspaceAnchor anchor;
};

/// One frame of it.
struct WorldFrame {
  std::uint64_t frame = 0;
  double time = 0.0;  // at its end [s]
  std::span<const BodyState> bodies;
  std::span<const std::uint8_t> is_asleep;  // by body
  std::span<const JointReading> joints;
  std::span<const Motion> handles;   // by hand [world]
  std::span<const Wrench> commands;  // sent, by hand [N, N m; device frame]
  std::span<const WorldGrip> grips;  // by hand
  std::optional<WorldAim> aimed;     // of free hands, since the frame before
  WorldStep step;
  WorldHapticNow haptic;  // `commands` are then what the world would send
  // By the clock; in lockstep 0.
  double step_cpu = 0.0;   // of the processor, for the whole frame [s]; not in the hash
  std::uint64_t lost = 0;  // frames that were skipped before it, as the one before took too long
};

/// How it went for a hand.
struct WorldHandSummary {
  double force_max = 0.0;  // sent [N]
  // that the hand has put in since the start, least and at the end [J]
  double port_energy = 0.0, port_energy_min = 0.0;
  Fault fault = Fault::none;
  double hung = 0.0;    // by which its thread was overdue when that ended the session [s]; 0: no
  std::string trouble;  // what its device says at the end, for a person; "": nothing
};

/// How the haptic steps of a hand went, where they are apart from the world's.
struct WorldHapticSummary {
  std::uint64_t steps = 0;
  double force_max = 0.0;  // sent [N]
  // that the hand has put in at its device since the start, at the end and the least [J]
  double port_energy = 0.0, port_energy_min = 0.0;
  std::int32_t rows_max = 0, bodies_max = 0, newton_max = 0;  // of a step
  std::uint64_t cut_short = 0;    // steps whose solve had no factors left: the body waited
  std::uint64_t held_back = 0;    // steps in which it waited where its model ended
  std::uint64_t corrections = 0;  // models that moved it back to where the world has it
  double correction_max = 0.0;    // by so much [m]
  double model_age_max = 0.0;     // while it held something [s]
  std::uint64_t state_hash = 0;   // of the body and what was sent, of all steps
};

/// How it went.
struct WorldSummary {
  std::uint64_t frames = 0;
  std::uint64_t state_hash = 0;                 // of all bodies and what was sent, of all frames
  double force_max = 0.0;                       // sent, of all hands [N]
  double energy_start = 0.0, energy_end = 0.0;  // mechanical_energy [J]
  // that hands have put in since the start: all at the end, and the least of any [J]; below 0: it
  // was handed out
  double port_energy = 0.0, port_energy_min = 0.0;
  std::vector<WorldHandSummary> hands;
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
  // By the clock: frames that came late by more than a frame's time, and by how much in all [s].
  std::uint64_t late_frames = 0;
  double lost_time = 0.0;
  // the first of a hand, or not_finite where the motion came to be no number: all devices were left
  // at zero force
  Fault fault = Fault::none;
  // By hand, where haptic steps are apart from the world's; else empty, and `hands` is what devices
  // got. Where they are, `hands` and the port's energy are those of the world's side.
  std::vector<WorldHapticSummary> haptic;
  // Of their threads, of all hands together; in lockstep there are none.
  std::uint64_t haptic_missed = 0;  // ticks of the clock without a step
  // of a step, of the processor; not of devices that own the clock
  DurationHistogram haptic_cpu;
  std::uint64_t haptic_stops = 0;    // times that one hung and the watchdog sent zero force
  std::string refused;               // what the system refused to them; "": nothing
  std::uint64_t haptic_dropped = 0;  // steps that WorldShell::ticks was not told of

  bool has_fault() const noexcept { return fault != Fault::none; }
};

/// A session frame by frame: the one loop's body that lockstep and the clock have in common. Each
/// frame reads the devices, makes a step of 1 / rate with all bodies in one solve an island, and
/// sends each coupling's reaction, cut at the limits of its device and hand. A fault of one hand
/// ends the session, before a step is made, with zero force on all.
/// Invariant: every device has zero force when it is destroyed, however that comes.
/// Thread: one.
class WorldRun {
 public:
  /// config   constant while it runs
  /// devices  one a hand; null: nobody holds it
  /// errors   std::invalid_argument for another number of devices, and for one that holds a person,
  ///          (kNoPersonInLockstep); InputError for a motor that is too fast
  WorldRun(const WorldSessionConfig& config, std::span<HapticDevice* const> devices);
  ~WorldRun();
  WorldRun(const WorldRun&) = delete;
  WorldRun& operator=(const WorldRun&) = delete;

  /// What free hands take hold of from the next frame on; one that holds something else lets go of
  /// that. Bodies that nothing moves, and numbers of none or of another world: nothing.
  void aim(const WorldAim& aim) noexcept;
  /// Makes the next frame; null: the session is over, nothing was made.
  /// aims   null, or taken up once the devices have been read: what comes before a sample that
  ///        closes the clutch is there by then
  WorldFrame* make_frame(Latest<WorldAim>* aims = nullptr);
  /// Of the world after the last frame.
  const WorldState& state() const noexcept;
  /// That it goes on with, and the working memory of its last step.
  const World& world() const noexcept;
  const WorldScratch& scratch() const noexcept;
  /// How often it has gone on with another world.
  std::uint32_t changes() const noexcept;
  /// Goes on with another world: bodies that come and go between two frames. Hands hold what they
  /// held, but for what is gone.
  ///
  /// next     constant from here on, outlives the run: the same hands, rate and joints
  /// state    of that world
  /// was      by body: its number so far; -1: it is new
  /// errors   std::bad_alloc, and then nothing has changed
  void go_on(const WorldSessionConfig& next, const WorldState& state,
             std::span<const std::int32_t> was);
  /// So many frames were skipped: their time is lost to the world.
  void lose(std::uint64_t frames) noexcept;
  /// Leaves zero force and tells how it went.
  WorldSummary end();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Runs a world in lockstep: on a virtual clock, as fast as it goes.
///
/// config, devices  and errors as of WorldRun
/// sink     called after every frame; may be empty
/// stop     null, or looked at every frame
/// errors   also what a sink throws
/// Thread   [offline]
WorldSummary run_world(const WorldSessionConfig& config, std::span<HapticDevice* const> devices,
                       const std::function<void(const WorldFrame&)>& sink = {},
                       const std::atomic<bool>* stop = nullptr);

/// What a world by the clock has around it.
struct WorldShell {
  std::function<void(const WorldFrame&)> sink{};  // after every frame; may be empty
  const std::atomic<bool>* stop = nullptr;        // null, or looked at every frame
  LivePorts* live = nullptr;  // pauses, single steps, what free hands are aimed at; null: nobody
  // Before every frame, and while paused: what happens between two; may be empty.
  std::function<void(WorldRun&)> between{};
  // Waits for the next tick and tells how many were over before; empty: of the clock on the wall.
  std::function<std::uint64_t()> wait_for_tick{};
  // Where hands are apart from the world: their steps since the last call, after every frame and
  // once more at the end, all that there was room for (WorldSummary::haptic_dropped); may be empty.
  std::function<void(std::span<const HandTick>)> ticks{};
  std::size_t tick_room = 0;  // haptic steps that may wait for the world; 0: those of 16 s
};

/// The same by the clock: a step of 1 / rate at each tick. A step that takes longer has the world
/// go more slowly than the clock, by whole frames, which are counted; none is longer to catch up.
/// The bits are those of run_world for the same samples.
///
/// config, devices  and errors as of run_world
/// Thread   [offline]
WorldSummary run_world_by_clock(const WorldSessionConfig& config,
                                std::span<HapticDevice* const> devices, const WorldShell& shell);

}  // namespace thigma
