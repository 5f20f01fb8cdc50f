#pragma once
// The live page's server: pages watch a session, one of them may hold its device, and sessions
// follow each other.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer/server/messages.h"
#include "viewer/server/web_server.h"

#include "thigma/device/web_device.h"
#include "thigma/session/live_ports.h"
#include "thigma/session/session.h"

namespace thigma::live {

/// Whether a file that a page sends, or that is to be written, is a recording by its name.
bool is_recording_name(const std::string& name);

/// What a page asked for that takes a new session: the program's business.
struct LiveRequest {
  enum class Kind : std::uint8_t {
    reset,
    use_device,
    record,
    choose,
    open,
    seek,
    inspect,
    place,
    compose,
    save,
    add,
    remove
  };
  Kind kind = Kind::reset;
  PageId page = 0;
  std::int64_t id = 0;
  // The device; name of the choice; what to open; name of the file to inspect; "hold" or "touch";
  // title of what is composed; name to save under; of add and remove: a body's.
  std::string text;
  double number = 0.0;  // index of the choice; time to go to [s]; metres per unit of what is placed
  bool flag = false;    // of record; of place: repair; of save: as one file
  std::string data{};   // of inspect: the file; of compose: a JSON array of objects
  std::optional<Vec3> point{};  // of add: of the centre of mass [m; world]
};

/// A session that begins.
struct LiveStart {
  std::string device;         // its address
  bool is_web = false;        // `web:`
  bool is_simulated = false;  // no motors: may be paused
  std::string recording{};    // file being written; "" none
  bool is_lockstep = false;
  PageId holder = 0;                     // page that holds `web:` from the start; 0 none
  std::optional<GainTask> gains{};       // what stiffnesses are judged for; nothing: no warnings
  std::vector<LiveParameter> choices{};  // parameters that are the program's business
  std::string replay{};                  // recording that is shown instead of a session; "" none
  double replay_seconds = 0.0;           // its length [s]
  std::vector<float> replay_force{};     // largest of each of equally long parts of it [N]
};

/// Serves one scene. Threads: one of its own for the server; observe is called by the thread
/// that drains a session's telemetry, all else by the program's.
/// Invariant: nothing that a page does or fails to do makes a caller wait.
class LiveServer {
 public:
  /// config     of the first session, with the device's limits; start: the object's world_from_mesh
  /// devices    addresses that pages may choose from
  /// files      of the page
  /// address    where it listens, and the token of pages that may do more than watch
  /// link       of the device web:; outlives the server
  /// errors     PortUnavailable
  LiveServer(SceneView scene, const SessionConfig& config, const Pose& start,
             std::vector<std::string> devices, std::vector<WebFile> files,
             const WebAddress& address, WebDeviceChannel& link, const WebLimits& limits = {});
  ~LiveServer();
  LiveServer(const LiveServer&) = delete;
  LiveServer& operator=(const LiveServer&) = delete;

  std::string address() const;
  std::uint16_t port() const;

  /// Another scene, between sessions; as for the constructor. Waits until nothing of the one before
  /// is in use, a tick of the server at most.
  void show(SceneView scene, const SessionConfig& config, const Pose& start);
  /// The same scene with other levels of detail, at any time: `scene` is told again, with
  /// `refined`, and its meshes. Waits as show() does.
  void refine(SceneView scene);
  /// A world with other bodies, between two of its frames, from its own thread: `scene` is told
  /// again with its bodies where they are, and its meshes; frames observed from here on are of it,
  /// and until one comes pages see the last with these bodies. Waits as show() does.
  /// was   by body: its number before; -1: it is new. Empty: another session's, of which nothing is
  ///       to be seen before its first frame
  void change_world(SceneView scene, std::vector<std::int32_t> was);
  /// What pages may open.
  void offer(const OpenMenu& menu);
  /// What is being done that takes long, and how far it is; "" when it is done.
  void show_progress(const std::string& what, double share);
  /// From true to false what a page has asked for is being made ready, and pages may cancel that.
  void set_preparing(bool is_preparing);
  /// Whether one of them has since; throw, then.
  bool is_cancelled() const;
  /// How fast pages want a recording to be shown; 1 at the begin of each [s of it a second].
  double replay_speed() const;
  /// A text message to one page.
  void send(PageId page, const std::string& message);
  /// The samples that come next, until the next answer, are of an earlier time; pages that are busy
  /// just then get their rows later.
  void rewind();

  LivePorts& ports();
  void observe(const HapticSample& sample);
  void observe(const ContactSample& sample);
  void observe(const SessionEvent& event);
  /// Of a world, in place of the first two.
  void observe(const WorldFrame& frame);
  /// What keeps a world's bodies apart, of late, and how many rows there are in all.
  void observe(std::span<const WorldRow> rows, std::size_t near);

  /// The parameters as pages have set them, for the session that comes next. Pages cannot change
  /// them from here to begin_session.
  void prepare_session(SessionConfig& config);
  void begin_session(const LiveStart& start);
  /// The recording has ended before its session: pages may change again what it kept them from. Any
  /// thread.
  void lose_recording();
  void end_session(SessionEnd end, std::uint64_t dropped_samples);

  /// What a page asked for, in order; nothing when nobody did.
  std::optional<LiveRequest> take_request();
  /// Answers a request; reason "" when it was done.
  void answer(const LiveRequest& request, const std::string& reason);
  /// Pages connected now.
  std::size_t page_count() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace thigma::live
