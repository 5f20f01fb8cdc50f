// Fine relief felt over coarse surfaces: a probe led over a ridged plate (docs/textures.md).
#include <cstdio>

#include "thigma/thigma.h"

using namespace thigma;

int main() {
  const Scene scene = load_scene("plate");  // a built-in scene
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 2.0});
  const SessionSummary felt = run_lockstep(session);
  std::printf("largest force %.2f N, %llu depths from textures\n", felt.force_max,
              static_cast<unsigned long long>(felt.texture_depths));
}
