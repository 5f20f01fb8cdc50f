#include "experiments/common/hierarchy_bytes.h"

namespace thigma::experiments {
namespace {

template <class T>
double bytes_of(const T& container) {
  return static_cast<double>(container.size() * sizeof(*container.data()));
}

}  // namespace

double hierarchy_bytes(const ClodHierarchy& h) {
  return bytes_of(h.nodes) + bytes_of(h.patches) + bytes_of(h.level_patches) + bytes_of(h.support) +
         bytes_of(h.vertices) + bytes_of(h.lanes) + bytes_of(h.faces) + bytes_of(h.edges) +
         bytes_of(h.hull_triangles) + bytes_of(h.triangle_ids);
}

}  // namespace thigma::experiments
