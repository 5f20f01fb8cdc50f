#pragma once
// The one list of mesh formats: how a file is recognised, read and written. Messages, the page,
// Python, fuzzing and the tests of damaged files follow it.

#include <string>
#include <string_view>

#include "thigma/import/detail/raw_mesh.h"

namespace thigma::detail {

struct MeshFormatRow {
  MeshFormat format;
  const char* kind;                    // as messages name it; rows of one kind stand together
  const char* ending;                  // of file names, in small letters
  const char* name;                    // as reports print it
  bool (*is)(const FileClues& clues);  // null: any text that no other row knows
  RawMesh (*read)(std::string_view bytes, const std::string& name);
  std::string (*write)(const TriangleMesh& mesh, const std::string& name);  // null: read only
  bool is_chosen_by_ending;  // what is written to a file with this ending; else the first row
  bool is_exact;             // every position reads back to the same bits, in the same order
};

RawMesh read_obj(std::string_view bytes, const std::string& name);
/// texture   null, or where texture coordinates go: every corner must have some then
RawMesh read_obj_texture(std::string_view bytes, const std::string& name, ObjTexture* texture);
std::string write_obj(const TriangleMesh& mesh, const std::string& name);

bool is_ply(const FileClues& clues);
RawMesh read_ply(std::string_view bytes, const std::string& name);  // tells the three apart
std::string write_ply_ascii(const TriangleMesh& mesh, const std::string& name);
std::string write_ply_little(const TriangleMesh& mesh, const std::string& name);
std::string write_ply_big(const TriangleMesh& mesh, const std::string& name);

// A file of the right size is binary, whatever it begins with: many begin with "solid" too.
bool has_binary_stl_size(std::string_view bytes);
bool is_stl_ascii(const FileClues& clues);
bool is_stl_binary(const FileClues& clues);
RawMesh read_stl_ascii(std::string_view bytes, const std::string& name);
RawMesh read_stl_binary(std::string_view bytes, const std::string& name);  // of 84 bytes and more
std::string write_stl_ascii(const TriangleMesh& mesh, const std::string& name);
std::string write_stl_binary(const TriangleMesh& mesh, const std::string& name);

bool is_off(const FileClues& clues);
RawMesh read_off(std::string_view bytes, const std::string& name);
std::string write_off(const TriangleMesh& mesh, const std::string& name);

/// A new format: its functions above, a row here, its value in MeshFormat.
inline constexpr MeshFormatRow kMeshFormats[] = {
    {MeshFormat::obj, "OBJ", ".obj", "obj", nullptr, read_obj, write_obj, true, true},
    {MeshFormat::ply_ascii, "PLY", ".ply", "ply (ascii)", is_ply, read_ply, write_ply_ascii, false,
     true},
    {MeshFormat::ply_little, "PLY", ".ply", "ply (little-endian)", is_ply, read_ply,
     write_ply_little, true, true},
    {MeshFormat::ply_big, "PLY", ".ply", "ply (big-endian)", is_ply, read_ply, write_ply_big, false,
     true},
    {MeshFormat::stl_binary, "STL", ".stl", "stl (binary)", is_stl_binary, read_stl_binary,
     write_stl_binary, true, false},
    {MeshFormat::stl_ascii, "STL", ".stl", "stl (ascii)", is_stl_ascii, read_stl_ascii,
     write_stl_ascii, false, false},
    {MeshFormat::off, "OFF", ".off", "off", is_off, read_off, write_off, true, true},
};

/// The row of a format; null for a value that is none.
inline const MeshFormatRow* row_of(MeshFormat format) {
  for (const MeshFormatRow& row : kMeshFormats)
    if (row.format == format) return &row;
  return nullptr;
}

}  // namespace thigma::detail
