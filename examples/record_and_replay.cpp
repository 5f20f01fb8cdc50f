// A session recorded, run again from the recording, exported as a table.
#include <cstdio>

#include "thigma/recording/replay_session.h"
#include "thigma/scene/record_session.h"
#include "thigma/thigma.h"

using namespace thigma;

int main() {
  const Scene scene = load_scene("ellipsoid");
  SceneSession session = open_session(scene, {.device = "hand:", .duration = 1.0});
  record_lockstep(session, "session.mcap");
  const ReplayReport again = replay_recording("session.mcap");
  export_csv(read_recording("session.mcap"), "session.csv");
  std::printf("%llu frames, %s\n", static_cast<unsigned long long>(again.frames),
              again.identical ? "the same bits again" : again.reason.c_str());
}
