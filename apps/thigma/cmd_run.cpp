// thigma run: a hand moves an object against others and feels what it touches.

#include <cstdio>
#include <memory>
#include <mutex>
#include <optional>

#include "device_errors.h"
#include "guarded_writer.h"
#include "json_out.h"
#include "named_scene.h"
#include "playback.h"
#include "run_live.h"
#include "run_options.h"
#include "run_session.h"
#include "run_summary.h"
#include "run_world.h"
#include "signal_guard.h"
#include "verbs.h"
#include "viewer/server/live_server.h"
#include "viewer/server/web_server.h"
#include <unistd.h>

#include "thigma/core/error.h"
#include "thigma/device/open_device.h"
#include "thigma/recording/config_json.h"
#include "thigma/recording/recording.h"
#include "thigma/scene/packed_scene.h"
#include "thigma/scene/record_session.h"
#include "thigma/session/simulated_session.h"

namespace thigma::app {
namespace {

/// The newest frame for the live table, handed over by the session's drain thread.
class LiveTable {
 public:
  void observe(const HapticSample& sample) {
    const std::lock_guard lock(mutex_);
    haptic_ = sample;
  }
  void observe(const ContactSample& sample) {
    const std::lock_guard lock(mutex_);
    contacts_ = sample.contacts;
    clusters_ = sample.clusters;
    query_ = sample.query_cpu;
  }
  void draw(bool is_first) {
    const std::lock_guard lock(mutex_);
    if (!is_first) std::fprintf(stderr, "\033[6A");
    const HapticSample& h = haptic_;
    const Vec3 mm = 1e3 * h.body.position;
    std::fprintf(stderr, "\033[K time      %9.2f s      %s%s\n", h.time,
                 h.is_grasped ? "held" : "not held",
                 h.fault != Fault::none ? fault_name(h.fault)
                 : h.is_armed           ? ", forces on"
                                        : ", forces off");
    std::fprintf(stderr, "\033[K object    %9.2f %9.2f %9.2f mm\n", mm.x(), mm.y(), mm.z());
    std::fprintf(stderr, "\033[K force     %9.3f %9.3f %9.3f N      |F| %.3f N\n",
                 h.command.force.x(), h.command.force.y(), h.command.force.z(),
                 h.command.force.norm());
    std::fprintf(stderr, "\033[K torque    %9.2f %9.2f %9.2f mN m\n", 1e3 * h.feedback.torque.x(),
                 1e3 * h.feedback.torque.y(), 1e3 * h.feedback.torque.z());
    std::fprintf(stderr,
                 "\033[K contacts  %9lld in %d clusters, query %.0f us, model %.1f ms old\n",
                 static_cast<long long>(contacts_), static_cast<int>(clusters_), 1e6 * query_,
                 1e3 * h.model_age);
    std::fprintf(stderr, "\033[K depth     %9.4f mm     stretch %.3f mm\n",
                 h.penetration > 0.0 ? 1e3 * h.penetration : 0.0, 1e3 * h.stretch);
  }

 private:
  std::mutex mutex_;
  HapticSample haptic_;
  std::int64_t contacts_ = 0;
  std::int32_t clusters_ = 0;
  double query_ = 0.0;
};

/// The scene travels with its recording.
void attach_scene(const SceneDescription& scene, const Common& common, RecordingWriter& writer) {
  std::vector<McapAttachment> files;
  try {
    files = pack_scene(scene);
  } catch (const InputError& error) {
    if (!common.quiet) print_error(std::string(error.what()) + "; the recording goes without it");
  }
  for (const McapAttachment& file : files) writer.attach(file);
}

std::unique_ptr<RecordingWriter> open_recording(const std::string& path, const RunOptions& options,
                                                const Run& run, const Common& common) {
  if (path.empty()) return nullptr;
  const RecordedConfig recorded = recorded_config(run.session, options.is_lockstep);
  auto writer = std::make_unique<RecordingWriter>(path, write_config(recorded));
  attach_scene(run.given, common, *writer);
  record_surfaces(run.session.config.contact, *writer);
  if (!common.quiet && !writer->moved().empty())
    print_error(path + ": what a session that was killed left is now " + writer->moved());
  return writer;
}

/// How late this machine wakes a thread that does nothing, so that missed frames can be judged.
EmptyLoop measure_floor(const SessionConfig& config) {
  const EmptyLoop floor = measure_empty_loop(config.haptic_thread, config.rate, 0.5, config.spin);
  const DurationSummary late = summarize(floor.wake_late);
  std::fprintf(stderr,
               "thigma: empty loop at %g Hz: %llu of %llu frames missed, late by p50 %.2f us, p99 "
               "%.1f us, max %.0f us\n",
               config.rate, static_cast<unsigned long long>(floor.missed),
               static_cast<unsigned long long>(floor.ticks), 1e6 * late.p50, 1e6 * late.p99,
               1e6 * late.max);
  return floor;
}

void prepare_process(Run& run, bool is_quiet) {
  const std::string refused = lock_process_memory();
  if (!refused.empty() && !is_quiet) std::fprintf(stderr, "thigma: %s\n", refused.c_str());
  if (!is_quiet) run.floor = measure_floor(run.session.config);
}

/// Lines for people; empty: no lines, no progress either.
Log log_of(const Common& common) {
  if (common.quiet) return {};
  return [](const std::string& line) { std::fprintf(stderr, "thigma: %s\n", line.c_str()); };
}

/// Without a page: one session, no table. is_whole: of the recording, where one was asked for.
SessionSummary run_alone(const RunOptions& options, const Common& common, Run& run,
                         bool& is_whole) {
  GuardedWriter<RecordingWriter> recorder([&](const RecordingFailure& failure) {
    is_whole = false;
    print_error(failure.line());
  });
  recorder.begin(open_recording(options.record, options, run, common));
  SessionSinks sinks;
  if (recorder.is_open()) {
    sinks = {[&](const HapticSample& sample) { recorder.write_frame(sample); },
             [&](const ContactSample& sample) { recorder.write(sample); },
             [&](const SessionEvent& event) { recorder.write(event); }};
  }
  const bool has_threads = !options.is_lockstep && !run.session.simulation;
  if (has_threads) prepare_process(run, common.quiet);
  SessionConfig config = run.session.config;
  if (recorder.is_open()) config.telemetry_models = kRecordedModels;
  RunControl control{.is_lockstep = options.is_lockstep, .stop = &stop_requested};
  LivePorts ports;  // for levels that are built meanwhile
  LastBody last;
  if (run.levels && has_threads) {
    config.live = &ports;
    sinks.haptic = [&, write = sinks.haptic](const HapticSample& sample) {
      last.observe(sample);
      if (write) write(sample);
    };
    control.poll = [&] {
      if (take_levels(run, config, last.state(), log_of(common)))
        ports.replacement.store(run.replacement.get(), std::memory_order_release);
      return false;
    };
  }
  const SessionSummary summary = run_session(run, config, control, sinks);
  if (has_threads && !common.quiet) {
    for (const std::string& note : summary.notes)
      std::fprintf(stderr, "thigma: %s\n", note.c_str());
  }
  recorder.close(RecordingEnd{summary.frames, summary.state_hash, summary.dropped_samples});
  return summary;
}

/// With the page, and a table in the terminal.
SessionSummary run_with_page(const RunOptions& options, const Common& common,
                             WebDeviceChannel& link, std::unique_ptr<Run>& run) {
  LiveTable table;
  const bool wants_table = !options.is_lockstep && !common.quiet && isatty(2) != 0;
  int polls = 0;
  LiveProgram program;
  program.run = &run;
  program.web_channel = &link;
  program.options = &options;
  program.seed = common.seed;
  program.stop = &stop_requested;
  program.record = [&](const std::string& path) {
    return open_recording(path, options, *run, common);
  };
  program.log = [&common](const std::string& line) {
    if (!common.quiet) std::fprintf(stderr, "thigma: %s\n", line.c_str());
  };
  program.print_trouble = print_error;
  if (wants_table) {
    program.observe_haptic = [&table](const HapticSample& sample) { table.observe(sample); };
    program.observe_contact = [&table](const ContactSample& sample) { table.observe(sample); };
    program.poll = [&] {
      if (++polls % 10 == 0) table.draw(polls == 10);
    };
  }
  if (!options.is_lockstep) prepare_process(*run, common.quiet);
  return run_live(program);
}

void tell_of_suspension() {
  if (was_suspended)
    print_error(
        "a session cannot be suspended, as the device would keep its last force: ended instead");
}

int refuse(int code, const std::string& why) {
  print_error(why);
  return code;
}

int run_asked(const RunOptions& asked, const Common& common) {
  for (const std::string& read : {asked.scene, asked.replay})
    if (!asked.record.empty() && is_one_file(read, asked.record))
      return refuse(kUsage, "--record " + asked.record + " is what is read, expected another file");
  if (!asked.record.empty() && !live::is_recording_name(asked.record) && !common.quiet)
    print_error(asked.record +
                ": not named .mcap: `thigma run` and the page do not take it for a recording, "
                "replay, export and plot do");
  if (asked.replay.empty() && is_named_world(asked.scene)) {
    const SignalGuard signals;
    const int code = run_world_scene(asked, common, stop_requested);
    tell_of_suspension();
    return code;
  }
  const Log log = log_of(common);
  RunOptions options = asked;
  options.is_shown = !options.replay.empty();
  if (options.is_shown) use_recorded_scene(options);
  SceneDescription scene = read_run_scene(options);
  if (const std::string wrong = check_meshes(scene, options); !wrong.empty())
    return refuse(kUsage, "run: " + wrong);
  WebDeviceChannel link;
  std::unique_ptr<Run> run = prepare_run(std::move(scene), options, common.seed,
                                         {log, {}, has_page(options) ? &link : nullptr});
  const SignalGuard signals;
  bool is_whole = true;
  const SessionSummary summary = has_page(options) ? run_with_page(options, common, link, run)
                                                   : run_alone(options, common, *run, is_whole);
  if (common.json) {
    nlohmann::ordered_json json =
        run_summary_json(summary, run->scene.description.file, run->session.device_uri,
                         run->floor ? &*run->floor : nullptr);
    if (run->session.simulation) json["simulation"] = simulation_json(*run);
    print_json(json);
  } else {
    std::printf("%s", run_summary_text(summary).c_str());
    if (run->session.simulation) std::printf("%s", simulation_text(*run).c_str());
  }
  flush_output();
  if (!options.histograms.empty()) write_histograms(options.histograms, summary.histograms);
  for (const SessionEvent& event : summary.safety_events) {
    std::fprintf(stderr, "thigma: safety fault %s at %.3f s: zero force%s%s\n",
                 event.detail.c_str(), event.time,
                 summary.end == SessionEnd::fault ? " since" : " until taken up again",
                 event.text.empty() ? "" : ("; " + event.text).c_str());
  }
  tell_of_suspension();
  if (summary.end == SessionEnd::fault) return kSafetyFault;
  if (!is_whole) return kFailed;
  return summary.end == SessionEnd::stopped ? kInterrupted : kDone;
}

}  // namespace

int run_verb(const RunOptions& options, const Common& common) {
  try {
    return with_device([&] { return run_asked(options, common); });
  } catch (const live::PortUnavailable& error) {
    return refuse(kUnavailable, error.what());
  }
}

void add_run(CLI::App& app, Common& common) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* verb = add_verb(app, common, "run", "move an object against others and feel them",
                            [options, &common]() -> int {
                              const std::string wrong = check_run_options(*options);
                              if (!wrong.empty()) return refuse(kUsage, wrong);
                              try {
                                parse_faults(options->fault_text);
                              } catch (const InputError& error) {
                                return refuse(kUsage, error.what());
                              }
                              return run_verb(*options, common);
                            });
  add_run_options(*verb, *options);
}

}  // namespace thigma::app
