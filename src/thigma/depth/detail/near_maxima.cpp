#include "thigma/depth/detail/near_maxima.h"

#include <bit>

#include <xmmintrin.h>

namespace thigma::detail {

void collect_near(const HeightMap& object, const HeightMap& scene, const MapGrid& grid,
                  double within, DepthSamples& result) noexcept {
  const float floor = static_cast<float>(result.depth[0] - within);
  result.near.clear();
  result.near.push_back({result.at, within * within});
  const float *const a = object.heights.data(), *const b = scene.heights.data();
  const std::size_t count = object.heights.size(), whole = count - count % 4;
  // Few samples are above the floor, so four are looked at together first.
  const auto for_above = [&](const auto& visit) {
    const __m128 least = _mm_set1_ps(floor);
    for (std::size_t i = 0; i < whole; i += 4) {
      const __m128 sum = _mm_add_ps(_mm_loadu_ps(a + i), _mm_loadu_ps(b + i));
      const unsigned above = static_cast<unsigned>(_mm_movemask_ps(_mm_cmpgt_ps(sum, least)));
      for (unsigned k = above; k != 0; k &= k - 1)
        visit(i + static_cast<std::size_t>(std::countr_zero(k)));
    }
    for (std::size_t i = whole; i < count; ++i)
      if (a[i] + b[i] > floor) visit(i);
  };
  std::size_t found = 0;
  for_above([&](std::size_t) { ++found; });
  // Leaving samples out changes an average over a wide maximum little; a narrow one has few.
  const std::size_t room = kMaxNear - 1;
  const std::size_t stride = (found + room - 1) / room;
  std::size_t seen = 0;
  for_above([&](std::size_t i) {
    if (seen++ % stride != 0) return;
    const double above = static_cast<double>(a[i] + b[i] - floor);
    const int column = static_cast<int>(i) % grid.columns, row = static_cast<int>(i) / grid.columns;
    result.near.push_back({grid.at(column, row), above * above});
  });
}

}  // namespace thigma::detail
