#include <cstdio>

#include "thigma/thigma.h"

int main() {
  const thigma::Scene scene = thigma::load_scene("ellipsoid");
  thigma::SceneSession session = thigma::open_session(scene, {.device = "hand:", .duration = 1.0});
  std::printf("largest force %.2f N\n", thigma::run_lockstep(session).force_max);
}
