#include "thigma/convex/pair.h"

namespace thigma {

void closest_points_batch(std::span<const PairQuery> queries, const RelativePose& x, double stop,
                          Separation* out) noexcept {
  for (std::size_t i = 0; i < queries.size(); ++i) {
    out[i] = closest_points(*queries[i].a, *queries[i].b, x, stop, *queries[i].cache);
  }
}

}  // namespace thigma
