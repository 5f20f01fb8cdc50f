#pragma once
// From the options of `thigma run` to a session that can be started.

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "run_options.h"

#include "thigma/device/web_device.h"
#include "thigma/scene/level_build.h"
#include "thigma/scene/load_scene.h"
#include "thigma/session/rt_thread.h"
#include "thigma/session/simulated_session.h"

namespace thigma::app {

/// Everything of a run. Not movable: the session's configuration points into the scene.
struct Run {
  SceneDescription given;  // before the options changed it
  Scene scene;
  SceneSession session;
  // of the machine just before a threaded session, where it was measured
  std::optional<EmptyLoop> floor;
  SimulatedSummary simulated;               // how the last simulation went, where there is one
  WebDeviceChannel* web_channel = nullptr;  // of the page, where there is one; outlives the run
  // of the scene's levels, where the run has begun without; null: none
  std::unique_ptr<LevelBuild> levels;
  std::vector<Scene> former;  // before their levels came: a session may stand on one
  // for the session that ran when the levels came
  std::unique_ptr<ContactReplacement> replacement;
};

/// Where the object of a session is, handed over by the thread that drains it. Thread: any.
class LastBody {
 public:
  void observe(const HapticSample& sample) {
    const std::lock_guard lock(mutex_);
    body_ = sample.body;
  }
  BodyState state() const {
    const std::lock_guard lock(mutex_);
    return body_;
  }

 private:
  mutable std::mutex mutex_;
  BodyState body_;
};

/// Who is told how a run is prepared, and what it shares with the page.
struct RunHooks {
  Log log;  // lines for people; may be empty
  // What is being built and the share that is done; may be empty, may throw to give it up.
  std::function<void(const std::string& what, double share)> progress;
  WebDeviceChannel* web_channel = nullptr;  // of the page; null without one
};

/// The scene that the options name.
/// Thread   [offline]. InputError.
SceneDescription read_run_scene(const RunOptions& options);

/// Looks at all meshes of a scene before anything is built, since that may take minutes.
///
/// returns  "", or a sentence on the use of --scale: a pair of meshes without it of which one is
///          larger than a hand could feel (exit code 2)
/// Thread   [offline]. InputError for the first that cannot be used.
std::string check_meshes(const SceneDescription& scene, const RunOptions& options);

/// Loads or builds levels of detail, places the object, opens the device.
///
/// Thread   [offline]. InputError, IoError, DeviceAddressError, DeviceUnavailable,
///          std::invalid_argument.
std::unique_ptr<Run> prepare_run(SceneDescription scene, const RunOptions& options,
                                 std::uint64_t seed, const RunHooks& hooks);

/// Takes over levels that have been built beside a run: sessions that come next have them, and what
/// lets the one that runs go on with them is in run.replacement, where that is held by a hand.
///
/// now      configuration of the session that runs
/// near     where its object about is
/// returns  whether there were any; the scene of the run is another then
/// Thread   [offline], while a session of the run may run
bool take_levels(Run& run, const SessionConfig& now, const BodyState& near, const Log& log);

/// How the session of a run is run.
struct RunControl {
  bool is_lockstep = false;                 // on a virtual clock; false: on the clock of the wall
  const std::atomic<bool>* stop = nullptr;  // null, or ends the session when set
  std::function<void()> begun{};            // when it has; may be empty
  // Every 10 ms of a session on the wall's clock, in the calling thread; true ends it. May be
  // empty.
  std::function<bool()> poll{};
};

/// Runs the session of a run: in lockstep or on threads, with its device or, where the scene has a
/// simulation, without. How a simulation went stays in run.simulated.
///
/// config   the run's, but for what changes from session to session
/// sinks    called by a thread that is not real time
/// errors   as run_lockstep, Session and run_simulated; what a sink throws
/// Thread   [offline]
SessionSummary run_session(Run& run, const SessionConfig& config, const RunControl& control,
                           const SessionSinks& sinks);

/// Opens a device anew, or another one, and places the object for it as prepare_run does. The run,
/// which a session may be using, stays as it is.
///
/// world_from_body  where the object starts unless it has to be placed elsewhere
/// Thread   [offline]; errors as prepare_run.
SceneSession open_run_device(const RunOptions& options, std::uint64_t seed, const std::string& uri,
                             const Pose& world_from_body, const Run& run, const Log& log = {});

}  // namespace thigma::app
