#pragma once
// How far and how carefully surfaces are simplified.

#include <array>
#include <cstddef>
#include <functional>

namespace thigma {

/// Of one edge that collapses (filtered_edge_collapse.h).
struct CollapseParams {
  int bisections = 3;            // K
  double least_quality = 0.02;   // of a new triangle: 4 sqrt(3) area / sum of squared edges, 1 when
                                 // equilateral; where the worst of the old ones is below, that
  double sliver_quality = 2e-3;  // a triangle of less quality may turn over
};

/// What may collapse in one stage of the loop.
struct SimplifyStage {
  double longest_edge = 0.0;     // projected edges up to this, times the radius
  double deviation_share = 0.0;  // deviation from the original beyond `deviation_limit`: up to this
                                 // times the projected edge, and `farthest_deviation`
};

/// Stages of the loop, in order: each collapses until nothing more does. Levels are chosen from the
/// first two; the others run only while more than `coarsest_share` of the original's patches is
/// left.
enum SimplifyStageName : std::size_t { kFine, kFineFar, kCoarse, kCoarseFar, kLast };
using SimplifyStages = std::array<SimplifyStage, 5>;

/// Stages of edges up to two lengths, each first near the original and then farther from it; at the
/// last up to twice the longer: for rings and plates that begin with few patches.
constexpr SimplifyStages simplify_stages(double longest_edge, double longest_coarse_edge,
                                         double deviation_share = 1.0) {
  return {{{longest_edge, 0.0},
           {longest_edge, deviation_share},
           {longest_coarse_edge, 0.0},
           {longest_coarse_edge, deviation_share},
           {2.0 * longest_coarse_edge, deviation_share}}};
}

/// Of the loop (simplify_surface.h).
struct SimplifyParams {
  SimplifyStages stages = simplify_stages(0.125, 0.5);
  double coarsest_share = 0.02;
  double deviation_limit = 0.02;  // new triangles stay this near the original, times the radius,
  // and while edges are short this near, times the longest projected edge collapsed so far: first
  // levels lie close to the original
  double deviation_early = 0.4;
  double farthest_deviation = 0.045;   // in any stage, times the radius
  double volume_limit = 0.1;           // change of a surface that is closed but for small holes,
                                       // times its volume
  double convexity_tolerance = 1e-6;   // least, times the radius; see DecompositionParams
  double protrusion_tolerance = 1e-5;  // least, times the radius
  double last_level_share = 0.8;  // the last level has at most this share of the patches before it
  CollapseParams collapse;
  int threads = 1;  // that attempts are made on, the same surfaces with any; build_clod's own there
  std::function<void(double)> progress;  // called with the share of the work done, 0..1, rising; by
                                         // build_clod for all of its work
};

}  // namespace thigma
