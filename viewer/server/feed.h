#pragma once
// Telemetry on its way from a session to the pages: nothing here can make the session wait.

#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

#include "viewer/server/protocol.h"

#include "thigma/core/latest.h"
#include "thigma/core/spsc_ring.h"
#include "thigma/device/workspace.h"
#include "thigma/session/session.h"

namespace thigma::live {

/// A haptic frame and what had to be remembered to show it.
struct HapticNow {
  HapticSample sample;
  Pose ghost;  // where the hand would have the body: world_from_body
};

/// Between the thread that drains a session's telemetry and the thread that serves pages.
/// Thread: observe from the draining thread, everything else from the serving one. Sessions may
/// follow each other, one at a time.
class LiveFeed {
 public:
  explicit LiveFeed(const Workspace& workspace) : workspace_(workspace) {}

  /// To be called before the samples of a session: nothing is remembered of the one before.
  void begin_session(const Workspace& workspace) noexcept;
  void observe(const HapticSample& sample);
  void observe(const ContactSample& sample);
  void observe(const SessionEvent& event);
  /// A step of a world, which shows no contacts; cpu: time of it [s].
  void observe_world_step(double cpu);

  /// Moves all rows that wait to the end of `rows`.
  void take_rows(std::vector<ChannelRow>& rows);
  /// Moves all CPU times of queries that wait to the end of `times` [s].
  void take_query_times(std::vector<double>& times);
  /// Moves all events that wait to the end of `events`.
  void take_events(std::vector<SessionEvent>& events);
  /// Nothing of what has come so far is shown any more: another scene comes. Rows and events that
  /// wait stay.
  void forget();
  /// The newest frame; null before the first.
  const HapticNow* haptic();
  /// The newest contact frame; null before the first.
  const ContactSample* contact();
  std::uint64_t contact_updates() const { return contact_updates_.load(std::memory_order_relaxed); }
  /// Rows there was no room for.
  std::uint64_t dropped_rows() const { return rows_.dropped(); }

 private:
  Workspace workspace_;
  // The draining thread's.
  Pose last_body_, body_from_grasp_;
  bool was_grasped_ = false;
  std::uint64_t next_frame_ = 0;  // the one that last_body_ is the state before; 0: not known
  // Shared.
  SpscRing<ChannelRow> rows_{8192};
  SpscRing<double> query_times_{8192};
  Latest<HapticNow> haptic_;
  Latest<ContactSample> contact_;
  std::atomic<std::uint64_t> contact_updates_{0};
  std::mutex events_mutex_;  // events are rare; no real-time thread comes here
  std::vector<SessionEvent> events_;
  // The serving thread's.
  bool has_haptic_ = false, has_contact_ = false;
};

/// Snapshot of a frame but for the sums over time: rates and counts of contacts. clusters gets what
/// the snapshot's own span points to.
///
/// body_from_mesh, grasp_point   of the object, the latter in the body frame
/// contact                       null: no clusters
Snapshot make_snapshot(const HapticNow& now, const ContactSample* contact, const RigidBody& body,
                       const Workspace& workspace, const Pose& body_from_mesh,
                       const Vec3& grasp_point, std::vector<ViewedCluster>& clusters);

/// The rows of the newest model as they stand at the frame, those that press in it first, then the
/// nearest; at most kViewedRows. Rows without a normal, of parallel edges, are left out.
///
/// contact  null: none
/// rows     overwritten
void view_rows(const HapticSample& haptic, const ContactSample* contact,
               std::vector<ViewedRow>& rows);

}  // namespace thigma::live
