#include <cstdio>

#include "thigma/thigma.h"

int main() {
  const thigma::Scene scene = thigma::load_scene("scenes/jaws.toml");
  thigma::SceneSession session = thigma::open_session(scene, {.device = "hand:", .duration = 4.0});
  const thigma::SessionSummary felt = thigma::run_lockstep(session);
  std::printf("largest force %.2f N\n", felt.force_max);
}
