#pragma once
// The text messages of docs/protocol.md: what pages ask for, and what they are told.

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/server/tuning.h"
#include "viewer/server/web_server.h"
#include "viewer/server/world_feed.h"

#include "thigma/clod/hierarchy.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/session/session.h"

namespace thigma {
struct HapticTexture;
}

namespace thigma::live {

/// What a page asks for.
struct Command {
  enum class Kind : std::uint8_t {
    hold,
    use_device,
    pause,
    step,
    reset,
    record,
    set,
    level,
    open,
    seek,
    upload,
    place,
    cancel,
    speed,
    compose,
    save,
    grab,
    add,
    remove
  };
  Kind kind = Kind::reset;
  std::int64_t id = 0;
  bool flag = false;  // of hold, pause, record; of place: repair; of save: as one file
  // of step, set, level, seek, speed; of upload: bytes; of place: metres per unit
  double number = 0.0;
  std::int64_t mesh = 0;  // of level: the mesh's number
  // of use_device: the device; of set: the parameter; of open: what; of upload: a file's name; of
  // place: "hold" or "touch"; of compose: the title; of save: a name; of grab, add, remove: a
  // body's; of grab "": none
  std::string text;
  std::string objects{};  // of compose: a JSON array of objects
  // of grab: where [m; mesh frame]; of add: of the centre of mass [m; world]
  std::optional<Vec3> point{};
};

/// A message of a page, or why it is none.
struct ParsedCommand {
  Command command;
  Refusal refusal;
};
ParsedCommand parse_command(std::string_view text);

/// A body of the scene as it is shown. Meshes and hierarchy outlive the server.
struct SceneBodyView {
  std::string name;
  // of the levels that are not free, finest first; one at least
  std::span<const TriangleMesh> meshes;
  const ClodHierarchy* hierarchy = nullptr;
  Pose world_from_mesh;                   // of static ones
  const HapticTexture* relief = nullptr;  // over the surface of level 0; null: none is felt
  std::string source{};  // what a composition calls it (docs/protocol.md, `compose`)
  // as the scene has them; nothing: it leaves them open
  double unit_scale = 1.0;                              // metres per unit of the mesh
  std::optional<double> friction{}, mass{}, density{};  // mass [kg], density [kg/m^3]
  // of a world of several bodies
  std::int32_t body = -1;  // its number there
  std::int32_t mesh = -1;  // number of its mesh: bodies of one number have one mesh
  bool moves = false;      // a hand may take hold of it
};

/// What is shown, and does not change.
struct SceneView {
  std::string title, name;
  std::string program;  // and its version
  SceneBodyView object;
  std::vector<SceneBodyView> statics;  // of a world: all bodies but `object`
  WorldView world{};
};

/// What a page may open.
struct OpenMenu {
  struct Item {
    std::string name, title;
  };
  std::vector<Item> scenes, recordings;
};

/// What a session was told of a fault, or of something late that was ridden out.
struct Trouble {
  std::string name;   // of the fault; "": none
  std::string text;   // more, for people
  double time = 0.0;  // [s; session clock]
};

enum class RunPhase : std::uint8_t { running, paused, ended };

/// Of the constrained response, for `state`: the newest contact model, and shares of the frames of
/// the last second.
struct RowsNow {
  std::int64_t rows = 0, in_model = 0, halvings = 0, left_out = 0;  // see ContactSample
  double travel = 0.0, look_ahead = 0.0;                            // [m]
};

/// What the hand can be made to feel at most, device size; NaN: not known, or nothing turns it.
struct WrenchLimits {
  double force = std::numeric_limits<double>::quiet_NaN();   // [N]
  double torque = std::numeric_limits<double>::quiet_NaN();  // [N m]
};

/// By the safety limits and those of the device.
/// Thread    any
WrenchLimits wrench_limits(const HapticParams& params);

/// How the session stands, for `state`.
struct RunState {
  int session = 0;
  RunPhase run = RunPhase::running;
  std::string reason;  // "" for null
  double time = 0.0;
  std::string device;
  std::vector<std::string> devices;
  std::string recording;        // being written; "" for null
  std::string replay;           // being shown instead of a session; "" for null
  double replay_seconds = 0.0;  // its length [s]
  double replay_speed = 1.0;    // seconds of it a second
  bool is_simulated = true;
  std::size_t pages = 0;
  Trouble fault;            // latched, or what ended the session
  Trouble late;             // the last one ...
  std::uint64_t lates = 0;  // ... of so many
  std::optional<RowsNow> rows;
  WrenchLimits limits;
};

/// Over the last second; NaN: nothing was measured.
struct Timing {
  double step_p50, step_p99, late_p50, late_p99, query_p50, query_p99;  // [s]
  double haptic_hz, contact_hz;
  std::uint64_t missed = 0;
  double held_back = 0.0, squeezed = 0.0;  // of the frames, shares
};

/// A page, and whether it may do more than watch.
struct PageRights {
  PageId id = 0;
  bool may_control = true;
};

std::string hello_message(const SceneView& scene, const PageRights& page, double lost_after,
                          std::size_t max_message);
/// start: the object's world_from_mesh where the session begins; is_refined: it is told again as
/// its levels have come, and the session goes on.
std::string scene_message(const SceneView& scene, const SessionConfig& config, const Pose& start,
                          bool is_refined = false);
std::string parameters_message(const std::vector<LiveParameter>& list);
std::string state_message(const RunState& state, const Timing& timing, std::string_view holder,
                          std::uint64_t dropped_yours, std::uint64_t dropped_rows,
                          std::uint64_t dropped_samples);
std::string menu_message(const OpenMenu& menu);
/// what: being done, "" when it is; share 0..1
std::string progress_message(const std::string& what, double share);
/// `strip`: the largest force of each of equally long parts of a recording [N].
std::string strip_message(double seconds, const std::vector<float>& force);

/// `saved`: where something is now that a page had saved.
std::string saved_message(std::int64_t id, const std::string& path);

std::string event_message(const SessionEvent& event);
/// `camera`: where the handle of the second device is that moves the view.
std::string camera_message(const Pose& pose);
/// reason: "" when it was done.
std::string ack_message(std::int64_t id, const std::string& reason,
                        std::optional<double> value = std::nullopt);

}  // namespace thigma::live
