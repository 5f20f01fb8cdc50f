#pragma once
// What a .clod file holds: a hierarchy with the surfaces of its levels, its mass and its origin.

#include <cstdint>
#include <vector>

#include "thigma/clod/hierarchy.h"
#include "thigma/files/checksum.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Mass of the original surface for unit density.
struct ClodMass {
  bool is_closed = false;  // every edge has two faces: volume, centre and inertia mean something
  MassProperties measure;
};

/// What an asset was made from. Nothing a query needs.
struct ClodOrigin {
  Sha256 source{};          // of the bytes the mesh was read from; zeros: not known
  Sha256 key{};             // of everything the asset depends on, as a cache has it; zeros: none
  double unit_scale = 1.0;  // metres per unit of the source
  bool is_repaired = false;
  double contact_tolerance = 0.0;                    // as in ClodParams
  double longest_edge = 0.0, deviation_limit = 0.0;  // of SimplifyParams, the fine stage
  double convexity_tolerance = 0.0, protrusion_tolerance = 0.0;  // as in DecompositionParams
  std::int32_t max_vertices = 0;
  bool is_reparented = true, has_culling_hulls = true;  // the form of the tree; false: the text's
};

/// A hierarchy as it is kept in a file.
/// Invariant: `meshes` is empty, or has one mesh for each level that is not free; triangle_ids of a
/// patch index the mesh of its level.
struct ClodAsset {
  ClodHierarchy hierarchy;
  std::vector<TriangleMesh> meshes;
  ClodMass mass;
  ClodOrigin origin;
};

/// Of each triangle of a level's mesh: its patch, -1 without one (m). Level 0: into
/// hierarchy.patches; simplified levels: into hierarchy.level_patches.
/// level   with a mesh
/// Thread  [offline].
std::vector<std::int32_t> patches_of_triangles(const ClodAsset& asset, std::int32_t level);

/// Multiplies all lengths by a factor, as if the mesh had been scaled before: positions, s, h,
/// thickness and planes by it, r by its inverse, D by its square. Equal to building the scaled mesh
/// to rounding.
///
/// factor  > 0 and finite
/// Thread  [offline]; no failure.
void scale_hierarchy(ClodHierarchy& hierarchy, double factor);

/// The same for everything in an asset: volumes with the third power, inertia with the fifth.
void scale_asset(ClodAsset& asset, double factor);

}  // namespace thigma
