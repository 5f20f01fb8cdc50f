#pragma once
// Triangles into mesh files.

#include <string>

#include "thigma/import/read_mesh.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma {

/// Format for a file name: .ply binary little-endian double, .stl binary (single precision, as STL
/// is), .off, and OBJ for any other.
MeshFormat format_for_name(const std::string& path);

/// A mesh as the bytes of a file. Text is written with the fewest digits that read back to the same
/// bits.
/// Thread    [offline]; throws InputError when a position does not fit (STL: single precision).
std::string format_mesh(const TriangleMesh& mesh, MeshFormat format, const std::string& name);

/// Writes a mesh; the file appears complete or not at all.
/// Thread    [offline]; throws IoError.
void write_mesh(const TriangleMesh& mesh, const std::string& path);

}  // namespace thigma
