#pragma once
// What a mesh is like, and whether it can be used.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "thigma/import/read_mesh.h"
#include "thigma/mesh/measure.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// usable: every edge has one or two faces, orientation is consistent, no vertex is pinched; open
/// or closed, any number of components, crossing itself or not. repairable: repair_mesh makes it
/// usable. rejected: neither.
enum class MeshVerdict : std::uint8_t { usable, repairable, rejected };

const char* verdict_name(MeshVerdict verdict);

/// Counts and measures of a mesh; the names are those of `thigma inspect --json`.
struct MeshReport {
  std::string file;  // empty for a mesh from memory
  std::string format;
  std::int64_t triangles = 0;  // of the file, before any is left out
  std::int64_t vertices = 0;   // after merging equal positions
  std::int64_t vertices_in_file = 0;
  std::int64_t triangles_left_out = 0;    // repeat an index after merging
  std::int64_t components = 0;            // connected over shared edges
  std::int64_t boundary_edges = 0;        // of one face
  std::int64_t nonmanifold_edges = 0;     // of three or more faces
  std::int64_t nonmanifold_vertices = 0;  // whose faces form more than one fan
  std::int64_t misoriented_edges = 0;     // of two faces that run along it the same way
  // without area: left out, or kept with three distinct vertices
  std::int64_t degenerate_triangles = 0;
  // of the same three vertices as an earlier one, either way round
  std::int64_t duplicate_triangles = 0;
  std::int64_t self_intersections = 0;  // pairs that meet other than at shared vertices or edges
  // that lie so close to another that welding them closes boundary edges
  std::int64_t unwelded_vertices = 0;
  std::int64_t inside_out_components = 0;  // closed, of negative volume, in no other
  std::int64_t nonorientable_components = 0;
  std::int64_t zero_volume_components = 0;  // closed, and flat to rounding
  // false: not asked for, or stopped at a limit (then at least that many)
  bool self_intersections_counted = false;
  bool closed = false;                 // no boundary edge
  bool manifold = false;               // no non-manifold edge or vertex
  bool oriented = false;               // no misoriented edge
  double area = 0.0;                   // [m^2]
  std::optional<double> volume;        // [m^3]; none unless closed, manifold and oriented
  std::optional<Vec3> center_of_mass;  // [m; body frame]; as volume
  std::optional<Mat3> inertia;         // unit density, about the centre of mass [kg m^2]; as volume
  double radius = 0.0;                 // of the smallest enclosing ball [m]
  Vec3 center = Vec3::Zero();          // of that ball [m; body frame]
  Bounds bounds;                       // [m; body frame]
  MeshVerdict verdict = MeshVerdict::rejected;
  std::vector<std::string> reasons;   // why not usable, a short sentence each
  std::vector<std::string> warnings;  // what to know though usable
};

struct InspectOptions {
  bool self_intersections = true;  // the one slow count; the verdict does not depend on it
};

/// Looks at a mesh and changes nothing. Any content is valid input, non-finite numbers and wild
/// indices included.
/// Thread    [offline]; deterministic.
MeshReport inspect_mesh(const TriangleMesh& mesh, const InspectOptions& options = {});

/// The same, with what reading already counted.
MeshReport inspect_mesh(const MeshFile& file, const std::string& name,
                        const InspectOptions& options = {});

/// Closed, consistently oriented components of negative volume that lie in no other, numbered as by
/// connect_over_edges, ascending. For a merged mesh with finite positions and at least one
/// triangle.
std::vector<std::int32_t> find_inside_out_components(const TriangleMesh& mesh);

}  // namespace thigma
