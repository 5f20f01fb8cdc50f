// What s0 buys: the shipped scenes in the hand, queried again at thresholds from 0.05 to 20 %,
// exactly, and by a point shell; and whether s0 between 1 and 5 % decides the level of a contact by
// its area (Sec. 3.4.3, 3.5.2).

#include "experiments/common/all_experiments.h"
#include "experiments/level-choice/casts.h"
#include "experiments/level-choice/tables.h"

#include "thigma/scene/scene_file.h"

namespace thigma::experiments {
namespace level_choice {
namespace {

const std::vector<double> kThresholds = {0.0,   0.0005, 0.0025, 0.005, 0.01,
                                         0.025, 0.05,   0.1,    0.2,   kNoMetric};
const std::vector<double> kFewThresholds = {0.0, 0.01, 0.025, 0.05, kNoMetric};

struct Scene {
  const char* name;
  double seconds;  // of the session
  int quick_triangles;
};

constexpr Scene kScenes[] = {{"jaws", 3.0, 0},
                             {"golf", 3.0, 24'000},
                             {"ball_joint", 2.0, 24'000},
                             {"cup_spoon", 3.0, 24'000}};

Studied study(const Context& context, const std::string& name, const SceneDescription& scene,
              double seconds, int triangles) {
  tell(context, name);
  Studied pair;
  pair.name = name;
  pair.is_quick = context.quick;
  for (const double s0 : context.quick ? kFewThresholds : kThresholds)
    pair.settings.push_back(setting_at(s0));
  const SessionPair session = session_pair(*context.assets, scene, seconds, triangles);
  const ContactWorld& world = session.config.contact;
  pair.radius = std::min(world.object->radius, world.scene.front().hierarchy->radius);
  const ShellPair shells = build_shells(scene, triangles, session);
  pair.shell_build = shells.build;
  pair.study =
      measure(touch(session, kShipped), shells, pair.settings, context.quick ? 8 : 32, kShipped);
  return pair;
}

}  // namespace
}  // namespace level_choice

Outcome run_level_choice(const Context& context) {
  using namespace level_choice;
  Outcome outcome = empty_outcome();
  const auto add = [&](const Studied& pair) {
    add_rows(pair, outcome);
    for (const Claim& claim : claims_of(pair)) outcome.claims.push_back(claim);
  };
  for (const Scene& s : kScenes)
    add(study(context, s.name, parse_scene(builtin_scene(s.name), s.name, ""),
              context.quick ? 1.0 : s.seconds, context.quick ? s.quick_triangles : 0));
  if (const auto casts = casts_scene())
    add(study(context, "casts", *casts, context.quick ? 1.0 : 3.0, 0));
  else
    tell(context, "casts: left out, THIGMA_SHARED names no folder with meshes");
  return outcome;
}

}  // namespace thigma::experiments
