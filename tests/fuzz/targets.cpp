// The list of targets: the kinds of mesh files as the library knows them, and kTargets.

#include <cstring>

#include "fuzz/fuzz_target.h"

#include "thigma/import/read_mesh.h"

namespace thigma::fuzz {

std::vector<Target> targets() {
  std::vector<Target> all;
  for (const MeshKind& kind : mesh_kinds()) {
    const char* name = kind.ending + 1;  // without the dot
    all.push_back({name, fuzz_mesh, std::strcmp(name, "stl") == 0 ? mutate_stl : nullptr});
  }
  all.insert(all.end(), std::begin(kTargets), std::end(kTargets));
  return all;
}

}  // namespace thigma::fuzz
