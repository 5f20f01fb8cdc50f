#pragma once
// From a mesh to contact levels of detail: one tree that is both levels and bounding volumes.

#include <cstdint>
#include <memory>

#include "thigma/clod/clod_asset.h"
#include "thigma/clod/hierarchy.h"
#include "thigma/convex/decomposition.h"
#include "thigma/mesh/triangle_mesh.h"
#include "thigma/simplify/simplify_params.h"

namespace thigma {

struct Simplification;

struct ClodParams {
  DecompositionParams decomposition;
  SimplifyParams simplify;
  // within which faces count as support of a vertex (Sec. 3.3.5); times the radius
  double contact_tolerance = 0.004;
  int threads = 1;                // of all but decomposition and the loop of simplification
  bool has_culling_hulls = true;  // nodes bounded by hulls of the finest surface below them; false:
                                  // by their own patch and h, as in the text
};

/// What building did, for reports.
struct ClodReport {
  std::int64_t childless = 0;  // patches of simplified levels that no finer patch is nearest to
  double decompose_seconds = 0.0, simplify_seconds = 0.0, parameter_seconds = 0.0,
         tree_seconds = 0.0;                       // CPU time
  std::shared_ptr<Simplification> simplification;  // set by build_clod
  DecompositionParams decomposition;               // with the tolerances that were used
};

/// Levels of detail of a usable mesh under free levels, with r, s, h and D.
///
/// Leaves are the finest patches of the original, as of build_exact_hierarchy: an exact query takes
/// either. A patch of a simplified level that is nearest to no patch below it has no node.
///
/// mesh     usable in the sense of import/inspect.h [m]
/// report   null, or filled
/// Thread   [offline]; deterministic; throws InputError when no triangle has an area.
/// Source   Sec. 3.2-3.3, Algorithm 3.3.1. Deviates: parents by geometry and culling hulls
///          (docs/deviations.md).
ClodHierarchy build_clod(const TriangleMesh& mesh, const ClodParams& params = {},
                         ClodReport* report = nullptr);

/// Builds levels of detail of a usable mesh with all that belongs to them.
///
/// mesh     as of build_clod [m]
/// report   null, or filled; the meshes of its simplification are moved out of it
/// Thread   [offline]; as build_clod.
ClodAsset build_clod_asset(const TriangleMesh& mesh, const ClodParams& params = {},
                           ClodReport* report = nullptr);

}  // namespace thigma
