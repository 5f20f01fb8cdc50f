#pragma once
// Worlds of several bodies on their way to the pages: where all bodies are, and what hands do.

#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "thigma/loop/samples.h"
#include "thigma/multibody/world_rows.h"
#include "thigma/session/world_session.h"

namespace thigma::live {

/// What pages know of a world, and does not change.
struct WorldView {
  std::vector<Pose> body_from_mesh;   // by body; empty: the scene is none
  std::vector<Workspace> workspaces;  // by hand
  std::int32_t page_hand = -1;        // the one that pages hold
  double rate = 1000.0;               // [Hz]
  std::uint32_t changes = 0;          // of the session's world so far, see WorldAim

  bool is_world() const { return !body_from_mesh.empty(); }
};

/// A hand as it is shown.
struct ViewedHand {
  Pose handle;                      // [world]
  Pose ghost;                       // where it would have what it holds: world_from_mesh
  Vec3 grasp_point = Vec3::Zero();  // on what it holds; else of the handle [m; world]
  Vec3 force = Vec3::Zero();        // on the hand [N; world axes, device size]
  std::int32_t body = -1;           // that it holds; -1: none
  bool is_page = false;
};

/// All that is shown of a frame.
struct WorldNow {
  double time = 0.0;  // [s]
  std::uint64_t frame = 0;
  std::vector<Pose> bodies;  // world_from_mesh
  std::vector<std::uint8_t> is_asleep;
  std::vector<ViewedHand> hands;
  std::int32_t shown_hand = -1;  // whose force and ghost the `snapshot` has: the page's while it
                                 // holds something, else the first that does
  std::int32_t shown_body = -1;  // that it holds, or that was shown last
  std::uint64_t haptic_ticks = 0, haptic_missed = 0;  // as of WorldHapticNow
  double step_cpu = 0.0;                              // of the processor, for the frame [s]
  std::vector<WorldRow> rows;                         // that are shown, as of a frame of late
  std::size_t rows_near = 0;                          // in all
};

/// Keeps the newest frame. Thread: observe from the world's thread, which never waits; newest from
/// the serving one.
class WorldFeed {
 public:
  void begin_session(const WorldView& view);
  /// The frame as samples have it, for rows and tiles: that of the hand that is shown.
  HapticSample observe(const WorldFrame& frame);
  /// What keeps bodies apart, shown from the next frame on.
  /// near   how many rows there are in all
  void observe(std::span<const WorldRow> rows, std::size_t near);
  /// Null before the first frame. Valid until the next call.
  const WorldNow* newest();
  /// What has come so far is not shown any more. Of the serving thread.
  void forget();
  /// The bodies of a world that has changed, where they are until its next frame. Of the serving
  /// thread, while the world's waits.
  /// bodies   world_from_mesh, by body
  /// was      by body: its number before; -1: it is new
  void carry(std::vector<Pose> bodies, std::span<const std::int32_t> was);

 private:
  WorldView view_;              // the world's thread
  std::int32_t last_ = -1;      // body shown last
  WorldNow draft_;              // likewise
  std::vector<WorldRow> rows_;  // likewise: the newest
  std::size_t rows_near_ = 0;   // likewise
  std::mutex mutex_;            // of next_; held for a swap
  WorldNow next_;
  bool has_next_ = false;
  WorldNow now_;  // the serving thread's
  bool has_now_ = false;
};

/// `bodies` of docs/protocol.md.
std::string encode_bodies(const WorldNow& now);

}  // namespace thigma::live
