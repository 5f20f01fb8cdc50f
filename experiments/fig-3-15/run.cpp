// Fig. 3.15: the moving jaws, rendered directly; one recorded path at thresholds up to 2.5 % and
// exactly.

#include "experiments/common/all_experiments.h"
#include "experiments/common/contact_profile.h"
#include "experiments/common/hands.h"

namespace thigma::experiments {
namespace fig_3_15 {
namespace {

std::vector<Claim> make_claims(const Profile&, const Profile&, const ProfileStudy& study) {
  return {on_this_machine(at_least(
              "time",
              "query time proportional to the front: R^2 of the means along the path, over "
              "the thresholds with levels",
              time_by_front(study), 0.9)),
          stated("time-exact", "the same with the exact query, another algorithm, for one more",
                 time_by_front_with_exact(study))};
}

}  // namespace
}  // namespace fig_3_15

Outcome run_fig_3_15(const Context& context) {
  using namespace fig_3_15;
  const Known no_profile{
      "the whole motion reaches contacts of levels whose surface lies elsewhere by up to their "
      "deviation: 0.976; thresholds of 1 % and finer, the one-ring reading of D and one D a "
      "patch hold it",
      "sweep.csv", 0.95};
  return run_profile(
      context, {.scene = "jaws",
                .hand = jaws_hand,
                .quick_seconds = 0.65,
                .thresholds = {0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025},
                .title = "Contact profile for moving jaws (Fig. 3.15)",
                .source_front = "more than 10",
                .source_speed_up = "50",
                .why_no_profile = context.quick ? Known{} : no_profile,
                .why_no_curvature =
                    {"the force ripples as contacts of levels pass over the edges of their "
                     "patches and from cluster to cluster: it comes near the bound at s0 = 0.1 % "
                     "alone; at 2.5 % one D a patch, the 2 % cap and switching without "
                     "interpolation are better, the one-ring reading of D is not",
                     "sweep.csv", 0.35},
                .own_claims = make_claims});
}

}  // namespace thigma::experiments
