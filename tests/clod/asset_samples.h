#pragma once
// A small asset with several levels, for tests of files.

#include "support/wavy_ball.h"

#include "thigma/clod/build_clod.h"
#include "thigma/clod/build_hierarchy.h"
#include "thigma/clod/clod_asset.h"
#include "thigma/clod/validate_hierarchy.h"
#include "thigma/math/random.h"
#include "thigma/mesh/shapes.h"

namespace thigma::test {

inline TriangleMesh wavy_ball(int frequency) { return wavy_ball_of(frequency, 1.0, 0.12); }

inline ClodParams generous() {
  ClodParams params;
  params.simplify.stages = simplify_stages(0.5, 0.25);
  params.simplify.deviation_limit = 0.08;
  return params;
}

inline TriangleMesh sample_mesh() { return wavy_ball(7); }

inline const ClodAsset& sample_asset() {
  static const ClodAsset asset = build_clod_asset(sample_mesh(), generous());
  return asset;
}

}  // namespace thigma::test
