// Sessions: a frame at a call, or on threads that Python cannot hold up.

#include <cmath>
#include <cstdio>
#include <optional>
#include <type_traits>
#include <utility>

#include "bind.h"
#include "scene_run.h"

namespace thigma::python {
namespace {

using bindings::Handle;
using bindings::RunSample;
using bindings::SteppedRun;
using bindings::ThreadedRun;

SessionOptions session_options(const py::dict& options) {
  SessionOptions o;
  o.device = options["device"].cast<std::string>();
  o.duration = options["duration"].cast<double>();
  o.seed = options["seed"].cast<std::uint64_t>();
  if (!options["rate"].is_none()) o.rate = options["rate"].cast<double>();
  if (!options["start"].is_none())
    o.world_from_body = pose_from(options["start"].cast<Doubles>(), "start");
  return o;
}

template <class Run>
std::unique_ptr<Run> open(const std::shared_ptr<Scene>& scene, const py::dict& options) {
  const SessionOptions chosen = session_options(options);
  const auto recording = options["recording"].cast<std::string>();
  const py::gil_scoped_release unlocked;
  return std::make_unique<Run>(scene, chosen, recording);
}

std::optional<Handle> handle_of(const std::optional<Doubles>& pose,
                                const std::optional<Doubles>& velocity, std::uint32_t buttons) {
  if (!pose) return std::nullopt;
  Handle handle;
  handle.pose = pose_from(*pose, "handle");
  handle.buttons = buttons;
  if (velocity) {
    const double* v = velocity->data();
    handle.twist = Twist{Vec3(v[0], v[1], v[2]), Vec3(v[3], v[4], v[5])};
  }
  return handle;
}

py::list events(const bindings::RunLog& log) {
  py::list list;
  for (const SessionEvent& event : log.events()) {
    py::dict d;
    d["time"] = event.time;
    d["frame"] = event.frame;
    d["kind"] = event_name(event.kind);
    d["detail"] = event.detail;
    d["text"] = event.text;
    list.append(std::move(d));
  }
  return list;
}

py::dict quantiles(const DurationSummary& s) {
  py::dict d;
  d["p50"] = s.p50;
  d["p99"] = s.p99;
  d["p999"] = s.p999;
  d["max"] = s.max;
  d["count"] = s.count;
  return d;
}

/// Fills a dict with what visit_summary tells: the numbers of `thigma run --json`.
class ToDict {
 public:
  explicit ToDict(py::dict& dict) : at_(&dict) {}

  template <class Value>
  void operator()(const std::string& key, const Value& value) {
    (*at_)[py::str(key)] = number(value);
  }
  template <class Fill>
  void group(const std::string& key, bool is_known, const Fill& fill) {
    py::dict group;
    py::dict* const outer = std::exchange(at_, &group);
    if (is_known) fill();
    at_ = outer;
    (*at_)[py::str(key)] = is_known ? py::object(group) : py::none();
  }

 private:
  template <class Value>
  static py::object number(const Value& value) {
    if constexpr (std::is_same_v<Value, std::optional<double>>) return number(value.value_or(NAN));
    if constexpr (std::is_same_v<Value, double>)
      if (!std::isfinite(value)) return py::none();
    return py::cast(value);
  }
  static py::object number(const Quantiles& q) {
    py::dict d;
    const auto put = [&](const char* key, double seconds) {
      d[key] = q.durations.count > 0 ? number(seconds / q.unit) : py::none();
    };
    put("p50", q.durations.p50);
    put("p99", q.durations.p99);
    if (q.has_tail) put("p999", q.durations.p999);
    if (q.has_tail) put("p9999", q.durations.p9999);
    put("max", q.durations.max);
    return d;
  }
  py::dict* at_;  // the group that is being filled
};

py::dict to_dict(const SessionSummary& s) {
  py::dict d;
  d["end"] = end_name(s.end);
  d["seconds"] = s.seconds;
  d["rate"] = s.rate;
  d["frames"] = s.frames;
  d["missed"] = s.missed;
  d["overruns"] = s.deadlines.overruns;
  d["step_cpu"] = quantiles(s.step_cpu);
  d["wake_late"] = quantiles(s.wake_late);
  d["contact_updates"] = s.contact_updates;
  d["query_cpu"] = quantiles(s.query_cpu);
  d["contacts_mean"] = s.contacts_mean;
  d["clusters_mean"] = s.clusters_mean;
  d["dropped_contacts"] = s.dropped_contacts;
  d["dropped_samples"] = s.dropped_samples;
  d["force_max"] = s.force_max;
  d["force_rms"] = s.force_rms;
  d["torque_max"] = s.torque_max;
  d["torque_rms"] = s.torque_rms;
  d["penetration_max"] = s.penetration_max;
  d["stretch_max"] = s.stretch_max;
  d["energy_min"] = s.energy_min;
  d["state_hash"] = hex_text(s.state_hash);
  d["notes"] = s.notes;
  py::dict figures;
  visit_summary(s, ToDict(figures));
  d["figures"] = figures;
  return d;
}

Pose pose_of(const BodyState& body) { return {body.position, body.orientation}; }
Wrench momentum_of(const BodyState& body) { return {body.linear_momentum, body.angular_momentum}; }

void bind_sample(py::module_& module) {
  py::class_<RunSample> sample(module, "Sample", "A haptic frame, as it was.");
  const auto add = [&sample](const char* name, auto get, const char* meaning) {
    sample.def_property_readonly(name, get, meaning);
  };
  using S = const RunSample&;
  sample.def("__repr__", [](S s) {
    char text[120];
    std::snprintf(text, sizeof text, "<thigma.Sample frame %llu, %.3f s, force %.3g N>",
                  static_cast<unsigned long long>(s.haptic.frame), s.haptic.time,
                  s.haptic.command.force.norm());
    return std::string(text);
  });
  add(
      "frame", [](S s) { return s.haptic.frame; }, "Counts from 0.");
  add(
      "time", [](S s) { return s.haptic.time; }, "Session clock [s].");
  add(
      "handle", [](S s) { return to_array(s.haptic.handle.pose); },
      "Pose of the handle (7,) [m; world].");
  add(
      "handle_velocity", [](S s) { return to_array(s.haptic.handle.twist); },
      "Of the handle, linear and angular (6,) [m/s, rad/s; world].");
  add(
      "device_handle", [](S s) { return to_array(s.haptic.device.motion.pose); },
      "Pose of the handle as the device tells it (7,) [m; device frame].");
  add(
      "buttons", [](S s) { return s.haptic.device.buttons; },
      "Bits; 1: the hand holds the object.");
  add(
      "pose", [](S s) { return to_array(pose_of(s.haptic.body)); },
      "Of the object's centre of mass (7,) [m; world].");
  add(
      "momentum", [](S s) { return to_array(momentum_of(s.haptic.body)); },
      "Of the object, linear and angular (6,) [kg m/s, kg m^2/s; world].");
  add(
      "contact_wrench", [](S s) { return to_array(s.haptic.contact); },
      "On the object about its centre of mass (6,) [N, N m; world].");
  add(
      "command", [](S s) { return to_array(s.haptic.command); },
      "Wrench sent to the hand, about the handle (6,) [N, N m; device frame].");
  add(
      "penetration", [](S s) { return s.haptic.penetration; },
      "Deepest contact of the model in use; -inf: none near [m].");
  add(
      "stretch", [](S s) { return s.haptic.stretch; },
      "Of the coupling, from handle to grasp point [m; world].");
  add(
      "energy", [](S s) { return s.haptic.energy; },
      "Put in by the hand so far at the device's port [J].");
  add(
      "touching", [](S s) { return s.haptic.touching; }, "Contact terms that push.");
  add(
      "is_grasped", [](S s) { return s.haptic.is_grasped; }, "Whether the hand holds the object.");
  add(
      "fault", [](S s) { return fault_name(s.haptic.fault); }, "Latched fault, or \"none\".");
  add(
      "contacts", [](S s) { return s.contacts; }, "Found in the last contact frame.");
  add(
      "contact_depth", [](S s) { return s.contact_depth; }, "Deepest of them [m].");
  add(
      "query_cpu", [](S s) { return s.query_cpu; }, "CPU time of that query [s].");
}

/// What both kinds of runs have.
template <class Run>
void bind_run(py::class_<Run>& run) {
  run.def(py::init(&open<Run>))
      .def_property_readonly("last", [](const Run& r) { return r.log().last(); })
      .def_property_readonly("events", [](const Run& r) { return events(r.log()); })
      .def_property_readonly(
          "start_pose", [](const Run& r) { return to_array(r.session().config.world_from_body); })
      .def_property_readonly("device", [](const Run& r) { return r.session().device_uri; })
      .def("finish", [](Run& r) {
        const SessionSummary* summary = nullptr;
        {
          const py::gil_scoped_release unlocked;
          summary = &r.finish();
        }
        return to_dict(*summary);
      });
}

std::optional<RunSample> step(SteppedRun& run, std::uint64_t frames,
                              const std::optional<Doubles>& pose,
                              const std::optional<Doubles>& velocity, std::uint32_t buttons) {
  const std::optional<Handle> handle = handle_of(pose, velocity, buttons);
  const py::gil_scoped_release unlocked;
  if (!run.step(frames, handle, check_signals)) return std::nullopt;
  return run.log().last();
}

}  // namespace

void bind_sessions(py::module_& module) {
  bind_sample(module);
  py::class_<SteppedRun> stepped(module, "SteppedRun");
  bind_run(stepped);
  stepped.def("step", &step).def_property_readonly("is_over", &SteppedRun::is_over);
  py::class_<ThreadedRun> threaded(module, "ThreadedRun");
  bind_run(threaded);
  threaded.def("start", &ThreadedRun::start, WithoutGil())
      .def("wait",
           [](ThreadedRun& run) {
             const py::gil_scoped_release unlocked;
             run.wait(check_signals);
           })
      .def_property_readonly("is_running", &ThreadedRun::is_running);
}

}  // namespace thigma::python
