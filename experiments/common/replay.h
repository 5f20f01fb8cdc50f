#pragma once
// Contact experiments of Sec. 3.5.3: a hand leads the object once, rendered directly; the same
// poses are then queried again at other resolutions.

#include <functional>
#include <vector>

#include "experiments/common/assets.h"

#include "thigma/contact/query_contacts.h"
#include "thigma/contact/resolution.h"
#include "thigma/device/hand.h"
#include "thigma/response/direct.h"

namespace thigma::experiments {

/// d of direct rendering, over the pair's smaller radius. The text takes d = F_max / k for the
/// device's best stiffness k; with 3.3 N this is 1.8 kN/m for the jaws and 3 kN/m for the golf
/// ball, what 6-DoF devices of its time rendered.
inline constexpr double kDirectTolerance = 0.05;

/// Direct rendering as in the text: the device's maximum force at zero distance, nothing at the
/// tolerance.
///
/// tolerance_share  d over the pair's smaller radius: the device is taken to be one whose best
///                  stiffness is F_max / d
/// max_force        [N]
PenaltyParams direct_gains(const Pair& pair, double tolerance_share = kDirectTolerance,
                           double max_force = 3.3);

/// A motion of the object.
struct Path {
  double step = 0.001;      // from pose to pose [s]
  std::vector<Pose> poses;  // world_from_object
};

/// How a hand moves, relative to the object's first touch with the scene.
struct HandScript {
  double seconds = 0.9;
  double depth = 0.0025;  // of the target beyond the touch: arm_stiffness times it is pressed [m]
  double approach_time = 0.15;  // [s]
  Vec3 slide = Vec3::Zero();    // amplitude across the approach [m]
  double slide_rate = 1.5;      // [Hz]
  Vec3 turn = Vec3::Zero();     // amplitude about the object's centre [rad]
  double turn_rate = 1.1;       // [Hz]
  double tap = 0.0;             // amplitude of depth [m]
  double tap_rate = 0.0;        // [Hz]
};

/// The simulated hand leads the object along a script, with direct rendering at the given
/// resolution. The path starts where the pair stands apart. The reaction acts about the centre of
/// the object, whose handle is there.
/// Thread   [offline]; deterministic while the resolution has no budget in time.
Path record_path(const Pair& pair, const Resolution& resolution, const PenaltyParams& gains,
                 const HandScript& script);

/// What each frame of a path gave.
struct Profile {
  std::vector<Vec3> force, torque;  // on the object, about its centre [N, N m; world]
  std::vector<double> force_size;   // [N]
  std::vector<double> cpu;          // of the query, least of the repeats [s]
  std::vector<double> front, tests, contacts;
  std::vector<double> mandatory, unrefined;
  std::vector<double> level;  // mean of both objects' levels over the contacts; NaN without
  std::vector<double> depth;  // of the deepest contact [m]; -tolerance without
  std::vector<double> bound;  // largest of the frame [m]
};

/// Where clusters of contacts start from.
enum class ClusterStart : unsigned char {
  last_frame,  // as a session has it: smooth, but dependent on what came before
  afresh,      // a function of the contacts alone
};

/// Queries a path with a front of its own.
/// repeats   at least 1; all but the times are the same in each
Profile replay(const Pair& pair, const Path& path, const Resolution& resolution,
               const PenaltyParams& gains, int repeats = 1,
               ClusterStart start = ClusterStart::last_frame);

/// A resolution as the text has it: threshold alone, no cap. s0 = 0: exact.
Resolution as_in_text(double threshold);

/// Leaves out frames before the first with a force in `reference` and after the last.
struct Span {
  std::size_t begin = 0, end = 0;
};
Span in_contact(const Profile& reference);
std::vector<double> cut(const std::vector<double>& values, const Span& span);

}  // namespace thigma::experiments
