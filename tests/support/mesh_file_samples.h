#pragma once
// Sound files of every mesh format.

#include <string>

#include "thigma/files/file.h"
#include "thigma/import/detail/mesh_formats.h"

namespace thigma::test {

/// A mesh in a format; where the format is only read, the seed `sample` of its fuzz target.
inline std::string mesh_file(const TriangleMesh& mesh, const detail::MeshFormatRow& row) {
  if (row.write != nullptr) return row.write(mesh, "sample");
  return read_file(std::string(THIGMA_SOURCE_DIR "/tests/fuzz/corpus/") + (row.ending + 1) +
                   "/sample");
}

/// A file name for a format: "obj", "ascii.ply", "little-endian.ply".
inline std::string mesh_file_name(const detail::MeshFormatRow& row) {
  const std::string name = row.name, ending = row.ending;
  const std::size_t open = name.find('(');
  if (open == name.npos) return name;
  return name.substr(open + 1, name.find(')') - open - 1) + ending;
}

/// Whether a file holds bytes that no text has.
inline bool is_binary(const std::string& bytes) { return bytes.find('\0') != bytes.npos; }

}  // namespace thigma::test
