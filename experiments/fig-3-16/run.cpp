// Fig. 3.16: a golf club taps a dimpled ball, rendered directly; one path at thresholds up to 3 % and exactly.

#include "experiments/common/all_experiments.h"
#include "experiments/common/contact_profile.h"
#include "experiments/common/hands.h"
#include "experiments/common/statistics.h"

namespace thigma::experiments {
namespace {

constexpr double kMain = 0.03;

std::vector<Claim> make_claims(const ProfileStudy& study) {
  const std::size_t main = setting_index(study, "s0 = 3 %");
  const Profile& exact = study.profiles[0];
  const Profile& coarse = study.profiles[main];
  const Likeness& like = study.likeness[main];
  return {at_least("profile", "correlation of the force at 3 % with the exact one",
                   like.correlation, 0.98),
          at_least("curvature", "the same of its second derivative, low-passed at 50 Hz",
                   like.curvature, 0.9),
          at_least("front",
                   "times the front is smaller at 3 % than exact, means along the path; the source "
                   "has nearly 100",
                   mean(exact.front) / mean(coarse.front), 10.0),
          below("steady", "variation of the query time with levels over that of the exact query",
                coefficient_of_variation(coarse.cpu) / coefficient_of_variation(exact.cpu), 1.0),
          at_least("force-front", "the front grows with the force: rank correlation at 3 %",
                   rank_correlation(coarse.front, coarse.force_size), 0.5),
          stated("force-front-exact", "the same of the exact query",
                 rank_correlation(exact.front, exact.force_size)),
          stated("speed-up", "mean query time exact over that at 3 %; the source has nearly 100",
                 mean(exact.cpu) / mean(coarse.cpu))};
}

}  // namespace

Outcome run_fig_3_16(const Context& context) {
  const Pair golf = scene_pair(*context.assets, "golf");
  const PenaltyParams gains = direct_gains(golf);
  HandScript hand = golf_hand(golf.radius);
  if (context.quick) hand.seconds = 0.35;
  const Path path = record_path(golf, as_in_text(kMain), gains, hand);
  const ProfileStudy study = study_profile(
      context, golf, path, gains,
      profile_settings({0.0005, 0.001, 0.0025, 0.005, 0.01, 0.03}, kMain), context.quick ? 1 : 3);
  Outcome outcome;
  outcome.tables = profile_tables(study);
  outcome.figure = profile_figure(study, "Contact profile for the golf scene (Fig. 3.16)",
                                  "path recorded at 3 %, played back at the other thresholds; "
                                  "tolerance 5 % of the ball's radius");
  outcome.claims = make_claims(study);
  return outcome;
}

}  // namespace thigma::experiments
