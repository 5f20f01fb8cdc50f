// Levels of detail of a mesh: built, written, read again (docs/simplification.md).
#include <cstdio>

#include "thigma/clod/build_clod.h"
#include "thigma/clod/clod_file.h"
#include "thigma/models/make_model.h"

using namespace thigma;

int main() {
  const TriangleMesh mesh = models::make_model({.name = "golf_ball", .triangles = 4000});
  write_clod(build_clod_asset(mesh), "ball.clod");
  const ClodAsset asset = read_clod("ball.clod");
  for (std::size_t k = 0; k < asset.hierarchy.levels.size() && k < asset.meshes.size(); ++k)
    std::printf("level %zu: %zu triangles\n", k, asset.meshes[k].triangles.size());
}
