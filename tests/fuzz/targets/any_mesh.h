#pragma once
// What the targets of the mesh formats have in common.

#include "fuzz/fuzz_target.h"

#include "thigma/import/read_mesh.h"

namespace thigma::fuzz {

/// Reads a mesh, checks what read_mesh promises, looks at small ones as `inspect` does, and writes
/// and reads them again.
void read_any_mesh(const std::string& bytes);

}  // namespace thigma::fuzz
