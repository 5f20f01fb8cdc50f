#include "thigma/depth/detail/near_maxima.h"

namespace thigma::detail {

void collect_near(const HeightMap& object, const HeightMap& scene, const MapGrid& grid,
                  double within, DepthSamples& result) noexcept {
  const float floor = static_cast<float>(result.depth[0] - within);
  result.near.clear();
  result.near.push_back({result.at, within * within});
  const std::size_t count = object.heights.size();
  std::size_t found = 0;
  for (std::size_t i = 0; i < count; ++i) found += object.heights[i] + scene.heights[i] > floor;
  // Leaving samples out changes an average over a wide maximum little; a narrow one has few.
  const std::size_t room = kMaxNear - 1;
  const std::size_t stride = (found + room - 1) / room;
  std::size_t seen = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double above = static_cast<double>(object.heights[i] + scene.heights[i] - floor);
    if (!(above > 0.0) || seen++ % stride != 0) continue;
    const int column = static_cast<int>(i) % grid.columns, row = static_cast<int>(i) / grid.columns;
    result.near.push_back({grid.at(column, row), above * above});
  }
}

}  // namespace thigma::detail
