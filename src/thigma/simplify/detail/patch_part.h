#pragma once
// Patches on trial: what some triangles would be as a patch, without changing the surface.

#include <array>
#include <cstdint>
#include <vector>

#include "thigma/simplify/patched_surface.h"

namespace thigma::detail {

struct PatchPart {
  std::vector<std::int32_t> triangles, vertices;
  std::vector<HalfSpace> half_spaces;  // as in SurfacePatch
  TreeBox box{Vec3::Zero(), Vec3::Zero()};
  std::int32_t patch = -1;  // whose number it has, -1 of none yet
  bool is_absorbed = false;
};

/// Triangles whose corners are on trial too: the tree of the surface does not know where they are.
using MovedTriangles = std::array<std::int32_t, 2>;

/// Fills vertices and hull from the triangles.
void describe_part(const PatchedSurface& surface, PatchPart& part, Quickhull& hull);

/// Appends what is left of a patch without one of its triangles, connected over edges: nothing, one
/// part, or several, of which the first has the patch's number.
void append_rest(const PatchedSurface& surface, std::int32_t patch, std::int32_t without,
                 std::vector<PatchPart>& parts);

/// A shell of a surface with triangles on trial.
struct ShellOnTrial {
  const PatchedSurface& surface;
  std::int32_t shell = -1;
  const MovedTriangles& moved;
};

/// Whether no triangle of the shell that is neither in `part` nor in `beside` reaches into a hull.
///
/// half_spaces, box  of the hull
bool is_hull_clear(const ShellOnTrial& shell, const PatchPart& part, const PatchPart* beside,
                   const std::vector<HalfSpace>& half_spaces, const TreeBox& box);

/// Merges each of the first `count` parts with others, of all parts, as long as the union is a
/// convex patch over an edge they share.
///
/// returns  how many were absorbed
/// Thread   [offline]; deterministic.
int merge_parts(const ShellOnTrial& shell, std::size_t count, Quickhull& hull,
                std::vector<PatchPart>& parts);

}  // namespace thigma::detail
