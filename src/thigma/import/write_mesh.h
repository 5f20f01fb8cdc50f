#pragma once
// Triangles into mesh files.

#include <string>

#include "thigma/import/read_mesh.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Format for a file name, by its ending: binary where the format has a binary form (.ply
/// little-endian doubles, .stl single precision, as STL is), and OBJ for an ending that no format
/// has.
MeshFormat format_for_name(const std::string& path);

/// The endings that choose a format, ".ply, ... else OBJ", for help.
std::string written_mesh_endings();

/// A mesh as the bytes of a file. Text is written with the fewest digits that read back to the same
/// bits.
/// Thread    [offline]; throws InputError when a position does not fit (STL: single precision), or
///           where the format is only read.
std::string format_mesh(const TriangleMesh& mesh, MeshFormat format, const std::string& name);

/// Writes a mesh; the file appears complete or not at all.
/// Thread    [offline]; throws IoError.
void write_mesh(const TriangleMesh& mesh, const std::string& path);

}  // namespace thigma
