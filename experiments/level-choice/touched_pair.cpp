#include "experiments/level-choice/touched_pair.h"

#include <cmath>
#include <cstdio>

namespace thigma::experiments::level_choice {

TouchedPair touch(SessionPair session, double threshold) {
  Resolution& resolution = session.config.contact.resolution;
  resolution = setting_at(threshold).resolution;
  const std::unique_ptr<HapticDevice> hand = open_device("hand:", session.hand);
  session.config.haptic.device = hand->limits();
  TouchedPair pair{session, {}};
  const auto look = [&](const ContactSample& sample) {
    const BodyState& state = sample.model.state;
    if (sample.contacts > 0)
      pair.touching.push_back(Pose{state.position, state.orientation} *
                              session.config.contact.body_from_mesh);
  };
  run_lockstep(session.config, *hand, {.haptic = {}, .contact = look, .event = {}});
  return pair;
}

Setting setting_at(double threshold) {
  Setting setting{"exact", threshold, {}};
  if (!(threshold > 0.0)) return setting;
  setting.resolution.is_exact = false;
  setting.resolution.metric.haptic = std::isfinite(threshold) ? threshold : 1e9;
  char name[32];
  std::snprintf(name, sizeof name, "%g %%", 100.0 * threshold);
  setting.name = std::isfinite(threshold) ? name : "no metric";
  return setting;
}

}  // namespace thigma::experiments::level_choice
