#pragma once
// The point shell beside the levels: both objects' shells, both ways
// (benchmarks/baselines/point_shell.h).

#include "benchmarks/baselines/point_shell.h"
#include "experiments/common/session_pair.h"

namespace thigma::experiments::level_choice {

struct ShellPair {
  bench::PointShell object, scene;
  double build = 0.0;  // CPU time of building both [s]
  double bytes = 0.0;  // of both
};

/// Shells of the surfaces a scene is made of, with samples as far as its query may ask.
///
/// description  one static object
/// triangles    as of the session
/// session      of the same description and triangles
/// Thread       [offline].
ShellPair build_shells(const SceneDescription& description, int triangles,
                       const SessionPair& session);

}  // namespace thigma::experiments::level_choice
