// The same scene in real time: a haptic thread at 1 kHz beside a contact thread.
#include <cstdio>

#include "thigma/thigma.h"

using namespace thigma;

int main() {
  const Scene scene = load_scene("ellipsoid");
  const SceneSession opened = open_session(scene, {.device = "hand:", .duration = 2.0});
  Session session(opened.config, *opened.device, {.event = [](const SessionEvent& e) {
                    std::printf("%s\n", event_name(e.kind));
                  }});
  session.start();
  const SessionSummary felt = session.finish();  // waits for the two seconds
  std::printf("%llu frames, %llu late, largest force %.2f N\n",
              static_cast<unsigned long long>(felt.frames),
              static_cast<unsigned long long>(felt.missed), felt.force_max);
}
