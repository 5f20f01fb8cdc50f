// Fig. 3.15: the moving jaws, rendered directly; one recorded path at thresholds up to 2.5 % and exactly.

#include "experiments/common/all_experiments.h"
#include "experiments/common/contact_profile.h"
#include "experiments/common/hands.h"
#include "experiments/common/statistics.h"

namespace thigma::experiments {
namespace {

constexpr double kMain = 0.025;

std::vector<Claim> make_claims(const ProfileStudy& study) {
  const std::size_t main = setting_index(study, "s0 = 2.5 %");
  const Profile& exact = study.profiles[0];
  const Profile& coarse = study.profiles[main];
  const Likeness& like = study.likeness[main];
  const double speed_up = mean(exact.cpu) / mean(coarse.cpu);
  return {
      at_least("profile", "correlation of the force at 2.5 % with the exact one", like.correlation,
               0.98),
      at_least("curvature", "the same of its second derivative, low-passed at 50 Hz",
               like.curvature, 0.9),
      at_least("front", "times the front is smaller at 2.5 % than exact, means along the path",
               mean(exact.front) / mean(coarse.front), 10.0),
      at_least("time",
               "query time proportional to the front: R^2 of the means along the path, over the "
               "thresholds",
               time_by_front(study), 0.9),
      stated("time-frames", "the same over the single frames of all thresholds",
             time_by_front_of_frames(study)),
      stated("speed-up", "mean query time exact over that at 2.5 %; the source has 50", speed_up)};
}

}  // namespace

Outcome run_fig_3_15(const Context& context) {
  const Pair jaws = scene_pair(*context.assets, "jaws");
  const PenaltyParams gains = direct_gains(jaws);
  HandScript hand = jaws_hand(jaws.radius);
  if (context.quick) hand.seconds = 0.65;
  const Path path = record_path(jaws, as_in_text(kMain), gains, hand);
  const ProfileStudy study = study_profile(
      context, jaws, path, gains,
      profile_settings({0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025}, kMain), context.quick ? 1 : 3);
  Outcome outcome;
  outcome.tables = profile_tables(study);
  outcome.figure = profile_figure(
      study, "Contact profile for moving jaws (Fig. 3.15)",
      "path recorded at 2.5 %, played back at the other thresholds; tolerance 5 % of the radius");
  outcome.claims = make_claims(study);
  return outcome;
}

}  // namespace thigma::experiments
