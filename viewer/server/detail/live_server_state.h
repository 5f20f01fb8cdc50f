#pragma once
// Inside of the live server: its state and the steps on it. Commands of pages are in
// live_server_commands.cpp, what pages are sent in live_server_show.cpp, sessions and pages that
// come and go in live_server.cpp.

#include <atomic>
#include <deque>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/server/feed.h"
#include "viewer/server/live_server.h"
#include "viewer/server/protocol.h"
#include "viewer/server/timing_window.h"
#include "viewer/server/tuning.h"

namespace thigma::live {

inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
inline constexpr const char* kIsLockstep = "a session in lockstep is the same every time";
inline constexpr const char* kIsRecording =
    "a recording is being written, and could not be replayed if this changed: stop it first";
inline constexpr const char* kIsReplay =
    "a recording is shown as it was; begin a session to change this";
inline constexpr const char* kIsHeld = "another page holds the device";
inline constexpr const char* kIsWatching =
    "this page only watches: open the address with its token, as the program has printed it";
inline constexpr const char* kIsNoWorld = "only a world of several bodies has some to choose from";
inline constexpr const char* kIsWorld = "a world of several bodies has no parameters to change yet";
inline constexpr const char* kIsRestarting = "the session is just beginning anew";

struct LiveServer::Impl {
  Impl(SceneView scene_in, const SessionConfig& config_in, const Pose& start_in,
       std::vector<std::string> devices, std::vector<WebFile> files, const WebAddress& address,
       WebDeviceChannel& link_in, const WebLimits& limits_in);

  // On the server's thread.
  void opened(PageId page);
  void closed(PageId page);
  Refusal received(PageId page, std::string_view message, bool is_binary);
  Refusal take_samples(PageId page, std::string_view message);
  void take_command(PageId page, const Command& command);
  std::string cancel();
  std::string set_speed(double value);
  std::string hold(PageId page, bool wanted);
  bool is_held_by_other(PageId page) const;
  std::string grab(PageId page, const Command& command);
  std::string pause(bool wanted);
  std::string step(double frames);
  std::string change(const Command& command);
  std::string take_upload(PageId page, const Command& command);
  Refusal take_chunk(PageId page, std::string_view message);
  std::size_t waiting_files();
  void ask_program(LiveRequest request);
  void show_scene(SceneView view, const SessionConfig& config, const Pose& start);
  void encode_meshes();
  void encode_world_meshes();
  void carry_world(std::span<const std::int32_t> was);
  void send_scene(PageId page);
  std::vector<LiveParameter> parameters();
  std::string send_level(PageId page, const Command& command);
  bool is_choice(const std::string& name) const;
  void tick();
  void collect_rows();
  void show();
  void show_camera(PageId page, const DeviceState& device);
  void send_events();
  void remember(const SessionEvent& event);
  void send_state();
  void send_state_to(PageId page);
  void send_parameters();
  void send_to_all(const std::string& text);
  Snapshot snapshot_now(const HapticNow& now);
  void show_world(const WorldNow& world, Snapshot& snapshot);
  void began(const LiveStart& start);
  void forget_troubles();
  void lock_tuner();  // with the mutex held
  void lost_recording();
  void ended(SessionEnd end, std::uint64_t dropped_samples);

  const WebLimits limits;

  // The server's thread only, but while it is constructed.
  SceneView scene;
  SessionConfig config;  // what `scene` says of it
  Pose body_from_mesh;
  Vec3 grasp_point;
  Pose start_pose;
  std::vector<std::string> meshes;
  bool is_refined = false;  // while `scene` is told again for its levels alone
  OpenMenu menu;
  struct Upload {
    std::int64_t id = 0;
    std::string name;
    std::size_t bytes = 0;
    std::string data;
  };
  std::map<PageId, Upload> uploads;

  // Between threads.
  std::unique_ptr<LivePorts> ports;
  WebDeviceChannel& link;
  LiveFeed feed;
  WorldFeed world_feed;
  std::atomic<std::size_t> open_pages{0};
  std::atomic<bool> is_preparing{false}, is_cancelled{false};
  std::atomic<double> replay_speed{1.0};
  mutable std::mutex mutex;  // of what follows; never held for longer than a copy takes
  Tuner tuner;
  bool is_restarting = true;
  WrenchLimits next_limits;  // of the session that is being prepared
  std::deque<LiveRequest> requests;

  // The server's thread only.
  RunState state;
  LiveStart now_running;
  PageId holder = 0;
  double last_sample = -std::numeric_limits<double>::infinity();  // of the holder's clock
  Timing timing{kUnknown, kUnknown, kUnknown, kUnknown, kUnknown, kUnknown,
                kUnknown, kUnknown, 0,        0.0,      0.0};
  TimingWindow window;
  std::vector<ChannelRow> rows;
  // Rows of the time before a frame that was jumped to come once, as nothing runs on there. Pages
  // that were busy just then get them later.
  bool is_rewound = false;  // they are coming
  std::map<PageId, std::vector<std::string>> owed;
  std::vector<double> query_times;
  std::vector<SessionEvent> events;
  std::map<PageId, Pose> told_cameras;
  std::vector<ViewedCluster> clusters;
  std::vector<ViewedRow> viewed_rows;
  std::uint64_t ticks = 0, left_out = 0, dropped_samples = 0;
  Fault last_fault = Fault::none;
  double rate;

  WebServer server;  // last: its thread uses all of the above
};

}  // namespace thigma::live
