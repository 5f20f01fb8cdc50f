#include "thigma/depth/detail/triangle_span.h"

#include <algorithm>
#include <cmath>

namespace thigma::detail {

HeightSpan start_span(const ProjectedPatch& patch, const ProjectedTriangle& t, double spacing,
                      Vec2& origin) noexcept {
  const HapticTexture& texture = *patch.texture;
  Vec2 low = Vec2::Constant(std::numeric_limits<double>::infinity());
  for (const Vec2& at : t.at) low = low.cwiseMin(t.texel_origin + t.texel_by_at * at);
  const auto index = [](double at, int count) {
    return static_cast<int>(std::clamp(std::floor(at) - 1.0, 0.0, count - 1.0));
  };
  const int column = index(low.x(), texture.width), row = index(low.y(), texture.height);
  origin = Vec2(column, row);
  HeightSpan span;
  span.texels = &texel_at(texture, column, row).x;
  span.texel_row = texture.width + 1;
  span.high_x = static_cast<float>(texture.width - 1 - column);
  span.high_y = static_cast<float>(texture.height - 1 - row);
  span.by_x = static_cast<float>(t.texel_by_at(0, 0) * spacing);
  span.by_y = static_cast<float>(t.texel_by_at(1, 0) * spacing);
  span.by_h = static_cast<float>(t.height_by_at.x() * spacing);
  for (int k = 0; k < 3; ++k) span.m[k] = static_cast<float>(t.carried[k]);
  return span;
}

}  // namespace thigma::detail
