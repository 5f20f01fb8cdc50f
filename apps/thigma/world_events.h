#pragma once
// What happens in a world, for its pages.

#include <string>
#include <vector>

#include "viewer/server/live_server.h"

#include "thigma/scene/world_scene.h"
#include "thigma/session/world_session.h"

namespace thigma::app {

/// Tells pages what happens in a world, once each. Thread: the world's.
class WorldEvents {
 public:
  WorldEvents(const LoadedWorld& world, live::LiveServer& server);

  /// Bodies have the names of this world from here on.
  void use(const LoadedWorld& world);

  /// Who was grasped and released, and where the world goes slower than the clock.
  void observe(const WorldFrame& frame);

 private:
  void tell(const WorldFrame& frame, EventKind kind, const std::string& detail,
            const std::string& text);

  const double rate_;  // [Hz]
  live::LiveServer& server_;
  const std::string nobody_;
  std::vector<std::string> names_;   // of bodies
  std::vector<std::string> held_;    // by hand
  double lost_ = 0.0, since_ = 0.0;  // [s]
};

}  // namespace thigma::app
