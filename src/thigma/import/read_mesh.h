#pragma once
// Mesh files into triangles, recognised by content, never by name.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// How a mesh file is written. What is known of each: import/detail/mesh_formats.h.
enum class MeshFormat : std::uint8_t {
  obj,
  ply_ascii,
  ply_little,
  ply_big,
  stl_ascii,
  stl_binary,
  off
};

/// A kind of mesh files, as people and file choosers know it: "PLY", ".ply".
struct MeshKind {
  const char* name;
  const char* ending;
};

/// Every kind that is read, once, in the order of messages.
std::vector<MeshKind> mesh_kinds();

/// The kinds by name, "OBJ, PLY, ... or OFF", for messages and help.
std::string mesh_kind_names();

/// "obj", "ply (ascii)", "ply (little-endian)", ... as reports print it.
const char* format_name(MeshFormat format);

/// What was in a file. Bit-equal positions are one vertex (-0 equals 0), triangles that then repeat
/// an index are left out, and vertices that no triangle uses are gone; zero-area triangles of three
/// vertices stay.
struct MeshFile {
  TriangleMesh mesh;  // in the file's own unit: formats state none
  MeshFormat format = MeshFormat::obj;
  std::int64_t vertices_in_file = 0;    // corners for STL, which has no vertices
  std::int64_t triangles_in_file = 0;   // polygons fan-triangulated
  std::int64_t vertices_merged = 0;     // onto an equal one
  std::int64_t vertices_unused = 0;     // positions no triangle uses
  std::int64_t triangles_left_out = 0;  // repeat an index after merging
};

/// Reads a mesh. Polygons become fans around their first corner: right for convex ones; a concave
/// one may fold.
///
/// path      any name
/// returns   the mesh, maybe without a triangle (inspect_mesh rejects that)
/// errors    InputError "FILE: what, where (line, byte or element), what was expected" for anything
///           damaged, a coordinate that is not finite or above 1e50, an index out of range
/// Thread    [offline]. Memory is bounded by a multiple of the file's size, whatever a header
///           claims.
MeshFile read_mesh(const std::string& path);

/// The same from memory; `name` stands for the file in messages.
MeshFile parse_mesh(std::string_view bytes, const std::string& name);

/// What reading does to any triangles, for a mesh made in memory. Positions finite, indices in
/// range.
MeshFile merge_equal_positions(TriangleMesh mesh);

/// Largest coordinate accepted: fifth powers (moments of inertia) must stay finite [any unit].
inline constexpr double kMaxCoordinate = 1e50;

}  // namespace thigma
