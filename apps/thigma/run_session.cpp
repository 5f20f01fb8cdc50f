#include "run_session.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <thread>
#include <utility>

#include "named_scene.h"
#include "progress.h"

#include "thigma/core/error.h"
#include "thigma/scene/asset_cache.h"
#include "thigma/scene/scene_file.h"

namespace thigma::app {
namespace {

// Of a mesh without a unit: what a hand holds is smaller, and in millimetres a thing of 1 mm is
// larger [m].
constexpr double kLargestRadius = 1.0;

void set_friction(double friction, SceneDescription& scene) {
  scene.contact.friction = {friction, friction};
  scene.object.material.reset();
  for (SceneObject& other : scene.statics) other.material.reset();
}

/// What of the options the scene itself can say.
void apply_options(const RunOptions& options, SceneDescription& scene) {
  if (options.sends_zero) scene.safety.max_force = scene.safety.max_torque = 0.0;
  // What decides gains = "auto" has to be known before there is a configuration.
  if (!options.device.empty()) scene.device.uri = options.device;
  if (options.rate) scene.rate = *options.rate;
  apply(options.resolution, scene.contact.resolution);
  if (options.resolution.carry) scene.contact.carry = options.resolution.carry;
  if (options.has_no_blend) scene.contact.resolution.interpolates = false;
  if (const auto response = response_of(options.response)) {
    scene.contact.response = *response;
  } else if (asks_for_levels(options.resolution) && !scene.contact.response) {
    // Who asks for levels asks for the law that has them everywhere.
    scene.contact.response = ResponseKind::coupled;
  }
  ContactGains& contact = scene.contact;
  if (options.resolution.is_exact) contact.has_levels_far = false;
  if (contact.response == ResponseKind::constrained &&
      (options.resolution.threshold || !options.resolution.deviation_cap.empty()))
    contact.has_levels_far = true;
  if (options.friction) set_friction(*options.friction, scene);
  if (options.is_passive) scene.is_passive = true;
  if (options.scene.empty()) scene.simulation.reset();  // somebody holds it
  if (options.texture == "on" && !has_relief(scene))
    throw InputError(scene.file +
                     ": nothing in it has a texture, for --texture on, expected "
                     "an object or static body with one");
}

/// Shows on standard error and to the page how far building has come.
class BuildProgress {
 public:
  explicit BuildProgress(const RunHooks& hooks) : hooks_(hooks) {}
  void update(const std::string& what, double share, double triangles) {
    if (what != what_) {
      what_ = what;
      bar_.emplace(what, "triangles", static_cast<bool>(hooks_.log));
    }
    bar_->update(share, triangles);
    if (hooks_.progress) hooks_.progress(what, share);
    if (share < 1.0) return;
    bar_.reset();
    what_.clear();
  }

 private:
  const RunHooks& hooks_;
  std::string what_;
  std::optional<Progress> bar_;
};

LoadOptions load_options(const RunOptions& options, const RunHooks& hooks,
                         BuildProgress& progress) {
  LoadOptions load;
  load.repairs = options.is_repair;
  load.has_textures = options.texture != "off";
  load.keeps_levels = !options.has_no_cache;
  load.log = hooks.log;
  load.progress = [&progress](const std::string& what, double share, double triangles) {
    progress.update(what, share, triangles);
  };
  return load;
}

SessionOptions session_options(const RunOptions& options, std::uint64_t seed,
                               WebDeviceChannel* web_channel, const Log& log) {
  SessionOptions session;
  session.duration = options.duration.value_or(0.0);
  session.seed = seed;
  session.rate = options.rate;
  session.web_channel = web_channel;
  session.log = log;
  return session;
}

constexpr std::int64_t kPollPeriod = 10'000'000;  // [ns]

/// Waits a little; true: the session is to end.
bool poll(const RunControl& control) {
  const bool is_polled = control.poll && control.poll();
  const bool is_stopped = control.stop != nullptr && control.stop->load(std::memory_order_relaxed);
  sleep_ns(kPollPeriod);
  return is_polled || is_stopped;
}

/// A simulation at the pace of the clock, in a thread of its own.
SessionSummary run_paced(Run& run, const SessionConfig& config, const RunControl& control,
                         const SessionSinks& sinks) {
  std::atomic<bool> stops{false}, is_over{false};
  std::exception_ptr error;
  if (control.begun) control.begun();
  std::thread worker([&] {
    try {
      run.simulated = run_simulated(config, *run.session.simulation, true, sinks, &stops);
    } catch (...) {
      error = std::current_exception();
    }
    is_over = true;
  });
  while (!is_over)
    if (poll(control)) stops = true;
  worker.join();
  if (error) std::rethrow_exception(error);
  return run.simulated.session;
}

SessionSummary run_threads(Run& run, const SessionConfig& config, const RunControl& control,
                           const SessionSinks& sinks) {
  Session session(config, *run.session.device, sinks);
  session.start();
  if (control.begun) control.begun();
  while (session.is_running())
    if (poll(control)) session.request_stop();
  return session.finish();
}

/// Before levels of detail are built beside a session that a page shows [s]: the way to its first
/// picture keeps few processors busy, and even a thread that gives way slows what shares a core.
/// Whose hand is held gets its levels as soon as can be.
double head_start(const Run& run) {
  constexpr unsigned kFew = 4;  // processors
  const unsigned processors = std::thread::hardware_concurrency();
  const bool is_few = processors > 0 && processors <= kFew;
  const bool is_shown = run.web_channel != nullptr;
  return is_few && is_shown && !run.session.device->limits().holds_person ? 5.0 : 0.0;
}

}  // namespace

SceneDescription read_run_scene(const RunOptions& options) {
  if (!options.scene.empty()) return read_named_scene(options.scene);
  return scene_from_pair(options.object, options.against, options.scale.value_or(1.0),
                         options.pose_text.empty() ? Pose{} : *parse_pose(options.pose_text));
}

std::string check_meshes(const SceneDescription& scene, const RunOptions& options) {
  std::vector<const SceneObject*> objects(1, &scene.object);
  for (const SceneObject& other : scene.statics) objects.push_back(&other);
  double largest = 0.0;
  std::string name;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const SceneObject& object = *objects[i];
    if (object.is_textured || object.model) continue;
    const double radius = check_source({.name = object.mesh,
                                        .role = i == 0 ? "--object" : "--against",
                                        .scale = object.unit_scale,
                                        .is_repair = options.is_repair || scene.repairs});
    if (radius > largest) name = object.mesh;
    largest = std::max(largest, radius);
  }
  if (options.object.empty() || options.scale || largest <= kLargestRadius) return "";
  double scale = 1e-3;
  while (largest * scale > kLargestRadius) scale *= 1e-3;
  char line[512];
  std::snprintf(line, sizeof line,
                "%.300s: a radius of %.3g m, which no hand feels; --scale %g where it is in %s, "
                "--scale 1 where it "
                "is meant",
                name.c_str(), largest, scale, scale == 1e-3 ? "mm" : "smaller units");
  return line;
}

bool take_levels(Run& run, const SessionConfig& now, const BodyState& near, const Log& log) {
  if (!run.levels || !run.levels->is_over()) return false;
  const std::unique_ptr<LevelBuild> levels = std::move(run.levels);
  try {
    Scene scene = levels->take();
    run.replacement = run.session.simulation ? nullptr : replace_contacts(now, scene, near);
    run.former.push_back(std::move(run.scene));
    run.scene = std::move(scene);
    run.session.config.contact.object = run.scene.config.contact.object;
    if (run.replacement) run.session.config.contact = run.replacement->world;
  } catch (const std::exception& error) {
    if (log) log(std::string("no levels of detail: ") + error.what());
    return false;
  }
  if (log) log("levels of detail are there");
  return true;
}

SessionSummary run_session(Run& run, const SessionConfig& config, const RunControl& control,
                           const SessionSinks& sinks) {
  if (!control.is_lockstep)
    return run.session.simulation ? run_paced(run, config, control, sinks)
                                  : run_threads(run, config, control, sinks);
  if (control.begun) control.begun();
  if (!run.session.simulation)
    return run_lockstep(config, *run.session.device, sinks, control.stop);
  run.simulated = run_simulated(config, *run.session.simulation, false, sinks, control.stop);
  return run.simulated.session;
}

std::unique_ptr<Run> prepare_run(SceneDescription scene, const RunOptions& options,
                                 std::uint64_t seed, const RunHooks& hooks) {
  auto run = std::make_unique<Run>();
  run->given = scene;
  run->web_channel = hooks.web_channel;
  apply_options(options, scene);
  refuse_web_without_page(scene.device.uri, hooks.web_channel);
  BuildProgress progress(hooks);
  LoadOptions load = load_options(options, hooks, progress);
  // Whoever says how long measures, and gets the levels from the first frame on; so does lockstep,
  // which is the same every time. Of a recording that is shown no frame is like one without them.
  load.defers_levels = !options.is_lockstep && !options.duration && !options.is_shown;
  run->scene = load_scene(scene, load);
  if (options.spin) run->scene.config.spin = 1e-6 * *options.spin;
  run->scene.config.faults = parse_faults(options.fault_text);
  run->session =
      open_session(run->scene, session_options(options, seed, hooks.web_channel, hooks.log));
  if (run->scene.lacks_levels) {
    load.progress = {};
    if (load.log) load.log("begins at full resolution; levels of detail are built meanwhile");
    run->levels = std::make_unique<LevelBuild>(std::move(scene), std::move(load), head_start(*run));
  }
  return run;
}

SceneSession open_run_device(const RunOptions& options, std::uint64_t seed, const std::string& uri,
                             const Pose& world_from_body, const Run& run, const Log& log) {
  SessionOptions session = session_options(options, seed, run.web_channel, log);
  session.device = uri;
  session.world_from_body = world_from_body;
  return open_session(run.scene, session);
}

}  // namespace thigma::app
