#include <cstdio>

#include "thigma/thigma.h"

int main() {
  const thigma::Scene scene =
      thigma::load_scene(thigma::scene_from_pair("lower.obj", "upper.obj", 0.00024));
  thigma::SceneSession session = thigma::open_session(scene, {.device = "hand:", .duration = 4.0});
  const thigma::SessionSummary felt = thigma::run_lockstep(session);
  std::printf("largest force %.2f N\n", felt.force_max);
}
