#pragma once
// Speed of the convex pair functions on coherent motion, for the program's `bench`.

#include <cstdint>
#include <string>
#include <vector>

namespace thigma::bench {

/// CPU time of one function on one class of hulls, nanoseconds a pair.
struct PairTiming {
  std::string name;  // "single", "batched", "axis", "sphere"
  int vertices_low = 0, vertices_high = 0;
  // over frames of (time of the frame / pairs), best of the repetitions of each frame
  double median = 0.0;
  double p99 = 0.0;
  double least = 0.0;
  double iterations = 0.0;  // mean turns of the distance loop, where it applies
};

struct PairTimingParams {
  int pairs = 256;
  int frames = 64;
  int repetitions = 5;
  double motion = 0.01;  // of the hull size a frame
  std::uint64_t seed = 1;
};

/// Times separated, coherent pairs of thin patch-like hulls of diameter 1, placed 10 to 30
/// diameters from the origins, all under one relative pose (the set-up of the figures to compare
/// with). Thread: measures the calling thread's CPU clock; everything is warm.
std::vector<PairTiming> time_pairs(const PairTimingParams& params = {});

/// The same pairs and poses through FCL's convex solver, where it was built with; empty otherwise.
struct ConvexBaseline {
  int vertices_low = 0, vertices_high = 0;
  double median = 0.0, p99 = 0.0;  // as PairTiming [ns]
  double disagreement = 0.0;       // largest difference from our distances, by the hull size
};
std::vector<ConvexBaseline> time_convex_baseline(const PairTimingParams& params = {});

}  // namespace thigma::bench
