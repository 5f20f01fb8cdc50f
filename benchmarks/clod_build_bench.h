#pragma once
// What building levels of detail costs.

#include <cstdint>
#include <string>
#include <vector>

#include "benchmarks/bench_rows.h"

#include "thigma/clod/hierarchy.h"
#include "thigma/mesh/triangle_mesh.h"

namespace thigma::bench {

struct ClodBuildCost {
  std::int64_t triangles = 0, patches = 0;
  double cpu = 0.0, wall = 0.0;  // of all threads; on the clock [s]
  double serial = 0.0;           // CPU time of the parts that run on one thread [s]
  std::int64_t peak_bytes = 0;   // above what the process held before; 0: not known here
  std::int64_t file_bytes = 0;   // as a .clod file
  int threads = 2;
};

/// Builds, and says what it cost. Thread [offline].
ClodHierarchy build_measured(const TriangleMesh& mesh, ClodBuildCost& cost);

/// A row of it.
Row build_row(const std::string& model, const ClodBuildCost& cost);

/// Rows of the procedural models; quick: a few thousand triangles each.
std::vector<Row> clod_build_rows(bool quick);

}  // namespace thigma::bench
