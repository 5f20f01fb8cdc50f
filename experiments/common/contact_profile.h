#pragma once
// The contact profile of Figs. 3.15 and 3.16: force, query time and front along one path, at
// several thresholds.

#include <string>
#include <vector>

#include "experiments/common/experiment.h"
#include "experiments/common/replay.h"

namespace thigma::experiments {

/// One way to query, by name.
struct Setting {
  std::string name;
  double threshold = 0.0;  // s0 as a share of the radius; 0: exact
  Resolution resolution;
};

/// Thresholds as in the text, cap off, from exact to the coarsest; then those that differ from it
/// at `main`: other readings of D, the smaller D, the cap, without interpolation.
std::vector<Setting> profile_settings(const std::vector<double>& thresholds, double main);

/// How alike two force profiles are.
struct Likeness {
  double correlation = 0.0;  // of the force
  // correlation of the second derivatives of the force, low-passed at 50 Hz; NaN where the poses
  // are too far apart in time for that
  double curvature = 0.0;
  // root mean square of the difference of the force vectors over that of the reference
  double force_error = 0.0;
  double torque_error = 0.0;  // the same of torque
  double shape_error = 0.0;   // of the force, after the best constant and scale
  double torque_shape_error = 0.0;
};
Likeness compare(const Profile& profile, const Profile& reference, double step);

/// What a study measured.
struct ProfileStudy {
  double step = 0.001;             // of the path [s]
  std::vector<Setting> settings;   // the first is exact
  std::vector<Profile> profiles;   // one a setting, cut to the frames in contact
  std::vector<Likeness> likeness;  // to the first
};

ProfileStudy study_profile(const Context& context, const Pair& pair, const Path& path,
                           const PenaltyParams& gains, const std::vector<Setting>& settings,
                           int repeats);

/// A figure of Sec. 3.5.3 as data: what happens, and what the text says of it.
struct ProfileFigure {
  const char* scene;                  // built in
  HandScript (*hand)(double radius);  // what leads the object
  double quick_seconds;               // of the script with --quick [s]
  std::vector<double> thresholds;     // s0, rising; the path is led at the last
  const char* title;
  const char* source_front;     // how much smaller the source's front is, in words
  const char* source_speed_up;  // how much faster its query, in words
  // Why these do not hold; no reason: they are expected to.
  Known why_no_profile;
  Known why_no_curvature;
  std::vector<Claim> (*own_claims)(const Profile& exact, const Profile& coarse,
                                   const ProfileStudy& study);
};

/// Leads the object once, plays the path back at every setting, and makes claims, tables and figure
/// of it.
Outcome run_profile(const Context& context, const ProfileFigure& figure);

/// How well query time is proportional to the front: R^2 of the means along the path, over the
/// thresholds of the text. The exact query is another algorithm, here as in the source, with a
/// price of its own for a node pair.
double time_by_front(const ProfileStudy& study);
/// The same with the exact query for one more.
double time_by_front_with_exact(const ProfileStudy& study);

}  // namespace thigma::experiments
