#pragma once
// The contact profile of Figs. 3.15 and 3.16: force, query time and front along one path, at several thresholds.

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

/// Thresholds as in the text, cap off, from exact to the coarsest; then those that differ from it at `main`: the
/// other reading of D, the cap, without interpolation.
std::vector<Setting> profile_settings(const std::vector<double>& thresholds, double main);

/// How alike two force profiles are.
struct Likeness {
  double correlation = 0.0;  // of the force
  double curvature =
      0.0;  // correlation of the second derivatives of the force, low-passed at 50 Hz
  double force_error =
      0.0;  // root mean square of the difference of the force vectors over that of the reference
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

/// data.csv (a row a frame and setting) and sweep.csv (a row a setting).
std::vector<Table> profile_tables(const ProfileStudy& study);
/// Force, query time and front over time, as the source draws them, for the settings of the text.
plot::Figure profile_figure(const ProfileStudy& study, const std::string& title,
                            const std::string& note);

/// Index of a setting by name; assert: there is one.
std::size_t setting_index(const ProfileStudy& study, const std::string& name);

/// How well query time is proportional to the front over the settings of the text: R^2 of the means along the path.
double time_by_front(const ProfileStudy& study);
/// The same over single frames of all of them.
double time_by_front_of_frames(const ProfileStudy& study);

}  // namespace thigma::experiments
