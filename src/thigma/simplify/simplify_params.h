#pragma once
// How far and how carefully surfaces are simplified.

#include <functional>

namespace thigma {

/// Of one edge that collapses (filtered_edge_collapse.h).
struct CollapseParams {
  int bisections = 3;           // K
  double least_quality = 0.02;  // of a new triangle: 4 sqrt(3) area / sum of squared edges, 1 when
                                // equilateral; where the worst of the old ones is below, that
  double free_to_turn = 2e-3;   // a triangle of less quality may turn over
  bool is_relaxed = true;       // step 3
  bool keeps_volume = true;     // the relaxed position first tried keeps the volume of the object
  // where neither quadric nor ends will do, the best convex position
  bool seeks_convex_start = true;
  bool guards_original = true;  // the limit on deviation holds from the original's vertices too
};

/// Of the loop (simplify_surface.h).
struct SimplifyParams {
  double longest_edge = 0.125;     // projected edges up to this times the radius collapse,
  double coarsest_share = 0.02;    // and longer ones while more than this share of the original's
  double longest_edge_ever = 0.5;  // patches is left, up to this times the radius
  double deviation_limit = 0.02;   // new triangles stay this near the original, times the radius,
  // and while edges are short this near, times the longest projected edge collapsed so far: first
  // levels lie close to the original
  double deviation_early = 0.4;
  // where nothing else is left to do this near, times the projected
  double deviation_share = 1.0;
  double deviation_ever = 0.045;  // edge, up to this times the radius
  double volume_limit = 0.1;      // change of a surface that is closed but for small holes, times
                                  // its volume
  double convexity_tolerance = 1e-6;   // least, times the radius; see DecompositionParams
  double protrusion_tolerance = 1e-5;  // least, times the radius
  double last_level = 0.8;  // a level that did not come to half the patches is kept below this
  bool flips_edges = true;  // reflex edges flip where no more can collapse
  CollapseParams collapse;
  std::function<void(double)> progress;  // called with the share of the work done, 0..1, rising; by
                                         // build_clod for all of its work
};

}  // namespace thigma
