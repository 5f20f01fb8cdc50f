// Scenes and sessions.

#include "guard.h"
#include "handles.h"
#include "scene_of_meshes.h"

#include "thigma/core/error.h"

namespace {

using namespace thigma;
using bindings::SteppedRun;
using bindings::ThreadedRun;

std::string text_or_empty(const char* text) { return text == nullptr ? "" : text; }

thigma_session_options defaults() {
  thigma_session_options options{};
  options.struct_size = sizeof options;
  options.seed = 1;
  return options;
}

SessionOptions options_from(const thigma_session_options& given) {
  if (!(given.duration >= 0.0 && given.duration < 1e9))
    throw InputError("session: duration must be a finite time, 0 or more [s]");
  SessionOptions options;
  options.device = text_or_empty(given.device);
  options.duration = given.duration;
  options.seed = given.seed;
  if (given.rate != 0.0) options.rate = given.rate;
  return options;
}

void fill(const bindings::RunSample& from, thigma_sample& to) {
  const HapticSample& h = from.haptic;
  to.fault = static_cast<int32_t>(h.fault);
  to.frame = h.frame;
  to.time = h.time;
  c::put(h.handle.pose, to.handle);
  c::put(Pose{h.body.position, h.body.orientation}, to.pose);
  c::put(h.contact, to.contact_wrench);
  c::put(h.command, to.command);
  to.penetration = h.penetration;
  to.contacts = from.contacts;
}

void fill(const SessionSummary& from, thigma_summary& to) {
  to.end = static_cast<int32_t>(from.end);
  to.frames = from.frames;
  to.missed = from.missed;
  to.seconds = from.seconds;
  to.force_max = from.force_max;
  to.torque_max = from.torque_max;
  to.penetration_max = from.penetration_max;
  to.state_hash = from.state_hash;
}

const bindings::RunLog& log_of(const thigma_session& session) {
  return session.stepped ? session.stepped->log() : session.threaded->log();
}

void refuse_finished(const thigma_session& session) {
  if (session.is_finished) throw std::invalid_argument("session: is closed, expected an open one");
}

bindings::Handle handle_from(const thigma_handle& given) {
  bindings::Handle handle;
  handle.pose = c::pose_from(given.pose, "handle");
  handle.buttons = given.buttons;
  return handle;
}

void finish(thigma_session& session, thigma_summary* summary) {
  session.is_finished = true;
  const SessionSummary& felt =
      session.stepped ? session.stepped->finish() : session.threaded->finish();
  if (summary != nullptr) fill(felt, *summary);
}

}  // namespace

extern "C" {

thigma_result thigma_scene_load(const char* path, thigma_scene** scene) {
  return c::guarded([&] {
    c::needed(scene, "scene");
    *scene = new thigma_scene{std::make_shared<const Scene>(load_scene(&c::needed(path, "path")))};
  });
}

thigma_result thigma_scene_pair(const char* object, const char* against, double scale,
                                const double* pose, thigma_scene** scene) {
  return c::guarded([&] {
    c::needed(scene, "scene");
    const Pose place = pose == nullptr ? Pose{} : c::pose_from(pose, "pose");
    SceneDescription pair =
        scene_from_pair(&c::needed(object, "object"), &c::needed(against, "against"), scale, place);
    *scene = new thigma_scene{std::make_shared<const Scene>(load_scene(std::move(pair)))};
  });
}

thigma_result thigma_scene_of_meshes(const thigma_mesh* object, const thigma_mesh* against,
                                     const double* pose, thigma_scene** scene) {
  return c::guarded([&] {
    c::needed(scene, "scene");
    const TriangleMesh& held = c::needed(object, "object").surface;
    const TriangleMesh& standing = c::needed(against, "against").surface;
    const Pose place = pose == nullptr ? Pose{} : c::pose_from(pose, "pose");
    *scene = new thigma_scene{
        std::make_shared<const Scene>(bindings::scene_of_meshes(held, standing, place))};
  });
}

void thigma_scene_free(thigma_scene* scene) { delete scene; }

void thigma_session_options_init(thigma_session_options* options) {
  if (options != nullptr) *options = defaults();
}

thigma_result thigma_session_open(const thigma_scene* scene, const thigma_session_options* options,
                                  thigma_session** session) {
  return c::guarded([&] {
    c::needed(session, "session");
    const std::shared_ptr<const Scene>& loaded = c::needed(scene, "scene").scene;
    const thigma_session_options given =
        options == nullptr ? defaults() : c::sized(options, "options");
    const SessionOptions chosen = options_from(given);
    const std::string recording = text_or_empty(given.recording);
    auto made = std::make_unique<thigma_session>();
    if (given.has_threads != 0)
      made->threaded = std::make_unique<ThreadedRun>(loaded, chosen, recording);
    else
      made->stepped = std::make_unique<SteppedRun>(loaded, chosen, recording);
    *session = made.release();
  });
}

thigma_result thigma_session_step(thigma_session* session, uint64_t frames,
                                  const thigma_handle* handle, thigma_sample* sample) {
  return c::guarded([&]() -> thigma_result {
    thigma_session& s = c::needed(session, "session");
    refuse_finished(s);
    if (!s.stepped)
      throw std::invalid_argument("session: step of a session on threads, expected lockstep");
    if (frames < 1) throw std::invalid_argument("frames: 0, expected 1 or more");
    if (sample != nullptr) c::sized(sample, "sample");
    std::optional<bindings::Handle> held;
    if (handle != nullptr) held = handle_from(c::sized(handle, "handle"));
    const bool goes_on = s.stepped->step(frames, held);
    if (const auto last = s.stepped->log().last(); last && sample != nullptr) fill(*last, *sample);
    return goes_on ? THIGMA_OK : THIGMA_ENDED;
  });
}

thigma_result thigma_session_start(thigma_session* session) {
  return c::guarded([&] {
    thigma_session& s = c::needed(session, "session");
    refuse_finished(s);
    if (!s.threaded)
      throw std::invalid_argument("session: start of a session in lockstep, expected threads");
    s.threaded->start();
  });
}

int32_t thigma_session_is_running(const thigma_session* session) {
  if (session == nullptr || session->is_finished) return 0;
  return session->stepped ? !session->stepped->is_over() : session->threaded->is_running();
}

thigma_result thigma_session_last(const thigma_session* session, thigma_sample* sample) {
  return c::guarded([&] {
    const auto last = log_of(c::needed(session, "session")).last();
    c::sized(sample, "sample");
    if (!last) throw std::invalid_argument("session: no frame has been made yet");
    fill(*last, *sample);
  });
}

thigma_result thigma_session_finish(thigma_session* session, thigma_summary* summary) {
  return c::guarded([&] {
    if (summary != nullptr) c::sized(summary, "summary");
    finish(c::needed(session, "session"), summary);
  });
}

void thigma_session_free(thigma_session* session) {
  if (session == nullptr) return;
  static_cast<void>(c::guarded([&] { finish(*session, nullptr); }));
  delete session;
}

}  // extern "C"
