#pragma once
// The points around a surface of which each is known to be outside of it or not.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"
#include "thigma/mesh/triangle_tree.h"

namespace thigma::detail {

/// A body-centred cubic lattice around a surface: the corners and the middles of cubes. A point is
/// outside when a way over neighbours, all farther than the offset from the surface, leads from it
/// to the border. Neighbours are at most a cell apart, so with an offset above half a cell no way
/// leads through the surface; nor through a gap below 2 sqrt(offset^2 - cell^2 / 4), where the
/// middle of no edge of the lattice is far enough from both rims.
struct ShellLattice {
  Vec3 origin = Vec3::Zero();                         // of the corner 0 0 0
  double cell = 0.0;                                  // side of a cube
  double offset = 0.0;                                // from the surface
  std::array<std::int64_t, 3> count{};                // of corners along each axis; as many middles
  std::vector<std::uint8_t> is_outside;               // by point
  std::unordered_map<std::int64_t, double> distance;  // of points near the offset, by point

  std::int64_t points() const { return 2 * count[0] * count[1] * count[2]; }
  /// kind: 0 a corner, 1 the middle beyond it along all axes.
  std::int64_t index(int kind, std::int64_t i, std::int64_t j, std::int64_t k) const {
    return ((kind * count[2] + k) * count[1] + j) * count[0] + i;
  }
  Vec3 position(std::int64_t point) const;
};

/// Points of a lattice over a box that is enough for the surface [1].
double lattice_points(const Vec3& extent, double cell, double offset);

/// Finds what is outside.
/// mesh, tree  the surface
/// cell        side of a cube; offset more than half of it
/// progress    called with a share, 0..1; may be empty
/// returns     none where more than most_near points lie near the surface
/// Thread      [offline]; deterministic. Memory: two bytes a point, and some 60 for each near the
///             surface.
std::optional<ShellLattice> build_shell_lattice(const TriangleMesh& mesh, const TriangleTree& tree,
                                                double cell, double offset, std::size_t most_near,
                                                const std::function<void(double)>& progress);

/// Whether a point of the lattice within a cell beyond the offset is outside: what the surface has
/// there can be touched.
bool is_seen_from_outside(const ShellLattice& lattice, const Vec3& p);

/// The surface between outside and inside, at the offset: closed, manifold, seen from outside,
/// without an intersection. Tetrahedra of the lattice are cut one by one (marching tetrahedra).
/// Thread      [offline]; deterministic.
TriangleMesh cut_shell_lattice(const ShellLattice& lattice);

}  // namespace thigma::detail
