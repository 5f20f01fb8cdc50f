#pragma once
// A watertight surface around any triangles: what makes a soup or a cracked scan touchable.

#include <cstdint>
#include <functional>
#include <string>

#include "thigma/import/inspect.h"
#include "thigma/import/nearest_point.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Side of a cell of the shell's lattice, times the radius of the mesh: some 20,000 to 200,000
/// triangles. Gaps up to 0.45 cells are closed.
inline constexpr double kShellCell = 0.03;

struct ShellParams {
  double cell = kShellCell;                // times the radius, in (0, 0.5]
  std::function<void(double)> progress{};  // called with a share, 0..1; may be empty
};

/// The shell of a mesh, and how far the two are from each other. A part of the mesh is hidden where
/// nothing outside comes within a cell and a half of it: inner walls, roots in a socket, the back
/// of a closed crack.
struct Shell {
  TriangleMesh mesh;               // closed, manifold, consistently turned, without intersections
  double cell = 0.0;               // side of a cell [m]
  LargestDistance to_mesh;         // of any point of the shell from the mesh [m]
  LargestDistance from_mesh;       // of any point of the mesh that is not hidden from the shell [m]
  double hidden_share = 0.0;       // of the area of the mesh [1]
  LargestDistance hidden;          // of any hidden point from the shell [m]
  std::int64_t vertices_held = 0;  // that could not be brought all the way to the mesh
};

/// Wraps a mesh: a surface at an offset of about half a cell around everything, then brought to a
/// thirtieth of a cell from the mesh, vertex by vertex, as far as it nowhere comes to meet itself.
/// Holes wider than a cell stay open: the shell goes in, and walls become thin solids. What no way
/// from outside leads to is filled. Corners that point inwards are rounded by about a third of a
/// cell; those that point outwards are kept.
///
/// mesh      any triangles: open, crossing, unwelded, turned at random, without an area; finite
/// name      of the file, for messages
/// Thread    [offline]; deterministic; throws InputError when the mesh has no triangle or no size,
///           the cell is out of range or needs more than 64 million lattice points or 8 million
///           near the surface, or the mesh lies so far from the origin that positions have too few
///           digits for cells.
/// Source    offset and descent as of Portaneri et al. 2022 (alpha wrapping), on a fixed lattice;
///           marching tetrahedra on a body-centred lattice (Chan and Purisima 1998).
Shell wrap_in_shell(const TriangleMesh& mesh, const std::string& name,
                    const ShellParams& params = {});

/// Whether there is something to wrap: false for a file without a triangle, or of no size.
bool can_wrap(const MeshReport& report);

/// The component with the largest area, connected over edges; of equal ones the first.
struct LargestComponent {
  TriangleMesh mesh;
  std::int64_t left_out = 0;   // components
  double area_left_out = 0.0;  // of the whole area [1]
};

/// mesh      finite, indices in range
/// Thread    [offline]; deterministic.
LargestComponent keep_largest_component(const TriangleMesh& mesh);

}  // namespace thigma
