#pragma once
// Do the levels of detail keep their promises? Counts what breaks them; every count is 0 for right
// ones.

#include <cstdint>

#include "thigma/simplify/simplify_surface.h"

namespace thigma {

/// Violations of the invariants of Simplification, over all levels.
struct LevelCheck {
  std::int64_t misplaced_triangles = 0;  // in no patch though they have an area, or out of range
  std::int64_t empty_patches = 0;
  std::int64_t reflex_edges = 0;        // inside a patch, beyond the convexity tolerance
  std::int64_t off_hull = 0;            // triangles with a vertex of their patch over their plane
  std::int64_t protruding_patches = 0;  // whose hull a triangle of the same shell reaches into
  std::int64_t oversized_patches = 0;   // of more vertices than the decomposition allows
  std::int64_t wrong_parents = 0;
  std::int64_t changed_surfaces = 0;  // levels with another Euler characteristic than the original
  // with more than half the patches and half the triangles of the one before, but the last
  std::int64_t unhalved_levels = 0;
  std::int64_t rising_resolutions = 0;

  std::int64_t total() const {
    return misplaced_triangles + empty_patches + reflex_edges + off_hull + protruding_patches +
           oversized_patches + wrong_parents + changed_surfaces + unhalved_levels +
           rising_resolutions;
  }
};

/// Checks levels by other means than they were built with: from the meshes alone.
///
/// decomposition  that the levels were built from
/// Thread         [offline]; no failure.
LevelCheck check_levels(const Simplification& simplification,
                        const ConvexDecomposition& decomposition);

}  // namespace thigma
