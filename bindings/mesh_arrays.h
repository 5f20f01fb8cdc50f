#pragma once
// Meshes from the arrays of other languages, and from files, as load_usable_mesh has them.

#include <cstdint>
#include <string>
#include <vector>

#include "thigma/mesh/triangle_mesh.h"

namespace thigma::bindings {

/// Arrays of the caller, copied.
struct MeshArrays {
  const double* vertices = nullptr;  // (vertex_count, 3)
  std::int64_t vertex_count = 0;
  const std::int32_t* triangles = nullptr;  // (triangle_count, 3)
  std::int64_t triangle_count = 0;
};

/// How a mesh is taken.
struct MeshOptions {
  double scale = 1.0;                            // metres per unit, > 0
  bool repairs = false;                          // take repairable ones repaired
  std::vector<std::string>* repaired = nullptr;  // null, or filled with what was done
};

/// A usable mesh [m]. Equal positions become one vertex and unused ones go.
/// Thread [offline]; throws InputError with the first reason.
TriangleMesh usable_mesh(const MeshArrays& arrays, const MeshOptions& options);

/// The same of a file, or of a model such as "procedural:ball".
TriangleMesh usable_mesh(const std::string& path, const MeshOptions& options);

}  // namespace thigma::bindings
